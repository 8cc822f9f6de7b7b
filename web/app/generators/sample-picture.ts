// SPDX-License-Identifier: GPL-3.0-or-later
import { html, svg, type TemplateResult } from 'lit/html.js'
import { at } from '../../lib/base/diagram-data.ts'
import type { Float64s } from '../../lib/index.ts'
import { fitted } from '../../view/camera.ts'
import { interestingBox } from './interesting-box.ts'

const SIZE = { width: 48, height: 36 }
const MARGIN = { top: 3, right: 3, bottom: 3, left: 3 }
const SMALLEST = 0.7

/** A thumbnail of circles without outliers. */
export function pictureOf(circles: Float64s): TemplateResult {
  const { width, height } = SIZE
  const { x, y, scale } = fitted(interestingBox(circles), SIZE, MARGIN)
  const number = (value: number) => String(Math.round(100 * value) / 100)
  let path = ''
  for (let k = 0; k < circles.length; k += 3) {
    const [cx, cy] = [width / 2 + (at(circles, k) - x) * scale, height / 2 - (at(circles, k + 1) - y) * scale]
    const r = Math.max(at(circles, k + 2) * scale, SMALLEST)
    // Browsers draw arcs of huge circles wrong.
    if (r > 1e4 || cx + r < 0 || cx - r > width || cy + r < 0 || cy - r > height) continue
    const turn = `a${number(r)} ${number(r)} 0 1 0 `
    path += `M${number(cx - r)} ${number(cy)}${turn}${number(2 * r)} 0${turn}${number(-2 * r)} 0`
  }
  return html`<svg class="sample" viewBox="0 0 ${width} ${height}" aria-hidden="true">${svg`<path d=${path} />`}</svg>`
}
