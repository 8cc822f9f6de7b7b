// SPDX-License-Identifier: GPL-3.0-or-later
// Converts SVG to PNG and PDF with an installed program: rsvg-convert (librsvg) or a Chromium browser.
import { spawnSync } from 'node:child_process'
import { copyFileSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'

export interface Converted {
  readonly svg: string
  readonly width: number
  readonly height: number
  /** Pixels of the PNG per pixel of the SVG. */
  readonly scale: number
}

const BROWSERS = [
  ...['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'microsoft-edge', 'brave-browser'],
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
  'C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe',
]
/** Time limit of a converter. */
const SECONDS = 60

export const NO_CONVERTER =
  'PNG and PDF need rsvg-convert (apt install librsvg2-bin, brew install librsvg) or Chromium; or set CHROMIUM_PATH to a browser.'

/** Writes a PNG or a PDF. Returns false if no converter is installed; throws the converter's message. */
export function convert(picture: Converted, format: 'png' | 'pdf', file: string): boolean {
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-'))
  try {
    const made = join(folder, `picture.${format}`)
    if (!byRsvg(picture, format, made) && !byBrowser(picture, format, made, folder)) return false
    copyFileSync(made, file)
    return true
  } finally {
    rmSync(folder, { recursive: true, force: true })
  }
}

function byRsvg({ svg, scale }: Converted, format: 'png' | 'pdf', made: string): boolean {
  const zoom = format === 'png' ? ['--zoom', String(scale)] : []
  return run('rsvg-convert', ['--format', format, ...zoom, '--output', made], svg)
}

function byBrowser(picture: Converted, format: 'png' | 'pdf', made: string, folder: string): boolean {
  const { svg, width, height, scale } = picture
  const page = join(folder, 'picture.html')
  writeFileSync(
    page,
    `<!doctype html><meta charset="utf-8"><style>@page { size: ${width}px ${height}px; margin: 0 } body { margin: 0 } svg { display: block }</style>${svg}`,
  )
  const task =
    format === 'pdf'
      ? [`--print-to-pdf=${made}`, '--no-pdf-header-footer']
      : [
          `--screenshot=${made}`,
          `--window-size=${Math.ceil(width)},${Math.ceil(height)}`,
          `--force-device-scale-factor=${scale}`,
        ]
  // The sandbox protects against foreign pages, which are not loaded here. In containers it often cannot start.
  const always = [
    '--headless',
    '--no-sandbox',
    '--disable-gpu',
    '--hide-scrollbars',
    `--user-data-dir=${join(folder, 'profile')}`,
  ]
  const own = process.env.CHROMIUM_PATH
  return (own === undefined ? BROWSERS : [own]).some((browser) =>
    run(browser, [...always, ...task, pathToFileURL(page).href]),
  )
}

/** Returns false if the program is not installed. */
function run(program: string, args: readonly string[], input = ''): boolean {
  const { error, status, stderr } = spawnSync(program, args, { input, timeout: SECONDS * 1000, encoding: 'utf8' })
  if (error !== undefined && 'code' in error && error.code === 'ENOENT') return false
  if (error !== undefined || status !== 0) throw new Error(`${program} failed: ${error?.message ?? stderr.trim()}`)
  return true
}
