// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/tile.h"

namespace circle_voronoi {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

/// The tile, or the error, that a stream reads from a text in pieces of a given size.
Result<Tile> readInPieces(std::string_view text, std::size_t size) {
  Tile all;
  TileStream stream("test");
  const auto add = [&](const Result<Tile>& tile) -> std::optional<Error> {
    if (!tile) return tile.error();
    const auto& [circles, ids, done] = tile.value();
    all.circles.insert(all.circles.end(), circles.begin(), circles.end());
    all.ids.insert(all.ids.end(), ids.begin(), ids.end());
    all.done.insert(all.done.end(), done.begin(), done.end());
    return std::nullopt;
  };
  for (std::size_t i = 0; i < text.size(); i += size) {
    if (const auto error = add(stream.read(text.substr(i, size)))) return *error;
  }
  if (const auto error = add(stream.end())) return *error;
  return all;
}

std::string errorOf(std::string_view text, std::size_t size) {
  const auto tile = readInPieces(text, size);
  return tile ? "" : tile.error().message;
}

TEST(TileStream, ReadsTheSameInPiecesOfAnySize) {
  using namespace std::string_view_literals;
  const std::vector<std::string_view> texts = {
      "x,y,r\n1,2,3\n4,5,6"sv,
      "\xEF\xBB\xBF\r\n# trees\r\nid;x;y;r;done\r\n4;1;2;3;1\r\n\r\n7;4,5;5;6;0\r\n"sv,
      "x,y,r\r1,2,3\r\r4,5,6\r"sv,
      "x,y,r,name\n1,2,3,\"a\n\"\"b\"\"\r\nc\"\n4,5,6,\"\"\n"sv,
      ",,,\n# 5\" wide\nname,x,y,r\n5\" wide,1,2,3\nb,4,5,6\n"sv,
      // With spaces between fields, a field with a line end comes before the names.
      "5\" \"a\nb\" c\" x y r\n1 2 3 4 5 6\n"sv,
      ";;;\n\t\t\t\n1\t2\t3\n"sv,
      "1,2,3\n4,5,\"6"sv,
      "1,2,3\n4,\"5\"5,6\n7,8,9\n"sv,
      "1,2,3\n4,5\n7,8,-9\n"sv,
      "1,2,3\n4,5,-6\n7,8\n"sv,
      "x,y,r,id\n1,2,-3,a\n"sv,
      "1;2;3\n4,5;5;6\n7.5;8;9\n"sv,
      "\n\n# nothing\n\n"sv,
      "\n\n"sv,
      "\n [[1,2,3]]\n"sv,
      "\n\0\n1,2,3\n"sv,
      "\xFF\xFE\n\0"sv,
      "\xEF\xBB\xBF\xEF\xBB\xBF\n1,2,3\n"sv,
      "\"a\nb\n1,2,3\n"sv,
      ""sv,
  };
  for (const std::string_view text : texts) {
    const auto whole = readInPieces(text, text.size() + 1);
    for (std::size_t size = 1; size <= text.size(); ++size) {
      SCOPED_TRACE(std::string(text) + "\n- in pieces of " + std::to_string(size));
      const auto tile = readInPieces(text, size);
      ASSERT_EQ(static_cast<bool>(tile), static_cast<bool>(whole));
      if (!tile) {
        EXPECT_EQ(tile.error().message, whole.error().message);
        EXPECT_EQ(tile.error().circle, whole.error().circle);
        continue;
      }
      EXPECT_EQ(tile.value().circles, whole.value().circles);
      EXPECT_EQ(tile.value().ids, whole.value().ids);
      EXPECT_EQ(tile.value().done, whole.value().done);
    }
  }
}

TEST(TileStream, GivesTheCirclesOfTheLinesThatAPieceCompletes) {
  TileStream stream("test");
  const auto countAfter = [&](std::string_view piece) { return stream.read(piece).value().circles.size(); };
  EXPECT_EQ(countAfter("x,y,r\n1,2,"), 0U);
  EXPECT_EQ(countAfter("3\n4,5,6\r"), 1U) << "the CR may be half of a line end";
  EXPECT_EQ(countAfter("\n7,8,9\r"), 1U);
  EXPECT_EQ(countAfter("1"), 1U);
  EXPECT_EQ(countAfter(",2,3"), 0U);
  EXPECT_EQ(stream.end().value().circles, (std::vector<Circle>{{1, 2, 3}}));
}

TEST(TileStream, ATileHasTheLastLineToo) {
  const Tile tile = readTile("id,x,y,r,done\n7,1,2,3,0\n4,4,5,6,1", "test").value();
  EXPECT_EQ(tile.ids, (std::vector<std::int64_t>{4, 7}));
  EXPECT_EQ(tile.circles, (std::vector<Circle>{{4, 5, 6}, {1, 2, 3}}));
  EXPECT_EQ(tile.done, (std::vector<std::uint8_t>{1, 0}));
}

TEST(TileStream, NamesTheFirstErrorOfTheText) {
  for (const std::size_t size : {1, 7, 100}) {
    EXPECT_EQ(errorOf("1,2,3\n4,5,-6\n7,8\n", size), "test:2: Circle 1 has a negative radius.");
    EXPECT_EQ(errorOf("1,2,3\n4,5\n7,8,-9\n", size), "test:2: expected three numbers x,y,r separated by commas.");
  }
}

TEST(TileStream, HasALimitForALineAndForWhatComesBeforeTheTable) {
  const std::string table = "x,y,r\n1,2,3\n";
  const std::string line(65 * kMiB, 'a');
  std::string comments(65 * kMiB, '#');
  for (std::size_t i = 0; i < comments.size(); i += kMiB) comments[i] = '\n';
  for (const std::size_t size : {33 * kMiB, 100 * kMiB}) {
    EXPECT_EQ(errorOf(table + "\"" + line, size), "test:3: a line is too long, or a quotation mark is not closed.");
    EXPECT_EQ(errorOf(table + line + "\n4,5,6\n", size),
              "test:3: a line is too long, or a quotation mark is not closed.");
    EXPECT_EQ(errorOf(comments + "\n1,2,3\n", size), "test:1: the first 64 MiB have neither a header nor a circle.");
    EXPECT_EQ(errorOf(table + comments + "\n1,2,\n", size), "test:69: r is empty.");
  }
}

// Messages name the index in the whole text, even though only a piece is read.
TEST(TileStream, NamesTheCircleAndTheLineOfTheWholeThatAreWrong) {
  TileStream stream("test");
  ASSERT_TRUE(stream.read("x,y,r\n0,0,1\n1,1,1\n2,2").ok());
  ASSERT_EQ(stream.read(",1\n").value().ids, std::vector<std::int64_t>{2});
  const auto refused = stream.read("3,3,1\n4,4,-1\n");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().circle, 4);
  EXPECT_EQ(refused.error().message, "test:6: Circle 4 has a negative radius.");
}

}  // namespace
}  // namespace circle_voronoi
