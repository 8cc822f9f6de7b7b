// SPDX-License-Identifier: GPL-3.0-or-later
export function chromiumPath(): string
export function chromiumShellPath(): string
