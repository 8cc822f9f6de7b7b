// SPDX-License-Identifier: GPL-3.0-or-later
// `circle-voronoi picture`: the picture of a link or a file, as SVG, PNG or PDF.
import { renameSync, rmSync, writeFileSync } from 'node:fs'
import { extname } from 'node:path'
import { parseArgs } from 'node:util'
import { CircleVoronoiError } from '../lib/base/errors.ts'
import { convert, NO_CONVERTER } from './converters.ts'
import { readSource } from './read-source.ts'
import { renderSVG } from './render.ts'

export const USAGE = `Draw a link or a file as the playground shows it
Usage: circle-voronoi picture SOURCE [OPTIONS]

SOURCE: a link to the playground, its text from v1. on, or a file: CSV, JSON, GeoJSON, an SVG that the
playground has saved, or a text with a link. - reads standard input

Options:
  -o, --output FILE   .svg, .png or .pdf; standard output as SVG without it
  --size WxH          the size in pixels. Default: 720x480
  --scale FACTOR      pixels of a PNG for each pixel of the size. Default: 2
  --dark              colors for a dark page
  -h, --help          print this help

PNG and PDF need rsvg-convert or Chromium.
`
const FORMATS = ['.svg', '.png', '.pdf'] as const
const BAD_INPUT = 2
const FAILURE = 1

class UsageError extends Error {}

/** Runs the command and returns the exit status. `program` is the path of this program. */
export async function picture(args: readonly string[], program: string): Promise<number> {
  try {
    await draw(args, program)
    return 0
  } catch (error) {
    const isInput = error instanceof UsageError || (error instanceof CircleVoronoiError && error.code !== 'internal')
    process.stderr.write(`circle-voronoi: ${(error as Error).message}\n`)
    return isInput ? BAD_INPUT : FAILURE
  }
}

async function draw(args: readonly string[], program: string): Promise<void> {
  const { values, positionals } = parsed(args)
  if (values.help === true) {
    process.stdout.write(USAGE)
    return
  }
  const [source, ...more] = positionals
  if (source === undefined || more.length > 0)
    throw new UsageError('picture takes one link or file; see picture --help.')
  const { output } = values
  const format = output === undefined ? '.svg' : extname(output).toLowerCase()
  if (!FORMATS.some((name) => name === format))
    throw new UsageError(
      `${output}: picture writes ${FORMATS.join(', ')}, not ${format || 'a file without extension'}.`,
    )
  const [width, height] = sizeOf(values.size ?? '720x480')
  const scale = Number(values.scale ?? 2)
  if (!(scale > 0 && scale <= 100)) throw new UsageError('--scale is a number above 0, and at most 100.')
  const scheme = values.dark === true ? 'dark' : 'light'
  const svg = await renderSVG(await readSource(source, program), { width, height, scheme })
  if (output === undefined) {
    process.stdout.write(svg)
    return
  }
  // The picture is written to a temporary file first, so that only a complete file replaces an existing one.
  const made = `${output}.part${format}`
  try {
    if (format === '.svg') writeFileSync(made, svg)
    else if (!convert({ svg, width, height, scale }, format === '.png' ? 'png' : 'pdf', made))
      throw new Error(NO_CONVERTER)
    renameSync(made, output)
  } finally {
    rmSync(made, { force: true })
  }
}

function parsed(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: {
        output: { type: 'string', short: 'o' },
        size: { type: 'string' },
        scale: { type: 'string' },
        dark: { type: 'boolean' },
        help: { type: 'boolean', short: 'h' },
      },
    })
  } catch (error) {
    throw new UsageError(`picture: ${(error as Error).message.split('. To specify')[0]}.`)
  }
}

function sizeOf(text: string): [width: number, height: number] {
  const [, width, height] = /^(\d{1,5})x(\d{1,5})$/.exec(text) ?? []
  if (Number(width) > 0 && Number(height) > 0) return [Number(width), Number(height)]
  throw new UsageError(`--size is a width and a height in pixels, such as 720x480, not "${text}".`)
}
