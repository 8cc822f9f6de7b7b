// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures made without a browser equal pictures of a browser: of the element, of the playground, and of the program.
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, type Page, test } from '@playwright/test'
import { encodeLink, type LinkInput } from '../../web/lib/link.ts'
import type { PictureOptions } from '../../web/picture/index.ts'
import { ROOT } from './project.mjs'
import { INLINE_POLICY, type Server, serve } from './static-server.ts'

const { renderSVG } = (await import(`${ROOT}dist/picture/index.js`)) as {
  renderSVG(state: LinkInput | string, options?: PictureOptions): Promise<string>
}
const PROGRAM = join(ROOT, 'dist/cli/circle-voronoi.js')
const SIZE = { width: 500, height: 340 }
/** Circles with a hidden one, overlaps, and an unbounded cell. */
const CIRCLES = [
  [0, 0, 2],
  [10, 0, 1],
  [5, 8, 1.5],
  [9, 6, 1],
  [5, 4, 0.5],
  [5.1, 8.2, 0.3],
  [1, 1.5, 1.2],
]
const REGION = {
  type: 'Polygon',
  coordinates: [
    [
      [-1, -2],
      [11, -1],
      [10, 9],
      [2, 10],
    ],
    [
      [4, 1],
      [6, 1],
      [6, 3],
    ],
  ],
} as const
const layers = (...names: string[]) => Object.fromEntries(names.map((name) => [name, true]))

const STATES: Readonly<Record<string, LinkInput>> = {
  'circles alone': { circles: CIRCLES },
  'a view': { circles: CIRCLES, view: { x: 4, y: 3, span: 5 } },
  'no circle': { circles: [] },
  'layers of the diagram': {
    circles: CIRCLES,
    layers: { ...layers('hull', 'dual', 'delaunay', 'ordinary', 'power', 'hidden', 'largestDisc'), cells: 'degree' },
  },
  'a path, merged vertices and cells at a distance': {
    circles: CIRCLES,
    layers: { path: { from: { x: -1, y: 5 }, to: { x: 11, y: 3 } }, nearZero: 0.4, maxDistance: 1.5, cells: 'gap' },
  },
  'layers of the method': {
    circles: CIRCLES,
    layers: { ...layers('samples', 'sampleGraph', 'antipodalDiscs', 'directedEdges', 'missedEdges'), cells: 'none' },
  },
  'a region and areas as colors': { circles: CIRCLES, region: REGION, layers: { cells: 'area' } },
  'given areas': { circles: CIRCLES.slice(0, 5), region: REGION, areas: [1, 2, 1, 3, 1] },
  'a box whose opposite sides are glued together': {
    circles: CIRCLES,
    lattice: { a: [12, 0], b: [3, 10] },
    layers: { cells: 'degree', dual: true },
  },
  'a circle that an edit moves out of the box': {
    circles: CIRCLES,
    lattice: { a: [12, 0], b: [3, 10] },
    edits: [{ kind: 'replace', id: 1, circle: { x: 10, y: -2, r: 1 } }],
  },
  'names, and colors in any notation of CSS': {
    circles: CIRCLES,
    attributes: {
      properties: [
        ...['rebeccapurple', 'rgb(10% 20% 30% / 0.5)', 'hsl(120deg 30% 40%)', 'rgb(1 2)'],
        ...['oklch(60% 0.15 50)', 'color-mix(in srgb, red, blue)', 'currentcolor'],
      ].map((color) => JSON.stringify({ color, name: `In ${color}` })),
      ids: CIRCLES.map(() => ''),
      heights: CIRCLES.map(() => ''),
      collection: '',
    },
  },
  'circles after edits': {
    circles: CIRCLES,
    edits: [
      { kind: 'remove', id: 1 },
      { kind: 'insert', circle: { x: 12, y: 3, r: 0.7 } },
      { kind: 'replace', id: 4, circle: { x: 6, y: 3, r: 0.9 } },
    ],
  },
  'names, colors, axes and a grid': {
    circles: CIRCLES,
    attributes: {
      properties: ['{"name":"A & <B>"}', '{"fill":"#abcdef"}', '{"name":"漢字"}', '{"n":1}', '{}', '{}', '{}'],
      ids: [],
      heights: [],
      collection: '',
    },
    colors: '0123450',
    layers: layers('grid'),
  },
  'a mosaic': {
    circles: CIRCLES,
    region: REGION,
    layers: { fullColor: true, edges: false, vertices: false },
  },
  'names alone': { circles: CIRCLES, names: ['A', '', 'B', '', '', 'C', ''], layers: { labels: true } },
  'names that are not shown': { circles: CIRCLES, names: ['A', '', 'B', '', '', 'C', ''], layers: { labels: false } },
  'a step of the method': { circles: CIRCLES, step: 40, layers: { dual: true } },
  'a step of flips': { circles: CIRCLES, step: 3, method: 'auto' },
  'the last step': { circles: CIRCLES, step: 100_000 },
}

let server: Server
test.beforeAll(async () => {
  server = await serve(ROOT, `${INLINE_POLICY}; style-src 'self' 'unsafe-inline'`)
})
test.afterAll(() => server.close())

/** Opens a page with an element of the picture's size. */
async function openElement(page: Page): Promise<void> {
  await page.route(`${server.address}picture.html`, (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<!doctype html><meta name="color-scheme" content="light dark">
        <script type="module" src="dist/element/index.js"></script>
        <circle-voronoi style="width: ${SIZE.width}px; height: ${SIZE.height}px" circles="[]"></circle-voronoi>`,
    }),
  )
  await page.goto(`${server.address}picture.html`)
}

for (const scheme of ['light', 'dark'] as const) {
  test(`a picture in Node is that of an element, byte for byte: ${scheme}`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme })
    await openElement(page)
    for (const [name, state] of Object.entries(STATES)) {
      const shown = await page.evaluate(async (json) => {
        const state: LinkInput = JSON.parse(json)
        const figure = document.querySelector('circle-voronoi') as HTMLElementTagNameMap['circle-voronoi']
        await figure.setState({ layers: {}, ...state, step: undefined })
        // The edits of a state are applied once its circles are there.
        if (state.edits !== undefined) await figure.updateComplete
        if (state.step !== undefined) await figure.setState(state)
        return figure.toSVG()
      }, JSON.stringify(state))
      expect(await renderSVG(state, { ...SIZE, scheme }), name).toBe(shown)
      expect(shown, name).toMatch(/^<svg/)
    }
  })
}

test('a picture has the names of circles and their colors', async () => {
  const named = await renderSVG(STATES['names, colors, axes and a grid'] as LinkInput)
  for (const text of ['>A &#38; &#60;B&#62;</text>', '>漢字</text>', '#abcdef', '>10</text>'])
    expect(named).toContain(text)
  expect(await renderSVG(STATES['names alone'] as LinkInput)).toContain('>A</text>')
  expect(await renderSVG(STATES['names that are not shown'] as LinkInput)).not.toContain('<text')
})

test('a picture in Node is what the playground saves of a link', async ({ page, baseURL }) => {
  const view = { x: 5, y: 4, span: 9 }
  const link = await encodeLink({ circles: CIRCLES, view, layers: { hull: true, power: true }, region: REGION })
  await page.goto(`${baseURL}/#${link}`)
  await expect(page.locator('#status')).toContainText('edges')
  await page.getByRole('button', { name: 'Files', exact: true }).click()
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'SVG' }).click()])
  const svg = readFileSync(await saved.path(), 'utf8').replace(/<metadata.*<\/metadata>\n/, '')
  const { width, height } = page.viewportSize() as { width: number; height: number }
  expect(await renderSVG(link, { width, height })).toBe(svg)
  // The program draws the same from the address.
  const drawn = run('picture', `${baseURL}/#${link}`, '--size', `${width}x${height}`)
  expect(drawn).toEqual({ status: 0, stdout: svg, stderr: '' })
})

test('the program draws links to data sets and families, and files', async ({ baseURL }) => {
  const cities = await encodeLink({ dataSet: 'cities', edits: [{ kind: 'remove', id: 3 }] })
  const drawn = run('picture', `${baseURL}/embed.html#${cities}`)
  expect(drawn).toMatchObject({ status: 0, stderr: '' })
  // The picture is clipped to its region.
  expect(drawn.stdout).toContain('<clipPath')
  expect(run('picture', `#${cities}`)).toEqual({
    status: 2,
    stdout: '',
    stderr:
      'circle-voronoi: The link names the data set "cities" of the playground: pass its whole address, https://.../#v1...\n',
  })
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-picture-'))
  const file = (name: string, text: string) => {
    writeFileSync(join(folder, name), text)
    return join(folder, name)
  }
  const csv = CIRCLES.map((circle) => `${circle.join()}\n`).join('')
  const svg = await renderSVG({ circles: CIRCLES })
  const link = await encodeLink({ circles: CIRCLES })
  expect(run('picture', file('a.csv', `x,y,r\n${csv}`)).stdout).toBe(svg)
  expect(run('picture', file('a.json', JSON.stringify(CIRCLES))).stdout).toBe(svg)
  expect(run('picture', file('link.txt', `${baseURL}/#${link}\n`)).stdout).toBe(svg)
  const saved = svg.replace('>\n', () => `>\n<metadata id="circle-voronoi">${link}</metadata>\n`)
  expect(run('picture', file('a.svg', saved)).stdout).toBe(svg)
  // A family has the circles of the command `generate`.
  const family = run('picture', await encodeLink({ dataSet: 'dense:7:50' }))
  const generated = run('generate', 'dense', '50', '--seed', '7').stdout
  expect(family.stdout).toBe(run('picture', file('dense.csv', generated)).stdout)
  rmSync(folder, { recursive: true })
})

test('the program writes SVG, PNG and PDF, and says what is wrong in one sentence', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-picture-'))
  const link = await encodeLink({ circles: CIRCLES })
  const env = { CHROMIUM_PATH: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium' }
  for (const [name, start] of [
    ['a.svg', '<svg'],
    ['a.png', '\x89PNG'],
    ['a.pdf', '%PDF'],
  ] as const) {
    const path = join(folder, name)
    expect(run('picture', link, '-o', path, '--size', '300x200', env)).toEqual({ status: 0, stdout: '', stderr: '' })
    const bytes = readFileSync(path)
    expect(bytes.toString('latin1').startsWith(start)).toBe(true)
    // The picture has two pixels per CSS pixel.
    if (name === 'a.png') expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([600, 400])
    if (name === 'a.pdf') expect(bytes.toString('latin1').match(/\/Type\s*\/Page\b/g)).toHaveLength(1)
  }
  const nowhere = { CHROMIUM_PATH: join(folder, 'none'), PATH: folder }
  for (const [args, status, message] of [
    [[link, '-o', join(folder, 'b.png'), nowhere], 1, 'PNG and PDF need rsvg-convert'],
    [[link, '-o', join(folder, 'b.gif')], 2, 'picture writes .svg, .png, .pdf, not .gif.'],
    [[link, '--size', 'large'], 2, '--size is a width and a height in pixels, such as 720x480, not "large".'],
    [[link, '--sice', '3x3'], 2, "picture: Unknown option '--sice'"],
    [[], 2, 'picture takes one link or file'],
    [['v1.AAAA'], 2, 'a part of it is missing or wrong'],
    [[join(folder, 'none.csv')], 1, 'no such file'],
  ] as const) {
    const { stderr, ...rest } = run('picture', ...args)
    expect(rest).toEqual({ status, stdout: '' })
    expect(stderr).toContain(message)
    expect(stderr.trim().split('\n')).toHaveLength(1)
  }
  rmSync(folder, { recursive: true })
})

test('rsvg-convert draws as a browser does, in the same size', async ({ page }) => {
  const folder = mkdtempSync(join(tmpdir(), 'circle-voronoi-picture-'))
  const link = await encodeLink({ circles: CIRCLES, layers: { cells: 'degree' } })
  const noBrowser = { CHROMIUM_PATH: join(folder, 'none') }
  // Without programs, rsvg-convert cannot be found.
  const noRsvg = { CHROMIUM_PATH: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium', PATH: folder }
  for (const [name, env] of [
    ['rsvg', noBrowser],
    ['browser', noRsvg],
  ] as const) {
    for (const format of ['png', 'pdf']) {
      const path = join(folder, `${name}.${format}`)
      expect(run('picture', link, '-o', path, '--size', '300x200', env)).toEqual({ status: 0, stdout: '', stderr: '' })
    }
  }
  const difference = await page.evaluate(
    async (pngs) => {
      const pixels = await Promise.all(
        pngs.map(async (png) => {
          const image = new Image()
          image.src = `data:image/png;base64,${png}`
          await image.decode()
          const canvas = new OffscreenCanvas(image.width, image.height)
          const context = canvas.getContext('2d') as OffscreenCanvasRenderingContext2D
          context.drawImage(image, 0, 0)
          return [image.width, image.height, ...context.getImageData(0, 0, image.width, image.height).data]
        }),
      )
      const [one, other] = pixels as [number[], number[]]
      let sum = 0
      for (let k = 2; k < one.length; k++) sum += Math.abs((one[k] as number) - (other[k] as number))
      return { sizes: pixels.map((all) => all.slice(0, 2)), mean: sum / one.length }
    },
    ['rsvg', 'browser'].map((name) => readFileSync(join(folder, `${name}.png`)).toString('base64')),
  )
  // The picture has two pixels per unit of its size. Lines are smoothed in different ways.
  expect(difference.sizes).toEqual([
    [600, 400],
    [600, 400],
  ])
  expect(difference.mean).toBeLessThan(1)
  // A pixel is 3/4 of a point.
  for (const name of ['rsvg', 'browser']) {
    const box = /\/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)/.exec(readFileSync(join(folder, `${name}.pdf`), 'latin1'))
    const [width, height] = [Number(box?.[1]), Number(box?.[2])]
    expect(Math.abs(width - 225), name).toBeLessThan(1)
    expect(Math.abs(height - 150), name).toBeLessThan(1)
  }
  rmSync(folder, { recursive: true })
})

test('a state that cannot be drawn is one clear error', async () => {
  for (const [state, options, message] of [
    [undefined, {}, 'renderSVG takes a state or a link, not undefined.'],
    [{}, {}, 'The state has no circles: renderSVG needs the circles themselves.'],
    [{ dataSet: 'spruces' }, {}, 'names the data set "spruces"'],
    [{ circles: [[0, 0, -1]] }, {}, 'Circle 0'],
    [{ circles: CIRCLES, view: 3 }, {}, 'the view is invalid'],
    [{ circles: CIRCLES, areas: 'equal' }, {}, 'region'],
    [{ circles: CIRCLES }, { width: 0 }, 'The option width is a number from 1 to 100000, not 0.'],
    [{ circles: CIRCLES }, { scheme: 'blue' }, 'The option scheme is "light" or "dark", not "blue".'],
    [{ circles: CIRCLES }, { with: 3 }, 'with'],
  ] as const) {
    await expect(renderSVG(state as never, options as never)).rejects.toThrow(message)
  }
})

type Run = { readonly status: number | null; readonly stdout: string; readonly stderr: string }

/** Runs the program. The last argument may be environment variables. */
function run(...given: readonly (string | Record<string, string>)[]): Run {
  const args = given.filter((arg) => typeof arg === 'string')
  const variables = given.find((arg) => typeof arg === 'object')
  const env = { ...process.env, FORCE_COLOR: '0', ...variables }
  const { status, stdout, stderr } = spawnSync(process.execPath, [PROGRAM, ...args], {
    env,
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  })
  return { status, stdout, stderr }
}
