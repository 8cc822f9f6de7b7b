// SPDX-License-Identifier: GPL-3.0-or-later
import type { Spec } from './tutorial.d.mts'

export function loadFigureCircles(): Promise<
  (figure: Pick<Spec, 'name' | 'circles' | 'dataSet'>) => readonly (readonly number[])[]
>
