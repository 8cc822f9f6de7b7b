// SPDX-License-Identifier: GPL-3.0-or-later
// The program in WebAssembly passes the remaining tests of the native program, and generates each family.
import { execFileSync } from 'node:child_process'
import { describe } from 'node:test'
import { AT_ONCE, generatesTheSame, NATIVE, passesNativeTests } from '../wasm/native-program.mjs'

// These tests need not be repeated. Tests of documents use only the output of --help. Parsing the command line and
// converting is the same code, which tests/wasm/program.test.mjs covers.
const SAME_CODE = [
  'CliDocumentation.*',
  'CliConvert.*',
  'Cli.AnOptionThatIsNotUsedIsAnError',
  'Cli.BadUsageIsSaidInOneLine',
  '*.Refuses*',
]
// Node itself would not start with so little memory.
const NATIVE_ALONE = ['Cli.WantOfMemoryIsBadInput']
const ELSEWHERE = ['CliFiles.*', 'CliProgress.*', 'CliTile.*']

passesNativeTests(`Cli*-${[...SAME_CODE, ...NATIVE_ALONE, ...ELSEWHERE].join(':')}`)

describe('prints the same as the native program', AT_ONCE, () => {
  const families = execFileSync(NATIVE, ['generate', '--list'], { encoding: 'utf8' }).trim().split('\n')
  for (const family of families) generatesTheSame(family.split(' ')[0])
})
