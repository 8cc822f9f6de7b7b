// SPDX-License-Identifier: GPL-3.0-or-later
// Fixes the random numbers, so that detecting a change does not depend on luck. Counterexamples are not shrunk. A
// change that needs many examples to be detected counts as undetected.
import fc from 'fast-check'

fc.configureGlobal({ seed: 1, endOnFailure: true, numRuns: 25 })
