// SPDX-License-Identifier: GPL-3.0-or-later
// circle-voronoi edit: scripts of edits.
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/editor.h"
#include "circle_voronoi/io.h"
#include "cli.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

class CliEdit : public test::Cli {
 protected:
  const std::string circles_ = write("circles.csv", "0,0,1\n6,0,1\n0,8,1\n");

  /// The circles, hidden circles and vertices that are written.
  static Json partsOf(const std::string& text) {
    const Json diagram = Json::parse(text);
    return {diagram["circles"], diagram["hidden"], diagram["vertices"], diagram["hull"]};
  }
};

TEST_F(CliEdit, TracesEachEdit) {
  const std::string script = write("edits.csv", "insert,3,4,0.5\nremove,3\n");
  const std::string edit = "edit " + circles_ + " --script " + script;
  const std::string plain = textOf(edit);
  const std::string changes = textOf(edit + " -o " + path("diagram.json") + " --changes -");
  EXPECT_EQ(textOf(edit + " --trace " + path("trace.jsonl") + " --changes " + path("changes.jsonl")), plain);
  EXPECT_EQ(readFile(path("changes.jsonl")), changes);
  const std::string trace = readFile(path("trace.jsonl"));
  EXPECT_EQ(textOf(edit + " -o " + path("diagram.json") + " --trace -"), trace);
  std::string kinds;
  for (const std::string& line : test::linesOf(trace)) kinds += Json::parse(line)["kind"].get<std::string>() + ' ';
  EXPECT_EQ(kinds,
            "roundBegun faceMade faceMade faceMade faceMade "
            "circleInserted faceMade faceMade discNotEmpty faceRemoved faceRemoved faceMade faceMade "
            "circleShrunk faceRemoved faceRemoved faceMade faceMade faceRemoved faceRemoved circleRemoved ");
}

TEST_F(CliEdit, EndsWithTheDiagramOfTheCirclesThatAreLeft) {
  const std::string script = write("edits.csv",
                                   "# comes, moves and grows\n"
                                   "insert, 3,4,1\n"
                                   "\n"
                                   "replace,3,3.5,4,1.5\r\n"
                                   "insert,-9,0,0.25\n"
                                   "remove,1\n"
                                   "replace,0,-9,0,2");
  const std::string out = textOf("edit " + circles_ + " --script " + script);
  const std::string left = "-9,0,2\n0,8,1\n3.5,4,1.5\n-9,0,0.25\n";
  EXPECT_EQ(partsOf(out), partsOf(textOf("compute -", left)));
  EXPECT_EQ(textOf("certify -", out), "certified: 4 circles, 1 of them hidden; 1 vertices, 3 edges\n");
  // Edits a diagram alike, in another format, and from standard input.
  textOf("compute " + circles_ + " -o " + path("diagram.json"));
  EXPECT_EQ(
      textOf("edit " + path("diagram.json") + " --format svg --script - --bounds=-20,-20,20,20", readFile(script)),
      textOf("convert - --format svg --bounds=-20,-20,20,20", out));
}

TEST_F(CliEdit, InsertsARemovedCircleUnderItsId) {
  const std::string edit = "edit " + circles_ + " --script -";
  EXPECT_EQ(partsOf(textOf(edit, "remove,1\ninsert,1,3,4,1\n")), partsOf(textOf(edit, "replace,1,3,4,1\n")));
}

TEST_F(CliEdit, AScriptMayBeginWithAByteOrderMark) {
  const std::string edits = "insert,3,4,1\r\nremove,1\r\n";
  const std::string edit = "edit " + circles_ + " --format csv --script ";
  const std::string expected = textOf(edit + "-", edits);
  EXPECT_EQ(textOf(edit + "-", "\xEF\xBB\xBF" + edits), expected);
  EXPECT_EQ(textOf(edit + write("edits.csv", "\xEF\xBB\xBF" + edits)), expected);
  EXPECT_EQ(textOf(edit + "-", "\xEF\xBB\xBF"), textOf(edit + "-", "")) << "without an edit";
  expectFailure(run(edit + "-", "\xEF\xBB\xBFmove,1\n"), 2, "standard input:1: \"move\" is no edit");
}

double numberOf(double value) { return value; }
std::int32_t numberOf(std::int32_t value) { return value; }

/// The numbers of a list, or those members of its items, one after the other.
template <class Item, class... Members>
Json numbersOf(const std::vector<Item>& items, Members... members) {
  Json numbers = Json::array();
  for (const Item& item : items) {
    if constexpr (sizeof...(members) == 0) {
      numbers.push_back(numberOf(item));
    } else {
      (numbers.push_back(numberOf(item.*members)), ...);
    }
  }
  return numbers;
}

TEST_F(CliEdit, ChangesAreThoseOfTheLibrary) {
  const std::string text = "0,0,1\n6,0,1\n0,8,1\n5,7,2\n9,3,0.5\n";
  DiagramEditor editor = DiagramEditor::from(readCircles(text, "test").value()).value();
  // A circle comes between others, grows over them, and is removed.
  const std::vector<Edit> edits = {
      {Edit::Kind::insert, kNone, {3, 4, 0.5}}, {Edit::Kind::replace, 5, {4, 6, 4}}, {Edit::Kind::remove, 5, {}}};
  textOf("edit - --script " + write("edits.csv", "insert,3,4,0.5\nreplace,5,4,6,4\nremove,5\n") + " --changes " +
             path("changes.jsonl") + " -o " + path("after.json"),
         text);
  const auto lines = test::linesOf(readFile(path("changes.jsonl")));
  ASSERT_EQ(lines.size(), edits.size());
  for (std::size_t k = 0; k < edits.size(); ++k) {
    const Change change = editor.apply(std::span(edits).subspan(k, 1)).value();
    Json corners = Json::array();
    for (const auto& triple : change.vertexCircles) {
      for (const CircleId id : triple) corners.push_back(std::int32_t{id});
    }
    const Json expected = {{"way", "local"},
                           {"inserted", numbersOf(change.inserted)},
                           {"removed", numbersOf(change.removed)},
                           {"replaced", numbersOf(change.replaced)},
                           {"circles", numbersOf(change.circles, &Circle::x, &Circle::y, &Circle::r)},
                           {"hidden", numbersOf(change.hidden)},
                           {"hiders", numbersOf(change.hiders, &HiddenCircle::circle, &HiddenCircle::by)},
                           {"shown", numbersOf(change.shown)},
                           {"cells", numbersOf(change.cells)},
                           {"removedVertices", numbersOf(change.removedVertices)},
                           {"addedVertices", numbersOf(change.addedVertices)},
                           {"vertices", numbersOf(change.vertices, &Vertex::x, &Vertex::y, &Vertex::r)},
                           {"vertexCircles", corners},
                           {"removedEdges", numbersOf(change.removedEdges)},
                           {"addedEdges", numbersOf(change.addedEdges)},
                           {"edges", numbersOf(change.edges, &Edge::left, &Edge::right, &Edge::start, &Edge::end)},
                           {"hullSides", numbersOf(change.hullSides, &HullSide::side, &HullSide::next)}};
    EXPECT_EQ(Json::parse(lines[k]), expected);
    EXPECT_EQ(change.hiders.empty(), k != 1);
    EXPECT_FALSE(change.removedVertices.empty() || change.addedVertices.empty() || change.edges.empty());
  }
}

TEST_F(CliEdit, SaysInWhichLineAnEditIsWrong) {
  const auto expectRefusal = [&](const std::string& script, const std::string& message) {
    const std::string output = path("not.json");
    const std::string changes = path("not.jsonl");
    expectFailure(run("edit " + circles_ + " --script - -o " + output + " --changes " + changes, script), 2, message);
    EXPECT_FALSE(std::filesystem::exists(output));
    EXPECT_FALSE(std::filesystem::exists(changes));
  };
  expectRefusal("remove,1\n\nremove,1\n", "standard input:3: There is no circle with id 1.");
  expectRefusal("replace,9,0,0,1\n", "standard input:1: There is no circle with id 9.");
  expectRefusal("# a\ninsert,0,0,-1\n", "standard input:2: The new circle has a negative radius.");
  expectRefusal("insert,0,1e151,0\n",
                "standard input:1: The new circle has a coordinate or a radius beyond 7.9e28 (2^96).");
  expectRefusal("insert,0,nan,1\n", "standard input:1: \"nan\" is not a finite number.");
  expectRefusal("insert,0,\xFF\x1B,1\n", "standard input:1: \"??\" is not a finite number.");
  expectRefusal("\xFF\xFEr\n", "standard input:1: the text is UTF-16; save it as UTF-8.");
  expectRefusal("insert,0,0\n", "standard input:1: insert takes 3 numbers, not 2.");
  expectRefusal("insert,1,0,0,1\n", "standard input:1: There is no removed circle with id 1.");
  expectRefusal("insert,-1,0,0,1\n", "standard input:1: \"-1\" is no id.");
  expectRefusal("remove,1,2\n", "standard input:1: remove takes 1 number, not 2.");
  expectRefusal("replace,x,0,0,1\n", "standard input:1: \"x\" is no id.");
  expectRefusal("remove,1x\n", "standard input:1: \"1x\" is no id.");
  expectRefusal("move,0,1,1\n",
                "standard input:1: \"move\" is no edit; an edit is insert,x,y,r or remove,id or "
                "replace,id,x,y,r.");
  expectRefusal(",\n", "standard input:1: \"\" is no edit; an edit is insert,x,y,r or remove,id or replace,id,x,y,r.");
}

TEST_F(CliEdit, EditsWeights) {
  const std::string script = write("script.csv", "insert,3,4,-0.5\nreplace,1,5,0,-2\n");
  const std::string circles = write("weights.csv", "0,0,-1\n5,0,1\n");
  expectFailure(run("edit " + circles + " --script " + script), 2, "negative");
  const Json edited = Json::parse(textOf("edit --weights " + circles + " --script " + script));
  EXPECT_EQ(edited["weights"], true);
  const Json computed = Json::parse(textOf("compute --weights -", "0,0,-1\n5,0,-2\n3,4,-0.5\n"));
  EXPECT_EQ(edited["circles"], computed["circles"]);
  EXPECT_EQ(edited["vertices"], computed["vertices"]);
  // A diagram says itself that its radii are weights.
  textOf("compute --weights -o " + path("weights.json") + " " + circles);
  EXPECT_EQ(textOf("edit " + path("weights.json") + " --script " + script),
            textOf("edit --weights " + circles + " --script " + script));
  expectFailure(run("edit " + circles + " --script " + write("bad.csv", "insert,3,4,-0.5\n")), 2, "negative");
  expectFailure(run("edit " + path("weights.json") + " --script " + write("bad.csv", "insert,3,4,-1e151\n")), 2,
                "bad.csv:1: The new circle has a coordinate or a radius beyond 7.9e28 (2^96).");
}

TEST_F(CliEdit, RefusesInvalidScriptsAndOptions) {
  expectFailure(run("edit - --script -", ""), 2, "The circles and the script cannot both be standard input.");
  expectFailure(run("edit " + circles_ + " --script - --changes -", ""), 2,
                "--changes and --output cannot both be standard output.");
  Json others = Json::parse(textOf("compute " + circles_));
  for (const std::string metric : {"centers", "power"}) {
    others["metric"] = metric;
    expectFailure(run("edit " + write("others.json", others.dump()) + " --script -", ""), 2,
                  path("others.json") + ": the metric " + metric + " cannot be edited, only that of circles.");
  }
  const std::string script = write("edits.csv", "remove,0\n");
  expectFailure(run("edit " + circles_ + " --script " + script + " --format csv -o " + script), 2,
                script + " would be overwritten: it is the output as well.");
  expectFailure(run("edit " + circles_ + " --script " + script + " --format csv --changes " + circles_), 2,
                circles_ + " would be overwritten: it is the output as well.");
  EXPECT_EQ(readFile(script), "remove,0\n");
}

}  // namespace
}  // namespace circle_voronoi
