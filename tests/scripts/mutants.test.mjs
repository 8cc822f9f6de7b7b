// SPDX-License-Identifier: GPL-3.0-or-later
import { test } from 'vitest'
import { check, readMutants } from '../../scripts/mutate-core.mjs'

test('each change that `npm run mutate:core` makes fits the sources', () => readMutants().forEach(check))
