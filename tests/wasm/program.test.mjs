// SPDX-License-Identifier: GPL-3.0-or-later
// The program in WebAssembly passes the tests of the native program and prints the same bytes. These tests are about
// reading and writing in Node; tests/long/program.test.mjs has the rest.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { describe, it } from 'node:test'
import { AT_ONCE, both, generatesTheSame, NATIVE, passesNativeTests, ROOT } from './native-program.mjs'

const FORMATS = ['csv', 'svg', 'geojson', 'geojsonl', 'wkt', 'obj', 'json', 'stats']

passesNativeTests('CliFiles.*:CliProgress.*:CliTile.*-*.Refuses*')

describe('prints the same as the native program', AT_ONCE, () => {
  for (const family of ['uniform', 'extreme', 'chaos']) generatesTheSame(family)

  for (const family of ['log-uniform', 'chaos']) {
    const circles = execFileSync(NATIVE, ['generate', family, '200', '--seed', '3'])
    for (const format of FORMATS) {
      it(`${family} circles as ${format}`, async () => {
        assert.equal((await both(['compute', '-', '--format', format], circles)).status, 0)
      })
    }
  }

  it('what is cut at a box and drawn as closely as it is told', async () => {
    const options = ['--bounds=-3,1e-3,7.25,1e1', '--tolerance', '3e-7', '--max-distance', '0.75']
    const circles = readFileSync(`${ROOT}tests/fixtures/waka.csv`)
    for (const format of ['svg', 'geojson', 'wkt'])
      await both(['compute', '-', '--format', format, ...options], circles)
  })

  it('what is converted', async () => {
    const diagram = execFileSync(NATIVE, ['compute', `${ROOT}tests/fixtures/waka.csv`])
    for (const format of FORMATS.filter((name) => name !== 'stats'))
      assert.equal((await both(['convert', '-', '--format', format], diagram)).status, 0)
    await both(['convert', '-', '--format', 'csv'], diagram.subarray(0, 5000))
  })

  for (const command of ['compute', 'convert', 'generate', 'tile', 'treemap', 'certify']) {
    it(`the help of ${command}`, async () => assert.equal((await both([command, '--help'])).status, 0))
  }

  it('what is wrong', async () => {
    await both(['certify', `${ROOT}tests/fixtures`])
    await both(['compute', `${ROOT}none`])
    await both(['compute', '-', '--tolerance', 'nan'], '0,0,1\n')
    await both(['compute', '-', '--format', 'csv', '--bounds=0,0,1,1', '--weights=no'], '0,0,1\n')
    await both(['compute', '-', '--samples', '-1'], '0,0,1\n')
    await both(['paint'])
    await both(['tile', '-', '--size', '1', '--halo', '0', '-o', 'none'], '0,0,1\n')
  })
})
