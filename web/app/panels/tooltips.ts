// SPDX-License-Identifier: GPL-3.0-or-later
import { html, nothing, render } from 'lit/html.js'
import { byId } from './by-id.ts'

const ICONS = '.icon[title], #played button[title]'
/** Distance from an icon to its tooltip, in pixels. */
const GAP = 8

/** Shows names and keys of icons at once, in place of the browser's own late tooltips. */
export function mountTooltips(): void {
  const place = byId('tooltip', HTMLElement)
  let shown: HTMLElement | undefined
  let title = ''

  const hide = () => {
    if (shown === undefined) return
    // A title that has changed meanwhile is newer.
    if (!shown.hasAttribute('title')) shown.title = title
    shown.removeAttribute('aria-description')
    shown = undefined
    place.hidePopover()
  }
  const show = ({ target }: Event) => {
    const icon = target instanceof Element ? target.closest<HTMLElement>(ICONS) : null
    if (icon === null || icon === shown) return
    hide()
    shown = icon
    title = icon.title
    icon.removeAttribute('title')
    // The title described the icon to screen readers.
    icon.setAttribute('aria-description', title)
    const [, text = '', key] = /^(.*?)(?: \(([^()]+)\))?$/.exec(title) ?? []
    const name = icon.ariaLabel ?? text
    render(
      html`<b>${name}</b>${key === undefined ? nothing : html` <kbd>${key}</kbd>`}${text === name ? nothing : html`<small>${text}</small>`}`,
      place,
    )
    place.showPopover()
    placeBeside(place, icon)
  }
  const leave = ({ target }: Event) => {
    if (shown !== undefined && target instanceof Node && shown.contains(target)) hide()
  }
  document.addEventListener('pointerover', (event) => {
    if (event.pointerType === 'touch') return
    if (shown !== undefined && !(event.target instanceof Node && shown.contains(event.target))) hide()
    show(event)
  })
  document.addEventListener('focusin', (event) => {
    if (event.target instanceof Element && event.target.matches(':focus-visible')) show(event)
  })
  document.addEventListener('focusout', leave)
  document.addEventListener('pointerdown', hide, { capture: true })
  document.addEventListener('keydown', hide, { capture: true })
}

/** Beside a column of icons, or else below or above a row. */
function placeBeside(place: HTMLElement, icon: HTMLElement): void {
  // At the edge, the text would be as narrow as the room there.
  place.style.left = '0'
  const at = icon.getBoundingClientRect()
  const { width, height } = place.getBoundingClientRect()
  const around = icon.closest('#rail')?.getBoundingClientRect()
  const isBeside = around !== undefined && around.height > around.width
  const [x, y] = isBeside
    ? [around.right + GAP, at.top + (at.height - height) / 2]
    : [at.left + (at.width - width) / 2, at.top < innerHeight / 2 ? at.bottom + GAP : at.top - height - GAP]
  place.style.left = `${Math.min(Math.max(x, GAP), innerWidth - width - GAP)}px`
  place.style.top = `${Math.min(Math.max(y, GAP), innerHeight - height - GAP)}px`
}
