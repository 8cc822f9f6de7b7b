// SPDX-License-Identifier: GPL-3.0-or-later
// Messages quote the user's text as it is, whatever it says, and write numbers as every other locale does.
#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/tile.h"

namespace circle_voronoi {
namespace {

/// Names of columns, ids and files that look like parts of messages.
const std::vector<std::string> kHostile = {"the option r",
                                           "the option radius.",
                                           "; name one by the option x.",
                                           "Set `dissolve` to merge them.",
                                           "Set `shares` to scale them.",
                                           "tolerance must be",
                                           "maxSteps relax `shares`",
                                           "--radius",
                                           "%s %d {0} $& \\1 $1"};

/// The words of an error that name an option.
std::string optionWordsOf(const Error& error) { return error.message.substr(error.option.offset, error.option.size); }

TEST(Messages, QuoteNamesAsTheyAre) {
  for (const std::string& name : kHostile) {
    const auto field = readCircles("x,y," + name + "\n1,2,no\n", name, {.radius = name});
    ASSERT_FALSE(field);
    EXPECT_EQ(field.error().message, name + ":2: " + name + " is not a number: \"no\".");
    EXPECT_EQ(field.error().option.name, "");

    const auto id = readCircles("x,y,r,code\n1,2,no," + name + "\n", "test", {.id = "code"});
    EXPECT_EQ(id.error().message, "test:2: r is not a number: \"no\" (circle 0, code " + name + ").");

    // Quotation marks leave one separator only.
    const auto missing = readCircles("\"x\",\"y\",\"" + name + "\"\n1,2,3\n", name, {});
    EXPECT_EQ(missing.error().message, name + ":1: no column is called r, rad or radius, only x, y, " + name +
                                           "; name one by the option radius.");
    EXPECT_EQ(missing.error().option.name, "radius");
    EXPECT_EQ(optionWordsOf(missing.error()), "the option radius");

    const auto feature = readCircles(
        R"({"type":"FeatureCollection","features":[{"type":"Feature","id":")" + name + R"(","properties":{}}]})",
        "test");
    if (name.find('\\') == name.npos) {
      EXPECT_EQ(feature.error().message, "test:1: feature 0 (id \"" + name + "\") has no geometry.");
    }
    EXPECT_EQ(feature.error().option.name, "");
  }
}

TEST(Messages, AdviseAnOptionHoweverLongTheNamesBeforeItAre) {
  std::string header = "\"x\",\"y\"";
  for (int k = 0; k < 1000; ++k) header += ",\"the option r\"";
  const auto error = readCircles(header + "\n", "test").error();
  EXPECT_EQ(optionWordsOf(error), "the option radius");
  EXPECT_TRUE(error.message.ends_with("...; name one by the option radius.")) << error.message;
  const auto twice = readCircles("x,y,r,R\n1,2,3,4\n", "test").error();
  EXPECT_EQ(twice.option.name, "radius");
  EXPECT_EQ(optionWordsOf(twice), "the option radius");
}

TEST(Messages, NameTheOptionsOfRegionsAndFits) {
  const auto overlap = readRegion("MULTIPOLYGON (((0 0, 4 0, 0 4)), ((1 1, 5 1, 1 5)))", "the option dissolve").error();
  EXPECT_EQ(overlap.option.name, "dissolve");
  EXPECT_EQ(optionWordsOf(overlap), "`dissolve`");
  EXPECT_TRUE(overlap.message.starts_with("the option dissolve: Side ")) << overlap.message;
  const Region square = Region::from(Box{0, 0, 1, 1}).value();
  const std::vector<Circle> sites = {{0.25, 0.5, 0}, {0.75, 0.5, 0}};
  const auto fit = [&](const std::vector<double>& areas, const AreaFitOptions& options) {
    return fitAreas(sites, areas, square, options).error();
  };
  const Error sum = fit({1, 2}, {});
  EXPECT_EQ(sum.option.name, "shares");
  EXPECT_EQ(optionWordsOf(sum), "`shares`");
  EXPECT_EQ(fit({1, 2}, {.tolerance = 0}).option.name, "tolerance");
  EXPECT_EQ(fit({1, 2}, {.maxSteps = 0}).option.name, "maxSteps");
  EXPECT_EQ(fit({1, 2}, {.relax = -1}).option.name, "relax");
  for (const Error& error : {fit({1, 2}, {.tolerance = 0}), fit({1, 2}, {.maxSteps = 0}), fit({1, 2}, {.relax = -1})}) {
    EXPECT_EQ(optionWordsOf(error), error.option.name) << error.message;
  }
}

/// Commas as decimal marks, and points between thousands.
class Commas : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Texts and messages with numbers.
std::vector<std::string> numbersWritten(const Diagram& diagram, const Region& region) {
  std::vector<std::string> texts;
  const auto write = [&](auto writer) {
    std::ostringstream out;
    EXPECT_TRUE(writer(out));
    texts.push_back(out.str());
  };
  const ExportOptions drawn{.region = &region, .maxDistance = 1200.5, .tolerance = 0.5};
  write([&](auto& out) { return writeSvg(out, diagram, drawn); });
  write([&](auto& out) { return writeGeoJson(out, diagram, drawn); });
  write([&](auto& out) { return writeGeoJsonLines(out, diagram, drawn); });
  write([&](auto& out) { return writeWkt(out, diagram, drawn); });
  write([&](auto& out) { return writeObj(out, diagram, drawn); });
  write([&](auto& out) { return writeDiagramCsv(out, diagram); });
  write([&](auto& out) { return writeJson(out, diagram); });
  write([&](auto& out) { return writeStatsJson(out, diagram); });
  for (const auto writer : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
    write([&](auto& out) { return writer(out, diagram.circles, {}); });
    const auto read = readCircles(texts.back(), "test");
    EXPECT_TRUE(read);
    if (read) {
      EXPECT_EQ(*read, diagram.circles);
    }
  }
  const auto keep = [&](const auto& result) { texts.push_back(result ? "" : result.error().message); };
  keep(readCircles("x,y,r\n0.5,12345.5,-0.5\n", "test"));
  keep(readCircles("x,y,r\n0.5,12345.5,half\n", "test"));
  keep(readRegion("POLYGON ((0.5 0.5, 4000.5 4000.5, 4000.5 0.5, 0.5 4000.5))", "test"));
  const Region square = Region::from(Box{0, 0, 1234.5, 1}).value();
  const std::vector<Circle> sites = {{0.25, 0.5, 0}, {600, 0.5, 0}, {1200, 0.25, 0}};
  keep(fitAreas(sites, std::vector<double>{0.5, 1.5, 2000.25}, square));
  keep(fitAreas(sites, std::vector<double>{0.5, -1.5, 1}, square));
  keep(fitAreas(sites, std::vector<double>{0.5, 1, 1}, square, {.shares = true, .tolerance = 1.5}));
  keep(fitAreas(sites, std::vector<double>{1, 2, 300}, square, {.shares = true, .maxSteps = 1}));
  keep(fitAreas(sites, std::vector<double>{1, 2, 3}, Lattice{{0x1p94, 0}, {0, 0x1p94}}));
  for (std::size_t k = texts.size() - 7; k < texts.size(); ++k) EXPECT_NE(texts[k], "") << k;
  const auto known = readRegion("POLYGON ((0.5 0.5, 4000.5 0.5, 0.5 4000.5))", "test");
  EXPECT_TRUE(known);
  if (known) {
    EXPECT_EQ(known->bounds().maxX, 4000.5);
  }
  return texts;
}

/// Sets a locale with decimal commas for the C library, if the system can make one.
bool setCommaLocale(const std::filesystem::path& folder) {
  const std::string made = "localedef -i de_DE -f UTF-8 " + (folder / "de_DE.UTF-8").string() + " >/dev/null 2>&1";
  if (std::system(made.c_str()) == 0) setenv("LOCPATH", folder.c_str(), 1);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) return true;
  }
  return false;
}

TEST(Messages, AndFilesHaveTheSameNumbersInEveryLocale) {
  const std::vector<Circle> circles = {
      {0.5, 0.25, 1.5}, {2000.5, 10.125, 3}, {1500, 1800.75, 0.5}, {100, 1234567.5, 2}};
  const Diagram diagram = compute(circles).value();
  const Region region = Region::from(Box{-0.5, -1000.25, 3000.5, 2000.75}).value();
  const auto expected = numbersWritten(diagram, region);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "circle-voronoi-locales";
  std::filesystem::create_directories(folder);
  const bool isSet = setCommaLocale(folder);
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
  // The C++ locale has no name, so it leaves that of the C library.
  if (isSet) {
    EXPECT_STREQ(std::localeconv()->decimal_point, ",");
  }
  std::ostringstream shown;
  shown << 1234.5;
  EXPECT_EQ(shown.str(), "1.234,5");
  const auto found = numbersWritten(diagram, region);
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  unsetenv("LOCPATH");
  std::filesystem::remove_all(folder);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], expected[k]) << "text " << k;
}

}  // namespace
}  // namespace circle_voronoi
