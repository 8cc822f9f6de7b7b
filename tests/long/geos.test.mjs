// SPDX-License-Identifier: GPL-3.0-or-later
// GEOS finds the polygons of 5,000 clips valid and free of overlaps, and their union equal to the region.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { text } from 'node:stream/consumers'
import { test } from 'node:test'
import { ROOT } from '../wasm/native-program.mjs'

const CLIPS_OF_A_FAMILY = 500
const SEED = 20

test(`polygons of clips are valid for GEOS (seed ${SEED})`, async () => {
  const clips = spawn(`${ROOT}build/native/tests/cpp/circle_voronoi_print_clips`, [CLIPS_OF_A_FAMILY, SEED].map(String))
  // Debian's Python has Debian's shapely.
  const judge = spawn('/usr/bin/python3', [`${ROOT}tests/long/geos.py`])
  clips.stdout.pipe(judge.stdin)
  const ended = (child) => new Promise((resolve) => child.once('close', resolve))
  const [printed, reported, statusOfClips, statusOfJudge] = await Promise.all([
    text(judge.stdout),
    text(judge.stderr),
    ended(clips),
    ended(judge),
  ])
  assert.equal(statusOfClips, 0)
  assert.equal(statusOfJudge, 0, `${printed}\n${reported}`)
})
