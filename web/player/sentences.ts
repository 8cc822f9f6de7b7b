// SPDX-License-Identifier: GPL-3.0-or-later
import type { Trace, TraceEvent } from '../lib/wasm/trace.ts'
import { kindAt, type Step } from './steps.ts'

/** A number as a reader wants it: three digits that count. */
export function numberOf(value: number): string {
  const size = Math.abs(value)
  if (size >= 1e6 || (size > 0 && size < 1e-3)) return value.toExponential(2)
  return String(Number(value.toPrecision(size >= 1000 ? 6 : 3)))
}

const plural = (count: number, one: string, many = `${one}s`) => `${count} ${count === 1 ? one : many}`

export function listOf(ids: readonly number[], last = 'and'): string {
  if (ids.length < 2) return ids.join('')
  return `${ids.slice(0, -1).join(', ')} ${last} ${ids.at(-1)}`
}

const circlesText = (ids: readonly number[]) => (ids.length === 1 ? `circle ${ids[0]}` : `circles ${listOf(ids)}`)
const radiusOf = ({ disc }: TraceEvent) => numberOf(disc?.r ?? 0)
const atText = ({ disc }: TraceEvent) => `(${numberOf(disc?.x ?? 0)}, ${numberOf(disc?.y ?? 0)})`
const arrow = ({ circles }: TraceEvent) => `${circles[0]}→${circles[1]}`

/** What happens in a step, in one plain sentence. `tested`: what a disc is tested against, where that is known. */
export function sentenceOf(trace: Trace, step: Step, tested: readonly number[] = []): string {
  const count = step.end - step.event
  const event = step.event < trace.length ? trace.event(step.event) : undefined
  const during = (kind: string) => {
    const events: TraceEvent[] = []
    for (let k = step.event; k < step.end; k++) if (kindAt(trace, k) === kind) events.push(trace.event(k))
    return events
  }
  switch (step.line) {
    case 'begin': {
      const circles = trace.diagram.circles.length / 3
      const hidden = trace.diagram.hidden.length / 2
      return hidden === 0
        ? `There are ${plural(circles, 'circle')}.`
        : `There are ${plural(circles, 'circle')}, ${hidden} of them inside others and left out.`
    }
    case 'centers':
    case 'flipCenters':
      return `The Delaunay graph of the centers has ${plural(count, 'edge')}.`
    case 'angles':
      return 'At each center, the angles between these edges are divided by rays.'
    case 'samples':
      return `${plural(count, 'sample')} lie where edges and rays leave their circles.`
    case 'sampleGraph':
      return `The Delaunay graph of the samples has ${plural(count, 'edge')}.`
    case 'pairs':
      return `Its edges join ${plural(count, 'pair')} of circles: each gets an antipodal disc, and all go into the list by radius.`
    case 'take':
      return takenText(event as TraceEvent, tested)
    case 'used':
      return `A foot point of the disc of ${circlesText((event as TraceEvent).circles)} lies on an arc that is used already: it is dropped.`
    case 'notEmpty': {
      const [a, b, c] = (event as TraceEvent).circles
      return `The disc of circles ${a} and ${b} meets circle ${c}: it is dropped.`
    }
    case 'place': {
      const [a, b] = (event as TraceEvent).circles
      const against = tested.length > 0 ? ` It meets neither foot's neighbors, ${listOf(tested)}.` : ''
      return `The disc of circles ${a} and ${b} is empty: directed edges ${a}→${b} and ${b}→${a} are placed.${against}`
    }
    case 'form':
    case 'formThird': {
      const discs = during('threeTouchDiscFormed')
      const names = discs.map(({ circles, disc }) => `${circles.join('·')} (radius ${numberOf(disc?.r ?? 0)})`)
      return `${plural(count, 'three-touch disc')} ${count === 1 ? 'goes' : 'go'} into the list: ${names.join(', ')}.`
    }
    case 'stale':
      return `The directed edges of disc ${(event as TraceEvent).circles.join('·')} are gone or no longer next to each other: it is dropped.`
    case 'branch':
      return `The disc of ${circlesText((event as TraceEvent).circles)} is empty: its center ${atText(event as TraceEvent)} is a vertex, at distance ${radiusOf(event as TraceEvent)} from all three.`
    case 'finish': {
      const edges = during('directedEdgeDeleted').map(arrow)
      return `${plural(edges.length, 'segment')} end there: directed edges ${edges.join(', ')} are deleted.`
    }
    case 'placeThird':
      return `Directed edge ${arrow(event as TraceEvent)} takes their place: its segment goes on from the vertex.`
    case 'again':
      return `The judge found the diagram wrong: round ${((event as TraceEvent).numbers[0] ?? 0) + 1} begins with more samples.`
    case 'ties':
      return 'Four or more circles touch one disc: its triangles are settled by the places of the centers.'
    case 'flipDiscs':
      return `${plural(during('faceMade').filter(({ circles }) => circles.length === 3).length, 'triangle')}, each with the disc that touches its three circles.`
    case 'editBegin':
      return `The diagram has ${plural(during('faceMade').filter(({ circles }) => circles.length === 3).length, 'vertex', 'vertices')}.`
    case 'edit':
      return editText(event as TraceEvent, kindAt(trace, step.event) as string)
    case 'flipTest':
    case 'editTest':
      return testText(event as TraceEvent)
    case 'flip':
    case 'editFlip':
      return changeText(during('faceRemoved'), during('faceMade'))
    case 'hull': {
      const left = trace.at(step.end).directedEdges.length
      return `The list is empty. The ${plural(left, 'directed edge')} left are the hull.${verdictText(trace)}`
    }
    case 'flipDone':
      return `No edge is left to flip.${verdictText(trace)}`
    case 'editDone':
      return `The diagram is whole again.${verdictText(trace)}`
  }
}

function verdictText({ diagram: { certificate } }: Trace): string {
  return certificate.flaw === 'none'
    ? ' The judge proves the diagram.'
    : ` The judge refuses the diagram: ${certificate.message}`
}

function takenText(event: TraceEvent, tested: readonly number[]): string {
  const isTriple = event.kind === 'branchDisc' || event.kind === 'threeTouchDiscStale'
  if (isTriple) {
    return `The smallest disc in the list touches ${circlesText(event.circles)}, with radius ${radiusOf(event)}. Are its directed edges still there?`
  }
  const against = tested.length > 0 ? ` It is tested against ${circlesText(tested)}.` : ''
  return `The smallest disc in the list lies between circles ${listOf(event.circles.slice(0, 2))}, with radius ${radiusOf(event)}.${against}`
}

function editText({ circles: [id], disc }: TraceEvent, kind: string): string {
  const place = `(${numberOf(disc?.x ?? 0)}, ${numberOf(disc?.y ?? 0)}) with radius ${numberOf(disc?.r ?? 0)}`
  if (kind === 'circleInserted') return `Circle ${id} comes at ${place}.`
  if (kind === 'circleRemoved') return `Circle ${id} is gone.`
  return `Circle ${id} is now at ${place}.`
}

function testText(event: TraceEvent): string {
  const [a, b, c] = event.circles
  switch (event.kind) {
    case 'discMissing':
      return `No disc touches circles ${a}, ${b} and ${c}: the edge ${a}–${b} has to go.`
    case 'tangentNotClear':
      return `The tangent line of circles ${a} and ${b} meets circle ${c}: the edge ${a}–${b} is no longer on the hull.`
    case 'hullNotConvex':
      return `Circle ${a} lies within the tangent line of circles ${b} and ${c}: it leaves the hull.`
    case 'circleShrunk':
      return `Circle ${a} has shrunk to radius ${radiusOf(event)}: there it touches a disc of its neighbors.`
    default:
      return `The disc beside the edge ${a}–${b}, with radius ${radiusOf(event)}, meets circle ${c}: the edge is wrong.`
  }
}

function changeText(removed: readonly TraceEvent[], made: readonly TraceEvent[]): string {
  const flip = flipOf(removed, made)
  if (flip !== undefined) return `The edge ${flip.from.join('–')} becomes ${flip.to.join('–')}.`
  const name = ({ circles }: TraceEvent) => circles.join('·')
  if (removed.length === 0) return `New: ${made.map(name).join(', ')}.`
  if (made.length === 0) return `Gone: ${removed.map(name).join(', ')}.`
  if (removed.length === made.length && removed.every((face, k) => name(face) === name(made[k] as TraceEvent))) {
    return `The disc of ${listOf(removed.flatMap((face) => face.circles))} moves.`
  }
  return `${plural(removed.length, 'triangle')} ${removed.length === 1 ? 'goes' : 'go'}, ${made.length} come.`
}

/** The edge that goes and the one that comes, where two triangles take the place of two; infinity is `∞`. */
export function flipOf(
  removed: readonly TraceEvent[],
  made: readonly TraceEvent[],
): { readonly from: readonly (number | '∞')[]; readonly to: readonly (number | '∞')[] } | undefined {
  const common = ([first, second]: readonly TraceEvent[]) => {
    const corners = (face: TraceEvent) => (face.circles.length === 2 ? [...face.circles, '∞' as const] : face.circles)
    const others = corners(second as TraceEvent)
    return corners(first as TraceEvent).filter((corner) => (others as readonly unknown[]).includes(corner))
  }
  if (removed.length !== 2 || made.length !== 2) return undefined
  const [from, to] = [common(removed), common(made)]
  return from.length === 2 && to.length === 2 && String(from) !== String(to) ? { from, to } : undefined
}
