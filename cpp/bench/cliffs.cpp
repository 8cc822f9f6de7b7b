// SPDX-License-Identifier: GPL-3.0-or-later
#include "cliffs.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <utility>

#include "child.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi_families/families.h"
#include "variants.h"

namespace {

using namespace circle_voronoi;

constexpr std::uint64_t kSeed = 1;
constexpr double kMost = 3;
constexpr double kMostOfTies = 15;

struct Cost {
  double seconds;  ///< processor time
  char way[32];
  double flips;
  double filtered;  ///< signs that the filter decided
  double refined;   ///< signs that took twice the digits
  double inCircle;  ///< signs that took the in-circle test
  double exact;     ///< signs that took integers
};

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

Cost costOf(const std::vector<Circle>& circles) {
  const double start = processorSeconds();
  const auto diagram = compute(circles);
  Cost cost{};
  cost.seconds = processorSeconds() - start;
  if (!diagram) {
    std::strncpy(cost.way, "not certified", sizeof cost.way - 1);
    return cost;
  }
  const Stats& stats = diagram.value().stats;
  std::strncpy(cost.way, wayName(stats.way.value()).data(), sizeof cost.way - 1);
  cost.flips = static_cast<double>(stats.counts.flips);
  cost.filtered = static_cast<double>(stats.counts.filtered);
  cost.refined = static_cast<double>(stats.counts.refined);
  cost.inCircle = static_cast<double>(stats.counts.inCircle);
  cost.exact = static_cast<double>(stats.counts.exact);
  return cost;
}

/// Processor seconds of uniform circles, the median of three runs. Measured again for each entry, because the speed of
/// the machine may vary.
double uniformSeconds(std::size_t size, unsigned limitSeconds) {
  std::array<double, 3> seconds{};
  for (double& one : seconds) {
    const auto child = runInChild<Cost>(limitSeconds, [&] { return costOf(generate(Family::uniform, size, kSeed)); });
    one = child.value ? child.value->seconds : limitSeconds;
  }
  std::ranges::sort(seconds);
  return seconds[1];
}

/// The measurements for increasing numbers of circles.
class Row {
 public:
  Row(std::string name, bool isDegenerate) : name_(std::move(name)), isDegenerate_(isDegenerate) {}

  void print(std::size_t size, double uniform, const ChildResult<Cost>& child, unsigned limitSeconds) {
    std::printf("%-40s %8zu ", name_.c_str(), size);
    const double count = static_cast<double>(size);
    if (!child.value) {
      std::printf("%s  <--\n", child.isOver ? ("> " + std::to_string(limitSeconds) + " s").c_str() : "failed");
      return;
    }
    const Cost& cost = *child.value;
    const double each = cost.seconds / count;
    const double ratio = cost.seconds / uniform;
    std::printf("%9.2f %9.2f ", 1e6 * each, ratio);
    if (first_ > 0) {
      std::printf("%7.2f", each / first_);
    } else {
      std::printf("%7s", "");
      first_ = each;
    }
    std::printf("  %-16s %8.2f %8.2f %8.2f %9.2f %8.2f%s\n", cost.way, cost.flips / count, cost.filtered / count,
                cost.refined / count, cost.inCircle / count, cost.exact / count,
                ratio > mostRatio(cost) ? "  <--" : "");
    std::fflush(stdout);
  }

 private:
  double mostRatio(const Cost& cost) const {
    return isDegenerate_ || cost.refined + cost.inCircle + cost.exact > cost.filtered ? kMostOfTies : kMost;
  }

  std::string name_;
  bool isDegenerate_;
  double first_ = 0;  ///< seconds per circle at the first number of circles
};

}  // namespace

void printCliffs(const std::vector<std::string>& names, const std::vector<std::size_t>& sizes, unsigned limitSeconds) {
  std::printf("%-40s %8s %9s %9s %7s  %-16s %8s %8s %8s %9s %8s\n", "family", "n", "us/circle", "/ uniform", "growth",
              "way", "flips", "filtered", "refined", "in-circle", "exact");
  for (const FamilyInfo& family : families()) {
    if (!names.empty() && std::ranges::find(names, family.name) == names.end()) continue;
    for (const Variant& variant : variants()) {
      Row row(std::string(family.name) + std::string(variant.name), family.isDegenerate);
      for (const std::size_t size : sizes) {
        const auto child =
            runInChild<Cost>(limitSeconds, [&] { return costOf(variant.make(family.family, size, kSeed)); });
        row.print(size, uniformSeconds(size, limitSeconds), child, limitSeconds);
      }
    }
  }
}
