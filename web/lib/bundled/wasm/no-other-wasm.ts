// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces ../../wasm/other-wasm.ts in the element's one-file build, whose thread contains all modules.

export function metricsAddress(): undefined {}

export function regionsAddress(): undefined {}
