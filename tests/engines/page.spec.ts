// SPDX-License-Identifier: GPL-3.0-or-later
// The essential functions of the page in engines other than Chromium.
import { existsSync, readFileSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { expect, test } from '@playwright/test'
import { loadFiles } from '../../web/lib/files.ts'
import type { Circle, Edit, Point } from '../../web/lib/index.ts'
import { decodeLink, encodeLink } from '../../web/lib/link.ts'
import { loadCircleVoronoi } from '../../web/lib/wasm/loader.ts'
import { boundingBox, fitted, toScreen } from '../../web/view/camera.ts'
import { circlesOfText } from '../../web/view/circle-text.ts'
import { dataSet, PADDING } from '../e2e/page.ts'
import { type Engine, until } from './engine.ts'
import { ENGINES } from './engines.ts'
import { openWebKit } from './webkit.ts'

const BRONZE = dataSet('bronzefilter')
const START = dataSet('start')
const BRONZE_LINK = await encodeLink({ dataSet: 'bronzefilter' })
const FIVE = [
  [0, 0, 1],
  [6, 0, 1],
  [0, 8, 1],
  [9, 9, 2],
  [3, 3, 0.5],
] as const

/** The page in an engine. */
class Page {
  readonly engine: Engine

  constructor(engine: Engine) {
    this.engine = engine
  }

  text(selector: string): Promise<string> {
    return this.engine.evaluate((selector) => document.querySelector(selector)?.textContent ?? '', selector)
  }

  async says(selector: string, part: string): Promise<string> {
    return until(
      `"${part}" in ${selector}`,
      () => this.text(selector),
      (text) => text.includes(part),
    )
  }

  /** The value of a field of the inspector. */
  value(field: 'x' | 'y' | 'r'): Promise<number> {
    return this.engine.evaluate((id) => Number(document.querySelector<HTMLInputElement>(id)?.value), `#field-${field}`)
  }

  address(): Promise<string> {
    return this.engine.evaluate(() => location.href)
  }

  /** The position of a point of the plane while all given circles are visible. */
  async locate(circles: Float64Array, point: Point): Promise<Point> {
    // In a low window the tools have two columns.
    const { rail, ...size } = await this.engine.evaluate(() => ({
      width: innerWidth,
      height: innerHeight,
      rail: document.querySelector('#rail')?.getBoundingClientRect().right ?? 0,
    }))
    return toScreen(fitted(boundingBox(circles), size, { ...PADDING, left: rail + 16 }), size, point)
  }

  /**
   * Clicks the button with a name once it is visible. The driver locates it, because a download bar may shrink the
   * window.
   */
  async click(name: string): Promise<void> {
    const find = (name: string) => {
      const nameOf = (button: Element) => button.getAttribute('aria-label') ?? button.textContent?.trim()
      return [...document.querySelectorAll('button')].find(
        (button) => nameOf(button) === name && button.getClientRects().length > 0,
      )
    }
    await until(`button ${name}`, () => this.engine.click(find, name), Boolean)
  }

  /** Chooses a file in the file input that matches a selector, once it exists. */
  async choose(selector: string, path: string): Promise<void> {
    const isThere = (selector: string) => document.querySelector(selector) !== null
    await until(selector, () => this.engine.evaluate(isThere, selector), Boolean)
    await this.engine.choose(selector, path)
  }

  /** The painted colors at these pixels: red, green, blue. */
  colors(points: readonly Point[]): Promise<readonly (readonly number[])[]> {
    return this.engine.evaluate((points) => {
      const canvas = document.querySelector('#figure canvas') as HTMLCanvasElement
      const context = canvas.getContext('2d') as CanvasRenderingContext2D
      const [across, down] = [canvas.width / canvas.clientWidth, canvas.height / canvas.clientHeight]
      return points.map(({ x, y }) => [...context.getImageData(x * across, y * down, 1, 1).data.slice(0, 3)])
    }, points)
  }
}

for (const [name, openEngine] of ENGINES) {
  test.describe(name, () => {
    test('loads, drags, undoes, opens, saves and links', async ({ baseURL }, testInfo) => {
      const engine = await openEngine()
      try {
        const page = new Page(engine)
        await engine.open(`${baseURL}/#${BRONZE_LINK}`)
        await page.says('#status', '678 circles · 1,339 vertices · 2,016 edges')
        // The page is painted when a circle's color differs from the paper.
        const center = (i: number) =>
          page.locate(BRONZE, { x: BRONZE[3 * i] as number, y: BRONZE[3 * i + 1] as number })
        const from = await center(650)
        const isPainted = ([disc, paper]: readonly (readonly number[])[]) => String(disc) !== String(paper)
        await until('painted', () => page.colors([from, { x: 5, y: 200 }]), isPainted)

        await engine.drag([from, { x: from.x + 5, y: from.y }, { x: from.x + 9, y: from.y - 4 }])
        await page.says('#inspector', 'Circle 650')
        // The address contains the circle where it was dropped.
        const isLinked = (address: string) => address.includes('#v1.') && !address.endsWith(BRONZE_LINK)
        const link = await until('linked', () => page.address(), isLinked)
        const { dataSet, edits } = await decodeLink(new URL(link).hash)
        expect(dataSet).toBe('bronzefilter')
        expect(edits).toMatchObject([{ kind: 'replace', id: 650 }])
        const edit = edits?.[0] as Extract<Edit, { kind: 'replace' }> & { circle: Circle }
        expect(edit.circle.x).toBeGreaterThan(BRONZE[1950] as number)
        await engine.press('Control+z')
        await until(
          'undone',
          () => page.value('x'),
          (x) => x === BRONZE[1950],
        )

        await page.click('Files')
        const csv = testInfo.outputPath('five.csv')
        writeFileSync(csv, FIVE.join('\n'))
        await page.choose('#files input[type=file]', csv)
        await page.says('#status', '5 circles')
        await page.click('CSV')
        const saved = `${engine.downloads}/five.csv`
        await until('saved', async () => existsSync(saved) && readFileSync(saved, 'utf8').length > 0, Boolean)
        expect([...circlesOfText(readFileSync(saved, 'utf8'))]).toEqual(FIVE.flat())
        await page.click('JSON')
        const json = `${engine.downloads}/five.json`
        await until('saved', async () => existsSync(json) && readFileSync(json, 'utf8').endsWith('}\n'), Boolean)
        const diagram = (await loadFiles()).readDiagram(readFileSync(json, 'utf8'))
        expect((await loadCircleVoronoi()).certify(diagram).certified).toBe(true)
        await page.click('Share')
        await page.click('Copy link')
        await page.says('#toast', 'The link is in the clipboard.')

        // The circle is where it was dragged to. A download bar may have shrunk the window.
        await engine.open('about:blank')
        await engine.open(link)
        await page.says('#status', '678 circles')
        await engine.drag([await page.locate(BRONZE, edit.circle)])
        await page.says('#inspector', 'Circle 650')
        // The edits of a link follow its circles.
        const isMoved = (x: number) => Math.abs(x - edit.circle.x) < 0.005
        await until('moved', () => page.value('x'), isMoved)
        expect(await page.text('#problem')).toBe('')
      } finally {
        await engine.close()
      }
    })
  })
}

// Other engines run modules only once the style sheets are loaded.
test('in WebKit a finger drags each circle of the first scene, also from beside it', async ({ baseURL }) => {
  const engine = await openWebKit()
  try {
    const page = new Page(engine)
    const link = await encodeLink({ dataSet: 'start' })
    await engine.open(`${baseURL}/#${link}`)
    await page.says('#status', '8 circles')
    // The driver of WebKit has no fingers, so the events of its mouse become theirs.
    await engine.evaluate(() => {
      for (const name of ['pointerdown', 'pointermove', 'pointerup'] as const) {
        const change = (event: PointerEvent) => Object.defineProperty(event, 'pointerType', { value: 'touch' })
        addEventListener(name, change, { capture: true })
      }
    })
    const ids = Array.from({ length: START.length / 3 }, (_, i) => i)
    const moved = async () => {
      const { edits = [], circles } = await decodeLink(new URL(await page.address()).hash)
      // A link with many edits has the circles instead.
      if (circles !== undefined) return ids.filter((i) => circles[3 * i] !== START[3 * i])
      return edits.map((edit) => (edit.kind === 'replace' ? edit.id : -1)).sort((one, other) => one - other)
    }
    for (const i of ids) {
      const [x, y, r] = START.slice(3 * i, 3 * i + 3) as unknown as [number, number, number]
      const rim = await page.locate(START, { x, y: y + r })
      // A finger beside the rim, where a mouse would pan.
      const beside = { x: rim.x, y: rim.y - 8 }
      await engine.drag([beside, { x: beside.x + 6, y: beside.y }, { x: beside.x + 12, y: beside.y }])
      await until(`circle ${i} dragged`, moved, (edited) => edited.length === i + 1)
      // The card would cover a circle.
      await page.click('Deselect')
    }
    expect(await moved()).toEqual(ids)
  } finally {
    await engine.close()
  }
})

test('WebKit paints in the colors of style sheets that come after the page has begun', async ({ baseURL }) => {
  let hasBegun = () => {}
  const begun = new Promise<void>((resolve) => {
    hasBegun = resolve
  })
  const server = createServer(async ({ url = '/' }, response) => {
    // This is the first request of the page's own script.
    if (url.endsWith('.csv')) hasBegun()
    if (url.endsWith('.css')) await begun
    const answer = await fetch(baseURL + url, { headers: { 'Accept-Encoding': 'identity' } })
    response.writeHead(answer.status, { 'Content-Type': answer.headers.get('Content-Type') ?? 'text/plain' })
    response.end(Buffer.from(await answer.arrayBuffer()))
  })
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve))
  const engine = await openWebKit()
  try {
    const page = new Page(engine)
    await engine.open(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`)
    await page.says('#status', '8 circles')
    const center = await page.locate(START, { x: START[0] as number, y: START[1] as number })
    const isPainted = ([disc, paper]: readonly (readonly number[])[]) => String(disc) !== String(paper)
    await until('painted', () => page.colors([center, { x: 5, y: 200 }]), isPainted)
  } finally {
    await engine.close()
    server.close()
  }
})
