// SPDX-License-Identifier: GPL-3.0-or-later
import { Session } from 'node:inspector'
import { setFlagsFromString } from 'node:v8'

const session = new Session()

/** Sends a command to V8, which answers at once. */
function send<Answer>(command: string, options: object = {}): Answer {
  let answer: unknown
  session.post(command, options, (error, result) => {
    if (error !== null) throw error
    answer = result
  })
  return answer as Answer
}

/** A range of a script and how often it was executed, except for the ranges inside that have counts of their own. */
interface Block {
  readonly startOffset: number
  readonly endOffset: number
  readonly count: number
}

interface Coverage {
  readonly result: readonly {
    readonly url: string
    readonly functions: readonly { readonly ranges: readonly Block[] }[]
  }[]
}

setFlagsFromString('--no-opt')
setFlagsFromString('--no-maglev')
session.connect()
send('Profiler.enable')
send('Profiler.startPreciseCoverage', { callCount: true, detailed: true })

/** Returns how often `act` executes the blocks of the library's functions. */
export async function stepsOf(act: () => unknown): Promise<number> {
  send('Profiler.takePreciseCoverage')
  await act()
  const { result } = send<Coverage>('Profiler.takePreciseCoverage')
  return result
    .filter(({ url }) => /\/web\/lib\//.test(url))
    .flatMap(({ functions }) => functions.flatMap(({ ranges }) => ranges))
    .reduce((sum, { count }) => sum + count, 0)
}
