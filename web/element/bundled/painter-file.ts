// SPDX-License-Identifier: GPL-3.0-or-later
// In place of ../../view/painter-file.ts in the one file: its thread runs the same file, and knows by its name what it is.
import { scriptOfFile, workerOfFile } from '../../lib/bundled/one-file.ts'

export const PAINTER_NAME = 'circle-voronoi/painter'

export const painterFile = scriptOfFile

export function newPainterWorker(): Worker {
  return workerOfFile(PAINTER_NAME)
}
