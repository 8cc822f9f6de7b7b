// SPDX-License-Identifier: GPL-3.0-or-later
// The program circle-voronoi, as a user runs it.
#include "cli.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi_families/families.h"
#include "fixtures.h"
#include "lines.h"

namespace circle_voronoi {
namespace {

using test::Cli;
using test::Outcome;

const std::string kFixture = test::pathOfFixture("spruces");

TEST_F(Cli, ComputesAFile) {
  const auto json = nlohmann::json::parse(textOf("compute " + kFixture));
  EXPECT_EQ(json.at("circles").size(), 134U);
  EXPECT_TRUE(json.at("stats").at("certificate").at("certified"));
}

TEST_F(Cli, ReadsStandardInput) {
  const auto vertex = nlohmann::json::parse(textOf("compute -", "0,0,1\n6,0,1\n0,8,1\n")).at("vertices").at(0);
  EXPECT_EQ(vertex.at("x"), 3.0);
  EXPECT_EQ(vertex.at("r"), 4.0);
  EXPECT_EQ(nlohmann::json::parse(run("compute -", "[[0,0,1],[6,0,1]]").out).at("circles").size(), 2U);
}

TEST_F(Cli, WritesAFile) {
  EXPECT_EQ(textOf("compute " + kFixture + " -o " + path("out.json")), "");
  EXPECT_EQ(nlohmann::json::parse(readFile(path("out.json"))).at("format"), "circle-voronoi");
}

TEST_F(Cli, WritesStatsAlone) {
  const auto stats = nlohmann::json::parse(
      run("compute " + kFixture + " --format stats --method touching-disc --candidates dynamic --samples 3").out);
  EXPECT_EQ(stats.at("candidates"), "dynamic");
  EXPECT_EQ(stats.at("counts").at("circles"), 134);
  EXPECT_GT(stats.at("counts").at("samples"), 134);
}

TEST_F(Cli, WritesEveryFormat) {
  const auto written = [&](const std::string& options) { return textOf("compute " + kFixture + " " + options); };
  EXPECT_EQ(nlohmann::json::parse(written("--format geojson")).at("features").size(), 134U);
  EXPECT_TRUE(written("--format svg").starts_with("<svg "));
  EXPECT_TRUE(written("--format wkt --tolerance 0.01").starts_with("POLYGON "));
  EXPECT_NE(written("--format obj --bounds -1,-2,3,4").find("\no cells\n"), std::string::npos);
  EXPECT_TRUE(written("--format csv").starts_with("type,index,"));
  expectFailure(run("compute " + kFixture + " --format svg --bounds 0,0,-1,1"), 2, "--bounds");
  const std::vector<std::pair<std::string, std::string>> boxes = {
      {"0,0,1", "expected MINX,MINY,MAXX,MAXY, not 3 numbers."},
      {"0,0,1,1,1", "expected MINX,MINY,MAXX,MAXY, not 5 numbers."},
      {"0,0,1,x", "MAXY is not a finite number: \"x\"."},
      {"0,0,inf,1", "MAXX is not a finite number: \"inf\"."},
      {"0,,1,1", "MINY is not a finite number: \"\"."},
      {"0,0,0,1", "MAXX has to be above MINX."},
      {"0,2,1,1", "MAXY has to be above MINY."},
      {"-1e308,0,1e308,1", "A coordinate of the box is not finite, or beyond 1.2e30 (2^100)."},
      {"0,-1.3e30,1,1", "A coordinate of the box is not finite, or beyond 1.2e30 (2^100)."}};
  for (const auto& [box, problem] : boxes) {
    expectFailure(run("compute " + kFixture + " --format svg --bounds=" + box), 2, "--bounds: " + problem);
  }
  EXPECT_EQ(written("--format geojson --bounds=-1.2e30,-1.2e30,1.2e30,1.2e30").find("inf"), std::string::npos);
  for (const char* tolerance : {"0", "-1", "inf", "small"}) {
    expectFailure(run("compute " + kFixture + " --format svg --tolerance " + tolerance), 2, "--tolerance: expected");
  }
  expectFailure(run("compute " + test::pathOfFixture("missed-antipodal-disc-mixed-4") +
                    " --format svg --method touching-disc --samples 0"),
                1, "not certified");
}

TEST_F(Cli, SaysWhereSamplingMissedSomethingAndSamplesAgain) {
  const std::string command = "compute " + test::pathOfFixture("missed-antipodal-disc-mixed-4") +
                              " --format stats --method touching-disc --samples 0";
  const auto certificate = [&](const std::string& options) {
    return nlohmann::json::parse(run(command + options).out).at("certificate");
  };
  EXPECT_EQ(certificate("").at("certified"), false);
  EXPECT_NE(certificate("").at("message"), "");
  EXPECT_EQ(certificate(" --resample").at("certified"), true);
}

TEST_F(Cli, AllMethodsMakeTheSameDiagram) {
  const auto vertices = [&](const std::string& options) {
    auto list = nlohmann::json::parse(run("compute " + kFixture + " " + options).out).at("vertices");
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto expected = vertices("");
  EXPECT_EQ(vertices("--method flip"), expected);
  EXPECT_EQ(vertices("--method touching-disc"), expected);
  EXPECT_EQ(vertices("--method touching-disc --candidates uniform"), expected);
  EXPECT_EQ(vertices("--method touching-disc --candidates all-pairs"), expected);
}

TEST_F(Cli, OtherMetricsAreCertifiedAndNamedInFiles) {
  for (const std::string metric : {"power", "centers"}) {
    const std::string file = path(metric + ".json");
    ASSERT_EQ(run("compute " + kFixture + " --metric " + metric + " -o " + file).status, 0);
    const auto diagram = nlohmann::json::parse(readFile(file));
    EXPECT_EQ(diagram.at("metric"), metric);
    EXPECT_EQ(run("certify " + file).status, 0);
    // Its own edges are not those of the circles.
    const auto edgesOf = [](nlohmann::json all) {
      std::vector<nlohmann::json> edges;
      for (const auto& edge : all.at("edges")) edges.push_back(edge.at("circles"));
      std::sort(edges.begin(), edges.end());
      return edges;
    };
    EXPECT_NE(edgesOf(diagram), edgesOf(nlohmann::json::parse(run("compute " + kFixture).out)));
  }
  const std::string weighted = "x,y,w\n0,0,-4\n3,0,1\n0,3,2\n";
  const auto diagram = nlohmann::json::parse(run("compute - --metric power --weights w", weighted).out);
  // The border of the first two circles: x^2 + 4 = (x - 3)^2 - 1.
  EXPECT_NEAR(diagram.at("vertices").at(0).at("x").get<double>(), 4.0 / 6, 1e-15);
  const auto periodic = run("compute - --metric power --lattice 9,0,0,9", "1,2,3\n5,4,1\n");
  EXPECT_EQ(nlohmann::json::parse(periodic.out).at("metric"), "power");
  const std::vector<std::string> options = {"--method flip", "--trace " + path("trace"), "--sphere"};
  for (const std::string& option : options) {
    const auto failed = run("compute - --metric power " + option, "1,2,3\n");
    EXPECT_EQ(failed.status, 2) << option;
    EXPECT_NE(failed.err.find("--metric circles"), std::string::npos) << failed.err;
  }
}

TEST_F(Cli, BadLinesAreNamed) {
  expectFailure(run("compute -", "1,2,3\n1,2\n"), 2, "standard input:2: ");
  const std::string file = write("bad.csv", "x,y,r\n1,2,3\n1,2,three\n");
  expectFailure(run("compute " + file), 2, file + ":3: r is not a number");
  expectFailure(run("compute " + write("negative.csv", "1,2,-3\n")), 2, "negative.csv:1: ");
  expectFailure(run("compute " + write("bad.json", "[[1,2,3],\n[1,2]]")), 2, "bad.json:2: ");
}

TEST_F(Cli, BadInputLeavesAnOutputFileAlone) {
  const std::string file = write("kept.json", "before");
  expectFailure(run("compute - -o " + file, "nothing\n"), 2, "standard input:1: ");
  EXPECT_EQ(readFile(file), "before");
}

TEST_F(Cli, TheEndingOfTheOutputTellsTheFormatInAnyCaseAndUnknownOnesAreErrors) {
  ASSERT_EQ(run("compute " + kFixture + " -o " + path("table.csv")).status, 0);
  EXPECT_TRUE(readFile(path("table.csv")).starts_with("type,index,"));
  ASSERT_EQ(run("compute " + kFixture + " -o " + path("drawing.SVG")).status, 0);
  EXPECT_TRUE(readFile(path("drawing.SVG")).starts_with("<svg "));
  ASSERT_EQ(run("compute " + kFixture + " -o " + path("v1.2/../cells.GeoJson")).status, 1) << "no folder v1.2";
  for (const std::string name : {"drawing.png", "drawing.svgz", "drawing.svg.bak"}) {
    expectFailure(run("compute " + kFixture + " -o " + path(name)), 2, name + ": no format is called ");
    expectFailure(run("convert " + kFixture + " -o " + path(name)), 2, name + ": no format is called ");
    EXPECT_FALSE(std::filesystem::exists(path(name)));
  }
  ASSERT_EQ(run("compute " + kFixture + " --format svg -o " + path("drawing.txt")).status, 0);
  ASSERT_EQ(run("compute " + kFixture + " -o " + path("plain")).status, 0);
  EXPECT_TRUE(readFile(path("plain")).starts_with("{\"format\""));
  expectFailure(run("generate uniform 5 -o " + path("circles.json")), 2, "circles.json: generate writes csv, not json");
  ASSERT_EQ(run("generate uniform 5 -o " + path("circles.CSV")).status, 0);
}

TEST_F(Cli, AnOptionThatIsNotUsedIsAnError) {
  const std::string compute = "compute " + kFixture;
  for (const std::string method : {"", " --method flip", " --method auto"}) {
    for (const std::string option : {"--candidates dynamic", "--samples 1", "--resample"}) {
      expectFailure(run(compute + method + " " + option), 2,
                    option.substr(0, option.find(' ')) + " needs --method touching-disc.");
    }
  }
  const std::string disc = compute + " --method touching-disc --candidates ";
  expectFailure(run(disc + "all-pairs --samples 1"), 2, "--samples needs --candidates dynamic or uniform.");
  expectFailure(run(disc + "uniform --resample"), 2, "--resample needs --candidates dynamic.");
  for (const std::string format : {"json", "csv", "stats"}) {
    for (const std::string& command : {compute, "convert " + kFixture}) {
      expectFailure(run(command + " --bounds 0,0,1,1 --format " + format), 2,
                    "--bounds needs --format cells, svg, geojson");
      expectFailure(run(command + " --tolerance 1 --format " + format), 2, "--tolerance needs --format svg, geojson");
    }
  }
  expectFailure(run(compute + " --digits 2 --format stats"), 2, "--digits is not for --format stats.");
  expectFailure(run("convert " + kFixture + " --digits 2"), 2, "--digits is for diagrams; circles keep the digits");
  ASSERT_EQ(run(compute + " -o " + path("diagram.json")).status, 0);
  for (const std::string option : {"--bounds 0,0,1,1", "--tolerance 1", "--max-distance 1"}) {
    for (const std::string& circles : {kFixture, path("diagram.json") + " --circles"}) {
      expectFailure(run("convert " + circles + " --format geojson " + option), 2,
                    option.substr(0, option.find(' ')) + " is for diagrams; circles are written as they are.");
    }
  }
  for (const std::string digits : {"-1", "2.5", "two", "1e1", "''"}) {
    expectFailure(run(compute + " --digits " + digits), 2, "--digits");
  }
}

TEST_F(Cli, TracesTheTouchingDiscMethod) {
  const std::string compute = "compute --method touching-disc ";
  const std::string circles = "0,0,1\n6,0,1\n0,8,1\n";
  const std::string plain = run(compute + "- --format csv", circles).out;
  EXPECT_EQ(run(compute + "- --format csv --trace " + path("trace.jsonl"), circles).out, plain);
  const std::string trace = readFile(path("trace.jsonl"));
  EXPECT_TRUE(trace.starts_with("{\"kind\": \"roundBegun\", \"numbers\": [0]}\n"));
  EXPECT_NE(trace.find("{\"kind\": \"pairFound\", \"circles\": [0, 1]}\n"), std::string::npos);
  EXPECT_NE(
      trace.find(
          "{\"kind\": \"antipodalDiscAccepted\", \"disc\": {\"x\": 3, \"y\": 0, \"r\": 2}, \"circles\": [0, 1]}\n"),
      std::string::npos);
  for (const std::string& line : test::linesOf(trace))
    EXPECT_TRUE(nlohmann::json::parse(line).contains("kind")) << line;
  EXPECT_EQ(run(compute + "- -o " + path("diagram.csv") + " --trace -", circles).out, trace);

  // By flips: the center of one of four circles lies in the disc of the others.
  const std::string flips =
      run("compute - -o " + path("diagram.csv") + " --trace -", "0,0,1\n8,0,1\n0,8,1\n7,7,3\n").out;
  EXPECT_NE(flips.find("{\"kind\": \"centersJoined\", \"circles\": [0, 1]}\n"), std::string::npos);
  EXPECT_NE(flips.find("{\"kind\": \"faceMade\", \"circles\": [1, 0], \"numbers\": ["), std::string::npos) << flips;

  const std::string file = write("circles.csv", circles);
  expectFailure(run(compute + file + " --trace " + file), 2, "would be overwritten");
  EXPECT_EQ(readFile(file), circles);
  expectFailure(run(compute + "- --trace " + path("trace.jsonl"), "0,0,-1\n"), 2, "");
  EXPECT_EQ(readFile(path("trace.jsonl")), trace) << "a trace that cannot be made leaves the last one";
}

TEST_F(Cli, AnEmptyFileIsSaidToBeEmpty) {
  for (const std::string command : {"compute ", "convert ", "certify "}) {
    expectFailure(run(command + write("empty.csv", "")), 2, "empty.csv:1: the text is empty.");
    expectFailure(run(command + "-", "\n"), 2, "standard input:1: the text is empty.");
  }
  EXPECT_EQ(run("compute -", "x,y,r\n").status, 0) << "a table without rows";
}

TEST_F(Cli, EndsSilentlyOnABrokenPipe) {
  const Outcome result = shell(program_ + " generate uniform 100000 | head -n 1");
  EXPECT_EQ(result.out, "x,y,r\n");
  EXPECT_EQ(result.err, "");
}

TEST_F(Cli, ListsTheFamilies) {
  std::istringstream lines(textOf("generate --list"));
  for (const FamilyInfo& family : families()) {
    std::string line;
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with(std::string(family.name) + "  ")) << line;
    EXPECT_TRUE(line.ends_with(family.description)) << line;
  }
}

TEST_F(Cli, BadUsageIsSaidInOneLine) {
  expectFailure(
      run(""), 2,
      "A command is missing; the commands are certify, compute, convert, edit, find, fit, generate, tile and treemap.");
  expectFailure(run("picture"), 2, "The npm package has the command picture: npx circle-voronoi picture ...");
  EXPECT_NE(run("--help").out.find("the command picture draws"), std::string::npos);
  expectFailure(run("draw"), 2, "There is no command \"draw\"; the commands are certify, ");
  expectFailure(run("--draw"), 2, "There is no option --draw; the commands are certify, ");
  expectFailure(run("compute - --draw"), 2, "--draw");
  expectFailure(run("compute"), 2, "FILE");
  expectFailure(run("compute - --format xml"), 2, "--format");
  expectFailure(run("compute - --method magic"), 2, "--method");
  expectFailure(run("compute - --candidates some"), 2, "--candidates");
  expectFailure(run("compute - --samples -1"), 2, "--samples");
  expectFailure(run("compute - --threads -1"), 2, "--threads");
  expectFailure(run("compute - --samples 1001"), 2, "--samples");
  expectFailure(run("compute - --samples many"), 2, "--samples");
  expectFailure(run("compute - --method touching-disc --candidates uniform --samples 0", "1,2,3\n"), 2, "samples");
  expectFailure(run("generate nonsense 5"), 2, "nonsense");
  expectFailure(run("generate uniform -5"), 2, "N");
  for (const std::string seed : {"-1", "1.5", "x", "18446744073709551616", "+1"}) {
    expectFailure(run("generate uniform 5 --seed " + seed), 2, "--seed: expected a whole number from 0 to ");
  }
  EXPECT_EQ(run("generate uniform 5 --seed 18446744073709551615").status, 0);
}

TEST_F(Cli, WholeNumbersAreDecimal) {
  const std::string digits = "compute " + kFixture + " --format csv --digits ";
  const std::string samples = "compute " + kFixture + " --format csv --method touching-disc --samples ";
  EXPECT_EQ(textOf("generate uniform 010 --seed 010"), textOf("generate uniform 10 --seed 10"));
  EXPECT_EQ(textOf(digits + "010"), textOf(digits + "10"));
  EXPECT_EQ(textOf(samples + "010"), textOf(samples + "10"));
  for (const std::string number : {"0x10", "0b1", "1_0", "+1", "1.5"}) {
    expectFailure(run("generate uniform " + number), 2, "N: expected a whole number from 0 to 100000000.");
    expectFailure(run("generate uniform 5 --seed " + number), 2, "--seed: expected a whole number from 0 to ");
    expectFailure(run(digits + number), 2, "--digits: expected a whole number from 0 to 2147483647.");
    expectFailure(run(samples + number), 2, "--samples: expected a whole number from 0 to 1000.");
  }
}

TEST_F(Cli, NamesTheFilesThatCannotBeReadOrWritten) {
  expectFailure(run("compute " + path("missing.csv")), 1, "missing.csv: No such file or directory.");
  expectFailure(run("compute " + path("")), 1, "Cannot read");
  expectFailure(run("compute " + kFixture + " -o " + path("missing/out.json")), 1,
                "out.json: No such file or directory.");
  if (std::filesystem::exists("/dev/full")) expectFailure(run("compute " + kFixture + " -o /dev/full"), 1, "/dev/full");
}

#ifndef __SANITIZE_ADDRESS__  // which takes more room for itself than is given here
TEST_F(Cli, WantOfMemoryIsBadInput) {
  const std::string file = write("large.csv", "");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 33);  // takes no room on the disk
  expectFailure(shell("ulimit -v 4000000; " + program_ + " compute " + file), 2, "do not fit in memory");
}
#endif

TEST_F(Cli, GeneratesWhatTheLibraryGenerates) {
  const std::string text = textOf("generate log-uniform 200 --seed 9");
  const auto json = nlohmann::json::parse(textOf("compute -", text));
  const auto circles = generate(Family::logUniform, 200, 9);
  ASSERT_EQ(json.at("circles").size(), circles.size());
  for (std::size_t i = 0; i < circles.size(); ++i) EXPECT_EQ(json["circles"][i]["x"].get<double>(), circles[i].x);
  textOf("generate log-uniform 200 --seed 9 -o " + path("circles.csv"));
  EXPECT_EQ(readFile(path("circles.csv")), text);
}

TEST_F(Cli, CertifiesWhatItComputes) {
  const std::string file = path("diagram.json");
  textOf("compute " + kFixture + " -o " + file);
  const std::string verified = "certified: 134 circles, 0 of them hidden; 249 vertices, 382 edges\n";
  EXPECT_EQ(textOf("certify " + file), verified);
  EXPECT_EQ(textOf("certify -", readFile(file)), verified);
}

TEST_F(Cli, CertifyNamesTheFlawOfAWrongDiagram) {
  auto json = nlohmann::json::parse(run("compute " + kFixture).out);
  auto moved = json;
  moved["vertices"][7]["x"] = moved["vertices"][7]["x"].get<double>() + 0.001;
  expectFailure(run("certify " + write("moved.json", moved.dump())), 1, "Vertex 7 (circles ");
  auto crossed = json;
  std::swap(crossed["edges"][3]["vertices"], crossed["edges"][4]["vertices"]);
  expectFailure(run("certify " + write("crossed.json", crossed.dump())), 1, "Edge 3 (circles ");
}

TEST_F(Cli, CertifyRefusesFilesWithoutADiagram) {
  expectFailure(run("certify " + kFixture), 2, "spruces.csv:1: bad JSON");
  expectFailure(run("certify " + write("circles.json", "[[0, 0, 1]]")), 2, "circles.json:1: expected an object");
  expectFailure(run("certify -", "{\"format\": \"svg\"}"), 2, "standard input:1: the format is \"svg\"");
  expectFailure(run("certify -", "{\"format\": \"circle-voronoi\",\n \"version\": 2}"), 2,
                "standard input:2: the version is not 1");
  expectFailure(run("certify " + path("absent.json")), 1, "Cannot read");
}

TEST_F(Cli, HelpAndVersionGoToStandardOutput) {
  for (const char* arguments : {"--help", "compute --help", "--version"}) EXPECT_NE(textOf(arguments), "");
  const std::string help = textOf("generate --help");
  for (const FamilyInfo& family : families()) EXPECT_NE(help.find(std::string(family.name)), std::string::npos);
}

}  // namespace
}  // namespace circle_voronoi
