// SPDX-License-Identifier: GPL-3.0-or-later
// Random edits, and a form of diagrams that does not depend on the numbering of their parts.
import type { Circle, DiagramEditor, Edit, SnapshotData } from '../../web/lib/index.ts'

/** Circles on the points of a grid, with ties, nested and equal circles; or at any points. */
export function someCircle(random: () => number, isOnGrid: boolean): Circle {
  const place = () => (isOnGrid ? Math.floor(8 * random()) : 8 * random())
  return { x: place(), y: place(), r: isOnGrid ? Math.floor(3 * random()) / 2 : 2 * random() ** 4 }
}

/** A random edit: insertions, also under the ids of removed circles, removals, jumps, small moves, changes of radius. */
export function someEdit(random: () => number, isOnGrid: boolean, editor: DiagramEditor): Edit {
  const ids = editor.ids()
  const id = ids[Math.floor(random() * ids.length)]
  const kind = Math.floor(6 * random())
  if (id === undefined || kind < 2) {
    const former = Math.floor(random() * (ids.at(-1) ?? 0))
    const isFormer = kind === 0 && editor.circle(former) === undefined
    return { kind: 'insert', circle: someCircle(random, isOnGrid), ...(isFormer && { id: former }) }
  }
  if (kind === 2) return { kind: 'remove', id }
  const { x, y, r } = editor.circle(id) as Circle
  if (kind === 3) return { kind: 'replace', id, circle: { x, y, r: random() < 0.2 ? 6 : r * random() } }
  if (kind === 4) return { kind: 'replace', id, circle: { x: x + 0.01 * random(), y, r } }
  return { kind: 'replace', id, circle: someCircle(random, isOnGrid) }
}

/** Applies an edit. */
export function edited(editor: DiagramEditor, edit: Edit) {
  if (edit.kind === 'insert') return edit.id === undefined ? editor.insert(edit.circle) : editor.apply([edit])
  return edit.kind === 'remove' ? editor.remove(edit.id) : editor.replace(edit.id, edit.circle)
}

/** The contents of a snapshot by ids, each part in a canonical order. The hiding circles are left out. */
export function contentOf({ circles, vertices, vertexCircles, edges, hidden, hull, numbers }: SnapshotData) {
  const ids = numbers.circles
  const three = (list: ArrayLike<number>, i: number) => [list[3 * i], list[3 * i + 1], list[3 * i + 2]]
  const leastFirst = (list: number[]) => {
    const start = list.indexOf(Math.min(...list))
    return [...list.slice(start), ...list.slice(0, start)]
  }
  const circlesOf = (v: number) => leastFirst(three(vertexCircles, v).map((i) => ids[i as number] as number))
  const nameOf = (v: number) => (v === -1 ? 'infinity' : circlesOf(v).join(' '))
  const idOf = (i: number | undefined) => ids[i as number] as number
  const list = <Item>(length: number, item: (k: number) => Item) => Array.from({ length }, (_, k) => item(k))
  const steps = list(hull.length, (k) => `${idOf(hull[k])} ${idOf(hull[(k + 1) % hull.length])}`)
  const leastStep = steps.indexOf([...steps].sort()[0] as string)
  return {
    circles: list(ids.length, (i) => `${ids[i]}: ${three(circles, i)}`).sort(),
    vertices: list(vertices.length / 3, (v) => `${nameOf(v)}: ${three(vertices, v)}`).sort(),
    edges: list(edges.length / 4, (e) => {
      const [left, right, start, end] = edges.subarray(4 * e, 4 * e + 4) as Int32Array &
        [number, number, number, number]
      const one = `${idOf(left)} ${idOf(right)}: ${nameOf(start)}, ${nameOf(end)}`
      const other = `${idOf(right)} ${idOf(left)}: ${nameOf(end)}, ${nameOf(start)}`
      return one < other ? one : other
    }).sort(),
    hidden: list(hidden.length / 2, (h) => idOf(hidden[2 * h])).sort(),
    hull: [...steps.slice(leastStep), ...steps.slice(0, leastStep)],
  }
}
