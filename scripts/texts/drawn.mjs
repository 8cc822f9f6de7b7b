// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the initial pictures of the tutorial's own figures with the page's code.
import { readFileSync } from 'node:fs'
import { pathToFileURL } from 'node:url'
import { crc32, deflateSync } from 'node:zlib'
import { build } from 'esbuild'
import { ROOT } from '../run.mjs'

const BUNDLE = `${ROOT}build/drawn.mjs`
/** Size of the picture of cones, in pixels. */
const CONES = { width: 960, height: 600 }

/**
 * @typedef {object} Drawn
 * @property {string | Buffer} picture a file, SVG or PNG
 * @property {string} [told] the caption
 * @property {number} [height] height of the picture
 * @property {number} [last] last value of the slider
 * @property {number | string} [step] step of the slider
 */

/** @returns {Promise<{ draw: (spec: any, circles: readonly (readonly number[])[]) => Drawn, colorsOf: Function, extrasOf: Function }>} */
export async function loadDrawn(library) {
  await build({
    stdin: {
      contents: `export * from './drawn/kinds.ts'; export { paintCones } from './drawn/paint-cones.ts'; export { colorsOf } from './drawn/scene.ts'; export { extrasOf } from './extras.ts'`,
      resolveDir: `${ROOT}web/tutorial`,
    },
    outfile: BUNDLE,
    bundle: true,
    format: 'esm',
    platform: 'node',
    logLevel: 'warning',
  })
  const { KINDS, heightOf, paintCones, WIDTH, colorsOf, extrasOf } = await import(pathToFileURL(BUNDLE).href)
  const style = ['style/tokens.css', 'tutorial/drawn.css'].map((name) => readFileSync(`${ROOT}web/${name}`, 'utf8'))

  const { loadRegions } = await import(`${ROOT}dist/lib/regions.js`)
  const regions = await loadRegions()

  const draw = ({ kind, view, point, region, at = 0, tilt, turn }, circles) => {
    if (kind === undefined) {
      const { width, height } = CONES
      return { picture: png(paintCones(circles, view, { tilt, turn }, width, height), width, height) }
    }
    const scene = {
      circles: circles.map(([x, y, r]) => ({ x, y, r })),
      point: point && { x: point[0], y: point[1] },
      view,
      region,
    }
    const height = heightOf(kind)
    const { content, told } = KINDS[kind].draw(scene, at, library, regions)
    const picture = `<svg xmlns="http://www.w3.org/2000/svg" class="drawn" viewBox="0 0 ${WIDTH} ${height}"><style>
${style.join('\n')}</style>${content}</svg>
`
    return { picture, told, height, ...KINDS[kind].range(scene, library, regions) }
  }
  return { draw, colorsOf, extrasOf }
}

/** @param {Uint8ClampedArray} pixels red, green, blue and alpha */
function png(pixels, width, height) {
  const rows = Buffer.alloc((4 * width + 1) * height)
  for (let y = 0; y < height; y++) {
    Buffer.from(pixels.buffer, 4 * width * y, 4 * width).copy(rows, (4 * width + 1) * y + 1)
  }
  const header = Buffer.alloc(13)
  header.writeUInt32BE(width, 0)
  header.writeUInt32BE(height, 4)
  // 8 bits for each of red, green, blue and alpha.
  header.set([8, 6, 0, 0, 0], 8)
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a])
  return Buffer.concat([
    signature,
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows, { level: 9 })),
    chunk('IEND', Buffer.alloc(0)),
  ])
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type), data])
  const whole = Buffer.alloc(body.length + 8)
  whole.writeUInt32BE(data.length, 0)
  body.copy(whole, 4)
  whole.writeUInt32BE(crc32(body), body.length + 4)
  return whole
}
