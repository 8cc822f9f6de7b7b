// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/other-wasm.ts in the element's one-file builds, whose threads contain all modules.

export function metricsAddress(): undefined {}

export function regionsAddress(): undefined {}
