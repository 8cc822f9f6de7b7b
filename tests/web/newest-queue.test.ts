// SPDX-License-Identifier: GPL-3.0-or-later
import { describe, expect, it } from 'vitest'
import { NewestQueue } from '../../web/lib/base/newest-queue.ts'

describe('a queue in which the newest wins', () => {
  it('does one thing at a time, and of one key only the newest that waits', async () => {
    const queue = new NewestQueue<number, string>()
    const begun: number[] = []
    let go: (() => void) | undefined
    const act = async (work: number) => {
      begun.push(work)
      await new Promise<void>((resolve) => {
        go = resolve
      })
      if (work === 5) throw new Error('five')
      return `done ${work}`
    }
    const answers = [queue.add(1, 'a')]
    queue.drain(act)
    answers.push(queue.add(2, 'a'), queue.add(3, 'b'), queue.add(4, 'a'), queue.add(5))
    expect(queue.works).toEqual([1, 4, 3, 5])
    queue.settle('b')
    answers.push(queue.add(6, 'b'))
    queue.settle()
    answers.push(queue.add(7, 'a'))
    queue.drain(act)
    const settled = Promise.allSettled(answers)
    for (let count = 1; count <= 6; count++) {
      expect(begun).toHaveLength(count)
      go?.()
      await new Promise((resolve) => setTimeout(resolve))
    }
    expect(begun).toEqual([1, 4, 3, 5, 6, 7])
    expect((await settled).map((answer) => ('value' in answer ? answer.value : answer.reason.message))).toEqual([
      'done 1',
      'done 4',
      'done 3',
      'done 4',
      'five',
      'done 6',
      'done 7',
    ])
    expect(queue.works).toEqual([])
    // The queue continues with later items.
    const later = queue.add(8, 'a')
    queue.drain(act)
    go?.()
    expect(await later).toBe('done 8')
  })

  it('keeps the work of one key from being replaced, or all work', () => {
    const queue = new NewestQueue<number, void>()
    const add = (work: number, key: string) => {
      queue.add(work, key)
      return queue.works
    }
    add(1, 'a')
    add(2, 'b')
    queue.settle('b')
    expect(add(3, 'a')).toEqual([3, 2])
    expect(add(4, 'b')).toEqual([3, 2, 4])
    queue.settle()
    add(5, 'a')
    expect(add(6, 'b')).toEqual([3, 2, 4, 5, 6])
  })

  it('gives all away that waits, and takes nothing that is given away for waiting', () => {
    const queue = new NewestQueue<number, void>()
    queue.add(1, 'a')
    queue.add(2, 'a')
    expect(queue.takeAll().map(({ work, askers }) => [work, askers.length])).toEqual([[2, 2]])
    queue.add(3, 'a')
    expect(queue.takeAll().map(({ work, askers }) => [work, askers.length])).toEqual([[3, 1]])
  })
})
