// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles on the command line; tests/tiles has the drivers that put them together.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "cli.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using test::Outcome;

const std::string kPlane = " --known=-inf,-inf,inf,inf --max-radius 0";

using test::linesOf;

/// A tile of a grid of points, by ids that are not their rows.
std::string grid() {
  std::string text = "x;y;name;r;id\n";
  for (int i = 0; i < 49; ++i) {
    text += std::to_string(i % 7) + ";" + std::to_string(i / 7) + ";a;0;" + std::to_string(1000 - i) + "\n";
  }
  return text;
}

class CliTile : public test::Cli {};

TEST_F(CliTile, WritesFinalPartsWithTheIdsOfTheInput) {
  const std::string tile = write("tile.csv", grid());
  const auto lines = linesOf(
      textOf("compute " + tile + " --known=-0.5,-0.5,6.5,6.5 --max-radius 0 --core 2.5,2.5,3.5,3.5 --format csv"));
  ASSERT_GT(lines.size(), 1U);
  EXPECT_EQ(lines[0], "type,x,y,r,circle1,circle2,circle3,circle4");
  // The circle at (3, 3) is row 24. Two of its four edges lead to lower ids at greater rows and belong to other
  // circles.
  std::set<std::string> edges;
  for (const std::string& line : lines) {
    if (line.starts_with("edge,,,,")) edges.insert(line.substr(8, line.find(',', 12) - 8));
  }
  EXPECT_TRUE(edges.contains("976,977"));
  EXPECT_TRUE(edges.contains("976,983"));
  EXPECT_FALSE(edges.contains("975,976"));
}

TEST_F(CliTile, ReportsTheMissingHalo) {
  const std::string tile = write("tile.csv", grid());
  const Outcome result = run("compute " + tile +
                             " --known=-0.5,-0.5,6.5,6.5 --max-radius 0 --core=-0.5,-0.5,3.5,6 -o " + path("part.csv"));
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.find("circle-voronoi: " + tile + ": 9 of 24 circles of the core are not final; none is for 9"),
            0U)
      << result.err;
  EXPECT_GT(linesOf(readFile(path("part.csv"))).size(), 10U) << "what is final is written";
  const Outcome missing = run("compute " + tile + " --known=2,2,4,4 --max-radius 0.25 --core=3,3,4,4 --format csv");
  EXPECT_EQ(missing.status, 3);
  // The discs of the cell have the radius sqrt(1/2), half a step from the center.
  EXPECT_NE(missing.err.find("1 of 1 circles of the core are not final; a halo wider by 0.457106781"),
            std::string::npos)
      << missing.err;
}

// Along x a circle at the border of the core lacks more than along y, and comes first.
TEST_F(CliTile, TheMissingHaloIsForTheCircleThatNeedsMost) {
  const Outcome missing = run("compute " + write("tile.csv", grid()) +
                              " --known=-20,-20,4,3.75 --max-radius 0 --core=2,2,4,4 --format csv");
  EXPECT_EQ(missing.status, 3);
  EXPECT_NE(missing.err.find("3 of 4 circles of the core are not final; a halo wider by 0.457106781"),
            std::string::npos)
      << missing.err;
}

TEST_F(CliTile, DoneCirclesStayDoneInTheRemainingTile) {
  std::string tile = "id,x,y,r,done\n";
  for (int i = 0; i < 49; ++i) {
    const bool isDone = i % 7 == 4;  // the column beside the core
    tile += std::to_string(i) + "," + std::to_string(i % 7) + "," + std::to_string(i / 7) + ",0," +
            (isDone ? "1" : "0") + "\n";
  }
  const Outcome part = run(
      "compute - --known=-20,-20,20,3.75 --max-radius 0 --core=2.5,1.5,4.5,3.5 --format csv --open " + path("open.csv"),
      tile);
  EXPECT_EQ(part.status, 3) << part.err;
  // The circles of the upper row are not final. Below, the circle on the left is done now, and its neighbor was before.
  EXPECT_EQ(readFile(path("open.csv")), "id,x,y,r,done\n17,3,2,0,1\n18,4,2,0,1\n24,3,3,0,0\n25,4,3,0,1\n");
}

TEST_F(CliTile, ThePartsOfTwoTilesAndOfTheirRemainderAreTheWholeDiagram) {
  const std::string tile = write("tile.csv", grid());
  const auto rows = [&](const std::string& text) {
    auto lines = linesOf(text);
    lines.erase(lines.begin());
    return std::multiset<std::string>(lines.begin(), lines.end());
  };
  std::multiset<std::string> parts;
  std::string rest = "id,x,y,r,done\n";
  for (const std::string core : {"-1,-1,3,7", "3,-1,7,7"}) {
    const Outcome part = run("compute " + tile + " --known=-2,-2,8,8 --max-radius 0 --format csv --core=" + core +
                             " --open " + path("open.csv"));
    EXPECT_EQ(part.status, 3);
    parts.merge(rows(part.out));
    const std::string open = readFile(path("open.csv"));
    EXPECT_NE(open.find(",0,0\n"), std::string::npos);
    EXPECT_NE(open.find(",0,1\n"), std::string::npos);
    rest += open.substr(open.find('\n') + 1);
  }
  parts.merge(rows(textOf("compute - --format csv" + kPlane, rest)));
  EXPECT_EQ(parts, rows(textOf("compute " + tile + " --format csv" + kPlane)));
}

TEST_F(CliTile, WritesCellsAsLinesOfGeoJson) {
  const std::string tile = write("tile.csv", grid());
  const std::string compute = "compute " + tile + " --format geojsonl --bounds=-1,-1,7,7";
  EXPECT_EQ(linesOf(textOf(compute)).size(), 49U);
  const auto lines = linesOf(textOf(compute + " --known=-0.5,-0.5,6.5,6.5 --max-radius 0 --core 2.5,2.5,3.5,4.5"));
  ASSERT_EQ(lines.size(), 2U);
  const auto feature = nlohmann::json::parse(lines[1]);
  EXPECT_EQ(feature.at("properties").at("circle"), 976);
  EXPECT_EQ(feature.at("properties").at("area"), 1);
  std::set<int> neighbors = feature.at("properties").at("neighbors");
  for (const int beside : {969, 975, 977, 983}) EXPECT_TRUE(neighbors.contains(beside)) << beside;
  EXPECT_EQ(feature.at("geometry").at("type"), "Polygon");
}

TEST_F(CliTile, LinesOfGeoJsonNameAHiddenCircleAndItsHiderByTheirIds) {
  const auto lines = linesOf(
      textOf("compute - --known=-50,-50,50,50 --max-radius 0 --core=-5,-5,5,5 --format geojsonl --bounds=-1,-1,1,1",
             "id,x,y,r\n70,9,0,1\n80,0,0.5,1\n90,0,0,3\n100,-9,0,1\n110,0,9,1\n120,0,-9,1\n"));
  ASSERT_EQ(lines.size(), 2U);
  const auto hidden = nlohmann::json::parse(lines[0]).at("properties");
  EXPECT_EQ(hidden.at("circle"), 80);
  EXPECT_EQ(hidden.at("hiddenBy"), 90);
  EXPECT_FALSE(nlohmann::json::parse(lines[1]).at("properties").contains("hiddenBy"));
}

TEST_F(CliTile, EachTileHasAllCirclesThatReachIntoIt) {
  // Homes by half-open squares; a huge circle, known before and after the tiles that it reaches into; far ones.
  const std::string circles = "x,y,r\n50,50,45\n0,0,0\n10,0,0\n9.75,3,0\n-1e9,5,1\n-0.5,-0.5,0.1\n1e9,0,2\n";
  ASSERT_EQ(run("tile - --size 10 --halo 2 -o " + path("tiles"), circles).status, 0);
  EXPECT_EQ(readFile(path("tiles/tiles.txt")),
            "x-1y-1 1 -10,-10,0,0 -12,-12,2,2\n"
            "x-100000000y0 1 -1e+09,0,-999999990,10 -1000000002,-2,-999999988,12\n"
            "x0y0 2 0,0,10,10 -2,-2,12,12\n"
            "x1y0 1 10,0,20,10 8,-2,22,12\n"
            "x100000000y0 1 1e+09,0,1000000010,10 999999998,-2,1000000012,12\n"
            "x5y5 1 50,50,60,60 48,48,62,62\n");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path("tiles"))) ++files;
  EXPECT_EQ(files, 7U);
  EXPECT_EQ(readFile(path("tiles/x0y0.csv")),
            "id,x,y,r,done\n1,0,0,0,0\n2,10,0,0,0\n3,9.75,3,0,0\n5,-0.5,-0.5,0.1,0\n0,50,50,45,0\n");
  EXPECT_EQ(readFile(path("tiles/x1y0.csv")), "id,x,y,r,done\n2,10,0,0,0\n3,9.75,3,0,0\n0,50,50,45,0\n");
  EXPECT_EQ(readFile(path("tiles/x5y5.csv")), "id,x,y,r,done\n0,50,50,45,0\n");
}

// One that is in too many tiles to be put into each as it comes.
TEST_F(CliTile, AWideCircleIsInEachTileThatItMeetsUpToTheCorners) {
  std::string circles = "x,y,r\n50,50,45\n";
  for (const char* x : {"-5", "5", "95", "105"}) {
    for (const char* y : {"-5", "5", "95", "105"}) circles += std::string(x) + "," + y + ",0\n";
  }
  ASSERT_EQ(run("tile - --size 10 --halo 2 -o " + path("tiles"), circles).status, 0);
  for (const char* x : {"-1", "0", "9", "10"}) {
    for (const char* y : {"-1", "0", "9", "10"}) {
      const std::string name = std::string("x") + x + "y" + y + ".csv";
      const auto isBeside = [](const std::string& cell) { return cell == "-1" || cell == "10"; };
      EXPECT_EQ(readFile(path("tiles/" + name)).find("\n0,50,50,45,0\n") != std::string::npos,
                !isBeside(x) && !isBeside(y))
          << name;
    }
  }
}

// The quotients of these coordinates and the size are rounded up to whole numbers, or down below them.
TEST_F(CliTile, AHomeIsTheTileWhoseBoxHasTheCenter) {
  const std::string circles = "x,y,r\n-3.6000000000000005,0,0\n0,-4.800000000000001,0\n";
  ASSERT_EQ(run("tile - --size 0.1 --halo 0.01 -o " + path("tiles"), circles).status, 0);
  const auto lines = linesOf(readFile(path("tiles/tiles.txt")));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[0].starts_with("x0y-48 1 0,-4.800000000000001,")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("x-37y0 1 -3.7,0,-3.6")) << lines[1];
}

TEST_F(CliTile, AWeightBelowZeroReachesAsFarAsTheHalo) {
  const std::string circles = "x,y,r\n5,5,0\n8.5,5,-1\n15,5,0\n11,5,-9\n";
  ASSERT_EQ(run("tile - --weights --size 10 --halo 2 -o " + path("tiles"), circles).status, 0);
  EXPECT_EQ(readFile(path("tiles/x0y0.csv")), "id,x,y,r,done\n0,5,5,0,0\n1,8.5,5,-1,0\n3,11,5,-9,0\n");
  EXPECT_EQ(readFile(path("tiles/x1y0.csv")), "id,x,y,r,done\n1,8.5,5,-1,0\n2,15,5,0,0\n3,11,5,-9,0\n");
}

TEST_F(CliTile, ReadsATableInPiecesWithItsIdsAndLineNumbers) {
  std::string table = "\xEF\xBB\xBF# trees\r\nname\tr\ty\tx\tfid\tdone\r\n";
  for (int i = 0; i < 60'000; ++i) {
    table += "\"a\r\nb\"\t0,25\t" + std::to_string(i % 7) + "\t" + std::to_string(i) + "\t" + std::to_string(7 * i) +
             "\t" + std::to_string(i % 2) + "\r\n";
  }
  ASSERT_EQ(run("tile - --size 1e6 --halo 1 -o " + path("tiles"), table + "c\t1\t2\t-3\t1\t0").status, 0);
  const auto lines = linesOf(readFile(path("tiles/x0y0.csv")));
  ASSERT_EQ(lines.size(), 60'001U);
  EXPECT_EQ(lines[60'000], "419993,59999,2,0.25,1");
  EXPECT_NE(readFile(path("tiles/x-1y0.csv")).find("\n1,-3,2,1,0\n"), std::string::npos);
  expectFailure(run("tile - --size 1e6 --halo 1 -o " + path("more"), table + "c\t1\tz\t3\t1\t0"), 2,
                "standard input:120003: y is not a number: \"z\" (circle 60000, fid 1).");
  expectFailure(run("tile - --size 1e6 --halo 1 -o " + path("most"), table + "c\t-1\t0\t3\t1\t0"), 2,
                "standard input:120003: Circle 60000 has a negative radius.");
  // A circle of a piece after the first, and not the first circle of the piece.
  expectFailure(run("tile - --size 1e6 --halo 1 -o " + path("late"), table + "c\t1\t2\t3\t1\t0\r\nc\t-1\t0\t3\t2\t0"),
                2, "standard input:120004: Circle 60001 has a negative radius.");
}

TEST_F(CliTile, RefusesInvalidTilesAndOptions) {
  const std::string tile = write("tile.csv", grid());
  const auto fails = [&](const std::string& arguments, const std::string& message) {
    SCOPED_TRACE(arguments);
    expectFailure(run(arguments), 2, message);
  };
  const std::string known = "compute " + tile + " --known 0,0,1,1";
  fails(known + " --format csv", "--known needs --max-radius.");
  fails(known + " --max-radius 0", "--known needs --format csv or geojsonl.");
  fails(known + " --max-radius 0 -o " + path("a.svg"), "--known needs --format csv or geojsonl.");
  fails(known + " --max-radius -1 --format csv", "expected a number from 0");
  fails(known + " --max-radius 0 --format geojsonl", "--known needs --bounds or --region for geojsonl.");
  fails(known + " --max-radius 0 --format csv --method flip", "--known needs --method auto.");
  fails(known + " --max-radius 0 --format csv --trace " + path("t.jsonl"), "--known takes no --trace.");
  fails(known + " --max-radius 0 --format csv --project local", "--known takes no --project.");
  fails(known + " --max-radius 0 --format csv --digits 3", "--known takes no --digits for csv.");
  fails("compute " + tile + " --known 0,0,nan,1 --max-radius 0 --format csv", "MAXX is not a number");
  fails("compute " + tile + " --core 0,0,1,1 --format csv", "--core needs --known.");
  fails("compute " + tile + " --open " + path("a.csv") + " --format csv", "--open needs --known.");
  fails("compute " + tile + " --max-radius 0 --format csv", "--max-radius needs --known.");
  for (const char* options : {" --max-radius 0", " --max-radius 0.25 --core 0.25,0.5,0.75,0.75"}) {
    fails(known + options + " --format csv --open " + path("a.csv"), "--open needs a --core that lies within --known");
  }
  const std::string twice = write("twice.csv", "id,x,y,r\n4,0,0,1\n3,1,1,1\n4,2,2,1\n");
  fails("compute " + twice + " --format csv" + kPlane, "the id 4 is given twice.");
  // Not only in another place, but next to one another in order.
  fails("compute " + write("row.csv", "id,x,y,r\n3,0,0,1\n3,1,1,1\n4,2,2,1\n") + " --format csv" + kPlane,
        "the id 3 is given twice.");
  const std::string negative = write("negative.csv", "id,x,y,r\n-1,0,0,1\n");
  fails("compute " + negative + " --format csv" + kPlane,
        "negative.csv:2: id is no whole number from 0 to 9223372036854775807: \"-1\".");
  fails("compute " + write("done.csv", "done,x,y,r\n2,0,0,1\n") + " --format csv" + kPlane,
        "done.csv:2: done is no whole number from 0 to 1: \"2\".");
  const std::string fraction = write("fraction.csv", "id,x,y,r\n4.5,0,0,1\n");
  fails("compute " + fraction + " --format csv" + kPlane, "fraction.csv:2: id is no whole number from 0 to");
  const std::string json = write("circles.json", "[[0,0,1]]");
  fails("compute " + json + " --format csv" + kPlane, "a tile has to be a table (CSV), not JSON.");
  fails("tile " + tile + " --size 0 --halo 1 -o " + path("a"), "expected a number above 0");
  fails("tile " + tile + " --size 1 --halo -1 -o " + path("b"), "expected a number above 0");
  fails("tile " + tile + " --size 1e-20 --halo 1 -o " + path("c"), "--size is too small");
  const std::string tiny = write("tiny.csv", "id,x,y,r\n1,1e-20,0,0\n");
  fails("compute " + tiny + " --format csv" + kPlane, "tiny.csv: The circles are too small: all numbers are below");
  fails("tile " + tile + " --size 1 --halo 1 -o " + path(""), "is not empty");
  const std::string inFile = tile + "/tiles";
  expectFailure(run("tile " + tile + " --size 1 --halo 1 -o " + inFile), 1,
                "Cannot make the folder " + inFile + ": Not a directory.");
  const std::string full = "tile " + tile + " --size 1 --halo 1 -o " + path("full");
  const std::string said = shell("(ulimit -f 0; exec " + program_ + " " + full + ") 2>&1 | cat").out;
  EXPECT_EQ(said.rfind("circle-voronoi: Cannot write " + path("full/x"), 0), 0U) << said;
  fails("tile " + write("empty.csv", "# nothing\n") + " --size 1 --halo 1 -o " + path("d"), "the text is empty");
}

}  // namespace
}  // namespace circle_voronoi
