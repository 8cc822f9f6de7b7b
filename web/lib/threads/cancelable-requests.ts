// SPDX-License-Identifier: GPL-3.0-or-later

/** Requests that can be canceled one by one, by their signals, or all together. */
export class CancelableRequests {
  readonly #running = new Set<AbortController>()

  /** Runs a request. The controller that `act` gets follows `signal` and `cancelAll`. */
  async run<Answer>(
    signal: AbortSignal | undefined,
    act: (controller: AbortController) => Promise<Answer>,
  ): Promise<Answer> {
    signal?.throwIfAborted()
    const controller = new AbortController()
    const abort = () => controller.abort(signal?.reason)
    signal?.addEventListener('abort', abort)
    this.#running.add(controller)
    try {
      return await act(controller)
    } finally {
      this.#running.delete(controller)
      signal?.removeEventListener('abort', abort)
    }
  }

  cancelAll(reason: unknown): void {
    for (const controller of this.#running) controller.abort(reason)
  }
}
