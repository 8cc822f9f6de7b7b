// SPDX-License-Identifier: GPL-3.0-or-later
// Property tests take the same inputs each time, so that a failure is of the change; CIRCLE_VORONOI_SEED chooses others.
import fc from 'fast-check'

fc.configureGlobal({ seed: Number(process.env.CIRCLE_VORONOI_SEED ?? 1) })
