// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { countTestCases, summary } from '../../scripts/count-tests.mjs'

it('counts the test cases of a JUnit report by outcome', () => {
  const report = `<testsuites><testsuite name="a" tests="5">
    <testcase name="one" time="1"/>
    <testcase name="two"><system-out><![CDATA[<testcase name="no"><failure/>]]></system-out></testcase>
    <testcase name="three"><failure message="m">text</failure></testcase>
    <testcase name="four"><error/></testcase>
    <testcase name="five"><skipped/></testcase>
  </testsuite></testsuites>`
  expect(countTestCases(report)).toEqual({ passed: 2, failed: 2, skipped: 1 })
})

it('says so in one line', () => {
  expect(summary({ passed: 2, failed: 0, skipped: 0 })).toBe('2 passed, 0 failed')
  expect(summary({ passed: 2, failed: 1, skipped: 3 })).toBe('2 passed, 1 failed, 3 skipped')
})
