// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the table of texts that every reader of circles must pass. tests/files/readings.test.ts runs it for the readers
// in JavaScript.
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "circle_voronoi/io.h"

namespace circle_voronoi {
namespace {

/// The line that a message names: "text:3: ...".
int lineIn(const std::string& message) {
  const std::size_t begin = message.find(':') + 1;
  int line = 0;
  std::from_chars(message.data() + begin, message.data() + message.size(), line);
  return line;
}

TEST(Readings, AreTheSameInEveryReader) {
  std::ifstream file(CIRCLE_VORONOI_READINGS);
  const auto readings = nlohmann::json::parse(file);
  ASSERT_GT(readings.size(), 100U);
  for (const auto& reading : readings) {
    SCOPED_TRACE(reading["what"].get<std::string>());
    const auto circles = readCircles(reading["text"].get<std::string>(), "text");
    if (!reading.contains("circles")) {
      ASSERT_FALSE(circles);
      if (reading.contains("line")) {
        EXPECT_EQ(lineIn(circles.error().message), reading["line"].get<int>());
      }
      if (reading.contains("circle")) {
        EXPECT_EQ(circles.error().circle, reading["circle"].get<int>());
      }
      continue;
    }
    ASSERT_TRUE(circles) << circles.error().message;
    std::vector<double> numbers;
    for (const Circle& c : *circles) numbers.insert(numbers.end(), {c.x, c.y, c.r});
    const auto expected = reading["circles"].get<std::vector<double>>();
    EXPECT_EQ(numbers, expected);
    EXPECT_TRUE(std::ranges::equal(
        numbers, expected, {}, [](double v) { return std::signbit(v); }, [](double v) { return std::signbit(v); }));
  }
}

}  // namespace
}  // namespace circle_voronoi
