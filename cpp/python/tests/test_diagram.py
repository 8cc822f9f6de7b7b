# SPDX-License-Identifier: GPL-3.0-or-later
import json
import pickle
import warnings

import numpy as np
import pytest
from conftest import ROOT, program, program_geojson, program_json, random_circles, table

import circle_voronoi as cv


@pytest.mark.parametrize("seed", range(5))
def test_a_diagram_has_the_bits_that_the_program_writes(seed):
    circles = random_circles(200, seed)
    diagram = cv.compute(circles)
    written = program_json("compute", table(circles))
    assert diagram.vertices.tolist() == [[v["x"], v["y"], v["r"]] for v in written["vertices"]]
    assert diagram.edges.tolist() == [e["circles"] + [-1 if v is None else v for v in e["vertices"]] for e in written["edges"]]
    assert diagram.hull.tolist() == written["hull"]
    assert [circle for circle, _ in diagram.hidden] == [h["circle"] for h in written["hidden"]]
    assert diagram.certified and written["stats"]["certificate"]["certified"]


@pytest.mark.parametrize("threads", [0, 2])
def test_threads_give_the_same_bits(threads):
    circles = random_circles(20_000, 1)
    one, more = cv.compute(circles), cv.compute(circles, threads=threads)
    assert one.vertices.tobytes() == more.vertices.tobytes() and one.edges.tobytes() == more.edges.tobytes()


def test_arrays_are_read_only_views_that_keep_their_memory():
    vertices = cv.compute(random_circles(50, 2)).vertices
    again = cv.compute(random_circles(50, 2))
    assert vertices.tobytes() == again.vertices.tobytes()
    assert np.shares_memory(again.vertices, again.vertices)
    for name in "circles vertices vertex_circles edges hidden hull next_side first_side ids".split():
        array = getattr(again, name)
        with pytest.raises(ValueError):
            array[...] = 0


def test_the_parts_of_a_diagram_fit_together():
    diagram = cv.compute(random_circles(300, 3))
    visible = len(diagram) - len(diagram.hidden)
    assert len(diagram.vertices) == 2 * visible - 2 - len(diagram.hull)
    for (x, y, r), touched in zip(diagram.vertices, diagram.vertex_circles):
        distances = np.hypot(*(diagram.circles[touched, :2] - (x, y)).T) - diagram.circles[touched, 2]
        assert distances == pytest.approx(r, abs=1e-9)
    side = diagram.first_side[diagram.hull[0]]
    around = [side]
    while (side := diagram.next_side[side]) != around[0]:
        around.append(side)
    neighbors = {int(diagram.edges[s // 2, 1 - s % 2]) for s in around}
    assert neighbors == set(diagram.neighbors(diagram.hull[0]).tolist())


def test_neighbors_and_pairs_agree():
    diagram = cv.compute(random_circles(100, 4))
    pairs = {tuple(pair) for pair in diagram.neighbor_pairs().tolist()}
    assert pairs == {tuple(sorted((i, int(j)))) for i in range(100) for j in diagram.neighbors(i)}
    bounds = (20, 20, 60, 60)
    inside = {tuple(pair) for pair in diagram.neighbor_pairs(bounds=bounds).tolist()}
    assert inside < pairs
    assert inside == {tuple(sorted((i, int(j)))) for i in range(100) for j in diagram.neighbors(i, bounds=bounds)}


def test_find_gives_the_nearest_circle():
    circles = random_circles(200, 5)
    points = np.random.default_rng(6).random((1000, 2)) * 120 - 10
    found = cv.compute(circles).find(points)
    distances = np.hypot(*(points[:, None] - circles[None, :, :2]).transpose(2, 0, 1)) - circles[:, 2]
    assert distances[np.arange(1000), found] == pytest.approx(distances.min(axis=1), abs=1e-9)


def test_areas_centroids_and_perimeters_are_those_of_the_polygons():
    diagram = cv.compute(random_circles(60, 7))
    bounds = (10, 5, 90, 80)
    cells = diagram.polygons(bounds=bounds, tolerance=1e-4)
    areas = np.array([0 if cell is None else cell.area for cell in cells])
    assert diagram.areas(bounds=bounds) == pytest.approx(areas, abs=0.05)
    assert diagram.areas(bounds=bounds).sum() == pytest.approx(80 * 75, rel=1e-12)
    lengths = np.array([0 if cell is None else cell.length for cell in cells])
    assert diagram.perimeters(bounds=bounds) == pytest.approx(lengths, abs=0.05)
    centers = diagram.centroids(bounds=bounds)
    for cell, center in zip(cells, centers):
        if cell is None:
            assert np.isnan(center).all()
        elif cell.area > 1:
            assert center == pytest.approx(np.array(cell.centroid.coords[0]), abs=0.05)


def test_whole_cells_are_unbounded_empty_or_those_in_a_large_box():
    diagram = cv.compute(random_circles(60, 8))
    areas, clipped = diagram.areas(), diagram.areas(bounds=(-1e4, -1e4, 1e4, 1e4))
    is_bounded = np.isfinite(areas)
    assert set(np.flatnonzero(~is_bounded)) == set(diagram.hull)
    assert areas[diagram.hidden[:, 0]].tolist() == [0] * len(diagram.hidden)
    is_small = is_bounded & (clipped < 1e4)
    assert areas[is_small] == pytest.approx(clipped[is_small], rel=1e-9, abs=1e-9)
    assert cv.compute([[1, 2, 3]]).areas().tolist() == [np.inf]


def test_without_limits_polygons_are_those_in_the_box_that_files_name():
    diagram = cv.compute(random_circles(60, 8))
    box = diagram.export_box()
    collection = json.loads(diagram.to_bytes("geojson"))
    assert list(box) == collection["bbox"] == program_geojson(diagram.circles)["bbox"]
    properties = [feature["properties"] for feature in collection["features"]]
    areas = [np.inf if one["area"] is None else one["area"] for one in properties]
    assert diagram.areas().tolist() == areas
    clipped = diagram.clipped_cells()
    assert clipped.tolist() == [one.get("clipped", False) for one in properties]
    assert set(diagram.hull) <= set(np.flatnonzero(clipped))
    assert not clipped[diagram.hidden[:, 0]].any()
    assert diagram.clipped_cells(bounds=box).tolist() == clipped.tolist()
    inside = diagram.areas(bounds=box)
    assert (diagram.areas()[clipped] > inside[clipped]).all()
    assert diagram.areas()[~clipped] == pytest.approx(inside[~clipped], rel=1e-9)
    assert not diagram.clipped_cells(bounds=(-1e9, -1e9, 1e9, 1e9))[np.isfinite(areas)].any()
    assert diagram.export_box(max_distance=2.5) == tuple(json.loads(diagram.to_bytes("geojson", max_distance=2.5))["bbox"])


def test_many_hidden_circles_cause_a_warning():
    with pytest.warns(UserWarning, match="2 of 3 circles are hidden"):
        cv.compute([[0, 0, 9], [1, 0, 1], [0, 1, 1]])
    with pytest.warns(UserWarning, match="2 of 3 circles are hidden"):
        sphere = cv.compute_sphere([[0, 0, 500], [1, 0, 1], [0, 1, 1]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cv.compute([[0, 0, 9], [1, 0, 1], [20, 0, 1], [0, 20, 1]])
        # By other metrics, circles without a cell are usual.
        around = [[-20, 0, 90], [20, 0, 90], [0, 20, 90], [0, -20, 90]]
        assert len(cv.compute([*around, [0, 0, 1], [1, 0, 1]], metric="power").hidden) == 2
        assert len(pickle.loads(pickle.dumps(sphere)).hidden) == 2


def test_a_cell_cut_at_a_distance_is_a_disc_where_no_neighbor_is_near():
    diagram = cv.compute([[0, 0, 1], [100, 0, 2]])
    assert diagram.areas(max_distance=3) == pytest.approx(np.pi * np.array([16, 25]))


def test_certify_proves_and_the_paper_s_method_may_be_wrong():
    circles = random_circles(40, 9)
    assert cv.compute(circles).certify() == (True, "none", None, None, None, "")
    by_touching = cv.compute(circles, method="touching-disc", candidates="all-pairs")
    assert by_touching.stats["way"] == "touching-disc"


def test_options_choose_the_pairs_and_samples_of_the_touching_disc_method():
    circles = random_circles(40, 16)

    def counts(**options):
        stats = cv.compute(circles, method="touching-disc", **options).stats
        return stats["counts"]["samples"], stats["counts"]["antipodalDiscs"], stats["counts"]["resamplings"]

    visible = 40 - len(cv.compute(circles).hidden)
    assert counts(candidates="uniform", samples=7)[0] == 7 * visible
    assert counts(candidates="uniform")[0] == 50 * visible
    assert counts(samples=0)[0] < counts()[0] < counts(samples=3)[0]
    assert counts(candidates="all-pairs")[:2] == (0, visible * (visible - 1) // 2)
    missed = cv.read(ROOT / "tests/fixtures/missed-antipodal-disc-chaos-75.csv")
    for resample in (False, True):
        diagram = cv.compute(missed, method="touching-disc", resample=resample)
        assert (diagram.certified, diagram.stats["counts"]["resamplings"] > 0) == (resample, resample)
    assert set(cv.compute(circles).stats) == {"way", "counts", "seconds"}
    assert cv.compute(circles, method="flip").stats["way"] == "flip"


def test_limits_of_neighbors_are_a_distance_and_a_region():
    diagram = cv.compute([[0, 0, 1], [10, 0, 1], [0, 14, 1]])
    assert diagram.neighbors(0, max_distance=3).tolist() == []
    assert diagram.neighbors(0, max_distance=5).tolist() == [1]
    assert diagram.neighbor_pairs(max_distance=5).tolist() == [[0, 1]]
    assert diagram.neighbor_pairs(bounds=(-1, 5, 1, 9)).tolist() == [[0, 2]]
    near = {"region": [[-1, 5], [1, 5], [1, 9], [-1, 9]], "max_distance": 5}
    assert diagram.neighbors(2, **near).tolist() == [] and diagram.neighbor_pairs(**near).tolist() == []
    around = cv.compute([[0, 0, 1], *([9 * np.cos(k), 9 * np.sin(k), 1] for k in (4, 1, 5, 3, 0, 2))])
    order = around.neighbors(0).tolist()
    first = order.index(5)
    assert order[first:] + order[:first] == [5, 2, 6, 4, 1, 3]
    # The first two share an edge on either side of the third.
    between = cv.compute([[-5, 0, 4], [5, 0, 4], [0, 0, 0.5]])
    assert sorted(between.neighbors(0).tolist()) == [1, 2] and len(between.edges) == 4


@pytest.mark.parametrize("measure", ["areas", "centroids", "perimeters"])
def test_measures_take_all_limits(measure):
    diagram = cv.compute(random_circles(60, 17))
    box, corners = (10, 20, 90, 80), [[10, 20], [90, 20], [90, 80], [10, 80]]
    of = getattr(diagram, measure)
    for options in ({}, {"max_distance": 2}):
        assert of(bounds=box, **options) == pytest.approx(of(region=corners, **options), rel=1e-9, nan_ok=True)
    cells = diagram.polygons(bounds=box, max_distance=2, tolerance=1e-5)
    for i, cell in enumerate(cells):
        if cell is not None and cell.area > 0.1:
            value = {"areas": cell.area, "centroids": cell.centroid.coords[0], "perimeters": cell.length}[measure]
            assert of(bounds=box, max_distance=2)[i] == pytest.approx(np.array(value), abs=1e-2)
    whole = of()
    for circle in diagram.hull:
        assert np.isnan(whole[circle]).all() if measure == "centroids" else np.isinf(whole[circle])
    for circle in diagram.hidden[:, 0]:
        assert np.isnan(whole[circle]).all() if measure == "centroids" else whole[circle] == 0
    inside = np.setdiff1d(np.arange(60), [*diagram.hull, *diagram.hidden[:, 0]])
    assert whole[inside] == pytest.approx(of(bounds=(-1e5, -1e5, 1e5, 1e5))[inside], rel=1e-6)


def test_the_tolerance_of_polygons_is_by_default_a_hundred_thousandth_of_the_box():
    diagram = cv.compute([[0, 0, 1], [10, 0, 3]])

    def corners(**options):
        return len(diagram.polygons(bounds=(-50, -50, 50, 50), **options)[0].exterior.coords)

    assert corners() == corners(tolerance=1e-3) < corners(tolerance=1e-5)


def test_a_diagram_says_its_size_and_whether_it_is_certified():
    diagram = cv.compute([[0, 0, 1], [10, 0, 1], [0, 14, 1], [0, 0, 0.5]])
    assert repr(diagram) == "<Diagram of 4 circles, 1 hidden, 1 vertices, 3 edges, certified>"
    assert diagram.hidden.tolist() == [[3, 0]] and not diagram.weights
    assert cv.compute([[0, 0, -1]], weights=True).weights
    assert diagram.find([[1, 1], [9, 1], [1, 13]]).dtype == np.int32


def test_a_pickled_diagram_is_the_same():
    diagram = cv.compute(random_circles(40, 10)).update(remove=[3])
    copy = pickle.loads(pickle.dumps(diagram))
    assert copy.vertices.tobytes() == diagram.vertices.tobytes()
    assert copy.ids.tolist() == diagram.ids.tolist() and copy.certified


def test_negative_weights():
    circles = random_circles(30, 11)
    lowered = circles - [0, 0, 5]
    with pytest.raises(cv.CircleVoronoiError):
        cv.compute(lowered)
    assert cv.compute(lowered, weights=True).vertices[:, :2] == pytest.approx(cv.compute(circles).vertices[:, :2])


@pytest.mark.parametrize("weights", [False, True])
def test_a_power_diagram_has_the_point_of_least_power(weights, tmp_path):
    circles = random_circles(60, 13)
    if weights:
        circles[:, 2] = circles[:, 2] ** 2 - 30
    diagram = cv.compute(circles, metric="power", weights=weights)
    assert diagram.metric == "power" and diagram.certified and diagram.certify().certified
    file = tmp_path / "power.json"
    diagram.write(file)
    assert cv.read(file).edges.tobytes() == diagram.edges.tobytes()
    places = np.random.default_rng(14).uniform(circles.min(axis=0)[:2], circles.max(axis=0)[:2], (500, 2))
    squares = ((places[:, None, :] - circles[None, :, :2]) ** 2).sum(axis=2)
    powers = squares - (circles[:, 2] if weights else circles[:, 2] ** 2)
    assert (powers[np.arange(500), diagram.find(places)] <= powers.min(axis=1) + 1e-9).all()
    with pytest.raises(cv.CircleVoronoiError, match="power cannot be updated"):
        diagram.update(remove=[0])


def test_the_diagram_of_centers_ignores_radii():
    circles = random_circles(60, 15)
    points = cv.compute(circles[:, :2], r=0)
    centers = cv.compute(circles, metric="centers")
    assert centers.vertices.tobytes() == points.vertices.tobytes() and centers.certified


def test_the_largest_empty_disc_touches_three_circles():
    circles = random_circles(50, 12)
    disc = cv.compute(circles).largest_empty_disc()
    gaps = np.hypot(circles[:, 0] - disc.x, circles[:, 1] - disc.y) - circles[:, 2]
    assert gaps.min() == pytest.approx(disc.r, abs=1e-9)
    assert gaps[disc.circles] == pytest.approx(disc.r, abs=1e-9)


def test_the_largest_empty_disc_lies_in_a_box():
    diagram = cv.compute([[0, 0, 1]])
    box = (0, 0, 4, 4)
    centered, inside = diagram.largest_empty_disc(bounds=box), diagram.largest_empty_disc(bounds=box, inside=True)
    assert centered[:3] == pytest.approx((4, 4, 32**0.5 - 1)) and centered.circles.tolist() == [0]
    assert inside.r == pytest.approx((32**0.5 - 1) / (1 + 2**0.5)) and inside.circles.tolist() == [0]
    assert cv.compute([]).largest_empty_disc() is None


def test_a_plot_shows_edges_and_circles():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    diagram = cv.compute(random_circles(30, 15))
    ax = diagram.plot(bounds=(0, 0, 100, 100), color="black")
    assert len(ax.patches) == 1 and len(ax.collections) == 1
    assert ax.get_xlim() == (0, 100)
    corners = ax.patches[0].get_path().vertices
    assert corners.min() >= -1 and corners.max() <= 101
    ax.figure.savefig("figure.pdf")


def test_a_path_reaches_ends_far_from_the_circles():
    diagram = cv.compute([[0, 0, 1], [10, 0, 1]])
    for start, end in (([5, 0], [900, 700]), ([-900, 700], [5, 0])):
        path = diagram.clearest_path(start, end)
        assert path.clearance == pytest.approx(4)
        assert path.points[0] == pytest.approx(start)
        assert path.points[-1] == pytest.approx(end)


def test_a_path_follows_edges_and_stays_in_a_region():
    diagram = cv.compute([[0, 0, 1], [10, 0, 3]])
    path = diagram.clearest_path([4.5, -9], [4.5, 9], bounds=(1.5, -20, 6.5, 20))
    assert path.edges.tolist() == [0] and path.clearance == pytest.approx(3)
    coarse = diagram.clearest_path([4.5, -9], [4.5, 9], bounds=(1.5, -20, 6.5, 20), tolerance=1)
    assert len(coarse.points) < len(path.points)
    assert len({tuple(point) for point in path.points}) == len(path.points)
    walls = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[5, 0], [9, 0], [9, 4], [5, 4]]]
    assert diagram.clearest_path([1, 2], [8, 2], region=walls) is None
    with pytest.raises(cv.CircleVoronoiError, match="outside"):
        diagram.clearest_path([1, 2], [30, 2], bounds=(0, 0, 9, 9))
    with pytest.raises(cv.CircleVoronoiError):
        cv.compute([]).clearest_path([1, 2], [3, 4])
