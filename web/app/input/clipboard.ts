// SPDX-License-Identifier: GPL-3.0-or-later
// Circles in the clipboard: as lines of numbers for other programs, and so that this page knows its own, in any tab.
import type { Circle } from '../../lib/index.ts'
import type { PageActions } from '../page-actions.ts'

const OWN = 'application/x-circle-voronoi'

export function listenToClipboard(actions: PageActions): void {
  /** How often what was copied has been pasted here: each time a little farther aside. */
  let times = 0
  const isWritten = ({ target }: Event) =>
    target instanceof Element && target.closest('input, textarea, select, dialog') !== null

  const copy = (event: ClipboardEvent): boolean => {
    const circles = actions.held().map(({ circle: { x, y, r } }) => [x, y, r])
    if (isWritten(event) || circles.length === 0 || document.getSelection()?.isCollapsed === false) return false
    event.preventDefault()
    event.clipboardData?.setData(OWN, JSON.stringify(circles))
    event.clipboardData?.setData('text/plain', circles.map((circle) => `${circle.join('\t')}\n`).join(''))
    times = 0
    return true
  }
  document.addEventListener('copy', copy)
  document.addEventListener('cut', (event) => {
    if (copy(event)) actions.removeSelected()
  })
  document.addEventListener('paste', (event) => {
    const circles = isWritten(event) ? undefined : circlesOf(event.clipboardData?.getData(OWN) ?? '')
    if (circles === undefined) return
    event.preventDefault()
    // It is no file.
    event.stopImmediatePropagation()
    times += 1
    actions.paste(circles, times)
  })
}

/** `undefined`: it is something else. */
function circlesOf(text: string): Circle[] | undefined {
  try {
    const rows: unknown = JSON.parse(text)
    if (!Array.isArray(rows) || rows.length === 0) return undefined
    const isRight = rows.every((row) => Array.isArray(row) && row.length === 3 && row.every(Number.isFinite))
    return isRight ? rows.map(([x, y, r]) => ({ x, y, r })) : undefined
  } catch {
    return undefined
  }
}
