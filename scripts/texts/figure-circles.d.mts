// SPDX-License-Identifier: GPL-3.0-or-later
export function loadFigureCircles(): Promise<
  (figure: { readonly name: string; readonly dataSet: string }) => number[][]
>
