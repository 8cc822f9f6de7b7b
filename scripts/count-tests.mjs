// SPDX-License-Identifier: GPL-3.0-or-later
import { existsSync, readFileSync } from 'node:fs'

export const NO_TESTS = { passed: 0, failed: 0, skipped: 0 }

/** Counts the test cases of a JUnit report by outcome; a missing report has none. */
export function countTests(path) {
  return existsSync(path) ? countTestCases(readFileSync(path, 'utf8')) : NO_TESTS
}

export function countTestCases(xml) {
  const counts = { ...NO_TESTS }
  for (const { outcome } of testCases(xml)) counts[outcome] += 1
  return counts
}

/** The names of failed tests in a report. */
export function failedTests(path) {
  if (!existsSync(path)) return []
  const failed = testCases(readFileSync(path, 'utf8')).filter(({ outcome }) => outcome === 'failed')
  return failed.map(({ attributes }) => / name="([^"]*)"/.exec(attributes)?.[1] ?? attributes)
}

function testCases(xml) {
  // CDATA sections hold output, which may look like anything.
  const elements = xml.replace(/<!\[CDATA\[.*?\]\]>/gs, '')
  const cases = elements.matchAll(/<testcase\b([^>]*?)(?:(\/)>|>(.*?)<\/testcase>)/gs)
  return [...cases].map(([, attributes, isEmpty, body = '']) => ({
    attributes,
    outcome: isEmpty ? 'passed' : outcomeOf(body),
  }))
}

function outcomeOf(body) {
  if (/<(failure|error)\b/.test(body)) return 'failed'
  return /<skipped\b/.test(body) ? 'skipped' : 'passed'
}

/** Formats as `N passed, M failed`, with the number of skipped tests unless it is 0. */
export function summary({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ''}`
}
