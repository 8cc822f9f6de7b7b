// SPDX-License-Identifier: GPL-3.0-or-later
// `npm run bench:page [-- --sizes N,...] [--million] [--region]`: the page in Chromium with circles spread evenly: how long a frame takes
// while a circle is dragged, the picture is panned, the wheel zooms and the pointer hovers, and how long from an edit to its
// picture; with --million, opening, panning and zooming 1,000,000; with --region, dragging among 100,000 that are clipped to a
// region of 1,000 sides; and how long and how many bytes the first diagram takes on a
// slow line and processor (--sizes 0: that alone). Tables, and build/bench/page.json.
import { mkdirSync, writeFileSync } from 'node:fs'
import { withBuiltPage } from './built-page.mjs'
import { main, ROOT } from './run.mjs'

const SIZES = [300, 2_000, 10_000, 100_000]
const MILLION = 1_000_000
const CLIPPED = { circles: 100_000, sides: 1000 }
const FRAMES = 120
/** Slow 4G as in Lighthouse, in bits per second and milliseconds, and the slowdown of the processor. */
const SLOW = { bitsPerSecond: 1_638_400, latency: 150, processor: 4 }
const STARTS = 5
const VIEWPORT = { width: 1280, height: 800 }

/** `sides` is the number of sides of the region, 0 without one. */
async function bench(browser, url, circles, gestures, sides = 0) {
  const page = await browser.newPage({ viewport: VIEWPORT })
  page.setDefaultTimeout(120_000)
  try {
    await page.goto(url)
    await page.locator('#figure[aria-busy="false"]').waitFor()
    const times = { open: await opened(page, circles) }
    if (sides > 0) await clipped(page, circles, sides)
    await page.locator('#figure[aria-busy="false"]').waitFor()
    const frames = {}
    for (const gesture of gestures) {
      const { intervals, latency } = await GESTURES[gesture](page)
      intervals.sort((a, b) => a - b)
      const at = (share) => Math.round(10 * intervals[Math.floor(share * (intervals.length - 1))]) / 10
      frames[gesture] = at(0.5)
      frames[`${gesture}, 95 %`] = at(0.95)
      if (latency !== undefined) times['edit to picture'] = Math.round(latency)
      const start = performance.now()
      await page.locator('#figure[aria-busy="false"]').waitFor()
      times[`sharp after ${gesture}`] = Math.round(performance.now() - start)
    }
    const title = circles.toLocaleString('en')
    return { circles, title: sides > 0 ? `${title}, ${sides.toLocaleString('en')} sides` : title, frames, times }
  } finally {
    await page.close()
  }
}

/** Drops a file like a user. */
function drop(page, name, text) {
  return page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer()
      dataTransfer.items.add(new File([text], name))
      const event = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true })
      document.querySelector('#figure')?.dispatchEvent(event)
    },
    [name, text],
  )
}

/** Clips the cells to a coast around most of the circles. */
async function clipped(page, circles, sides) {
  const middle = 2 * Math.sqrt(circles)
  const ring = Array.from({ length: sides }, (_, k) => {
    const angle = (2 * Math.PI * k) / sides
    const radius = middle * (0.85 + 0.07 * Math.sin(17 * angle) + 0.05 * Math.sin(101 * angle))
    return [middle + radius * Math.cos(angle), middle + radius * Math.sin(angle)]
  })
  await drop(page, 'coast.geojson', JSON.stringify({ type: 'Polygon', coordinates: [ring] }))
  await page.locator('#toast', { hasText: 'coast.geojson' }).waitFor()
}

/** Opens a file of circles, and returns the milliseconds until they are visible. */
async function opened(page, circles) {
  const start = performance.now()
  await page.evaluate((count) => {
    let state = 1
    const random = () => {
      state = (state * 1664525 + 1013904223) % 2 ** 32
      return state / 2 ** 32
    }
    const width = 4 * Math.sqrt(count)
    const lines = Array.from({ length: count }, () => `${width * random()},${width * random()},${2 * random() ** 2}`)
    const clipboard = new DataTransfer()
    clipboard.items.add(new File([`x,y,r\n${lines.join('\n')}\n`], 'circles.csv', { type: 'text/csv' }))
    const event = new DragEvent('drop', { dataTransfer: clipboard, bubbles: true, cancelable: true })
    document.querySelector('#figure')?.dispatchEvent(event)
  }, circles)
  const text = `${circles.toLocaleString('en')} circles`
  await page.waitForFunction((said) => document.querySelector('#status')?.textContent.includes(said), text)
  return Math.round(performance.now() - start)
}

/**
 * Measures from the page's request to the frame with the diagram, which is part of the page itself, and to the frame in
 * which circles can be dragged; and the bytes sent until then. Caches are empty.
 */
async function firstDiagram(browser, url) {
  const context = await browser.newContext({ viewport: VIEWPORT, serviceWorkers: 'block' })
  try {
    const page = await context.newPage()
    const session = await context.newCDPSession(page)
    const bytesPerSecond = SLOW.bitsPerSecond / 8
    await session.send('Network.enable')
    await session.send('Network.emulateNetworkConditions', {
      offline: false,
      latency: SLOW.latency,
      downloadThroughput: bytesPerSecond,
      uploadThroughput: bytesPerSecond,
    })
    await session.send('Emulation.setCPUThrottlingRate', { rate: SLOW.processor })
    await page.addInitScript(() => {
      const marks = {
        seen: () => document.querySelector('#first-picture') !== null,
        // The counts arrive with the picture, so that the next frame shows both.
        live: () => document.querySelector('#status')?.textContent.includes('edges') === true,
      }
      for (const [name, isThere] of Object.entries(marks)) {
        const look = () => requestAnimationFrame(isThere() ? () => performance.mark(name) : look)
        requestAnimationFrame(look)
      }
    })
    await page.goto(url, { waitUntil: 'commit' })
    await page.waitForFunction(() => performance.getEntriesByName('live').length > 0)
    return await page.evaluate(() => {
      const all = [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')]
      const entries = /** @type {PerformanceResourceTiming[]} */ (all)
      const timeOf = (name) => Math.round(performance.getEntriesByName(name)[0].startTime)
      const bytes = entries.reduce((sum, { transferSize }) => sum + transferSize, 0)
      // Style sheets block rendering: a frame with the diagram is invisible before the first paint.
      const painted = Math.round(performance.getEntriesByName('first-contentful-paint')[0].startTime)
      return { 'is seen': Math.max(timeOf('seen'), painted), 'can be dragged': timeOf('live'), bytes }
    })
  } finally {
    await context.close()
  }
}

const MIDDLE = { x: VIEWPORT.width / 2, y: VIEWPORT.height / 2 }

/** Each gesture moves the pointer once per frame, and returns the times between frames. */
const GESTURES = {
  drag: async (page) => {
    const point = await pointOn(page, 'disc')
    await page.mouse.move(point.x, point.y)
    await page.mouse.down()
    const intervals = await moving(page, point, (k) => [60 * Math.sin(k / 12), 40 * Math.sin(k / 9)], 'pointermove')
    const latency = await latencyOf(page, point)
    await page.mouse.up()
    await page.keyboard.press('Escape')
    await page.keyboard.press('0')
    return { intervals, latency }
  },
  pan: async (page) => {
    const point = await pointOn(page, 'cell')
    await page.mouse.move(point.x, point.y)
    await page.mouse.down()
    const intervals = await moving(page, point, (k) => [200 * Math.sin(k / 20), 120 * Math.sin(k / 15)], 'pointermove')
    await page.mouse.up()
    return { intervals }
  },
  zoom: async (page) => {
    const intervals = await moving(page, MIDDLE, (k) => [0, 60 * Math.sin(k / 10)], 'wheel')
    await page.keyboard.press('0')
    return { intervals }
  },
  hover: async (page) => ({
    intervals: await moving(page, MIDDLE, (k) => [300 * Math.sin(k / 17), 200 * Math.sin(k / 13)], 'pointermove'),
  }),
}

/** A point where a circle's part can be grabbed. Zooms in until there is one. */
async function pointOn(page, part) {
  const { x, y } = MIDDLE
  for (let step = 0; step < 40; step++) {
    for (let k = 0; k < 60; k++) {
      const point = { x: x + 5 * k * Math.cos(k), y: y + 5 * k * Math.sin(k) }
      await page.mouse.move(point.x, point.y)
      await page.waitForTimeout(30)
      if ((await page.locator('#figure').getAttribute('data-cursor')) === part) return point
    }
    await page.mouse.move(x, y)
    await page.mouse.wheel(0, -300)
    await page.waitForTimeout(300)
  }
  throw new Error(`There is no ${part} to be grasped.`)
}

/** Dispatches the events of a moving pointer, one per frame. */
function moving(page, start, stepOf, type) {
  const steps = Array.from({ length: FRAMES }, (_, k) => stepOf(k))
  return page.evaluate(
    ([{ x, y }, steps, type]) =>
      new Promise((resolve) => {
        const figure = document.querySelector('#figure')
        const intervals = []
        let last
        let k = 0
        const frame = (now) => {
          if (last !== undefined) intervals.push(now - last)
          last = now
          const step = steps[k++]
          if (step === undefined) {
            resolve(intervals)
            return
          }
          const [dx, dy] = step
          const options = { bubbles: true, cancelable: true, pointerId: 1, pointerType: 'mouse', isPrimary: true }
          const event =
            type === 'wheel'
              ? new WheelEvent(type, { ...options, clientX: x, clientY: y, deltaY: dy })
              : new PointerEvent(type, { ...options, clientX: x + dx, clientY: y + dy })
          figure?.dispatchEvent(event)
          requestAnimationFrame(frame)
        }
        requestAnimationFrame(frame)
      }),
    [start, steps, type],
  )
}

/** Time from a move in a drag to the frame that shows it, with both the picture and the numbers of the circle. */
function latencyOf(page, { x, y }) {
  return page.evaluate(
    async ([x, y]) => {
      const figure = document.querySelector('#figure')
      const field = /** @type {HTMLInputElement} */ (document.querySelector('#field-x'))
      const nextFrame = () => new Promise(requestAnimationFrame)
      const times = []
      for (let k = 0; k < 21; k++) {
        await new Promise((resolve) => setTimeout(resolve, 100))
        const before = field.value
        const start = performance.now()
        const options = { bubbles: true, pointerId: 1, pointerType: 'mouse', isPrimary: true }
        figure?.dispatchEvent(new PointerEvent('pointermove', { ...options, clientX: x + 9 + 3 * k, clientY: y }))
        do {
          await nextFrame()
          // Other callbacks of this frame may still update it.
          await new Promise((resolve) => setTimeout(resolve))
        } while (field.value === before && performance.now() - start < 5000)
        times.push(performance.now() - start)
      }
      return times.sort((a, b) => a - b)[10]
    },
    [x, y],
  )
}

await main(() =>
  withBuiltPage(async (browser, url) => {
    const given = process.argv.indexOf('--sizes')
    const sizes = given < 0 ? SIZES : process.argv[given + 1].split(',').map(Number)
    const rows = []
    const starts = []
    for (let k = 0; k < STARTS; k++) starts.push(await firstDiagram(browser, url))
    starts.sort((a, b) => a['is seen'] - b['is seen'])
    for (const size of sizes.filter((size) => size > 0))
      rows.push(await bench(browser, url, size, ['drag', 'pan', 'zoom', 'hover']))
    if (process.argv.includes('--region'))
      rows.push(await bench(browser, url, CLIPPED.circles, ['drag', 'pan', 'zoom', 'hover'], CLIPPED.sides))
    if (process.argv.includes('--million')) rows.push(await bench(browser, url, MILLION, ['pan', 'zoom']))
    const first = starts[Math.floor(STARTS / 2)]
    console.log('The first diagram on slow 4G with a processor 4 times slower: the median')
    console.table({ 'start scene': first })
    if (rows.length > 0) {
      console.log('Milliseconds from frame to frame, the median and what 95 % stay below')
      console.table(Object.fromEntries(rows.map(({ title, frames }) => [title, frames])))
      console.log('Milliseconds until the picture is there')
      console.table(Object.fromEntries(rows.map(({ title, times }) => [title, times])))
    }
    mkdirSync(`${ROOT}build/bench`, { recursive: true })
    writeFileSync(`${ROOT}build/bench/page.json`, `${JSON.stringify({ first, rows }, undefined, 1)}\n`)
  }),
)
