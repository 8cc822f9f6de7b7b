// SPDX-License-Identifier: GPL-3.0-or-later
import { readFileSync } from 'node:fs'
import { use } from './main.js'

globalThis.fetch = () => {
  throw new Error('The network was asked.')
}
const file = new URL(import.meta.resolve('circle-voronoi/circle-voronoi.wasm'))
const sources = { default: undefined, url: file, bytes: readFileSync(file) }
const wasm = sources[process.argv[2]]
console.log(await use(wasm && { wasm }))
