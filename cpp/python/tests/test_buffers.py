# SPDX-License-Identifier: GPL-3.0-or-later
"""Buffers and arrays of every shape and type, given to every function that takes an array: right, or one error."""

import array
import subprocess
import sys
import textwrap

import numpy as np
import pytest

import circle_voronoi as cv

CIRCLES = np.array([[0, 0, 2], [10, 0, 1], [5, 8, 1.5], [4, 3, 0]])
SQUARE = np.array([[0, 0], [20, 0], [20, 20], [0, 20]], dtype=float)


def released(values):
    view = memoryview(np.array(values, dtype=float))
    view.release()
    return view


def ones(*shape):
    return memoryview(np.ones(shape))


# Each function with the right shape of its array; n stands for any number of rows.
TAKERS = {
    "compute": (lambda given: cv.compute(given), ("n", 3)),
    "compute, x": (lambda given: cv.compute(given, CIRCLES[:, 1], CIRCLES[:, 2]), (4,)),
    "compute, y": (lambda given: cv.compute(CIRCLES[:, 0], given, CIRCLES[:, 2]), (4,)),
    "compute, r": (lambda given: cv.compute(CIRCLES[:, :2], r=given), (4,)),
    "compute_periodic": (lambda given: cv.compute_periodic(given, (30, 0), (0, 30)), ("n", 3)),
    "compute_periodic, a": (lambda given: cv.compute_periodic(CIRCLES, given, (-40, 30)), (2,)),
    "compute_sphere": (lambda given: cv.compute_sphere(given), ("n", 3)),
    "compute_sphere, lat": (lambda given: cv.compute_sphere(CIRCLES[:, 0], given, CIRCLES[:, 2]), (4,)),
    "SphereDiagram.find": (lambda given: cv.compute_sphere(CIRCLES).find(given), ("n", 2)),
    "find": (lambda given: cv.compute(CIRCLES).find(given), ("n", 2)),
    "PeriodicDiagram.find": (lambda given: cv.compute_periodic(CIRCLES, (30, 0), (0, 30)).find(given), ("n", 2)),
    "clearest_path, start": (lambda given: cv.compute(CIRCLES).clearest_path(given, (1, 2)), (2,)),
    "clearest_path, end": (lambda given: cv.compute(CIRCLES).clearest_path((1, 2), given), (2,)),
    "bounds": (lambda given: cv.compute(CIRCLES).areas(bounds=given), (4,)),
    "update, insert": (lambda given: cv.compute(CIRCLES).update(insert=given), ("n", 3)),
    "update, replace": (lambda given: cv.compute(CIRCLES).update(replace={0: given}), (3,)),
    "update, remove": (lambda given: cv.compute(CIRCLES).update(remove=given), ("n",)),
    "Region": (lambda given: cv.Region(given), ("n", 2)),
    "Region of rings": (lambda given: cv.Region([given]), ("n", 2)),
    "fit_areas, points": (lambda given: cv.fit_areas(given, "equal", SQUARE), ("n", 2)),
    "fit_areas, areas": (lambda given: cv.fit_areas(CIRCLES[:, :2] + 1, given, SQUARE, shares=True), (4,)),
    "fit_areas, weights": (lambda given: cv.fit_areas(CIRCLES[:, :2] + 1, "equal", SQUARE, weights=given), (4,)),
    "fit_areas_periodic, points": (lambda given: cv.fit_areas_periodic(given, "equal", (9, 0), (0, 9)), ("n", 2)),
    "fit_areas_periodic, areas": (
        lambda given: cv.fit_areas_periodic(CIRCLES[:, :2], given, (30, 0), (0, 30), shares=True),
        (4,),
    ),
}

# Right arguments, by function.
RIGHT = {
    "compute_periodic, a": np.array([30.0, 1.0]),
    "bounds": np.array([0.0, 0.0, 9.0, 9.0]),
    "update, replace": np.array([1.0, 1.0, 1.0]),
    "update, remove": np.array([0, 2]),
    "Region": SQUARE,
    "Region of rings": SQUARE,
    "fit_areas, areas": np.array([1.0, 2.0, 3.0, 4.0]),
    "fit_areas, weights": np.array([0.0, 0.5, 0.0, 0.0]),
    "fit_areas_periodic, areas": np.array([1.0, 2.0, 3.0, 4.0]),
    "clearest_path, start": np.array([1.0, 5.0]),
    "clearest_path, end": np.array([1.0, 5.0]),
}
ROWS = {2: CIRCLES[:, :2] + 1, 3: CIRCLES}


def right(name):
    if name in RIGHT:
        return RIGHT[name]
    _, shape = TAKERS[name]
    return ROWS[shape[1]] if len(shape) == 2 else CIRCLES[:, 2].copy()


def bits(result):
    """Something to compare results by."""
    if isinstance(result, tuple):
        return [bits(item) for item in result]
    if isinstance(result, np.ndarray):
        return result.tobytes()
    if isinstance(result, cv.Diagram):
        return result.to_bytes("csv")
    if isinstance(result, cv.PeriodicDiagram):
        return bits(result.images)
    return str(result)


@pytest.mark.parametrize("name", TAKERS)
def test_the_numbers_count_and_not_how_they_lie_in_memory(name):
    call, _ = TAKERS[name]
    given = right(name)
    expected = bits(call(given))
    forms = {
        "a list": given.tolist(),
        "a memory view": memoryview(given),
        "a read-only memory view": memoryview(given).toreadonly(),
        "every second row": memoryview(np.repeat(given, 2, axis=0))[::2],
        "rows from the last": memoryview(np.ascontiguousarray(given[::-1]))[::-1],
        "columns in a row": memoryview(np.asfortranarray(given)),
        "the other order of bytes": given.astype(given.dtype.newbyteorder()),
        "an array of objects": given.astype(object),
    }
    if given.ndim == 1:
        forms["an array of Python"] = array.array("d" if given.dtype.kind == "f" else "l", given.tolist())
    for form, same in forms.items():
        assert bits(call(same)) == expected, form


BAD = {
    "no dimension": lambda: memoryview(np.array(3.5)),
    "three dimensions": lambda: ones(2, 2, 2),
    "too many columns": lambda: ones(3, 7),
    "one column": lambda: ones(3, 1),
    "five numbers": lambda: memoryview(np.array([0.5, 1, 2, 3, 4])),
    "released": lambda: released([[1, 2, 3]]),
    "a released row": lambda: [released([1, 2])],
    "complex numbers": lambda: memoryview(np.ones((3, 3), dtype=complex)),
    "records": lambda: memoryview(np.ones(4, dtype=[("x", "f8"), ("y", "f8")])),
    "an array of records": lambda: np.ones(4, dtype=[("x", "f8"), ("y", "f8")]),
    "letters": lambda: memoryview(b"abcdef").cast("c", (2, 3)),
    "texts": lambda: np.array([["a", "b", "c"]]),
    "dates": lambda: np.array([["2020-01-01"] * 3], dtype="datetime64[D]"),
    "durations": lambda: np.ones((3, 3), dtype="m8[s]"),
    "bytes": lambda: b"abc",
    "huge numbers": lambda: [[10**400, 0, 0]],
    "nothing": lambda: None,
    "a type": lambda: float,
    "an object": lambda: object(),
}
# Combinations that are right: one number for all, and no replacement.
ACCEPTED = {
    ("no dimension", "compute, r"),
    ("no dimension", "compute, y"),
    ("no dimension", "compute_sphere, lat"),
    ("no dimension", "fit_areas, weights"),
    ("no dimension", "fit_areas, areas"),
    ("no dimension", "fit_areas_periodic, areas"),
    ("nothing", "update, replace"),
}


@pytest.mark.parametrize("kind", BAD)
@pytest.mark.parametrize("name", TAKERS)
def test_another_array_is_one_error(name, kind):
    if (kind, name) in ACCEPTED or (kind == "nothing" and name in ("compute, r", "compute, y", "bounds")):
        return
    call, _ = TAKERS[name]
    with pytest.raises(cv.CircleVoronoiError) as caught:
        call(BAD[kind]())
    assert caught.value.code in ("badInput", "badOption", "nonFinite"), caught.value.code


def test_arrays_of_two_dimensions_are_not_flattened():
    for remove in (np.array([[0, 1]]), memoryview(np.array([[0], [1]])), [[0, 1]]):
        with pytest.raises(cv.CircleVoronoiError, match="expected \\(n,\\)"):
            cv.compute(CIRCLES).update(remove=remove)


def test_other_things_than_numbers_are_one_error_too():
    diagram = cv.compute(CIRCLES)
    calls = [
        lambda given: diagram.neighbors(given),
        lambda given: diagram.to_bytes("json", digits=given),
        lambda given: diagram.to_bytes(given),
        lambda given: diagram.to_bytes("geojson", attributes=given),
        lambda given: diagram.to_bytes("geojson", attributes=[given] * 4),
        lambda given: cv.compute(CIRCLES, threads=given),
        lambda given: cv.compute(CIRCLES, method=given),
        lambda given: diagram.areas(max_distance=given),
        lambda given: diagram.polygons(tolerance=given),
        lambda given: diagram.update(replace=given),
    ]
    for given in (ones(2, 2), released([1]), np.ones((2, 2)), int, object(), (i for i in "ab"), {"a": float("inf")}, [1]):
        for number, call in enumerate(calls):
            with pytest.raises(cv.CircleVoronoiError):
                call(given)
                pytest.fail(f"call {number} takes {given!r}")


def test_attributes_that_are_no_json_are_one_error():
    circular = {}
    circular["a"] = circular
    for bad in ({"a": float("inf")}, {"a": object()}, {("a", "b"): 1}, circular, {"a": "\ud800"}):
        with pytest.raises(cv.CircleVoronoiError) as caught:
            cv.compute(CIRCLES).to_bytes("geojson", attributes=[{}, bad, {}, {}])
        assert caught.value.code == "badInput" and caught.value.circle == 1, str(caught.value)


def test_what_an_iterator_raises_passes_through():
    def circles():
        yield [0, 0, 1]
        raise KeyError("gone")

    with pytest.raises(KeyError):
        cv.compute(circles())


# Exits with the lines that it prints. The second interpreter is refused, before and after an import in the first one.
SUBINTERPRETER = """
    import sys
    try:
        import _interpreters as interpreters
    except ImportError:
        import _xxsubinterpreters as interpreters

    script = '''
    try:
        import circle_voronoi
        print("imported", flush=True)
    except ImportError as error:
        print("refused:", error, flush=True)
    '''
    def refused():
        identity = interpreters.create()
        interpreters.run_string(identity, script)
        interpreters.destroy(identity)

    def used():
        import circle_voronoi
        print(len(circle_voronoi.compute([[0, 0, 1], [5, 0, 1]]).edges), flush=True)

    for step in sys.argv[1]:
        refused() if step == "s" else used()
"""


@pytest.mark.parametrize("steps", ["s", "sm", "ms", "smsm", "mssm"])
def test_subinterpreters_are_refused_and_the_first_one_goes_on(steps):
    run = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(SUBINTERPRETER), steps], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    lines = {"s": "refused: circle_voronoi cannot be imported in a subinterpreter.", "m": "1"}
    assert run.stdout.splitlines() == [lines[step] for step in steps]
