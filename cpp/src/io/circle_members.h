// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "column_names.h"
#include "json_reader.h"
#include "members.h"
#include "text.h"

namespace circle_voronoi {

/// Reads a JSON object with numbers of a circle among its members. Where it has several names of one number, the first
/// in the list of names that has a number counts.
class CircleMembers {
 public:
  /// `first`: the first of x, y and r that the object may have.
  CircleMembers(const ColumnNames& names, std::size_t first, Keep keep) : names_(&names), first_(first), keep_(keep) {}

  /// Reads the object that comes next. Throws ReadFailure.
  void read(JsonReader& reader, std::string_view text) {
    reader.enterObject();
    while (const auto key = reader.nextKey()) {
      const std::size_t k = numberNamed(*key);
      const bool isCandidate = k < ColumnNames::kCount;
      if (keep_ == Keep::circles && !isCandidate && !names_->isId(*key)) {
        reader.skip();
        continue;
      }
      std::string name(*key);
      const JsonKind kind = reader.kind();
      const std::size_t begin = reader.offset();
      double value = 0;
      if (isCandidate && kind == JsonKind::number) {
        value = reader.number();
      } else {
        reader.skip();
      }
      if (isCandidate) take(k, {*names_->rank(k, name), name, kind, value, reader.offset(), true}, reader);
      if (names_->isId(name) && id_.empty()) {
        const std::string_view raw = text.substr(begin, reader.offset() - begin);
        if (isIdValue(raw)) id_ = raw;
      }
      if (keep_ == Keep::attributes) {
        members_.emplace_back(std::move(name), oneLine(text.substr(begin, reader.offset() - begin)));
      }
    }
  }

  /// Returns number k; nothing if there is none. Throws ReadFailure if there is another value.
  const double* number(std::size_t k) const {
    const Found& found = found_[k];
    if (!found.isGiven) return nullptr;
    if (found.kind != JsonKind::number) {
      throw ReadFailure{found.offset - 1,
                        "expected a number for " + found.name + ", not " + std::string(nameOf(found.kind)) + "."};
    }
    return &found.value;
  }

  /// Returns the id in JSON; empty if there is none.
  const std::string& id() const { return id_; }

  /// Returns the JSON of a member that is a number; empty if there is none.
  std::string height() const {
    for (const auto& [name, value] : members_) {
      if (isSameName(name, "z") && isNumberValue(value)) return value;
    }
    return "";
  }

  /// Returns the members that are no numbers of the circle.
  std::string others() const {
    Members others;
    for (const auto& member : members_) {
      const bool isUsed = std::ranges::any_of(found_, [&](const Found& found) {
        return found.isGiven && found.kind == JsonKind::number && found.name == member.first;
      });
      if (!isUsed) others.add(member.first, member.second);
    }
    return others.take();
  }

 private:
  struct Found {
    std::size_t rank = 0;
    std::string name;  ///< as it is written
    JsonKind kind = JsonKind::null;
    double value = 0;
    std::size_t offset = 0;  ///< of the end of the value
    bool isGiven = false;
  };

  std::size_t numberNamed(std::string_view name) const {
    std::size_t k = first_;
    while (k < ColumnNames::kCount && !names_->means(k, name)) ++k;
    return k;
  }

  void take(std::size_t k, Found found, const JsonReader& reader) {
    Found& best = found_[k];
    if (best.isGiven && best.rank == found.rank) reader.fail(found.name + " is given twice.");
    const auto order = [](const Found& f) { return std::pair(f.kind != JsonKind::number, f.rank); };
    if (!best.isGiven || order(found) < order(best)) best = std::move(found);
  }

  const ColumnNames* names_;
  std::size_t first_;
  Keep keep_;
  std::array<Found, ColumnNames::kCount> found_ = {};
  std::string id_;
  std::vector<std::pair<std::string, std::string>> members_;
};

}  // namespace circle_voronoi
