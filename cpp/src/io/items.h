// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/point.h"
#include "json_reader.h"
#include "text.h"
#include "validate.h"

namespace circle_voronoi {

/// Reads an array of circles in JSON. Skips invalid items if ReadOptions::skipInvalid is set.
class ItemReader {
 public:
  struct Item {
    Circle circle = {};
    std::string properties = {};
    std::string id = {};
    std::string height = {};
    /// The other points of a MultiPoint, each with its height: circles with the same radius and attributes.
    std::vector<std::pair<Point, std::string>> others = {};
  };

  ItemReader(const ReadOptions& options, Keep keep)
      : weights_(options.weights), skipsInvalid_(options.skipInvalid), id_(options.id), keep_(keep) {}

  /// Reads the array that comes next. `readItem(item)` reads an item. Throws ReadError.
  template <class ReadItem>
  void read(JsonReader& reader, ReadItem readItem) {
    reader.enterArray();
    for (std::int64_t index = 0; reader.nextItem(); ++index) readOne(reader, index, readItem);
  }

  /// Reads the item that comes next; see `read`.
  template <class ReadItem>
  void readOne(JsonReader& reader, std::int64_t index, ReadItem readItem) {
    Item item;
    if (!skipsInvalid_) {
      try {
        readItem(item);
      } catch (ReadError& failure) {
        failure.circle = index;
        throw;
      }
      return add(std::move(item), reader.offset());
    }
    const auto before = reader.place();
    try {
      readItem(item);
      check(item.circle, index, reader);
      for (const auto& [point, height] : item.others) check({point.x, point.y, item.circle.r}, index, reader);
      add(std::move(item), reader.offset());
    } catch (ReadError& failure) {
      failure.circle = index;
      result_.skipped.push_back(failure);
      // A text that is not JSON cannot be skipped.
      reader.goTo(before);
      reader.skip();
    }
  }

  /// Returns the items that were read. Lists without any attributes are empty. Throws ReadError if no circle has the id
  /// that the user has named.
  ParsedFile take() {
    const auto& ids = result_.attributes.ids;
    if (!id_.empty() && !ids.empty() && std::ranges::all_of(ids, &std::string::empty)) {
      throw ReadError{0, "no circle has a string or a number called " + id_ + "."};
    }
    const auto clearUnused = [](auto& list) {
      if (std::ranges::all_of(list, &std::string::empty)) list.clear();
    };
    clearUnused(result_.attributes.properties);
    clearUnused(result_.attributes.ids);
    clearUnused(result_.attributes.heights);
    return std::move(result_);
  }

 private:
  void check(const Circle& circle, std::int64_t index, const JsonReader& reader) const {
    if (const auto error = errorOf(circle, weights_)) {
      throw ReadError{reader.offset(), "Circle " + std::to_string(index) + " " + error->what, error->code};
    }
  }

  void add(Item item, std::size_t offset) {
    const auto others = std::move(item.others);
    const Item first = others.empty() ? Item() : item;
    addOne(std::move(item), offset);
    for (const auto& [point, height] : others) {
      addOne({{point.x, point.y, first.circle.r}, first.properties, first.id, height}, offset);
    }
  }

  void addOne(Item item, std::size_t offset) {
    result_.parsed.circles.push_back(item.circle);
    result_.parsed.offsets.push_back(offset);
    if (keep_ == Keep::circles) return;
    result_.attributes.properties.push_back(std::move(item.properties));
    result_.attributes.ids.push_back(std::move(item.id));
    result_.attributes.heights.push_back(std::move(item.height));
  }

  bool weights_;
  bool skipsInvalid_;
  std::string id_;
  Keep keep_;
  ParsedFile result_;
};

}  // namespace circle_voronoi
