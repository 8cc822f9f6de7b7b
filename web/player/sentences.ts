// SPDX-License-Identifier: GPL-3.0-or-later
import type { Trace, TraceEvent } from '../lib/wasm/trace.ts'
import { short } from '../view/short.ts'
import { kindAt, type Step } from './steps.ts'
import { ENGLISH_PLAYER, type PlayerWords } from './words.ts'

/** Formats a number with three significant digits. */
export function numberOf(value: number): string {
  const size = Math.abs(value)
  if (size >= 1e6 || (size > 0 && size < 1e-3)) return value.toExponential(2)
  return short(value, size >= 1000 ? 6 : 3)
}

const radiusOf = ({ disc }: TraceEvent) => numberOf(disc?.r ?? 0)
const atText = ({ disc }: TraceEvent) => `(${numberOf(disc?.x ?? 0)}, ${numberOf(disc?.y ?? 0)})`
const arrow = ({ circles }: TraceEvent) => `${circles[0]}→${circles[1]}`
const nameOf = ({ circles }: TraceEvent) => circles.join('·')
const isTriangle = ({ circles }: TraceEvent) => circles.length === 3

type Two = [number, number]
type Three = [number, number, number]

/** Describes a step in one sentence. `tested` are the circles that a disc is tested against, if known. */
export function sentenceOf(
  trace: Trace,
  step: Step,
  tested: readonly number[] = [],
  words: PlayerWords = ENGLISH_PLAYER,
): string {
  const count = step.end - step.event
  const during = (kind: string) => {
    const events: TraceEvent[] = []
    for (let k = step.event; k < step.end; k++) if (kindAt(trace, k) === kind) events.push(trace.event(k))
    return events
  }
  // Steps without an event never read this variable.
  const event = (step.event < trace.length ? trace.event(step.event) : undefined) as TraceEvent
  switch (step.line) {
    case 'begin':
      return words.given(trace.diagram.circles.length / 3, trace.diagram.hidden.length / 2)
    case 'centers':
    case 'flipCenters':
      return words.centers(count)
    case 'angles':
      return words.angles
    case 'samples':
      return words.samples(count)
    case 'sampleGraph':
      return words.sampleGraph(count)
    case 'pairs':
      return words.pairs(count)
    case 'take':
      return event.kind === 'branchDisc' || event.kind === 'threeTouchDiscStale'
        ? words.takenTriple(event.circles, radiusOf(event))
        : words.takenPair(event.circles.slice(0, 2), radiusOf(event), tested)
    case 'used':
      return words.used(event.circles)
    case 'notEmpty':
      return words.notEmpty(...(event.circles.slice(0, 3) as Three))
    case 'place':
      return words.place(...(event.circles.slice(0, 2) as Two), tested)
    case 'form':
    case 'formThird':
      return words.form(during('threeTouchDiscFormed').map((disc) => words.disc(nameOf(disc), radiusOf(disc))))
    case 'stale':
      return words.stale(nameOf(event))
    case 'branch':
      return words.branch(event.circles, atText(event), radiusOf(event))
    case 'finish':
      return words.finish(during('directedEdgeDeleted').map(arrow))
    case 'placeThird':
      return words.placeThird(arrow(event))
    case 'again':
      return words.again((event.numbers[0] ?? 0) + 1)
    case 'ties':
      return words.ties
    case 'flipDiscs':
      return words.flipDiscs(during('faceMade').filter(isTriangle).length)
    case 'editBegin':
      return words.editBegin(during('faceMade').filter(isTriangle).length)
    case 'edit':
      return editText(event, kindAt(trace, step.event) as string, words)
    case 'flipTest':
    case 'editTest':
      return testText(event, words)
    case 'flip':
    case 'editFlip':
      return changeText(during('faceRemoved'), during('faceMade'), words)
    case 'hull':
      return `${words.hull(trace.at(step.end).directedEdges.length)} ${verdictText(trace, words)}`
    case 'flipDone':
      return `${words.flipDone} ${verdictText(trace, words)}`
    case 'editDone':
      return `${words.editDone} ${verdictText(trace, words)}`
  }
}

function verdictText({ diagram: { certificate } }: Trace, words: PlayerWords): string {
  return certificate.flaw === 'none' ? words.proven : words.refused(certificate.message)
}

function editText(event: TraceEvent, kind: string, words: PlayerWords): string {
  const id = event.circles[0] as number
  if (kind === 'circleInserted') return words.come(id, atText(event), radiusOf(event))
  return kind === 'circleRemoved' ? words.gone(id) : words.moved(id, atText(event), radiusOf(event))
}

function testText(event: TraceEvent, words: PlayerWords): string {
  const abc = event.circles as unknown as Three
  switch (event.kind) {
    case 'discMissing':
    case 'tangentNotClear':
    case 'hullNotConvex':
      return words[event.kind](...abc)
    case 'circleShrunk':
      return words.shrunk(abc[0], radiusOf(event))
    default:
      return words.discNotEmpty(abc[0], abc[1], abc[2], radiusOf(event))
  }
}

function changeText(removed: readonly TraceEvent[], made: readonly TraceEvent[], words: PlayerWords): string {
  const flip = flipOf(removed, made)
  if (flip !== undefined) return words.flip(flip.from.join('–'), flip.to.join('–'))
  if (removed.length === 0) return words.allNew(made.map(nameOf))
  if (made.length === 0) return words.allGone(removed.map(nameOf))
  if (removed.length === made.length && removed.every((face, k) => nameOf(face) === nameOf(made[k] as TraceEvent))) {
    return words.discMoves(removed.flatMap((face) => face.circles))
  }
  return words.triangles(removed.length, made.length)
}

/** The removed and the added edge of a flip; `∞` is infinity. */
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
