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

/// Reads a JSON object with numbers of a circle among its members. If several members name the same number, the first
/// name in the list whose member has a number counts. If a member is given twice, its last value counts, as in all of
/// JSON.
class CircleMembers {
 public:
  /// `first`: the first of x, y and r that the object may have.
  CircleMembers(const ColumnNames& names, std::size_t first, Keep keep) : names_(&names), first_(first), keep_(keep) {}

  /// Reads the object that comes next. Throws ReadError.
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
      if (isCandidate) take({k, *names_->rank(k, name), name, kind, value, reader.offset()});
      if (names_->isId(name) && (id_.empty() || name == idName_)) {
        const std::string_view raw = text.substr(begin, reader.offset() - begin);
        id_ = isIdValue(raw) ? raw : "";
        idName_ = name;
      }
      if (keep_ == Keep::attributes) {
        members_.emplace_back(std::move(name), oneLine(text.substr(begin, reader.offset() - begin)));
      }
    }
  }

  /// Returns number k; nothing if it is missing. Throws ReadError if its value is not a number, or if another member
  /// has the same name but for its case.
  const double* number(std::size_t k) const {
    const Found* const found = best(k);
    if (found == nullptr) return nullptr;
    if (!found->otherName.empty()) {
      throw ReadError{found->offset - 1, found->name + " and " + found->otherName + " mean the same."};
    }
    if (found->kind != JsonKind::number) {
      throw ReadError{found->offset - 1, "expected a number for " + found->name + ", not " +
                                             std::string(circle_voronoi::nameOf(found->kind)) + "."};
    }
    return &found->value;
  }

  /// Returns the name of number k as in the text; empty if it is missing.
  std::string_view nameOf(std::size_t k) const {
    const Found* const found = best(k);
    return found == nullptr ? std::string_view() : std::string_view(found->name);
  }

  /// Returns the id in JSON; empty if there is none.
  const std::string& id() const { return id_; }

  /// Returns the JSON of the member z or Z that is a number; empty if there is none.
  std::string height() const {
    for (const std::string_view name : {"z", "Z"}) {
      const auto last =
          std::find_if(members_.rbegin(), members_.rend(), [&](const auto& member) { return member.first == name; });
      if (last != members_.rend() && isNumberValue(last->second)) return last->second;
    }
    return "";
  }

  /// Returns all members except the numbers of the circle.
  std::string others() {
    std::array<const Found*, ColumnNames::kCount> used = {best(0), best(1), best(2)};
    std::erase_if(members_, [&](const auto& member) {
      return std::ranges::any_of(used, [&](const Found* found) {
        return found != nullptr && found->kind == JsonKind::number && found->name == member.first;
      });
    });
    return membersOf(members_);
  }

 private:
  struct Found {
    std::size_t k;  ///< the number that the name may mean
    std::size_t rank;
    std::string name;  ///< as in the text
    JsonKind kind;
    double value;
    std::size_t offset;          ///< the offset of the end of the value
    std::string otherName = {};  ///< the same name in other letters, if a member has it
  };

  std::size_t numberNamed(std::string_view name) const {
    std::size_t k = first_;
    while (k < ColumnNames::kCount && !names_->means(k, name)) ++k;
    return k;
  }

  void take(Found found) {
    const auto same = std::ranges::find_if(
        found_, [&](const Found& other) { return other.k == found.k && other.rank == found.rank; });
    if (same == found_.end()) {
      found_.push_back(std::move(found));
    } else if (same->name == found.name) {
      found.otherName = std::move(same->otherName);
      *same = std::move(found);
    } else {
      same->otherName = std::move(found.name);
      same->offset = found.offset;
    }
  }

  /// Returns member k, if there is one.
  const Found* best(std::size_t k) const {
    const Found* best = nullptr;
    const auto order = [](const Found& f) { return std::pair(f.kind != JsonKind::number, f.rank); };
    for (const Found& found : found_) {
      if (found.k == k && (best == nullptr || order(found) < order(*best))) best = &found;
    }
    return best;
  }

  const ColumnNames* names_;
  std::size_t first_;
  Keep keep_;
  std::vector<Found> found_;
  std::string id_;
  std::string idName_;
  MemberList members_;
};

}  // namespace circle_voronoi
