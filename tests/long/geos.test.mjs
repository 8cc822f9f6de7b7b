// SPDX-License-Identifier: GPL-3.0-or-later
// GEOS finds the polygons of 5,000 clips valid and free of overlaps, and their union equal to the region. Dissolved regions
// equal the unions of GEOS.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { text } from 'node:stream/consumers'
import { test } from 'node:test'
import { NATIVE, ROOT } from '../wasm/native-program.mjs'

const CLIPS_OF_A_FAMILY = 500
const UNIONS = 2000
const SEED = 20

/** Debian's own Python has Debian's shapely. */
const PYTHON = '/usr/bin/python3'

const ended = (child) => new Promise((resolve) => child.once('close', resolve))

test(`polygons of clips are valid for GEOS (seed ${SEED})`, async () => {
  const clips = spawn(`${ROOT}build/native/tests/cpp/circle_voronoi_print_clips`, [CLIPS_OF_A_FAMILY, SEED].map(String))
  const judge = spawn(PYTHON, [`${ROOT}tests/long/geos.py`])
  clips.stdout.pipe(judge.stdin)
  const [printed, reported, statusOfClips, statusOfJudge] = await Promise.all([
    text(judge.stdout),
    text(judge.stderr),
    ended(clips),
    ended(judge),
  ])
  assert.equal(statusOfClips, 0)
  assert.equal(statusOfJudge, 0, `${printed}\n${reported}`)
})

test(`regions that share borders dissolve into the unions of GEOS (seed ${SEED})`, async () => {
  const judge = spawn(PYTHON, [`${ROOT}tests/long/dissolve.py`, NATIVE, UNIONS, SEED].map(String))
  const [printed, reported, status] = await Promise.all([text(judge.stdout), text(judge.stderr), ended(judge)])
  assert.equal(status, 0, `${printed}\n${reported}`)
})
