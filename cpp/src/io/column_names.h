// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "circle_voronoi/io.h"
#include "named_option.h"
#include "text.h"

namespace circle_voronoi {

/// Returns whether two names are equal, ignoring the case of ASCII letters.
bool isSameName(std::string_view a, std::string_view b);

/// Returns whether a column is called so. The name of a column may have white space inside its quotation marks.
bool isNameOfColumn(std::string_view name, std::string_view column);

/// Returns whether x and y have names of longitude and latitude.
bool areDegrees(std::string_view x, std::string_view y);

/// The names of the columns of a table, of the members of a JSON object and of the properties of a GeoJSON point that
/// mean x, y, r or the id of a circle.
class ColumnNames {
 public:
  static constexpr std::size_t kCount = 3;  ///< x, y and r
  static constexpr std::size_t kRadius = 2;

  explicit ColumnNames(const ReadOptions& options);

  /// Returns whether each circle needs number k. A missing number that is not needed is 0.
  bool isNeeded(std::size_t k) const { return k != kRadius || radii_ == Radii::needed; }

  /// Returns whether all radii are 0.
  bool hasNoRadii() const { return radii_ == Radii::none; }

  /// Returns the position of a name in the list of names of number k, from 0; nothing if the list does not contain it.
  std::optional<std::size_t> rank(std::size_t k, std::string_view name) const;
  bool means(std::size_t k, std::string_view name) const { return rank(k, name).has_value(); }
  /// Returns the column of number k, from 1, if its option is "#1", "#2", ...
  std::optional<std::size_t> columnNumber(std::size_t k) const { return numberIn(own_[k]); }
  /// Returns the column of the id, from 1, if its option is "#1", "#2", ...
  std::optional<std::size_t> columnOfId() const { return numberIn(id_); }
  /// Returns whether the user has named number k.
  bool isGiven(std::size_t k) const { return !own_[k].empty(); }
  /// Returns whether the user gave any name.
  bool areGiven() const { return !missing(0).empty(); }
  /// Returns the first name given by the user that is not the number of one of `columns` columns, or an empty string.
  std::string missing(std::size_t columns) const;
  bool isId(std::string_view name) const { return isSameName(name, id_); }
  /// Returns whether the user has named the column of ids.
  bool hasId() const { return hasId_; }
  const std::string& id() const { return id_; }

  /// Returns "x, cx, lon, long, lng, longitude or easting".
  std::string listOf(std::size_t k) const;
  /// Returns the name of number k in the library: x, y or r.
  static std::string plain(std::size_t k);
  /// Returns advice to name the column of number k by its option: `before`, "the option x" and a full stop.
  static OptionAdvice advice(std::string before, std::size_t k);
  /// Ends the sentence about a missing radius: with advice to do without radii, where that is possible.
  ReadError withoutRadius(ReadError failure) const;

 private:
  static std::optional<std::size_t> numberIn(std::string_view option);

  std::array<std::string, kCount> own_;  ///< names given by the user; empty for the usual names
  std::string id_;
  bool hasId_;
  Radii radii_;
  bool weights_;
};

}  // namespace circle_voronoi
