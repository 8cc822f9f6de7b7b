// SPDX-License-Identifier: GPL-3.0-or-later
// A checker for StrykerJS that leaves out all changes except a random share, drawn by a seed. It reports the others as
// not compiling, so that they are not counted. Whether a change is in the sample does not depend on other changes.
import { createHash } from 'node:crypto'
import { CheckStatus } from '@stryker-mutator/api/check'
import { declareValuePlugin, PluginKind } from '@stryker-mutator/api/plugin'

const SHARE = Number(process.env.CIRCLE_VORONOI_MUTANTS)
const SEED = process.env.CIRCLE_VORONOI_SEED

/** @param {import('@stryker-mutator/api/core').Mutant} mutant */
function isInSample({ fileName, mutatorName, replacement, location }) {
  // Makes the path independent of the repository's place.
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
  /** Checks all changes at once, because nothing has to be compiled. */
  async group(mutants) {
    return [mutants.map(({ id }) => id)]
  },
}

export const strykerPlugins = [declareValuePlugin(PluginKind.Checker, 'sample', sample)]
