// SPDX-License-Identifier: GPL-3.0-or-later
// Copies and pastes circles: as lines of numbers for other programs, and in a format that the page recognizes in any
// tab.
import type { Circle } from '../../lib/index.ts'
import type { PageActions } from '../page-actions.ts'

const OWN = 'application/x-circle-voronoi'

export function listenToClipboard(actions: PageActions): void {
  /** Number of pastes of the copied circles. Each is offset further. */
  let times = 0
  const isWritten = ({ target }: Event) =>
    target instanceof Element && target.closest('input, textarea, select, dialog') !== null

  const copy = (event: ClipboardEvent): boolean => {
    const circles = actions.circles.selectedCircles().map(({ circle: { x, y, r } }) => [x, y, r])
    if (isWritten(event) || circles.length === 0 || document.getSelection()?.isCollapsed === false) return false
    event.preventDefault()
    event.clipboardData?.setData(OWN, JSON.stringify(circles))
    event.clipboardData?.setData('text/plain', circles.map((circle) => `${circle.join('\t')}\n`).join(''))
    times = 0
    return true
  }
  document.addEventListener('copy', copy)
  document.addEventListener('cut', (event) => {
    if (copy(event)) actions.circles.removeSelected()
  })
  document.addEventListener('paste', (event) => {
    const circles = isWritten(event) ? undefined : circlesOf(event.clipboardData?.getData(OWN) ?? '')
    if (circles === undefined) return
    event.preventDefault()
    // Prevents the text from being opened as a file.
    event.stopImmediatePropagation()
    times += 1
    actions.circles.paste(circles, times)
  })
}

/** `undefined`: the text contains no circles. */
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
