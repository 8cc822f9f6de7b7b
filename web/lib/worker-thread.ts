// SPDX-License-Identifier: GPL-3.0-or-later
// The entry point of the worker of `createWorker`.
import { answerWorker } from './threads/worker-answers.ts'

answerWorker()
