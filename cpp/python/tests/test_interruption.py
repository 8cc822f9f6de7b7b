# SPDX-License-Identifier: GPL-3.0-or-later
import signal
import threading

import numpy as np
import pytest

import circle_voronoi as cv


def many_circles():
    random = np.random.default_rng(1)
    return np.column_stack([random.random((1_000_000, 2)), np.zeros(1_000_000)])


def test_ctrl_c_cancels_a_computation():
    circles = many_circles()
    signal.setitimer(signal.ITIMER_REAL, 0.02)
    before = signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
    try:
        with pytest.raises(KeyboardInterrupt):
            cv.compute(circles)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert cv.compute(circles[:10]).certified


def test_other_threads_run_meanwhile():
    done = threading.Event()
    turns = 0

    def count():
        nonlocal turns
        while not done.wait(0.001):
            turns += 1

    counting = threading.Thread(target=count)
    counting.start()
    try:
        before = turns
        cv.compute(many_circles())
        assert turns > before + 1
    finally:
        done.set()
        counting.join()


def test_two_threads_compute_at_the_same_time():
    circles = many_circles()[:2000]
    expected = cv.compute(circles).vertices.tobytes()
    results = []
    threads = [threading.Thread(target=lambda: results.append(cv.compute(circles).vertices.tobytes())) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == [expected] * 8
