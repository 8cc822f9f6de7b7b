// SPDX-License-Identifier: GPL-3.0-or-later
import { at } from '../lib/base/diagram-data.ts'
import type { Box, Circle, Edit } from '../lib/index.ts'
import type { LinkState, LinkView } from '../lib/link.ts'
import { type Camera, fitted, type Padding, type Size } from '../view/camera.ts'
import type { CircleTable } from '../view/circle-table.ts'
import type { Domain } from '../view/domain.ts'
import type { CircleSet } from './history.ts'

/**
 * The circles of a link: either edits of the scene that was opened, or the table's current circles, whichever is
 * shorter. Data sets with more than `mostNamed` circles are stored by name.
 */
export function circlesOfLink(
  scene: CircleSet,
  table: CircleTable,
  mostNamed: number,
): Pick<LinkState, 'circles' | 'dataSet' | 'edits'> {
  const { dataSet, isEdited, circles } = scene
  if (dataSet === '' || isEdited || circles.length > 3 * mostNamed) return { circles: table.circles() }
  const edits = editsFrom(circles, table)
  if (edits.length === 0) return { dataSet }
  return edits.length < circles.length / 3 ? { dataSet, edits } : { circles: table.circles() }
}

/** The region of a link; left out if it is the data set's. */
export function regionOfLink({ dataSet, isEdited, domain }: CircleSet, { region }: Domain): Pick<LinkState, 'region'> {
  const own = dataSet === '' || isEdited ? undefined : domain?.region
  return region === own ? {} : { region: region ?? null }
}

/** The edits that turn circles with ids from 0 on into the circles of a table. */
function editsFrom(circles: Float64Array, table: CircleTable): Edit[] {
  const edits: Edit[] = []
  const count = circles.length / 3
  for (let id = 0; id < count; id++) {
    const circle = table.get(id)
    if (circle === undefined) edits.push({ kind: 'remove', id })
    else if (!isCircle(circles, id, circle)) edits.push({ kind: 'replace', id, circle })
  }
  for (let id = table.next(count, 1); id !== undefined; id = table.next(id + 1, 1)) {
    edits.push({ kind: 'insert', circle: table.get(id) as Circle })
  }
  return edits
}

/** The viewport of a link, independent of the size of the window. */
export function viewOfLink({ x, y, scale }: Camera, { width, height }: Size): LinkView {
  return { x, y, span: Math.min(width, height) / scale }
}

export function cameraOf({ x, y, span }: LinkView, { width, height }: Size): Camera {
  return { x, y, scale: Math.min(width, height) / span }
}

/** Range of zoom, relative to the whole picture. */
export const SMALLEST_ZOOM = 0.05
export const LARGEST_ZOOM = 1e7

/** The camera of a link's viewport if the viewport meets a box, else of the whole box. */
export function cameraShowing(view: LinkView | undefined, box: Box, size: Size, padding: Padding): Camera {
  const whole = fitted(box, size, padding)
  if (view === undefined) return whole
  const camera = cameraOf(view, size)
  const isNear = (value: number, from: number, to: number) => value >= from - (to - from) && value <= to + (to - from)
  const isRight = isNear(view.x, box.minX, box.maxX) && isNear(view.y, box.minY, box.maxY)
  const zoom = camera.scale / whole.scale
  return isRight && zoom >= SMALLEST_ZOOM && zoom <= LARGEST_ZOOM ? camera : whole
}

function isCircle(circles: Float64Array, i: number, { x, y, r }: Circle): boolean {
  return at(circles, 3 * i) === x && at(circles, 3 * i + 1) === y && at(circles, 3 * i + 2) === r
}
