// SPDX-License-Identifier: GPL-3.0-or-later
// Edits take steps in proportion to what they change, also beside a circle with many neighbors.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "circle_voronoi/editor.h"
#include "growth.h"

namespace circle_voronoi::test {
namespace {

/// The circles of an input in a random order, except for the first.
std::vector<Circle> shuffled(const GrowthInput& input) {
  std::vector<Circle> circles = input.circles;
  std::shuffle(circles.begin() + 1, circles.end(), std::mt19937_64(1));
  return circles;
}

std::shared_ptr<DiagramEditor> editorOf(std::span<const Circle> circles) {
  return std::make_shared<DiagramEditor>(DiagramEditor::from(circles).value());
}

TEST(GrowthOfEdits, OfInsertions) {
  expectGrowth({"insert", "editor.h",
                [](const GrowthInput& input) {
                  const auto circles = kept(shuffled(input));
                  const std::size_t half = circles->size() / 2;
                  const auto editor = editorOf(std::span(*circles).first(half));
                  return [circles, half, editor] {
                    for (std::size_t k = half; k < circles->size(); ++k) EXPECT_TRUE(editor->insert((*circles)[k]));
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfEdits, OfInsertionsInOrder) {
  expectGrowth({"insert", "editor.h",
                [](const GrowthInput& input) {
                  const auto editor = editorOf(std::span(input.circles).first(1));
                  return [circles = input.circles, editor] {
                    for (std::size_t k = 1; k < circles.size(); ++k) EXPECT_TRUE(editor->insert(circles[k]));
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfEdits, OfRemovals) {
  expectGrowth({"remove", "editor.h",
                [](const GrowthInput& input) {
                  const auto circles = shuffled(input);
                  const auto editor = editorOf(circles);
                  const auto count = static_cast<std::int32_t>(circles.size());
                  return [count, editor] {
                    for (std::int32_t id = 1; id < count; ++id) EXPECT_TRUE(editor->remove(id));
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfEdits, OfMoves) {
  expectGrowth({"replace", "editor.h",
                [](const GrowthInput& input) {
                  const auto circles = kept(shuffled(input));
                  const auto editor = editorOf(*circles);
                  return [circles, editor] {
                    for (std::size_t k = 1; k < circles->size(); ++k) {
                      // Less than the distance of neighbors, so that each move changes a few cells.
                      const auto& [x, y, r] = (*circles)[k];
                      const double turn = 1.0 / static_cast<double>(circles->size());
                      EXPECT_TRUE(editor->replace(static_cast<std::int32_t>(k), {x - turn * y, y + turn * x, r}));
                    }
                  };
                },
                circleFamilies()});
}

// The first circle of the hub has all others as neighbors, so its own edits take as many steps.
TEST(GrowthOfEdits, OfOneCircle) {
  expectGrowth({"apply", "editor.h",
                [](const GrowthInput& input) {
                  const auto editor = editorOf(input.circles);
                  const Circle first = input.circles[0];
                  return [first, editor] {
                    EXPECT_TRUE(editor->replace(0, {first.x, first.y, first.r * 1.01}));
                    EXPECT_TRUE(editor->remove(0));
                    EXPECT_TRUE(editor->apply(std::vector<Edit>{{Edit::Kind::insert, 0, first}}));
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfEdits, OfTheNearestCircle) {
  expectGrowth({"nearest", "editor.h",
                [](const GrowthInput& input) {
                  const auto editor = editorOf(input.circles);
                  return [circles = input.circles, editor] {
                    // Also points far inside the cell of the first circle, which is the large one of the hub.
                    const Circle& first = circles[0];
                    for (const auto& [x, y, r] : circles) {
                      for (const double share : {0.1, 0.9, 1.0}) {
                        const Point p = {first.x + share * (x - first.x), first.y + share * (y - first.y)};
                        EXPECT_NE(editor->nearest(p), kNone);
                      }
                    }
                  };
                },
                circleFamilies()});
}

TEST(GrowthOfEdits, OfSnapshots) {
  expectGrowth({"snapshot", "editor.h",
                [](const GrowthInput& input) {
                  const auto editor = editorOf(input.circles);
                  return [editor] {
                    EXPECT_TRUE(editor->snapshot());
                    EXPECT_TRUE(editor->numbers());
                    EXPECT_TRUE(editor->all());
                    EXPECT_TRUE(editor->certificate());
                  };
                },
                circleFamilies()});
}

}  // namespace
}  // namespace circle_voronoi::test
