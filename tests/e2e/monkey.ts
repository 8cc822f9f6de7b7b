// SPDX-License-Identifier: GPL-3.0-or-later
import type { CDPSession, Page } from '@playwright/test'
import { randomNumbers } from '../../web/app/random-numbers.ts'
import type { Point } from '../../web/lib/index.ts'

const SIZES = [
  { width: 1280, height: 800 },
  { width: 390, height: 780 },
  { width: 568, height: 320 },
  { width: 900, height: 1200 },
] as const
const KEYS = ['Tab', 'Shift+Tab', 'Enter', 'Escape', 'Delete', '+', '-', '0', 'v', 'h', 'a', 's', 'Space', '?'] as const
const ARROWS = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'] as const
const COMMANDS = ['z', 'z', 'z', 'Shift+z', 'Shift+z', 'y', 'a', 'd', 'c', 'v', 'x'] as const
const FILES = [
  ['three.csv', 'x,y,r\n0,0,1\n6,0,1\n0,8,1\n'],
  ['ties.csv', Array.from({ length: 64 }, (_, k) => `${k % 8},${Math.floor(k / 8)},0.25`).join('\n')],
  ['nested.csv', Array.from({ length: 40 }, (_, k) => `${k % 3},${k % 5},${1 + k / 8}`).join('\n')],
  ['one.json', '[[1, 2, 3]]'],
  ['empty.csv', ''],
  ['negative.csv', '0,0,-1'],
  ['damaged.json', '{"circles": [[0,'],
  [
    'people.csv',
    Array.from({ length: 30 }, (_, k) => `${(7 * k) % 31},${(11 * k) % 29},0.5,${1 + (k % 9)}`).join('\n'),
  ],
] as const
/** Regions around all circles of some data sets, around part of others, and far from all. */
const REGIONS = [
  ['square.wkt', 'POLYGON ((-4 -4, 12 -4, 12 12, -4 12))'],
  ['holes.wkt', 'POLYGON ((0 0, 60 0, 60 60, 30 40, 0 60), (5 5, 9 5, 7 9), (20 10, 30 10, 30 20, 20 20))'],
  ['two.wkt', 'MULTIPOLYGON (((0 0, 6 0, 3 7)), ((8 0, 500 0, 500 300, 8 300)))'],
  ['bow.wkt', 'POLYGON ((0 0, 9 9, 9 0, 0 9))'],
] as const
/** Above this number, copies of copies would soon fill the memory. */
const MOST_CIRCLES = 3000

/** The inputs of a page that the monkey uses. Only Playwright's page can change the color scheme. */
export type Hands = {
  evaluate<Arg, Result>(call: (arg: Arg) => Result, arg: Arg): Promise<Awaited<Result>>
  mouse: Pick<Page['mouse'], 'click' | 'down' | 'move' | 'up' | 'wheel'>
  keyboard: Pick<Page['keyboard'], 'down' | 'press' | 'up'>
  setViewportSize: Page['setViewportSize']
  emulateMedia?: (media: { colorScheme: 'light' | 'dark' }) => Promise<void>
}

/** Keeps the page in which it runs from leaving, from dragging something out and from asking for a file. */
export function stay(): void {
  const leaves = ({ target }: Event) => (target as Element).closest('a, input[type=file]') !== null
  document.addEventListener('click', (event) => leaves(event) && event.preventDefault(), { capture: true })
  document.addEventListener('dragstart', (event) => event.preventDefault(), { capture: true })
}

/** Performs random gestures, keys, tools, files, layers, panels and window sizes from a seed. */
export class Monkey {
  /** The log of actions, the last one at the end. */
  readonly done: string[] = []
  readonly #page: Hands
  readonly #touch: CDPSession | undefined
  readonly #random: () => number
  #size: (typeof SIZES)[number] = SIZES[0]

  /** Without a session of Chromium's protocol, there are no fingers. */
  constructor(page: Hands, seed: number, touch?: CDPSession) {
    this.#page = page
    this.#touch = touch
    this.#random = randomNumbers(seed)
  }

  async act(): Promise<void> {
    const status = await this.#page.evaluate(() => document.querySelector('#status')?.textContent ?? '', undefined)
    const count = Number(/^([\d,]+) circle/.exec(status)?.[1]?.replace(/,/g, ''))
    if (count > MOST_CIRCLES) return this.#do('Introduction', () => this.#choose('introduction'))
    // The actions with their frequencies.
    const acts: readonly (readonly [number, () => Promise<void>])[] = [
      [10, () => this.#drag()],
      [3, () => this.#click()],
      [3, () => this.#wheel()],
      [this.#touch === undefined ? 0 : 5, () => this.#finger()],
      [this.#touch === undefined ? 0 : 2, () => this.#pinch()],
      [8, () => this.#key()],
      [6, () => this.#command()],
      [
        3,
        () => this.#button('#rail button[aria-pressed], #undo, #redo, #view button, #inspector button, #group button'),
      ],
      [2, () => this.#button('#more, #more-tools button')],
      [4, () => this.#layer()],
      [1, () => this.#number()],
      [1, () => this.#file(this.#one(FILES))],
      [1, () => this.#file(this.#one(REGIONS))],
      [1, () => this.#draw()],
      [2, () => this.#region()],
      [1, () => this.#dataSet()],
      [1, () => this.#resize()],
      [this.#page.emulateMedia === undefined ? 0 : 1, () => this.#scheme()],
    ]
    let left = this.#random() * acts.reduce((sum, [weight]) => sum + weight, 0)
    const [, act] = acts.find(([weight]) => {
      left -= weight
      return left < 0
    }) as (typeof acts)[number]
    await act()
    // An open dialog would take all keys and clicks.
    await this.#page.evaluate(() => document.querySelector<HTMLDialogElement>('dialog[open]')?.close(), undefined)
  }

  async #do(what: string, act: () => Promise<unknown>): Promise<void> {
    this.done.push(what)
    await act()
  }

  #one<Item>(items: readonly Item[]): Item {
    return items[Math.floor(this.#random() * items.length)] as Item
  }

  #isTrue(chance: number): boolean {
    return this.#random() < chance
  }

  #point(): Point {
    const { width, height } = this.#size
    return { x: Math.round(width * this.#random()), y: Math.round(height * this.#random()) }
  }

  /** A distant point, or a near one. */
  #near({ x, y }: Point): Point {
    if (this.#isTrue(0.3)) return this.#point()
    return { x: x + Math.round(80 * (this.#random() - 0.5)), y: y + Math.round(80 * (this.#random() - 0.5)) }
  }

  async #drag(): Promise<void> {
    const [from, to] = [this.#point(), this.#point()]
    const held = this.#isTrue(0.3) ? this.#one(['Shift', 'Alt', 'Space']) : undefined
    const button = this.#isTrue(0.1) ? 'middle' : 'left'
    const end = this.#isTrue(0.3) ? this.#near(from) : to
    const during = this.#isTrue(0.2) ? this.#one(['Escape', 'Delete', 'Control+z', '0', 'ArrowUp']) : undefined
    const { mouse, keyboard } = this.#page
    await this.#do(`drag ${JSON.stringify({ from, end, held, button, during })}`, async () => {
      if (held !== undefined) await keyboard.down(held)
      await mouse.move(from.x, from.y)
      await mouse.down({ button })
      await mouse.move(end.x, end.y, { steps: 4 })
      if (during !== undefined) await keyboard.press(during)
      await mouse.move(to.x, to.y, { steps: 2 })
      await mouse.up({ button })
      if (held !== undefined) await keyboard.up(held)
    })
  }

  async #click(): Promise<void> {
    const { x, y } = this.#point()
    const clickCount = this.#isTrue(0.4) ? 2 : 1
    // Avoids buttons that open a dialog of the system.
    await this.#do(`click ${x} ${y} ${clickCount}`, async () => {
      const isFile = await this.#page.evaluate(
        ([x, y]) => document.elementFromPoint(x, y)?.closest('label.button') !== null,
        [x, y] as const,
      )
      if (!isFile) await this.#page.mouse.click(x, y, { clickCount })
    })
  }

  #focusFigure(): Promise<void> {
    return this.#page.evaluate(() => document.querySelector<HTMLElement>('#figure')?.focus(), undefined)
  }

  async #wheel(): Promise<void> {
    const { x, y } = this.#point()
    const delta = Math.round(1200 * (this.#random() - 0.5))
    await this.#do(`wheel ${x} ${y} ${delta}`, async () => {
      await this.#page.mouse.move(x, y)
      await this.#page.mouse.wheel(0, delta)
    })
  }

  #fingers(type: 'touchStart' | 'touchMove' | 'touchEnd' | 'touchCancel', points: readonly Point[]) {
    const touchPoints = points.map(({ x, y }, id) => ({ x: Math.max(x, 0), y: Math.max(y, 0), id }))
    return (this.#touch as CDPSession).send('Input.dispatchTouchEvent', { type, touchPoints })
  }

  async #finger(): Promise<void> {
    const from = this.#point()
    const to = this.#near(from)
    const isTap = this.#isTrue(0.3)
    const last = this.#isTrue(0.15) ? 'touchCancel' : 'touchEnd'
    await this.#do(`finger ${JSON.stringify({ from, to, isTap, last })}`, async () => {
      await this.#fingers('touchStart', [from])
      if (!isTap) {
        await this.#fingers('touchMove', [{ x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }])
        await this.#fingers('touchMove', [to])
      }
      await this.#fingers(last, [])
    })
  }

  async #pinch(): Promise<void> {
    const [one, other] = [this.#point(), this.#point()]
    const [oneTo, otherTo] = [this.#near(one), this.#near(other)]
    await this.#do(`pinch ${JSON.stringify({ one, other, oneTo, otherTo })}`, async () => {
      await this.#fingers('touchStart', [one])
      await this.#fingers('touchStart', [one, other])
      await this.#fingers('touchMove', [oneTo, otherTo])
      await this.#fingers('touchEnd', [])
    })
  }

  async #key(): Promise<void> {
    const isArrow = this.#isTrue(0.5)
    const modifier = isArrow && this.#isTrue(0.5) ? `${this.#one(['Shift', 'Alt', 'Control'])}+` : ''
    const key = modifier + this.#one(isArrow ? ARROWS : KEYS)
    const isOnFigure = this.#isTrue(0.7)
    await this.#do(`key ${key}`, async () => {
      if (isOnFigure) await this.#focusFigure()
      await this.#page.keyboard.press(key)
    })
  }

  async #command(): Promise<void> {
    const key = `Control+${this.#one(COMMANDS)}`
    const times = this.#isTrue(0.2) ? 8 : 1
    await this.#do(`${times} times ${key}`, async () => {
      for (let k = 0; k < times; k++) await this.#page.keyboard.press(key)
    })
  }

  /** Clicks a random existing button. */
  async #button(selector: string): Promise<void> {
    const choice = this.#random()
    await this.#do(`button ${selector} ${choice}`, () =>
      this.#page.evaluate(
        ([selector, choice]) => {
          const buttons = [...document.querySelectorAll<HTMLButtonElement>(selector)].filter((button) =>
            button.checkVisibility(),
          )
          buttons[Math.floor(choice * buttons.length)]?.click()
        },
        [selector, choice] as const,
      ),
    )
  }

  async #layer(): Promise<void> {
    const choice = this.#random()
    if (this.#isTrue(0.25)) return this.#select('#cell-colors', choice)
    await this.#do(`layer ${choice}`, () =>
      this.#page.evaluate((choice) => {
        const boxes = [...document.querySelectorAll<HTMLInputElement>('#layers input[type="checkbox"]')]
        boxes[Math.floor(choice * boxes.length)]?.click()
      }, choice),
    )
  }

  async #number(): Promise<void> {
    const choice = this.#random()
    const value = this.#one(['0', '1', '-1', '0.001', '7.5', '1e9', ''])
    await this.#do(`number ${choice} ${value}`, () =>
      this.#page.evaluate(
        ([choice, value]) => {
          const fields = [
            ...document.querySelectorAll<HTMLInputElement>('#inspector input, #layers input[type="number"]'),
          ]
          const field = fields[Math.floor(choice * fields.length)]
          if (field === undefined) return
          // A picker of colors gives nothing else.
          field.value = field.type === 'color' ? '#c04020' : value
          field.dispatchEvent(new Event('change', { bubbles: true }))
        },
        [choice, value] as const,
      ),
    )
  }

  async #file(file: readonly [name: string, text: string]): Promise<void> {
    await this.#do(`file ${file[0]}`, () =>
      this.#page.evaluate(([name, text]) => {
        const dataTransfer = new DataTransfer()
        dataTransfer.items.add(new File([text], name))
        document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }))
      }, file),
    )
  }

  /** Draws a polygon of a few corners, which may cross itself. */
  async #draw(): Promise<void> {
    const corners = Array.from({ length: 3 + Math.floor(3 * this.#random()) }, () => this.#point())
    const end = this.#one(['Enter', 'Enter', 'Enter', 'Escape'])
    await this.#do(`draw ${JSON.stringify(corners)} ${end}`, async () => {
      await this.#focusFigure()
      await this.#page.keyboard.press('p')
      for (const { x, y } of corners) {
        await this.#page.mouse.move(x, y)
        await this.#page.mouse.click(x, y)
      }
      await this.#focusFigure()
      await this.#page.keyboard.press(end)
    })
  }

  /** Sets areas, or clicks a button of the panel. */
  async #region(): Promise<void> {
    const choice = this.#random()
    await this.#do('Region', () =>
      this.#page.evaluate(() => {
        const button = document.querySelector<HTMLButtonElement>('[aria-controls="region"]')
        if (button?.getAttribute('aria-expanded') !== 'true') button?.click()
      }, undefined),
    )
    if (this.#isTrue(0.3)) await this.#button('#region .choices button')
    else await this.#select('#areas', choice)
  }

  async #dataSet(): Promise<void> {
    const id = this.#one(['introduction', 'introduction', 'bronzefilter', 'spruces', 'waka', 'random'])
    await this.#do(id, () => this.#choose(id))
  }

  #choose(id: string): Promise<void> {
    return this.#page.evaluate((id) => {
      const menu = document.querySelector('#data-set') as HTMLSelectElement
      menu.value = id
      menu.dispatchEvent(new Event('change', { bubbles: true }))
    }, id)
  }

  async #select(selector: string, choice: number): Promise<void> {
    await this.#do(`${selector} ${choice}`, () =>
      this.#page.evaluate(
        ([selector, choice]) => {
          const menu = document.querySelector<HTMLSelectElement>(selector)
          if (menu === null) return
          menu.selectedIndex = Math.floor(choice * menu.length)
          menu.dispatchEvent(new Event('change', { bubbles: true }))
        },
        [selector, choice] as const,
      ),
    )
  }

  async #resize(): Promise<void> {
    const size = this.#one(SIZES)
    this.#size = size
    await this.#do(`size ${size.width} ${size.height}`, () => this.#page.setViewportSize(size))
  }

  async #scheme(): Promise<void> {
    const colorScheme = this.#one(['light', 'dark'] as const)
    await this.#do(colorScheme, async () => this.#page.emulateMedia?.({ colorScheme }))
  }
}
