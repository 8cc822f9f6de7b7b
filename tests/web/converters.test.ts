// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures are converted by programs, here by scripts of a shell.
import { chmodSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { convert } from '../../web/picture/converters.ts'

let folder: string
const temporary = () => readdirSync(join(folder, 'temporary'))
const written = () => readFileSync(join(folder, 'out'), 'utf8')
const PICTURE = { svg: '<svg/>', width: 20.5, height: 10, scale: 3 }

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'converters-'))
  mkdirSync(join(folder, 'temporary'))
  vi.stubEnv('TMPDIR', join(folder, 'temporary'))
  vi.stubEnv('PATH', folder)
  vi.stubEnv('CHROMIUM_PATH', join(folder, 'browser'))
})
afterEach(() => {
  vi.unstubAllEnvs()
  rmSync(folder, { recursive: true })
})

/** Installs a program with a script. */
function install(name: string, script: string): void {
  writeFileSync(join(folder, name), `#!/bin/sh\nPATH=/usr/bin:/bin\n${script}\n`)
  chmodSync(join(folder, name), 0o755)
}

it.each([
  ['png', '--format png --zoom 3 --output'],
  ['pdf', '--format pdf --output'],
] as const)('a picture is converted to %s by rsvg-convert, and no file is left over', (format, options) => {
  install('rsvg-convert', `for last; do :; done; echo "$*" > "$last"; cat >> "$last"`)
  expect(convert(PICTURE, format, join(folder, 'out'))).toBe(true)
  expect(written()).toContain(`${options} `)
  expect(written()).toContain('<svg/>')
  expect(temporary()).toEqual([])
})

it.each([
  ['png', /--window-size=21,10 --force-device-scale-factor=3 file:/],
  ['pdf', /--no-pdf-header-footer file:/],
] as const)('without rsvg-convert a browser makes a %s', (format, options) => {
  install('browser', `for a; do case $a in --screenshot=*|--print-to-pdf=*) echo "$*" > "\${a#*=}";; esac; done`)
  expect(convert(PICTURE, format, join(folder, 'out'))).toBe(true)
  expect(written()).toMatch(options)
  expect(temporary()).toEqual([])
})

it('a failure of the program is thrown, and without a program there is no picture', () => {
  expect(convert(PICTURE, 'png', join(folder, 'out'))).toBe(false)
  install('rsvg-convert', 'cat > /dev/null; echo "no font" >&2; exit 1')
  expect(() => convert(PICTURE, 'png', join(folder, 'out'))).toThrow('no font')
  expect(temporary()).toEqual([])
  expect(readdirSync(folder)).not.toContain('out')
})
