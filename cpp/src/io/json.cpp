// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>

#include "circle_members.h"
#include "column_names.h"
#include "items.h"
#include "json_reader.h"
#include "text.h"

namespace circle_voronoi {
namespace {

Circle readArray(JsonReader& reader, const ColumnNames& names) {
  std::array<double, ColumnNames::kCount> values{};
  std::size_t count = 0;
  if (names.areGiven()) {
    reader.skip();
    reader.fail("no member is called " + names.missing(0) + ": the circle is an array.");
  }
  reader.enterArray();
  while (reader.nextItem()) {
    if (count == values.size()) reader.fail("a circle has three numbers, not more.");
    const JsonKind kind = reader.kind();
    if (kind != JsonKind::number) {
      reader.fail("expected a number for " + ColumnNames::plain(count) + ", not " + std::string(nameOf(kind)) + ".");
    }
    values[count] = reader.number();
    ++count;
  }
  if (count < values.size() && names.isNeeded(count)) {
    const std::string reason = "a circle has no " + ColumnNames::plain(count);
    if (count != ColumnNames::kRadius) reader.fail(reason + ".");
    throw names.withoutRadius(reader.failure(reason));
  }
  if (names.hasNoRadii()) values[ColumnNames::kRadius] = 0;
  return {values[0], values[1], values[2]};
}

Circle readObject(JsonReader& reader, std::string_view text, CircleMembers& members, const ColumnNames& names) {
  members.read(reader, text);
  std::array<double, ColumnNames::kCount> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (const double* number = members.number(k)) {
      values[k] = *number;
    } else if (names.isNeeded(k)) {
      const std::string reason = "a circle has no " + names.listOf(k);
      if (k != ColumnNames::kRadius) reader.fail(reason + ".");
      throw names.withoutRadius(reader.failure(reason));
    }
  }
  return {values[0], values[1], values[2]};
}

}  // namespace

Result<ParsedFile> readJson(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep) try {
  const ColumnNames names(options);
  JsonReader reader(text);
  ItemReader items(options, keep);
  bool isFirst = true;
  bool hasDegrees = false;
  items.read(reader, [&](ItemReader::Item& item) {
    const JsonKind kind = reader.kind();
    if (kind == JsonKind::array) {
      item.circle = readArray(reader, names);
      return;
    }
    if (kind != JsonKind::object) {
      reader.skip();  // so that the error points to the end of the value
      reader.fail("expected a circle, [x,y,r] or {\"x\":..,\"y\":..,\"r\":..}, not " + std::string(nameOf(kind)) + ".");
    }
    CircleMembers members(names, 0, keep);
    item.circle = readObject(reader, text, members, names);
    hasDegrees = (isFirst || hasDegrees) && areDegrees(members.nameOf(0), members.nameOf(1));
    isFirst = false;
    item.properties = members.others();
    item.id = members.id();
    item.height = members.height();
  });
  reader.finish();
  ParsedFile file = items.take();
  file.areDegrees = hasDegrees;
  return file;
} catch (const ReadError& failure) {
  return errorAt(name, text, failure);
}

}  // namespace circle_voronoi
