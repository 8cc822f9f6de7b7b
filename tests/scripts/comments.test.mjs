// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, it } from 'vitest'
import { isHeadless, sentencesOf } from '../../scripts/comments.mjs'

it.each([
  'What is drawn.',
  'Those of circles and their cells.',
  'Those that are not there any more get new ids.',
  'Whose cells these are shared with.',
  'Of how many circles a link says the name alone, if they have one.',
  'So many times as many circles need another grid.',
  'So does an edit that runs out of memory.',
  'How far it is with circles that are opened.',
  'As it is once the pointer is there.',
  'Where the path leaves the last edge.',
  'None is asked for.',
  'The ones that failed.',
  'Such as have an area.',
  'Whoever asks is told.',
  'Whether what is drawn is light on dark.',
  'Likewise.',
])('names a sentence without a subject: %s', (sentence) => {
  expect(isHeadless(sentence)).toBe(true)
})

it.each([
  'The picture after the pointer has arrived.',
  'Where two arcs meet, the cell has a corner.',
  'As the grid is regular, each query visits nine boxes.',
  'Those circles are sorted by radius.',
  'Of two equal discs, the first is kept.',
  'Whether the worker has answered.',
  'Such circles have no cell.',
  'So no product overflows.',
  'The same circle can be selected twice.',
  'Whatsoever is a word.',
])('accepts a sentence that has one: %s', (sentence) => {
  expect(isHeadless(sentence)).toBe(false)
})

// Words at the start of sentences, which must not be found in the comments of this file.
const [WHAT, WHERE, SO, NONE, HOW, THOSE] = ['What', 'Where', 'So', 'None', 'How', 'Those']

it('reads comments of TypeScript and C++ by sentence, across lines and after code', () => {
  const text = `/**
 * The circles,
 * in order. ${WHAT} is drawn.
 * @param radius ${WHAT} it is
 */
const url = 'https://example.org' // ${WHERE} the page is
/// The first
/// sentence. ${SO} it ends.
int a = 1;  // ${NONE}.
/** One line. */`
  expect(sentencesOf(text)).toEqual([
    { line: 2, sentence: 'The circles, in order.' },
    { line: 2, sentence: 'What is drawn.' },
    { line: 4, sentence: 'What it is' },
    { line: 6, sentence: 'Where the page is' },
    { line: 7, sentence: 'The first sentence.' },
    { line: 7, sentence: 'So it ends.' },
    { line: 9, sentence: 'None.' },
    { line: 10, sentence: 'One line.' },
  ])
})

it('reads comments and docstrings of Python', () => {
  const text = `# ${WHAT} is read.
x = 1  # ${HOW} far.
def f():
    """Returns the circles.

    ${THOSE} of the file.
    """
y = "So it is"`
  expect(sentencesOf(text)).toEqual([
    { line: 1, sentence: 'What is read.' },
    { line: 2, sentence: 'How far.' },
    { line: 4, sentence: 'Returns the circles.' },
    { line: 6, sentence: 'Those of the file.' },
  ])
})
