// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the tutorial's own figures interactive: readers drag circles and points or move them by keys, and a slider or a
// player selects the state.
import type { Circle, CircleVoronoi, Point } from '../lib/index.ts'
import { encodeLink } from '../lib/link.ts'
import type { RegionShape } from '../lib/regions/region-shape.ts'
import { loadLibrary } from '../lib/wasm/loader.ts'
import type { Regions } from '../lib/wasm/regions.ts'
import { HEIGHT, heightOf, KINDS, type KindName, type Scene, WIDTH } from './drawn/kinds.ts'

/** The description of a figure in a chapter, as scripts/texts/blocks.mjs writes it. */
export interface DrawnSpec {
  readonly kind: KindName
  readonly circles: readonly (readonly [number, number, number])[]
  readonly point?: readonly [number, number]
  readonly view: readonly [number, number, number]
  readonly at: number
  readonly region?: RegionShape
}

/** Distance of one key press, relative to the visible width or to the range of the slider. */
const STEP = 1 / 80
/** Milliseconds from one event to the next during playback. */
const PACE = 1400
/** Smallest size of a drag target, in CSS pixels. */
const GRAB = 22
const SVG = 'http://www.w3.org/2000/svg'
const KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

export async function bringToLife(page: Document): Promise<void> {
  const figures = [...page.querySelectorAll<HTMLElement>('[data-drawn]')]
  const library = await loadLibrary()
  const specs = figures.map((figure): DrawnSpec => JSON.parse(figure.dataset.drawn as string))
  for (const [k, figure] of figures.entries()) {
    const spec = specs[k] as DrawnSpec
    if (KINDS[spec.kind].hasRegions)
      void import('../lib/regions.ts')
        .then(({ loadRegions }) => loadRegions())
        .then((regions) => new Drawn(figure, spec, library, regions))
    else new Drawn(figure, spec, library)
  }
}

export function sceneOf({ circles, point, view, region }: DrawnSpec): Scene {
  return {
    circles: circles.map(([x, y, r]) => ({ x, y, r })),
    point: point && { x: point[0], y: point[1] },
    view,
    region,
  }
}

class Drawn {
  readonly #kind: KindName
  readonly #library: CircleVoronoi
  readonly #regions: Regions | undefined
  readonly #svg: SVGSVGElement
  readonly #content: SVGGElement
  readonly #handles: SVGGElement
  readonly #told: HTMLOutputElement
  readonly #slider: HTMLInputElement
  readonly #play: HTMLButtonElement | null
  readonly #link: HTMLAnchorElement | null
  #scene: Scene
  #value: number
  #isAsked = false
  #playing: number | undefined

  constructor(figure: HTMLElement, spec: DrawnSpec, library: CircleVoronoi, regions?: Regions) {
    this.#kind = spec.kind
    this.#library = library
    this.#regions = regions
    this.#scene = sceneOf(spec)
    this.#value = spec.at
    this.#told = figure.querySelector('output.told') as HTMLOutputElement
    this.#slider = figure.querySelector('input[type=range]') as HTMLInputElement
    this.#play = figure.querySelector('button.play')
    this.#link = figure.querySelector('a.open')
    const picture = figure.querySelector('.picture') as HTMLElement
    const { ownerDocument: page } = figure
    this.#svg = page.createElementNS(SVG, 'svg')
    this.#svg.classList.add('drawn')
    this.#svg.setAttribute('viewBox', `0 0 ${WIDTH} ${heightOf(spec.kind)}`)
    this.#svg.setAttribute('role', 'group')
    this.#svg.setAttribute('aria-label', (picture.querySelector('img') as HTMLImageElement).alt)
    this.#content = page.createElementNS(SVG, 'g')
    this.#handles = page.createElementNS(SVG, 'g')
    this.#svg.append(this.#content, this.#handles)
    this.#makeHandles(page)
    this.#listen(figure)
    this.#draw()
    picture.replaceChildren(this.#svg)
    // Text keeps the size of the surrounding text when the picture scales.
    new ResizeObserver(() => this.#fit()).observe(this.#svg)
  }

  #makeHandles(page: Document): void {
    const { circles, point } = this.#scene
    const { grip } = KINDS[this.#kind]
    /** `push` moves by a key in a direction. */
    const make = (
      name: string,
      move: (to: Point) => void,
      placeOf: () => Point,
      push = (way: readonly [number, number]) => {
        const step = this.#scene.view[2] * STEP
        const { x, y } = placeOf()
        move(this.#within({ x: x + way[0] * step, y: y + way[1] * step }))
      },
    ) => {
      const handle = page.createElementNS(SVG, 'circle')
      handle.classList.add('handle')
      handle.setAttribute('tabindex', '0')
      handle.setAttribute('role', 'button')
      handle.setAttribute('aria-label', `${name}: drag it, or press arrow keys`)
      // Chromium scrolls the page although the shape has `touch-action: none`.
      handle.addEventListener('touchstart', (event) => event.preventDefault(), { passive: false })
      handle.addEventListener('pointerdown', (event) => {
        handle.setPointerCapture(event.pointerId)
        const [from, at] = [this.#planeAt(event), placeOf()]
        const drag = (moved: PointerEvent) => {
          const to = this.#planeAt(moved)
          move(this.#within({ x: at.x + to.x - from.x, y: at.y + to.y - from.y }))
        }
        handle.addEventListener('pointermove', drag)
        handle.addEventListener('lostpointercapture', () => handle.removeEventListener('pointermove', drag), {
          once: true,
        })
      })
      handle.addEventListener('keydown', (event) => {
        const way = KEYS[event.key]
        if (way === undefined) return
        event.preventDefault()
        push(way)
      })
      this.#handles.append(handle)
    }
    for (const i of circles.keys()) {
      make(
        `Circle ${i}`,
        ({ x, y }) => this.#change({ circles: this.#scene.circles.map((c, k) => (k === i ? { ...c, x, y } : c)) }),
        () => this.#scene.circles[i] as Circle,
      )
    }
    if (grip !== undefined) {
      make(
        'Point on the border',
        (to) => this.#show(grip.valueAt(this.#scene, to)),
        () => grip.at(this.#scene, this.#value),
        // Each arrow key moves the point along its line, in whatever direction that runs.
        ([x, y]) => this.#show(this.#value + (x + y) * STEP * Number(this.#slider.max)),
      )
    }
    if (point === undefined) return
    make(
      'Point',
      (to) => this.#change({ point: to }),
      () => this.#scene.point as Point,
    )
  }

  #listen(figure: HTMLElement): void {
    this.#slider.addEventListener('input', () => this.#show(this.#slider.valueAsNumber))
    figure.querySelector('button.back')?.addEventListener('click', () => this.#show(Math.ceil(this.#value) - 1))
    figure.querySelector('button.forth')?.addEventListener('click', () => this.#show(Math.floor(this.#value) + 1))
    this.#play?.addEventListener('click', () => (this.#playing === undefined ? this.#start() : this.#pause()))
  }

  #change(change: Partial<Scene>): void {
    this.#scene = { ...this.#scene, ...change }
    this.#pause()
    this.#ask()
    const circles = this.#scene.circles.map(({ x, y, r }) => [x, y, r])
    const link = this.#link
    if (link === null) return
    const [address] = link.href.split('#') as [string]
    void encodeLink({ circles }).then((text) => {
      link.href = `${address}#${text}`
    })
  }

  /** Shows the state at a slider value. */
  #show(value: number): void {
    this.#pause()
    this.#value = Math.min(Math.max(value, 0), Number(this.#slider.max))
    this.#draw()
  }

  #start(): void {
    const last = Number(this.#slider.max)
    if (this.#value >= last) this.#value = 0
    if (this.#play !== null) this.#play.textContent = 'Pause'
    const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches
    const from = this.#value
    let begun: number | undefined
    const go = (now: number) => {
      begun ??= now
      const value = Math.min(from + (now - begun) / PACE, last)
      this.#value = isStill ? Math.floor(value) : resting(value)
      this.#draw()
      if (value >= last) return this.#pause()
      this.#playing = requestAnimationFrame(go)
    }
    this.#playing = requestAnimationFrame(go)
  }

  #pause(): void {
    if (this.#playing === undefined) return
    cancelAnimationFrame(this.#playing)
    this.#playing = undefined
    if (this.#play !== null) this.#play.textContent = 'Play'
  }

  #ask(): void {
    if (this.#isAsked) return
    this.#isAsked = true
    requestAnimationFrame(() => {
      this.#isAsked = false
      this.#draw()
    })
  }

  #draw(): void {
    const kind = KINDS[this.#kind]
    const { last, step } = kind.range(this.#scene, this.#library, this.#regions)
    this.#slider.max = `${last}`
    this.#slider.step = `${step}`
    this.#value = Math.min(this.#value, last)
    this.#slider.value = `${Math.floor(this.#value * 1e6) / 1e6}`
    const { content, told } = kind.draw(this.#scene, this.#value, this.#library, this.#regions)
    this.#content.innerHTML = content
    if (this.#told.value !== told) this.#told.value = told
    this.#slider.setAttribute('aria-valuetext', told)
    this.#placeHandles()
  }

  #placeHandles(): void {
    const { circles, point, view } = this.#scene
    const scale = WIDTH / view[2]
    const least = GRAB * this.#unit
    const grip = KINDS[this.#kind].grip?.at(this.#scene, this.#value)
    const points = [grip, point].flatMap((place) => (place === undefined ? [] : [{ ...place, r: 0 }]))
    const places = [...circles, ...points]
    for (const [k, { x, y, r }] of places.entries()) {
      const handle = this.#handles.children[k] as SVGCircleElement
      handle.setAttribute('cx', `${WIDTH / 2 + (x - view[0]) * scale}`)
      handle.setAttribute('cy', `${HEIGHT / 2 - (y - view[1]) * scale}`)
      handle.setAttribute('r', `${Math.max(r * scale, least)}`)
    }
  }

  /** The length of one CSS pixel, in units of the picture. */
  get #unit(): number {
    const { width } = this.#svg.getBoundingClientRect()
    return width === 0 ? 1 : WIDTH / width
  }

  #fit(): void {
    this.#svg.style.setProperty('--unit', `${this.#unit}`)
    this.#placeHandles()
  }

  #planeAt(event: PointerEvent): Point {
    const { left, top } = this.#svg.getBoundingClientRect()
    const { view } = this.#scene
    const scale = WIDTH / view[2]
    const unit = this.#unit
    return {
      x: view[0] + ((event.clientX - left) * unit - WIDTH / 2) / scale,
      y: view[1] - ((event.clientY - top) * unit - HEIGHT / 2) / scale,
    }
  }

  /** Clamps a dragged point to the picture. */
  #within({ x, y }: Point): Point {
    const { view } = this.#scene
    const [halfX, halfY] = [view[2] / 2, (view[2] / 2) * (HEIGHT / WIDTH)]
    return {
      x: Math.min(Math.max(x, view[0] - halfX), view[0] + halfX),
      y: Math.min(Math.max(y, view[1] - halfY), view[1] + halfY),
    }
  }
}

/** Easing that rests at each event for half of the time. */
function resting(value: number): number {
  const part = value - Math.floor(value)
  return Math.floor(value) + Math.max(0, 2 * part - 1)
}
