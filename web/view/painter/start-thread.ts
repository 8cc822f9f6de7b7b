// SPDX-License-Identifier: GPL-3.0-or-later
// The entry point of the worker of a view's `Painter`.

// First, because it brings Emscripten's scripts, which are compressed to a third if they follow one another.
import './other-modules.ts'
import { answerViews } from './painter-thread.ts'

answerViews()
