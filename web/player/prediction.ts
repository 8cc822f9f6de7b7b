// SPDX-License-Identifier: GPL-3.0-or-later
import type { Trace, TraceEvent } from '../lib/wasm/trace.ts'
import { flipOf } from './sentences.ts'
import { kindAt, type Step } from './steps.ts'
import { ENGLISH_PLAYER, type PlayerWords } from './words.ts'

/** A quiz question about the next step, with one right answer. */
export interface Question {
  readonly text: string
  readonly answers: readonly string[]
  readonly right: number
}

const ANTIPODAL = ['antipodalDiscAccepted', 'antipodalDiscNotEmpty', 'antipodalDiscUsed']

/** The question that can be asked after a step, before the next one is shown; `undefined` if nothing is open. */
export function questionAfter(
  trace: Trace,
  steps: readonly Step[],
  k: number,
  words: PlayerWords = ENGLISH_PLAYER,
): Question | undefined {
  const step = steps[k]
  const next = steps[k + 1]
  if (step === undefined || next === undefined) return undefined
  if (step.line === 'take') return questionOfDisc(trace, step, words)
  if (step.line !== 'flipTest' && step.line !== 'editTest') return undefined
  const events = Array.from({ length: next.end - next.event }, (_, i) => trace.event(next.event + i))
  const of = (kind: string) => events.filter((event) => event.kind === kind)
  const flip = flipOf(of('faceRemoved'), of('faceMade'))
  if (flip === undefined) return undefined
  return questionOfFlip(flip.from, flip.to, k, words)
}

function questionOfDisc(trace: Trace, step: Step, words: PlayerWords): Question {
  const kind = kindAt(trace, step.event) as string
  const { circles } = trace.event(step.event)
  const right = ANTIPODAL.indexOf(kind)
  if (right >= 0) {
    const text = words.askAntipodal(circles[0] as number, circles[1] as number)
    return { text, answers: words.antipodalAnswers, right }
  }
  const deleted = kind === 'branchDisc' ? deletedAfter(trace, step.event) : 0
  return {
    text: words.askThreeTouch(circles),
    answers: words.threeTouchAnswers,
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

/** Offers the right edge and two others of the same four circles, in an order that gives no hint. */
function questionOfFlip(from: readonly Corner[], to: readonly Corner[], seed: number, words: PlayerWords): Question {
  const [a, b] = from as readonly [Corner, Corner]
  const [c, d] = to as readonly [Corner, Corner]
  const answers = [`${c}–${d}`, `${a}–${c}`, `${b}–${d}`]
  const turn = seed % 3
  return {
    text: words.askFlip(`${a}–${b}`),
    answers: [...answers.slice(turn), ...answers.slice(0, turn)],
    right: (3 - turn) % 3,
  }
}
