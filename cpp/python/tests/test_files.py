# SPDX-License-Identifier: GPL-3.0-or-later
import datetime
import json
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, program, random_circles, table

import circle_voronoi as cv


@pytest.mark.parametrize("format", ["json", "csv", "svg", "geojson", "geojsonl", "wkt", "obj"])
def test_a_file_has_the_bytes_that_the_program_writes(format):
    path = table(random_circles(60, 1))
    diagram = cv.compute(cv.read(path))
    options = [] if format in ("json", "csv") else ["--bounds", "0,0,100,100"]
    written = program("compute", path, "--format", format, *options)
    diagram.write(f"cells.{format}", **({"bounds": (0, 0, 100, 100)} if options else {}))
    ours = Path(f"cells.{format}").read_bytes()
    if format == "json":  # times differ
        ours, written = (json.dumps({**json.loads(text), "stats": None}).encode() for text in (ours, written))
    assert ours == written


@pytest.mark.parametrize(
    "options, arguments",
    [
        ({"max_distance": 2}, ["--max-distance", "2"]),
        ({"tolerance": 0.5}, ["--tolerance", "0.5"]),
        ({"digits": 1}, ["--digits", "1"]),
        ({"region": [[0, 0], [100, 0], [50, 90]]}, ["--region", "triangle.wkt"]),
    ],
    ids=str,
)
def test_options_of_files_are_those_of_the_program(options, arguments):
    Path("triangle.wkt").write_text("POLYGON ((0 0, 100 0, 50 90, 0 0))")
    path = table(random_circles(60, 3))
    written = program("compute", path, "--format", "geojson", *arguments)
    plain = program("compute", path, "--format", "geojson")
    assert cv.compute(cv.read(path)).to_bytes("geojson", **options) == written != plain


def test_radii_may_be_negative_or_missing():
    Path("weights.csv").write_text("x,y,r\n1,2,-3\n")
    Path("points.csv").write_text("x,y\n1,2\n")
    assert cv.read("weights.csv", weights=True).tolist() == [[1, 2, -3]]
    assert cv.read("points.csv", points=True).tolist() == [[1, 2, 0]]
    assert cv.read("weights.csv", points=True).tolist() == [[1, 2, 0]]
    assert cv.read_attributes("weights.csv", points=True) == [{"r": -3}]
    for path, options in (("weights.csv", {}), ("points.csv", {"weights": True})):
        with pytest.raises(cv.CircleVoronoiError):
            cv.read(path, **options)


TABLE = "name,easting,northing,pull,r\nA,1,2,0.5,7\nB,3,,1,8\nC,5,6,-2,9\n"
POINT_AT = {"type": "Point", "coordinates": [1, 2]}
GEOJSON = {"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"pull": 3}, "geometry": POINT_AT}]}


@pytest.mark.parametrize(
    "name, text, options, arguments",
    [
        ("table.csv", TABLE.replace(",,", ",4,"), {"radius": "R"}, ["--radius", "R"]),
        ("table.csv", TABLE, {"x": "pull", "y": "r", "radius": "#2"}, ["--x", "pull", "--y", "r", "--radius", "#2"]),
        ("table.csv", TABLE, {"points": True, "x": "pull", "y": "r"}, ["--points", "--x", "pull", "--y", "r"]),
        ("table.csv", TABLE, {"radius": "pull", "skip_invalid": True}, ["--radius", "pull", "--skip-invalid"]),
        ("table.csv", TABLE.replace(",,", ",4,"), {"radius": "pull", "weights": True}, ["--radius", "pull", "--weights"]),
        ("points.geojson", json.dumps(GEOJSON), {"radius": "pull"}, ["--radius", "pull"]),
    ],
)
@pytest.mark.filterwarnings("ignore:.*were skipped")
def test_columns_are_those_of_the_program(name, text, options, arguments):
    Path(name).write_text(text)
    written = json.loads(program("compute", name, "--format", "json", *arguments))["circles"]
    circles, attributes = cv.read(name, **options), cv.read_attributes(name, **options)
    assert len(circles) > 0
    assert circles.tolist() == [[one["x"], one["y"], one["r"]] for one in written]
    assert attributes == [one.get("properties", {}) for one in written]


def test_a_warning_tells_how_many_rows_were_skipped():
    Path("table.csv").write_text(TABLE)
    with pytest.warns(UserWarning, match=r"^2 of 3 rows were skipped; the first: table.csv:3: "):
        assert cv.read("table.csv", radius="pull", skip_invalid=True).tolist() == [[1, 2, 0.5]]


@pytest.mark.parametrize(
    "options, words",
    [
        ({"x": 1}, "x must be the name of a column (got 1)."),
        ({"points": True, "radius": "r"}, "Points have no radii"),
        ({"points": True, "weights": True}, "Points have no radii"),
        ({"radius": "size"}, "size"),
    ],
)
def test_wrong_options_of_read_are_one_error(options, words):
    Path("circles.csv").write_text("x,y,r\n1,2,3\n")
    for read in (cv.read, cv.read_attributes):
        with pytest.raises(cv.CircleVoronoiError) as caught:
            read("circles.csv", **options)
        assert words in str(caught.value)


def test_a_file_of_a_diagram_takes_no_columns():
    cv.compute([[0, 0, 1]]).write("diagram.json")
    with pytest.raises(cv.CircleVoronoiError, match="diagram.json holds a diagram") as caught:
        cv.read("diagram.json", radius="pull")
    assert caught.value.code == "badOption"


def test_circles_and_attributes_are_read():
    path = ROOT / "public/data/bronzefilter.csv"
    assert cv.read(path).shape == (678, 3)
    Path("shops.csv").write_text("name;lon;lat;radius\nA;1,5;2;0,5\nB;3;4;1\n")
    assert cv.read("shops.csv").tolist() == [[1.5, 2, 0.5], [3, 4, 1]]
    assert cv.read_attributes("shops.csv") == [{"name": "A"}, {"name": "B"}]


def test_a_diagram_is_read_and_judged_again():
    diagram = cv.compute(random_circles(30, 2))
    diagram.write("diagram.json")
    assert cv.read("diagram.json").certified
    text = json.loads(Path("diagram.json").read_text())
    text["vertices"][0]["x"] += 1
    Path("diagram.json").write_text(json.dumps(text))
    wrong = cv.read("diagram.json")
    assert (wrong.certified, wrong.certificate.flaw, wrong.certificate.vertex) == (False, "vertexMisplaced", 0)


def test_attributes_become_properties():
    diagram = cv.compute([[0, 0, 1], [5, 0, 1]])
    text = diagram.to_bytes("geojson", attributes=[{"name": "A", "visits": 3}, {"name": "“B”"}])
    properties = [feature["properties"] for feature in json.loads(text)["features"]]
    assert properties[0]["name"] == "A" and properties[0]["visits"] == 3 and properties[1]["name"] == "“B”"


@pytest.mark.parametrize(
    "value, text",
    [
        (np.int64(3), 3),
        (np.float32(0.5), 0.5),
        (np.bool_(True), True),
        (float("nan"), None),
        (np.float64("nan"), None),
        (np.datetime64("NaT"), None),
        (np.datetime64("2024-05-01T12:30"), "2024-05-01T12:30"),
        (datetime.datetime(2024, 5, 1, 12, 30, tzinfo=datetime.timezone.utc), "2024-05-01T12:30:00+00:00"),
        (datetime.date(2024, 5, 1), "2024-05-01"),
        (datetime.time(12, 30), "12:30:00"),
        (np.arange(3), [0, 1, 2]),
        ({"inner": [np.int8(1), (float("nan"),)], np.int32(7): np.array(2.5)}, {"inner": [1, [None]], "7": 2.5}),
    ],
    ids=str,
)
@pytest.mark.parametrize("format", ["json", "geojson"])
def test_values_of_attributes_are_those_of_json(format, value, text):
    written = json.loads(cv.compute([[0, 0, 1], [5, 0, 1]]).to_bytes(format, attributes=[{"value": value}, {}]))
    row = written["circles" if format == "json" else "features"][0]
    assert row["properties"]["value"] == text


@pytest.mark.parametrize("value", [float("inf"), np.float64("-inf"), datetime.timedelta(1), b"x", {1: 2, "1": 3}, {(1, 2): 3}], ids=str)
def test_other_values_of_attributes_are_one_error(value):
    with pytest.raises(cv.CircleVoronoiError, match="^Row 1 of attributes is no JSON: ") as caught:
        cv.compute([[0, 0, 1], [5, 0, 1]]).to_bytes("json", attributes=[{}, {"value": value}])
    assert caught.value.circle == 1


def test_a_file_that_cannot_be_written_leaves_the_old_one():
    diagram = cv.compute([[0, 0, 1], [5, 0, 1]])
    Path("cells.geojson").write_text("old")
    with pytest.raises(cv.CircleVoronoiError):
        diagram.write("cells.geojson", tolerance=-1)
    assert Path("cells.geojson").read_text() == "old" and list(Path().iterdir()) == [Path("cells.geojson")]
    Path("folder.json").mkdir()
    with pytest.raises(OSError):
        diagram.write("folder.json")
    assert sorted(Path().iterdir()) == [Path("cells.geojson"), Path("folder.json")]
    diagram.write("cells.GeoJSON")
    assert Path("cells.GeoJSON").read_bytes() == diagram.to_bytes("geojson")


@pytest.mark.parametrize("text, words", [(b"x,y,r\n1,2,q\n", "bad.csv:2"), (b"", "bad.csv"), (b"\xff\xfe", "bad.csv")])
def test_a_bad_file_is_one_error_that_names_the_line(text, words):
    Path("bad.csv").write_bytes(text)
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.read("bad.csv")
    assert str(caught.value).startswith(words)


HOSTILE = ["the option r", "Set `dissolve` to merge them.", "name one by the option x.", "%s {0} $& \\1"]


@pytest.mark.parametrize("name", HOSTILE)
def test_messages_quote_names_as_they_are(name):
    Path(name).write_text(f'"x","y","{name}"\n1,2,3\n', encoding="utf-8")
    with pytest.raises(cv.CircleVoronoiError) as caught:
        cv.read(name)
    assert str(caught.value).startswith(f"{name}:1: no column is called r, rad or radius, only x, y, {name}; ")


def test_attributes_of_any_text_go_through_a_file():
    attributes = [{"": "", " a ": [{}, []], "é": {"the option r": None}, "z": "no height", "x\n": "\"\\"}, {}]
    diagram = cv.compute([[0, 0, 1], [5, 0, 1]])
    text = diagram.to_bytes("geojson", attributes=attributes)
    for feature, expected in zip(json.loads(text)["features"], attributes):
        assert {name: feature["properties"][name] for name in expected} == expected
    Path("circles.json").write_bytes(diagram.to_bytes("json", attributes=attributes))
    assert json.loads(Path("circles.json").read_text(encoding="utf-8"))["circles"][0]["properties"] == attributes[0]
    assert cv.read("circles.json").certified
