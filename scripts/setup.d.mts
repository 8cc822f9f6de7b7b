// SPDX-License-Identifier: GPL-3.0-or-later
export function setup(purpose?: string, meanwhile?: () => Promise<unknown>): Promise<void>
export function chromiumPath(): string
export function chromiumShellPath(): string
