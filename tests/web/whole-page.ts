// SPDX-License-Identifier: GPL-3.0-or-later
// The whole page with its threads, without a browser. Nothing of the project is replaced, and canvases have no pixels.
import { readFile } from 'node:fs/promises'
import { afterAll, expect, vi } from 'vitest'
import type { Attributes } from '../../web/editing/attributes.ts'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import type { View } from '../../web/view/view.ts'
import { Canvas, contextOfElement, Path } from './page-canvas.ts'
import { buttonOf, control, controls, element, measure, openPage, send } from './page-document.ts'
import { ThreadHere } from './page-threads.ts'

/** The size of the figure in pixels. */
export const SIZE = { width: 800, height: 600 }
/** Five circles apart from one another. Circle 3 has a bounded cell. */
export const FIVE = Float64Array.of(0, 0, 2, 20, 0, 3, 20, 20, 1, 10, 9, 2, 0, 20, 4)

/** Waits until a check passes, with short intervals. */
export const soon = <Value>(check: () => Value | Promise<Value>) => vi.waitFor(check, { timeout: 40_000, interval: 4 })

/** Waits until no message is under way between the page and its threads, and everything is drawn. */
export async function quiet(): Promise<void> {
  for (let frames = 0; frames < 3; frames++) {
    await new Promise((resolve) => requestAnimationFrame(resolve))
    if (ThreadHere.isBusy) frames = 0
  }
}

/** Waits for a control by the beginning of its accessible name. */
export const found = (within: Element, name: string) =>
  soon(() => {
    const names = [...controls(within).keys()]
    return control(within, names.includes(name) ? name : (names.find((other) => other.startsWith(name)) ?? name))
  })

/** Presses a control, and waits for what follows. */
export async function pressed(within: Element, ...names: readonly string[]): Promise<void> {
  for (const name of names) {
    const button = await found(within, name)
    button.click()
    await quiet()
  }
}

/** Enters a value as a user does who leaves the field, and waits for what follows. */
export async function entered(within: Element, name: string, ...values: readonly string[]): Promise<void> {
  const field = await found(within, name)
  for (const value of values) {
    field.value = value
    for (const type of ['input', 'change']) send(field, type)
    await quiet()
  }
}

/** Answers a request for a data set or WebAssembly by the file. */
export async function fetchHere(address: URL | string): Promise<Response> {
  const { pathname } = new URL(address)
  const name = pathname.split('/').at(-1) as string
  const folder = { 'families.wasm': 'web/app/generated', 'printed.wasm': 'web/tutorial/generated' }[name]
  const file = `${name.endsWith('.wasm') ? (folder ?? 'web/lib/generated') : 'public/data'}/${name}`
  try {
    return new Response(await readFile(file))
  } catch {
    return new Response(null, { status: 404 })
  }
}

let listening = new AbortController()
const listen = window.addEventListener.bind(window)

/** Provides an empty page with what happy-dom lacks. */
export function surround() {
  const { media } = openPage()
  ThreadHere.endAll()
  const surroundings = { Worker: ThreadHere, OffscreenCanvas: Canvas, Path2D: Path, fetch: fetchHere }
  Object.assign(globalThis, surroundings)
  Object.assign(HTMLCanvasElement.prototype, { getContext: contextOfElement })
  listening.abort()
  listening = new AbortController()
  const { signal } = listening
  window.addEventListener = (
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ) => listen(type, listener, { signal, ...(typeof options === 'object' ? options : { capture: options === true }) })
  measure(element('figure'), { clientWidth: SIZE.width, clientHeight: SIZE.height })
  return { media }
}

/** The view of the page that runs. */
let shown: View | undefined

/** The timers of pages. */
const timers = new Set<ReturnType<typeof setTimeout>>()
const begin = setTimeout
Object.assign(globalThis, {
  setTimeout: (...args: Parameters<typeof setTimeout>) => {
    const timer = begin(...args)
    timers.add(timer)
    return timer
  },
})

/** Ends the page that runs. Its timers must not outlive the document. */
function end(): void {
  for (const timer of timers) clearTimeout(timer)
  timers.clear()
  shown?.dispose()
}
afterAll(end)

/** Starts the page, at a link, and returns what its controls act on once `main.ts` has run. */
export async function wholePage(link: LinkInput | string = { circles: FIVE }) {
  vi.resetModules()
  end()
  const { media } = surround()
  const hash = typeof link === 'string' ? link : await encodeLink(link)
  history.replaceState(null, '', hash === '' ? location.pathname : `#${hash}`)
  const { figure } = await import('../../web/app/main.ts')
  const { store, editing, view, actions } = figure
  shown = view
  /** Opens circles with columns of a file. */
  const open = async (circles: Float64Array<ArrayBuffer>, columns: Attributes['columns'] = []) => {
    const attributes = { columns, ids: [], heights: [], collection: '' }
    const how = await actions.opening.open(async () => ({ circles, dataSet: '', isEdited: false, attributes }))
    expect([how, store.get().problem]).toEqual(['opened', ''])
    await quiet()
  }
  /** Opens a panel by its button. */
  const panel = async (id: string) => {
    if (element(id).hidden) buttonOf(id).click()
    await soon(() => expect(controls(element(id)).has('Close')).toBe(true))
    await quiet()
    return element(id)
  }
  const circle = (id: number) => editing.circles.get(id)
  return { media, actions, store, editing, view, open, panel, circle }
}
