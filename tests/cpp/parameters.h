// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "circle_voronoi_families/families.h"

namespace circle_voronoi::test {

/// Names a parameterized test by its family or by its text, without the characters that such names must not have.
struct NameOfParameter {
  template <class T>
  std::string operator()(const testing::TestParamInfo<T>& info) const {
    std::string name;
    if constexpr (std::is_same_v<T, Family>) {
      name = familyName(info.param);
    } else {
      name = info.param;
    }
    std::ranges::replace(name, '-', '_');
    return name;
  }
};

/// Returns the families for which a condition holds.
template <class Condition>
std::vector<Family> familiesWhere(Condition condition) {
  std::vector<Family> result;
  for (const FamilyInfo& info : families()) {
    if (condition(info.family)) result.push_back(info.family);
  }
  return result;
}

}  // namespace circle_voronoi::test
