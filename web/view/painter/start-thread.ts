// SPDX-License-Identifier: GPL-3.0-or-later
// The entry point of the worker of a view's `Painter`.
import { answerViews } from './painter-thread.ts'

answerViews()
