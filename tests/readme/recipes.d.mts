// SPDX-License-Identifier: GPL-3.0-or-later
import type { Block } from './blocks.d.mts'

export function recipes(): readonly (Block & { readonly title: string; readonly picture: string })[]
export function addModules(folder: string): void
export function pageOf(code: string): string
export function pageOfComponent(code: string): Promise<string>
export function withOwnElement(html: string): string
export const POLICY: string
export const OTHERS: readonly string[]
