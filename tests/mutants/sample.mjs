// SPDX-License-Identifier: GPL-3.0-or-later
// What StrykerJS asks which changes to leave out: all but a share, drawn by a seed. Of what is left out it says that it
// does not compile, and does not count it. Whether a change is in the sample depends on itself alone.
// @ts-check
import { createHash } from 'node:crypto'
import { CheckStatus } from '@stryker-mutator/api/check'
import { declareValuePlugin, PluginKind } from '@stryker-mutator/api/plugin'

const SHARE = Number(process.env.CIRCLE_VORONOI_MUTANTS)
const SEED = process.env.CIRCLE_VORONOI_SEED

/** @param {import('@stryker-mutator/api/core').Mutant} mutant */
function isInSample({ fileName, mutatorName, replacement, location }) {
  // Wherever the repository is.
  const file = fileName.replaceAll('\\', '/').replace(/.*\/(?=web\/)/, '')
  const text = JSON.stringify([SEED, file, mutatorName, replacement, location])
  return createHash('sha256').update(text).digest().readUInt32BE() < SHARE * 2 ** 32
}

/** @type {import('@stryker-mutator/api/check').Checker} */
const sample = {
  async init() {},
  async check(mutants) {
    return Object.fromEntries(
      mutants.map((mutant) => [
        mutant.id,
        isInSample(mutant)
          ? { status: CheckStatus.Passed }
          : { status: CheckStatus.CompileError, reason: 'Not in the sample.' },
      ]),
    )
  },
  /** All at once: nothing has to be compiled. */
  async group(mutants) {
    return [mutants.map(({ id }) => id)]
  },
}

export const strykerPlugins = [declareValuePlugin(PluginKind.Checker, 'sample', sample)]
