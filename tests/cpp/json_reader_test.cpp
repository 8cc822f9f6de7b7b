// SPDX-License-Identifier: GPL-3.0-or-later
// The reader of JSON, held against another one.
#include "json_reader.h"

#include <gtest/gtest.h>

#include <bit>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "random.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;

/// Takes any value apart and puts it together again.
Json valueOf(JsonReader& reader) {
  switch (reader.kind()) {
    case JsonKind::number:
      return reader.number();
    case JsonKind::string:
      return std::string(reader.string());
    case JsonKind::array: {
      Json array = Json::array();
      reader.enterArray();
      while (reader.nextItem()) array.push_back(valueOf(reader));
      return array;
    }
    case JsonKind::object: {
      Json object = Json::object();
      reader.enterObject();
      while (const auto key = reader.nextKey()) {
        const std::string name(*key);
        object[name] = valueOf(reader);
      }
      return object;
    }
    default: {
      const bool isNull = reader.kind() == JsonKind::null;
      const std::size_t from = reader.offset();
      reader.skip();
      return isNull ? Json() : Json(reader.offset() == from + 4);
    }
  }
}

std::optional<Json> parsed(const std::string& text) {
  try {
    JsonReader reader(text);
    Json value = valueOf(reader);
    reader.finish();
    return value;
  } catch (const ReadError& failure) {
    EXPECT_LE(failure.offset, text.size());
    return std::nullopt;
  }
}

bool isSkipped(const std::string& text) {
  try {
    JsonReader reader(text);
    reader.skip();
    reader.finish();
    return true;
  } catch (const ReadError&) {
    return false;
  }
}

/// Returns the keys of an object of numbers, asking for the keys in `names` by name, in turn.
std::vector<std::string> keysOf(const std::string& text, const std::vector<std::string>& names, std::size_t& plain) {
  JsonReader reader(text);
  reader.enterObject();
  std::vector<std::string> keys;
  for (std::size_t i = 0;; ++i) {
    if (i < names.size() && reader.nextKeyIs(names[i])) {
      ++plain;
      keys.push_back(names[i]);
    } else if (const auto key = reader.nextKey()) {
      keys.emplace_back(*key);
    } else {
      return keys;
    }
    (void)reader.number();
  }
}

/// The other parser's answer; integers as doubles.
std::optional<Json> expected(const std::string& text) {
  // It takes a byte-order mark, which is not part of JSON.
  if (text.starts_with("\xEF\xBB\xBF")) return std::nullopt;
  const Json value = Json::parse(text, nullptr, false);
  if (value.is_discarded()) return std::nullopt;
  return value;
}

const std::vector<std::string> kTexts = {
    R"({"a": [1, -2.5e3, 0, -0.0, 1E+2, 0.5e-7], "b": {"c": null, "d": true, "e": false}, "f": "", "g": [], "h": {}})",
    R"([[1,2,3],[4,5,6]])", R"([ {"x" : 1} , "\u0041\n\"\\\/\b\f\r\t\ud83d\ude00é€😀" ])", R"("\u00e9\u20ac")",
    " \t\r\n 17 "};

constexpr auto kTokens = std::to_array<std::string_view>({"{",
                                                          "}",
                                                          "[",
                                                          "]",
                                                          ",",
                                                          ":",
                                                          "\"",
                                                          "0",
                                                          "1",
                                                          "-",
                                                          ".",
                                                          "e",
                                                          "E",
                                                          "+",
                                                          "\\",
                                                          "\\u",
                                                          "\\n",
                                                          "\\ud83d",
                                                          "\\ude00",
                                                          "\\u00",
                                                          "true",
                                                          "false",
                                                          "null",
                                                          "nul",
                                                          " ",
                                                          "\n",
                                                          "\x01",
                                                          "\x7f",
                                                          "\x80",
                                                          "\xC3",
                                                          "\xE2\x82",
                                                          "\xED\xA0\x80",
                                                          "\xF4\x90\x80\x80",
                                                          "\xC0\xAF",
                                                          "\xF0\x9F\x98\x80",
                                                          "\"a\":"});

void expectTheSame(const std::string& text) {
  const auto theirs = expected(text);
  const auto ours = parsed(text);
  ASSERT_EQ(ours.has_value(), theirs.has_value()) << text;
  ASSERT_EQ(isSkipped(text), theirs.has_value()) << text;
  if (ours) {
    // Their numbers may be integers; comparison of numbers does not look at that.
    ASSERT_EQ(*ours, *theirs) << text;
  }
}

TEST(JsonReader, AKeyAskedForByNameIsReadOnlyIfItComesNext) {
  const std::vector<std::string> names = {"x", "y", "r"};
  struct Case {
    std::string text;
    std::vector<std::string> keys;
    std::size_t plain;
  };
  const Case cases[] = {{R"({"x": 1, "y": 2, "r": 3})", names, 3},
                        {R"({"x":1,"y":2,"r":3})", names, 1},
                        {R"({ "x": 1, "y" : 2, "r": 3})", names, 1},
                        {R"({"x": 1, "yr": 2})", {"x", "yr"}, 1},
                        {R"({"y": 1, "x": 2})", {"y", "x"}, 0},
                        {R"({"\u0078": 1, "y": 2})", {"x", "y"}, 1},
                        {R"({"x": 1, "y": 2, "r": 3, "s": 4})", {"x", "y", "r", "s"}, 3},
                        {"{}", {}, 0}};
  for (const auto& [text, keys, plain] : cases) {
    std::size_t count = 0;
    EXPECT_EQ(keysOf(text, names, count), keys) << text;
    EXPECT_EQ(count, plain) << text;
  }
  for (const std::string text :
       {R"({"x)", R"({"x")", R"({"x":)", R"({"x": 1, "y)", R"({"x": 1, "y": 2 "r": 3})", R"({"x": 1 "y": 2})"}) {
    std::size_t count = 0;
    EXPECT_THROW(keysOf(text, names, count), ReadError) << text;
  }
}

TEST(JsonReader, AgreesWithAnotherParserOnChangedTexts) {
  constexpr int kChanges = 30'000;
  Random random(1);
  for (const std::string& text : kTexts) expectTheSame(text);
  for (int i = 0; i < kChanges; ++i) {
    std::string text = kTexts[random.below(kTexts.size())];
    for (std::size_t changes = 1 + random.below(3); changes > 0; --changes) {
      const std::size_t at = random.below(text.size() + 1);
      const std::size_t size = std::min<std::size_t>(random.below(4), text.size() - at);
      text.replace(at, size, random.below(4) == 0 ? "" : kTokens[random.below(kTokens.size())]);
    }
    expectTheSame(text);
  }
}

TEST(JsonReader, ReadsNumbersToTheBit) {
  const auto bitsOf = [](const std::string& text) {
    JsonReader reader(text);
    return std::bit_cast<std::uint64_t>(reader.number());
  };
  for (const double value : {0.0, -0.0, 0.1, 1e22, 1e23, 0x1p-1074, 0x1.fffffffffffffp1023, 9007199254740993.0}) {
    EXPECT_EQ(bitsOf(Json(value).dump()), std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_EQ(bitsOf("-0"), std::bit_cast<std::uint64_t>(-0.0));
  EXPECT_EQ(bitsOf("12345678901234567890"), std::bit_cast<std::uint64_t>(12345678901234567890.0));
}

TEST(JsonReader, AValueOfAnotherKindIsNoNumber) {
  for (const std::string text : {"[1]", "\"1\"", "null"}) {
    try {
      (void)JsonReader(text).number();
      ADD_FAILURE() << text;
    } catch (const ReadError& failure) {
      EXPECT_EQ(failure.reason.substr(0, 32), "bad JSON: expected a number, not");
    }
  }
}

TEST(JsonReader, WholeNumbersFitOrAreNone) {
  const auto whole = [](const std::string& text) {
    JsonReader reader(text);
    return reader.whole<std::int32_t>();
  };
  EXPECT_EQ(whole("17"), 17);
  EXPECT_EQ(whole("-1"), -1);
  EXPECT_EQ(whole("1.5e1"), 15);
  EXPECT_EQ(whole("2147483647"), 2147483647);
  for (const char* text : {"2147483648", "-2147483649", "0.5", "1e10", "-1e300"}) EXPECT_EQ(whole(text), std::nullopt);
  // Beyond 2^53 not every whole number is a double, so a number with a point or an exponent may have been another one.
  const auto wide = [](const std::string& text) {
    JsonReader reader(text);
    return reader.whole<std::int64_t>();
  };
  EXPECT_EQ(wide("9007199254740993"), 9007199254740993);
  EXPECT_EQ(wide("9.007199254740992e15"), 9007199254740992);
  for (const char* text : {"9.007199254740994e15", "-1e16"}) EXPECT_EQ(wide(text), std::nullopt);
}

}  // namespace
}  // namespace circle_voronoi
