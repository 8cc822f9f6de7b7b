// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a change is noticed must not depend on luck, and the least example of it is of no interest. What needs many
// examples to be noticed counts as not noticed.
import fc from 'fast-check'

fc.configureGlobal({ seed: 1, endOnFailure: true, numRuns: 25 })
