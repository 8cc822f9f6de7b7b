// SPDX-License-Identifier: GPL-3.0-or-later
// Input without an end.
#include <gtest/gtest.h>

#include <string>

#include "cli.h"

namespace circle_voronoi {
namespace {

using CliEndless = test::Cli;

TEST_F(CliEndless, ALineWithoutAnEndIsAnError) {
  expectFailure(run("certify /dev/zero"), 2, "/dev/zero: a line is longer than 2 GiB");
  expectFailure(run("tile /dev/zero --size 1 --halo 1 -o " + path("tiles")), 2, "/dev/zero:1: ");
}

TEST_F(CliEndless, ALongLineOfAFileIsRead) {
  const std::string circles = write("circles.json", "[[0,0,1]," + std::string(3 << 20, ' ') + "[6,0,1],[0,8,1]]");
  EXPECT_EQ(run("convert " + circles + " --format csv").out, "x,y,r\n0,0,1\n6,0,1\n0,8,1\n");
}

}  // namespace
}  // namespace circle_voronoi
