// SPDX-License-Identifier: GPL-3.0-or-later
import type { Block } from './blocks.mjs'

export function recipeOf(blocks: readonly Block[], heading: string): Record<string, string>
