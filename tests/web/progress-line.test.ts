// SPDX-License-Identifier: GPL-3.0-or-later
// The progress line of the program in Node. tests/cpp/progress_text_test.cpp tests the native one with the same cases.
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import { ProgressLine } from '../../web/cli/progress-line.ts'

let text = ''
let line: ProgressLine
beforeEach(() => {
  vi.useFakeTimers()
  text = ''
  line = new ProgressLine((part) => {
    text += part
  })
})
afterEach(() => {
  vi.useRealTimers()
})

/** The output since the last call. */
function written(): string {
  const part = text
  text = ''
  return part
}

it('says each stage at once, its part, and the seconds', () => {
  line.begin(0)
  vi.advanceTimersByTime(500)
  expect(written()).toBe('')
  line.show('read', undefined)
  expect(written()).toBe('read, 0 s')
  line.show('read', undefined)
  vi.advanceTimersByTime(499)
  expect(written()).toBe('')
  vi.advanceTimersByTime(101)
  expect(written()).toBe(`\r${' '.repeat(9)}\rread, 1 s`)
  line.show('touch', 7)
  expect(written()).toBe(`\r${' '.repeat(9)}\rtouch 7 %, 1 s`)
  line.show('touch', 8)
  expect(written()).toBe(`\r${' '.repeat(14)}\rtouch 8 %, 1 s`)
  line.end()
  expect(written()).toBe(`\r${' '.repeat(14)}\r`)
  line.show('write', undefined)
  vi.advanceTimersByTime(5000)
  expect(written()).toBe('')
})

it('says nothing before its delay', () => {
  line.begin(1000)
  line.show('read', undefined)
  vi.advanceTimersByTime(999)
  line.show('triangulate', undefined)
  expect(written()).toBe('')
  vi.advanceTimersByTime(1)
  expect(written()).toBe('triangulate, 1 s')
  line.end()
})

it('writes nothing at all where it ends before its delay', () => {
  line.begin(1000)
  line.show('read', undefined)
  vi.advanceTimersByTime(900)
  line.end()
  vi.advanceTimersByTime(9000)
  expect(written()).toBe('')
})
