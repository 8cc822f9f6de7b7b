// SPDX-License-Identifier: GPL-3.0-or-later
import type { Trace, TraceEvent } from '../lib/wasm/trace.ts'
import { flipOf } from './sentences.ts'
import { kindAt, type Step } from './steps.ts'

/** What happens next? One answer is right. */
export interface Question {
  readonly text: string
  readonly answers: readonly string[]
  readonly right: number
}

const ANTIPODAL = {
  antipodalDiscAccepted: 'It is empty',
  antipodalDiscNotEmpty: 'It meets another circle',
  antipodalDiscUsed: 'A foot point lies on a used arc',
}
const THREE_TOUCH = ['Both its edges go, one comes', 'Three edges go', 'Nothing: an edge of it is gone']

/** The question that can be asked after a step, before the next one is shown; `undefined` if nothing is open. */
export function questionAfter(trace: Trace, steps: readonly Step[], k: number): Question | undefined {
  const step = steps[k]
  const next = steps[k + 1]
  if (step === undefined || next === undefined) return undefined
  if (step.line === 'take') return questionOfDisc(trace, step)
  if (step.line !== 'flipTest' && step.line !== 'editTest') return undefined
  const events = Array.from({ length: next.end - next.event }, (_, i) => trace.event(next.event + i))
  const of = (kind: string) => events.filter((event) => event.kind === kind)
  const flip = flipOf(of('faceRemoved'), of('faceMade'))
  if (flip === undefined) return undefined
  return questionOfFlip(flip.from, flip.to, k)
}

function questionOfDisc(trace: Trace, step: Step): Question {
  const kind = kindAt(trace, step.event) as string
  const { circles } = trace.event(step.event)
  if (kind in ANTIPODAL) {
    return {
      text: `What is the disc between circles ${circles[0]} and ${circles[1]}?`,
      answers: Object.values(ANTIPODAL),
      right: Object.keys(ANTIPODAL).indexOf(kind),
    }
  }
  const deleted = kind === 'branchDisc' ? deletedAfter(trace, step.event) : 0
  return {
    text: `Which directed edges does the disc of circles ${circles.join(', ')} take away?`,
    answers: THREE_TOUCH,
    right: deleted === 2 ? 0 : deleted === 3 ? 1 : 2,
  }
}

function deletedAfter(trace: Trace, branch: number): number {
  let count = 0
  for (let k = branch + 1; k < trace.length; k++) {
    const kind = kindAt(trace, k)
    if (kind === 'directedEdgeDeleted') count += 1
    else if (kind !== 'segmentFinished') break
  }
  return count
}

type Corner = TraceEvent['circles'][number] | '∞'

/** The right edge and two others of the same four circles, in an order that says nothing. */
function questionOfFlip(from: readonly Corner[], to: readonly Corner[], seed: number): Question {
  const [a, b] = from as readonly [Corner, Corner]
  const [c, d] = to as readonly [Corner, Corner]
  const answers = [`${c}–${d}`, `${a}–${c}`, `${b}–${d}`]
  const turn = seed % 3
  return {
    text: `The edge ${a}–${b} goes. Which one comes?`,
    answers: [...answers.slice(turn), ...answers.slice(0, turn)],
    right: (3 - turn) % 3,
  }
}
