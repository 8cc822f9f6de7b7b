// SPDX-License-Identifier: GPL-3.0-or-later
// examples/globe: circles on a globe, from a table.
import { readFileSync } from 'node:fs'
import { expect, type Locator, type Page, test } from '@playwright/test'
import { loadSphere } from '../../web/lib/sphere.ts'
import type { SphereDiagram } from '../../web/lib/wasm/sphere-diagram.ts'
import { soon } from '../soon.ts'
import { violationsInBoth } from './accessibility.ts'

const EARTH = 6371.0088
const DEGREE = Math.PI / 180
/** The share of its place that the globe fills. */
const FILLED = 0.94
const TABLE = readFileSync(new URL('../../public/data/world-cities.csv', import.meta.url), 'utf8')
const ROWS = TABLE.trim()
  .split('\n')
  .slice(1)
  .map((line) => line.split(','))
const NAMES = ROWS.map(([name]) => name as string)
const CAPS = Float64Array.from(ROWS.flatMap((row) => row.slice(2, 5).map(Number)))

/** A place as longitude and latitude. */
type Place = readonly [longitude: number, latitude: number]

/** The globe in its page. */
class Globe {
  readonly page: Page
  readonly picture: Locator
  readonly cell: Locator
  readonly summary: Locator
  readonly problem: Locator
  readonly problems: string[] = []

  constructor(page: Page) {
    this.page = page
    this.picture = page.getByRole('application', { name: 'Globe' })
    this.cell = page.locator('#cell')
    this.summary = page.locator('#summary')
    this.problem = page.getByRole('alert')
    page.on('pageerror', ({ message }) => this.problems.push(message))
    page.on('console', (message) => ['error', 'warning'].includes(message.type()) && this.problems.push(message.text()))
  }

  async open(): Promise<this> {
    await this.page.goto('/examples/globe/')
    await expect(this.summary).toHaveText(/: 357 circles, \d+ hidden inside others$/)
    return this
  }

  get name(): Promise<string | null> {
    return this.cell.getByRole('heading', { level: 2 }).textContent()
  }

  async paste(text: string): Promise<void> {
    await this.page.evaluate((text) => {
      const clipboardData = new DataTransfer()
      clipboardData.setData('text/plain', text)
      dispatchEvent(new ClipboardEvent('paste', { clipboardData }))
    }, text)
  }

  /** The middle of the picture, and the radius of the globe without zoom. */
  async middle(): Promise<{ x: number; y: number; radius: number }> {
    const box = await this.picture.boundingBox()
    if (box === null) throw new Error('The globe has no place.')
    const { x, y, width, height } = box
    return { x: x + width / 2, y: y + height / 2, radius: (FILLED * Math.min(width, height)) / 2 }
  }

  async saved(): Promise<{ readonly features: readonly Feature[] }> {
    const [download] = await Promise.all([
      this.page.waitForEvent('download'),
      this.page.getByRole('button', { name: 'Save GeoJSON' }).click(),
    ])
    expect(download.suggestedFilename()).toMatch(/-cells\.geojson$/)
    return JSON.parse(readFileSync(await download.path(), 'utf8'))
  }
}

interface Feature {
  readonly properties: Readonly<Record<string, unknown>>
  readonly geometry: { readonly coordinates: readonly (readonly (readonly Place[])[])[] } | null
}

/** The area of a ring on the unit sphere whose sides are straight in degrees. */
function areaOf(ring: readonly Place[]): number {
  return ring.slice(1).reduce((sum, [longitude, latitude], k) => {
    const [before, below] = ring[k] as Place
    const [low, high, across] = [below * DEGREE, latitude * DEGREE, (longitude - before) * DEGREE]
    // The mean of the sine along the side.
    const mean = Math.abs(high - low) < 1e-9 ? Math.sin(low) : (Math.cos(low) - Math.cos(high)) / (high - low)
    return sum - across * mean
  }, 0)
}

/** The place at a point of an orthographic picture, in radii from its middle. */
function placeAt([longitude, latitude]: Place, right: number, up: number): Place {
  const depth = Math.sqrt(1 - right * right - up * up)
  const [sine, cosine] = [Math.sin(latitude * DEGREE), Math.cos(latitude * DEGREE)]
  const turn = Math.atan2(right, depth * cosine - up * sine)
  return [longitude + turn / DEGREE, Math.asin(up * cosine + depth * sine) / DEGREE]
}

let cities: SphereDiagram
test.beforeAll(async () => {
  cities = (await loadSphere()).computeSphere(CAPS)
})

/** Turns the globe to a city by the buttons of neighbors, each nearer to it. */
async function turnTo(globe: Globe, city: number): Promise<void> {
  const { page, picture } = globe
  await picture.focus()
  await page.keyboard.press('Enter')
  for (;;) {
    const at = NAMES.indexOf((await globe.name) as string)
    if (at === city) break
    const place: Place = [CAPS[3 * city] as number, CAPS[3 * city + 1] as number]
    const [next] = [...cities.neighbors(at)].sort(
      (a, b) => cities.distanceFrom(a, ...place) - cities.distanceFrom(b, ...place),
    )
    await globe.cell
      .getByRole('button', { name: NAMES[next as number] as string, exact: true })
      .first()
      .click()
    await soon(() => globe.name).toBe(NAMES[next as number])
  }
}

test('the cell under the pointer is that of the nearest circle', async ({ page }) => {
  const globe = await new Globe(page).open()
  for (const name of ['Cairo', 'Melbourne', 'Lima']) {
    const city = NAMES.indexOf(name)
    await turnTo(globe, city)
    await page.mouse.move(5, 5)
    const { x, y, radius } = await globe.middle()
    for (const [right, up] of [
      [0.01, 0],
      [0.5, 0.5],
      [-0.6, 0.3],
      [-0.2, -0.7],
      [0.9, -0.1],
      [0.1, 0.95],
    ] as const) {
      const place = placeAt([CAPS[3 * city] as number, CAPS[3 * city + 1] as number], right, up)
      await page.mouse.move(x + radius * right, y - radius * up)
      const nearest = NAMES[cities.find(...place)] as string
      await soon(() => globe.name, `${name} ${right} ${up}`).toBe(nearest)
    }
    // Beside the globe there is no cell, so the selected one is shown.
    await page.mouse.move(x - 1.02 * radius, y - 0.5 * radius)
    await soon(() => globe.name).toBe(name)
  }
  expect(globe.problems).toEqual([])
})

test('saved cells cover the sphere, and have the columns of the table', async ({ page }) => {
  const globe = await new Globe(page).open()
  const { features } = await globe.saved()
  expect(features.map(({ properties }) => properties.name)).toEqual(NAMES)
  const areas = features.map(({ geometry }) =>
    (geometry?.coordinates ?? []).flat().reduce((sum, ring) => sum + areaOf(ring), 0),
  )
  expect(areas.reduce((sum, area) => sum + area) / (4 * Math.PI)).toBeCloseTo(1, 9)
  const total = features.reduce((sum, { properties }) => sum + (properties.area as number), 0)
  expect(total / (4 * Math.PI * EARTH ** 2)).toBeCloseTo(1, 9)
  for (const [i, { properties }] of features.entries()) {
    expect(properties).toMatchObject({ country: ROWS[i]?.[1], population: Number(ROWS[i]?.[5]), r: CAPS[3 * i + 2] })
    // Polygons are within 64 m of the borders.
    expect(((areas[i] as number) * EARTH ** 2) / Math.max(properties.area as number, 1)).toBeCloseTo(
      properties.area === 0 ? 0 : 1,
      1,
    )
  }
})

test('a table is dropped, pasted or opened, and a problem changes nothing', async ({ page }) => {
  const globe = await new Globe(page).open()
  const { picture, problem, summary } = globe
  // Longitudes and radii of other spellings, with decimal commas.
  await globe.paste('Ort;Längengrad;Breitengrad;Radius (m)\nPol;0;90;500000\nInsel;-135,5;-12,25;1000\n')
  await expect(summary).toHaveText('The pasted text: 2 circles')
  await expect(page.getByRole('combobox', { name: 'Unit' })).toHaveValue('m')
  await expect(page.getByRole('combobox', { name: 'Radius' })).toHaveValue('Radius (m)')
  await picture.click({ position: { x: 300, y: 300 } })
  await expect(globe.cell).toContainText(/Radius(500|1) km/)

  for (const [text, sentence] of [
    ['lon,lat,r\n10,95,1\n', /^The pasted text: circle 0 has the latitude 95, .*\.$/],
    ['lon,lat,r\n10,ninety,1\n', /^The pasted text:2: .*\.$/],
    ['place,height\nA,3\n', /^The pasted text: there are no columns for longitude and latitude, only place, height\.$/],
    ['lon,lat\n', /^The pasted text: there are no circles\.$/],
    ['{"type":"FeatureCollection","features":[]}', /^The pasted text: there are no circles\.$/],
  ] as const) {
    await globe.paste(text)
    await expect(problem).toHaveText(sentence)
    await expect(summary).toHaveText('The pasted text: 2 circles')
  }

  const dropped = await page.evaluateHandle(() => {
    const dataTransfer = new DataTransfer()
    const places = [
      { place: 'A', lat: 10, lng: 179 },
      { place: 'B', lat: -10, lng: -179 },
    ]
    dataTransfer.items.add(new File([JSON.stringify(places)], 'two.json'))
    return dataTransfer
  })
  await page.dispatchEvent('#globe', 'drop', { dataTransfer: dropped })
  await expect(summary).toHaveText('two.json: 2 circles')
  await expect(problem).toBeHidden()
  // Without a column of radii, places are points.
  await expect(page.getByRole('combobox', { name: 'Radius' })).toHaveValue('')
  await expect(page.getByRole('combobox', { name: 'Unit' })).toBeDisabled()

  const feature = { type: 'Feature', properties: { reach: 3 }, geometry: { type: 'Point', coordinates: [8, 50] } }
  const text = JSON.stringify({ type: 'FeatureCollection', features: [feature] })
  await page.getByLabel('Open a table').setInputFiles({
    name: 'one.geojson',
    mimeType: 'application/geo+json',
    buffer: Buffer.from(text),
  })
  await expect(summary).toHaveText('one.geojson: 1 circle')
  await page.getByRole('combobox', { name: 'Unit' }).selectOption('meters')
  await page.getByRole('combobox', { name: 'Colors' }).selectOption('radius')
  await expect(page.getByRole('list', { name: 'Legend' })).toHaveText('0.003')
  // The only cell is the whole sphere.
  const { features } = await globe.saved()
  expect(features[0]?.properties.area).toBeCloseTo(4 * Math.PI * EARTH ** 2, 0)

  // A reload keeps the table.
  await page.reload()
  await expect(summary).toHaveText('one.geojson: 1 circle')
  expect(globe.problems).toEqual([])
})

test('the place that is grabbed stays under the pointer, and the wheel zooms there', async ({ page }) => {
  const globe = await new Globe(page).open()
  const { x, y, radius } = await globe.middle()
  const at = { x: x + 0.3 * radius, y: y - 0.2 * radius }
  await page.mouse.move(at.x, at.y)
  await expect(globe.cell).toBeVisible()
  const name = await globe.name
  await page.mouse.down()
  for (const step of [0.25, 0.5, 0.75, 1]) await page.mouse.move(at.x - 0.7 * radius * step, at.y + 0.4 * radius * step)
  await page.mouse.up()
  await page.mouse.move(at.x - 0.7 * radius, at.y + 0.4 * radius + 0.5)
  await soon(() => globe.name).toBe(name)
  await page.mouse.wheel(0, -600)
  await page.mouse.move(at.x - 0.7 * radius, at.y + 0.4 * radius)
  await soon(() => globe.name).toBe(name)
  await page.mouse.wheel(0, 3000)
  // A drag selects nothing.
  await page.mouse.move(x - 1.02 * radius, y - radius)
  await expect(globe.cell).toBeHidden()
})

test('keys turn the globe, and the cell in the middle is said', async ({ page }) => {
  const globe = await new Globe(page).open()
  const said = page.locator('#said')
  await page.keyboard.press('Tab')
  await expect(globe.picture).toBeFocused()
  await expect(said).toHaveText(/^.+: [\d,]+ km², \d+ neighbors\.$/)
  const first = await said.textContent()
  for (let k = 0; k < 4; k++) await page.keyboard.press('ArrowRight')
  await expect(said).not.toHaveText(first as string)
  const second = (await said.textContent())?.split(':')[0]
  await page.keyboard.press('Enter')
  await expect(globe.cell.getByRole('heading', { level: 2 })).toHaveText(second as string)
  await page.keyboard.press('+')
  await page.keyboard.press('Shift+ArrowUp')
  // Home shows all places again.
  await page.keyboard.press('Home')
  await expect(said).toHaveText(first as string)
  await page.keyboard.press('Tab')
  await expect(page.getByLabel('Open a table')).toBeFocused()
})

test('columns color the cells, with a legend', async ({ page }) => {
  const globe = await new Globe(page).open()
  const legend = page.getByRole('list', { name: 'Legend' })
  await expect(legend).toBeHidden()
  await page.getByRole('combobox', { name: 'Colors' }).selectOption('population')
  await expect(legend.getByRole('listitem')).toHaveCount(6)
  await expect(legend.getByRole('listitem').last()).toHaveText(/ to 22,300,000$/)
  // Too many countries for a legend.
  await page.getByRole('combobox', { name: 'Colors' }).selectOption('country')
  await expect(legend).toBeHidden()
  await globe.paste('lon,lat,kind,size\n0,0,a,1\n10,0,b,2\n20,0,a,\n30,0,,5\n')
  await page.getByRole('combobox', { name: 'Colors' }).selectOption('kind')
  await expect(legend.getByRole('listitem')).toHaveText(['a', 'b', 'no value'])
  await page.getByRole('combobox', { name: 'Colors' }).selectOption('size')
  await expect(legend.getByRole('listitem')).toHaveText(['1', '2', '5', 'no value'])
})

for (const [width, height] of [
  [360, 640],
  [1280, 800],
] as const) {
  test(`the page is accessible and fits, ${width} pixels wide`, async ({ page }) => {
    await page.setViewportSize({ width, height })
    const globe = await new Globe(page).open()
    const { x, y } = await globe.middle()
    await page.mouse.click(x, y)
    await expect(globe.cell).toBeVisible()
    await page.getByRole('combobox', { name: 'Colors' }).selectOption('population')
    expect(await violationsInBoth(page)).toEqual([])
    const overflow = await page.evaluate(() => {
      const panel = document.getElementById('panel') as HTMLElement
      return [document.documentElement, panel].map(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth)
    })
    expect(overflow).toEqual([0, 0])
    expect(globe.problems).toEqual([])
  })
}

test.describe('with fingers', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true })

  test('a tap selects, and two fingers zoom', async ({ page }) => {
    const globe = await new Globe(page).open()
    const { x, y, radius } = await globe.middle()
    await page.touchscreen.tap(x + 0.2 * radius, y)
    await expect(globe.cell).toBeVisible()
    const name = await globe.name
    await expect(globe.cell).toBeInViewport()
    const session = await page.context().newCDPSession(page)
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...shifts: number[]) =>
      session.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: shifts.map((shift, id) => ({ x: x + 0.2 * radius + shift, y, id })),
      })
    await touch('touchStart', -20, 20)
    for (const shift of [30, 40, 60, 80]) await touch('touchMove', -shift, shift)
    await touch('touchEnd')
    // The place between the fingers has not moved.
    await page.touchscreen.tap(x + 0.2 * radius, y)
    await soon(() => globe.name).toBe(name)
    expect(globe.problems).toEqual([])
  })
})
