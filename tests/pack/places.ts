// SPDX-License-Identifier: GPL-3.0-or-later
// A figure wherever a page puts it, and where a point of its plane is then: for tests in all engines.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { ROOT } from './project.mjs'

declare global {
  /** The figure that `whenPlaced` found, also in a shadow root. */
  var placed: { readonly element: HTMLElementTagNameMap['circle-voronoi'] }
}

export const VIEW = { x: 5, y: 4, span: 20 }
/** The size of the picture in its own pixels. */
export const [WIDTH, HEIGHT] = [300, 200]

/** Each with the zoom of the figure. */
export const PLACES: readonly (readonly [name: string, around: (figure: string) => string, zoom?: number])[] = [
  ['as it is', (figure) => figure],
  ['made larger', (figure) => `<div style="transform: scale(1.6); transform-origin: 0 0">${figure}</div>`],
  ['made smaller', (figure) => `<div style="transform: scale(0.6); transform-origin: 0 0">${figure}</div>`],
  ['turned', (figure) => `<div style="transform: translate(100px, 60px) rotate(35deg)">${figure}</div>`],
  ['in perspective', (figure) => `<div style="transform: perspective(600px) rotateY(30deg)">${figure}</div>`],
  ['zoomed', (figure) => `<div style="zoom: 1.5">${figure}</div>`, 1.5],
  [
    'zoomed and made smaller',
    (figure) => `<div style="zoom: 1.5"><div style="transform: scale(0.7)">${figure}</div></div>`,
    1.5,
  ],
  [
    'zoomed in a shadow root',
    (figure) =>
      `<div><template shadowrootmode="open"><div style="zoom: 1.3; transform: rotate(-10deg)">${figure}</div></template></div>`,
    1.3,
  ],
]

/** Writes a page with a figure of three circles, whose view is known. Returns its path from the root of the project. */
export function writePlaced(folder: string, around: (figure: string) => string): string {
  const figure = `<circle-voronoi style="width: ${WIDTH}px; height: ${HEIGHT}px" circles="[[0,0,2],[10,0,1],[5,8,1.5]]"
    view="${Object.values(VIEW).join(' ')}"></circle-voronoi>`
  mkdirSync(join(ROOT, folder), { recursive: true })
  writeFileSync(
    join(ROOT, folder, 'index.html'),
    `<!doctype html><html lang="en"><title>Placed</title><link rel="icon" href="data:,">
    <style>body { margin: 150px }</style><script type="module" src="/dist/element/index.js"></script>${around(figure)}`,
  )
  return `${folder}/index.html`
}

/** The place of a point of the plane in the figure, in its own pixels. */
export function ownPlace(x: number, y: number): { readonly left: number; readonly top: number } {
  const scale = HEIGHT / VIEW.span
  return { left: WIDTH / 2 + (x - VIEW.x) * scale, top: HEIGHT / 2 - (y - VIEW.y) * scale }
}

/** Returns the position on the page of a place in the figure, from a mark that the browser lays out. It runs in the page. */
export function onPage({ left, top }: ReturnType<typeof ownPlace>, zoom = 1): [number, number] {
  const mark = document.createElement('i')
  mark.style.cssText = `position: absolute; width: 0; height: 0; left: ${left}px; top: ${top}px`
  placed.element.shadowRoot?.querySelector('.figure')?.append(mark)
  const box = mark.getBoundingClientRect()
  mark.remove()
  // WebKit, which lacks the property, gives the positions of boxes before zoom, and of pointers after zoom.
  const times = 'currentCSSZoom' in mark ? 1 : zoom
  return [times * box.left, times * box.top]
}

/** Ends once the figure is drawn. It runs in the page. */
export async function whenPlaced(): Promise<void> {
  await customElements.whenDefined('circle-voronoi')
  const host = document.querySelector('body > div')
  const element = document.querySelector('circle-voronoi') ?? host?.shadowRoot?.querySelector('circle-voronoi')
  Object.assign(globalThis, { placed: { element } })
  await placed.element.ready
  await placed.element.updateComplete
}

/** The center of circle 0, which is dragged, to a tenth. It runs in the page. */
export function centerOfFirst(): number[] {
  return [...placed.element.circles].slice(0, 2).map((value) => Math.round(10 * value) / 10)
}
