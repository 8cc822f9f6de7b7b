// SPDX-License-Identifier: GPL-3.0-or-later
// Reports to a learning management system by SCORM 1.2 (Run-Time Environment, ADL, 2001): the status of the lesson, the
// score, the time, and the circles, so that a reader can resume.
import type { FrameMessage } from '../element/frame-types.ts'
import { encodeLink } from '../lib/link.ts'

/** The functions that the system offers a lesson in SCORM 1.2. */
export interface ScormApi {
  LMSInitialize(empty: ''): string
  LMSGetValue(name: string): string
  LMSSetValue(name: string, value: string): string
  LMSCommit(empty: ''): string
  LMSFinish(empty: ''): string
}

/** The largest number of windows to search for the interface, because frames may be nested in a cycle. */
const MOST_PARENTS = 500
/** The maximum length of `cmi.suspend_data`, in characters. */
const MOST_SUSPENDED = 4096

/** Finds the system's interface in the enclosing windows or the opener. */
export function findApi(start: Window): ScormApi | undefined {
  return apiAround(start) ?? (start.opener === null ? undefined : apiAround(start.opener as Window))
}

function apiAround(start: Window): ScormApi | undefined {
  let window = start
  for (let k = 0; k < MOST_PARENTS; k++) {
    const api = apiOf(window)
    if (api !== undefined) return api
    if (window.parent === window) return undefined
    window = window.parent
  }
  return undefined
}

/** Returns the interface of a window, if any. A window of another origin throws. */
function apiOf(window: Window): ScormApi | undefined {
  try {
    return (window as Window & { API?: ScormApi }).API ?? undefined
  } catch {
    return undefined
  }
}

export class ScormSession {
  readonly #api: ScormApi
  readonly #hasCheck: boolean
  readonly #start = Date.now()
  #isPassed = false
  #isFinished = false
  #suspended = ''
  #isRestored: boolean

  /** Starts the session. `hasCheck` means that the reader can pass; otherwise opening the lesson completes it. */
  constructor(api: ScormApi, hasCheck: boolean) {
    this.#api = api
    this.#hasCheck = hasCheck
    api.LMSInitialize('')
    const status = api.LMSGetValue('cmi.core.lesson_status')
    this.#isPassed = status === 'passed' || status === 'completed'
    this.#suspended = api.LMSGetValue('cmi.suspend_data')
    this.#isRestored = this.#suspended === ''
    if (!this.#isPassed) this.#set('cmi.core.lesson_status', hasCheck ? 'incomplete' : 'completed')
    api.LMSCommit('')
  }

  /** A link with the circles of the last session, or empty. */
  get suspended(): string {
    return this.#suspended
  }

  /** Ends the restoration: circles that are reported from now on replace those of the last session. */
  markRestored(): void {
    this.#isRestored = true
  }

  /** Reports a change. A lesson stays passed. */
  async tell({ state, met }: FrameMessage): Promise<void> {
    if (state === undefined || this.#isFinished) return
    if (met === true && !this.#isPassed) {
      this.#isPassed = true
      this.#set('cmi.core.score.min', '0')
      this.#set('cmi.core.score.max', '100')
      this.#set('cmi.core.score.raw', '100')
      this.#set('cmi.core.lesson_status', 'passed')
      this.#api.LMSCommit('')
    }
    if (!this.#isRestored) return
    const link = await encodeLink({ circles: state.circles as never })
    if (link.length <= MOST_SUSPENDED) this.#suspended = link
  }

  /** Reports the time and the circles, and ends the session. */
  finish(): void {
    if (this.#isFinished) return
    this.#isFinished = true
    this.#set('cmi.core.session_time', durationOf(Date.now() - this.#start))
    this.#set('cmi.suspend_data', this.#suspended)
    this.#set('cmi.core.exit', this.#isPassed || !this.#hasCheck ? '' : 'suspend')
    this.#api.LMSCommit('')
    this.#api.LMSFinish('')
  }

  #set(name: string, value: string): void {
    this.#api.LMSSetValue(name, value)
  }
}

/** Formats milliseconds as HHHH:MM:SS.SS. */
export function durationOf(milliseconds: number): string {
  const hundredths = Math.round(milliseconds / 10)
  const pad = (value: number, digits = 2) => String(Math.floor(value)).padStart(digits, '0')
  const [hours, minutes, seconds] = [hundredths / 360_000, (hundredths / 6000) % 60, (hundredths / 100) % 60]
  return `${pad(hours, 4)}:${pad(minutes)}:${pad(seconds)}.${pad(hundredths % 100)}`
}
