# SPDX-License-Identifier: GPL-3.0-or-later
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
    for path, options in (("weights.csv", {"points": True}), ("points.csv", {"weights": True})):
        with pytest.raises(cv.CircleVoronoiError):
            cv.read(path, **options)


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
