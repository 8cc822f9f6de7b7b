// SPDX-License-Identifier: GPL-3.0-or-later
import { TRACE_KINDS, type Trace, type TraceKind } from '../lib/wasm/trace.ts'
import type { Program } from './program.ts'
import type { PseudocodeLine, StepKind } from './words.ts'

/** One step of playback; it may cover several events. */
export interface Step {
  /** The number of events that have happened after the step. */
  readonly end: number
  /** The first event that the step is about. It lies ahead if the step announces it. */
  readonly event: number
  readonly line: PseudocodeLine
}

const KIND_OF: Readonly<Record<PseudocodeLine, StepKind | undefined>> = {
  begin: 'stage',
  centers: 'stage',
  angles: 'stage',
  samples: 'stage',
  sampleGraph: 'stage',
  pairs: 'stage',
  take: undefined,
  used: 'rejected',
  notEmpty: 'rejected',
  place: 'edge',
  form: 'disc',
  stale: 'rejected',
  branch: 'vertex',
  finish: undefined,
  placeThird: 'edge',
  formThird: 'disc',
  again: 'stage',
  ties: 'stage',
  hull: 'stage',
  flipCenters: 'stage',
  flipDiscs: 'stage',
  flipTest: 'rejected',
  flip: 'edge',
  flipDone: 'stage',
  editBegin: 'stage',
  edit: 'circle',
  editTest: 'rejected',
  editFlip: 'edge',
  editDone: 'stage',
}

export function kindOf(step: Step): StepKind | undefined {
  return KIND_OF[step.line]
}

/** Event kinds that merge into one step when they follow each other. */
const RUNS: Readonly<Partial<Record<TraceKind, readonly TraceKind[]>>> = {
  centersJoined: ['centersJoined'],
  sampleTaken: ['sampleTaken'],
  samplesJoined: ['samplesJoined'],
  pairFound: ['pairFound'],
  threeTouchDiscFormed: ['threeTouchDiscFormed'],
  directedEdgePlaced: ['directedEdgePlaced'],
  segmentFinished: ['segmentFinished', 'directedEdgeDeleted'],
  faceMade: ['faceMade'],
}

const VERDICTS: Readonly<Partial<Record<TraceKind, PseudocodeLine>>> = {
  antipodalDiscUsed: 'used',
  antipodalDiscNotEmpty: 'notEmpty',
  antipodalDiscAccepted: 'place',
  threeTouchDiscStale: 'stale',
  branchDisc: 'branch',
}

const TESTS: readonly TraceKind[] = ['discNotEmpty', 'discMissing', 'tangentNotClear', 'hullNotConvex', 'circleShrunk']
const EDITS: readonly TraceKind[] = ['circleInserted', 'circleRemoved', 'circleReplaced']

export function kindAt(trace: Trace, k: number): TraceKind | undefined {
  return TRACE_KINDS[trace.kinds[k] as number]
}

export function programOf(trace: Trace): Program {
  const has = (kinds: readonly TraceKind[]) =>
    trace.kinds.some((kind) => kinds.includes(TRACE_KINDS[kind] as TraceKind))
  if (has(['pairFound', 'sampleTaken'])) return 'touching'
  if (has(EDITS)) return 'edits'
  return has(['centersJoined', 'faceMade']) ? 'flips' : 'touching'
}

/** Returns all steps. The first precedes all events; the last follows them. */
export function stepsOf(trace: Trace): readonly Step[] {
  const program = programOf(trace)
  const steps: Step[] = []
  const add = (line: PseudocodeLine, event: number, end: number) => steps.push({ end, event, line })
  const runFrom = (k: number, kinds: readonly TraceKind[]) => {
    let end = k
    while (end < trace.length && kinds.includes(kindAt(trace, end) as TraceKind)) end++
    return end
  }
  /** Whether the next new faces are the initial faces of a round. */
  let isBeginning = true
  let afterBranch = false
  for (let k = 0; k < trace.length; ) {
    const kind = kindAt(trace, k) as TraceKind
    let end = k + 1
    if (kind === 'roundBegun') {
      add(k === 0 ? 'begin' : 'again', k, end)
      isBeginning = true
    } else if (kind in VERDICTS) {
      add('take', k, k)
      afterBranch = kind === 'branchDisc'
      if (kind === 'antipodalDiscAccepted') end = runFrom(end, ['directedEdgePlaced'])
      add(VERDICTS[kind] as PseudocodeLine, k, end)
    } else if (TESTS.includes(kind)) {
      add(program === 'edits' ? 'editTest' : 'flipTest', k, end)
      isBeginning = false
    } else if (EDITS.includes(kind)) {
      add('edit', k, end)
      isBeginning = false
    } else if (kind === 'faceRemoved' || (kind === 'faceMade' && !isBeginning)) {
      end = runFrom(runFrom(k, ['faceRemoved']), ['faceMade'])
      const isReasoned = TESTS.includes(kindAt(trace, k - 1) as TraceKind)
      add(program === 'edits' ? 'editFlip' : isReasoned ? 'flip' : 'ties', k, end)
      isBeginning = false
    } else {
      end = runFrom(k, RUNS[kind] ?? [kind])
      const line = lineOfRun(kind, program, afterBranch)
      add(line, k, end)
      if (kind === 'centersJoined' && kindAt(trace, end) === 'sampleTaken') add('angles', end, end)
    }
    k = end
  }
  const last = { touching: 'hull', flips: 'flipDone', edits: 'editDone' } as const
  add(last[program], trace.length, trace.length)
  return steps
}

function lineOfRun(kind: TraceKind, program: Program, afterBranch: boolean): PseudocodeLine {
  switch (kind) {
    case 'centersJoined':
      return program === 'flips' ? 'flipCenters' : 'centers'
    case 'sampleTaken':
      return 'samples'
    case 'samplesJoined':
      return 'sampleGraph'
    case 'pairFound':
      return 'pairs'
    case 'threeTouchDiscFormed':
      return afterBranch ? 'formThird' : 'form'
    case 'directedEdgePlaced':
      return 'placeThird'
    case 'faceMade':
      return program === 'edits' ? 'editBegin' : 'flipDiscs'
    default:
      return 'finish'
  }
}

/** The next step after `k`, or the last one before it, that satisfies a predicate; `undefined` if there is none. */
export function nextStep(
  steps: readonly Step[],
  from: number,
  direction: 1 | -1,
  holds: (step: Step, k: number) => boolean,
): number | undefined {
  for (let k = from + direction; k >= 0 && k < steps.length; k += direction) {
    if (holds(steps[k] as Step, k)) return k
  }
  return undefined
}

/** Whether a step is about a circle in particular. Steps about all circles do not count. */
export function concerns(trace: Trace, steps: readonly Step[], k: number, circle: number): boolean {
  const step = steps[k] as Step
  if (kindOf(step) === 'stage' || step.event >= trace.length) return false
  for (let event = step.event; event < Math.max(step.end, step.event + 1); event++) {
    if (trace.event(event).circles.includes(circle)) return true
  }
  return false
}
