// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs of tests/fixtures/fits and tests/fixtures/regions, as the program is given them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli.h"
#include "fixtures.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

class CliAwkward : public test::Cli {
 protected:
  const std::string square_ = " --region " + write("square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1))");
  std::string fit(const std::string& file) const { return "fit " + file + " --areas a --shares" + square_; }
};

TEST_F(CliAwkward, SharesWhoseSumIsNoNumberAreRefused) {
  expectFailure(run(fit(test::fileOfFixtures("fits/huge-shares.csv"))), 2,
                "The areas sum to more than the largest number.");
}

TEST_F(CliAwkward, AnAreaThatNoWeightGivesDoesNotConverge) {
  // The two weights that come nearest hide the cell or give it a hundred times its area.
  expectFailure(run(fit(test::fileOfFixtures("fits/two-fit.csv"))), 1, "The fit stopped after");
}

TEST_F(CliAwkward, ThinCellsAreAsAccurateAsTheLastBitsAllow) {
  for (const double area : {1e-5, 1e-6, 1e-7, 3e-8, 1e-8}) {
    const std::string sites = "x,y,a\n0.3,0.4,1\n0.301,0.4," + std::to_string(area * 1e9) + "e-9\n";
    const auto [status, out, err] = run(fit(write("two.csv", sites)) + " --format geojson");
    ASSERT_EQ(status, 0) << area << ": " << err;
    const double found = Json::parse(out)["features"][1]["properties"]["area"].get<double>();
    // At weights with one bit more or less, the square of the area is one of the next ones in steps of the least area.
    const double least = 1.0189636649e-8;
    const double target = area / (1 + area);
    EXPECT_LE(std::abs(found * found - target * target), 0.51 * least * least) << area;
  }
}

TEST_F(CliAwkward, CountiesThatShareABorderAreMergedOnRequest) {
  const std::string circles = write("circles.csv", "x,y,r,share\n2,2,0,1\n7,6,1,2\n");
  const std::string compute =
      "compute " + circles + " --format geojson --region " + test::fileOfFixtures("regions/shared-border.wkt");
  expectFailure(run(compute), 2, "overlap beside (5, 0). Set --dissolve to merge them.");
  const auto [status, out, err] = run(compute + " --dissolve");
  ASSERT_EQ(status, 0) << err;
  double sum = 0;
  const Json cells = Json::parse(out);
  for (const Json& feature : cells["features"]) sum += feature["properties"]["area"].get<double>();
  EXPECT_NEAR(sum, 100, 1e-10);
  const std::string merged = " --dissolve --format wkt --region " + test::fileOfFixtures("regions/shared-border.wkt");
  EXPECT_EQ(run("fit " + circles + " --areas share --shares" + merged).status, 0);
  expectFailure(run("compute " + circles + " --dissolve"), 2, "--dissolve needs --region.");
}

}  // namespace
}  // namespace circle_voronoi
