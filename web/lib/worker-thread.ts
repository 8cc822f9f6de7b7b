// SPDX-License-Identifier: GPL-3.0-or-later
// What runs in the worker of `createWorker`.
import { answerRequests } from './threads/answer-requests.ts'

answerRequests()
