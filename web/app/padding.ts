// SPDX-License-Identifier: GPL-3.0-or-later
import type { Padding } from '../view/camera.ts'
import { byId } from './panels/by-id.ts'

/** Space between circles and the panels around them, in pixels. */
const MARGIN = 16
const MARGIN_AT_EDGE = 32
/** The largest width of a panel that is no sheet, relative to the window. */
const WIDEST = 0.7
/** Height of a scene's initial caption, in rem. It disappears at the first touch without moving anything. */
const SAID = 5.625
/** Height of the caption in a narrow window, where its lines are short. */
const SAID_IN_SHORT_LINES = 7
const SHORT_LINES = matchMedia('(max-width: 22em)')
/** Width of the caption beside the picture in low windows, in rem. In narrow windows it is above the status. */
const SAID_ASIDE = 13
const LOW = matchMedia('(max-height: 32em)')
const NARROW = matchMedia('(max-width: 40em)')

/**
 * The space that panels cover on each side of the picture, with a margin. Cards of the selection come and go and do not
 * count.
 */
export function paddingOfPage(): Padding {
  const boxOf = (id: string) => byId(id, HTMLElement).getBoundingClientRect()
  const rail = boxOf('rail')
  const isBelow = rail.width > rail.height
  const panel = document.querySelector('#left > .panel:not([hidden])')?.getBoundingClientRect()
  const [player, share] = [boxOf('player'), boxOf('share')]
  // Panels on phones are sheets as wide as the window.
  const isSheet = ({ width }: DOMRect) => width > WIDEST * innerWidth
  const sheets = [panel, player, share]
    .filter((box) => box !== undefined && isSheet(box))
    .map((box) => box?.top ?? innerHeight)
  const below = [boxOf('status'), boxOf('view'), ...(isBelow ? [rail] : [])].filter(({ height }) => height > 0)
  const rem = Number.parseFloat(getComputedStyle(document.documentElement).fontSize)
  const said = LOW.matches ? 0 : (SHORT_LINES.matches ? SAID_IN_SHORT_LINES : SAID) * rem
  // An open panel replaces the caption.
  const isAside = LOW.matches && !NARROW.matches && panel === undefined && share.width === 0 && player.width === 0
  const lowest = Math.min(...below.map(({ top }) => top), innerHeight)
  const free = NARROW.matches ? lowest - said : Math.min(lowest, innerHeight - said)
  const left = [isBelow ? 0 : rail.right, panel === undefined || isSheet(panel) ? 0 : panel.right]
  // The share card leaves room for the picture in wide windows.
  const beside = [player, ...(LOW.matches ? [share] : [])].find((box) => box.width > 0 && !isSheet(box))
  return {
    top: boxOf('top').bottom + MARGIN,
    right:
      (isAside ? SAID_ASIDE * rem : 0) +
      (beside !== undefined ? innerWidth - beside.left + MARGIN : isBelow ? MARGIN : MARGIN_AT_EDGE),
    // A sheet covers the caption.
    bottom: innerHeight - Math.min(...(sheets.length > 0 ? [lowest, ...sheets] : [free])) + MARGIN,
    left: Math.max(...left) + MARGIN,
  }
}

/** The space that panels cover, with the card for sharing, which leaves room for all circles in wide windows. */
export function coveredOfPage(): Padding {
  const padding = paddingOfPage()
  const { left, width } = byId('share', HTMLElement).getBoundingClientRect()
  const isBeside = width > 0 && width <= WIDEST * innerWidth
  return isBeside ? { ...padding, right: Math.max(padding.right, innerWidth - left + MARGIN) } : padding
}
