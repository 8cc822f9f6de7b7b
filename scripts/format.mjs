// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that clang-format would change no C++ file, and says how many files that are. With --write it formats them.
import { execFileSync } from 'node:child_process'
import { isMain, main, ROOT, statusOf } from './run.mjs'

if (isMain(import.meta.url)) {
  await main(async () => {
    const files = execFileSync('git', ['ls-files', '*.cpp', '*.h'], { cwd: ROOT, encoding: 'utf8' }).trim().split('\n')
    const isWriting = process.argv.includes('--write')
    const status = await statusOf('clang-format', [...(isWriting ? ['-i'] : ['--dry-run', '-Werror']), ...files])
    if (status !== 0) throw new Error('Format these files: node scripts/format.mjs --write')
    console.log(`${isWriting ? 'Formatted' : 'Checked the format of'} ${files.length} C++ files.`)
  })
}
