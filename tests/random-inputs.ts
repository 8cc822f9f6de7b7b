// SPDX-License-Identifier: GPL-3.0-or-later
// Gives property tests the same inputs each time, so that a failure is caused by the change. CIRCLE_VORONOI_SEED
// chooses others.
import fc from 'fast-check'

fc.configureGlobal({ seed: Number(process.env.CIRCLE_VORONOI_SEED ?? 1) })
