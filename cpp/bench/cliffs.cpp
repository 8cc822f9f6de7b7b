// SPDX-License-Identifier: GPL-3.0-or-later
#include "cliffs.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include "child.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/families.h"

namespace {

using namespace circle_voronoi;

using Circles = std::vector<Circle>;

constexpr std::uint64_t kSeed = 1;
constexpr double kMost = 3;
constexpr double kMostOfTies = 15;

double extentOf(const Circles& circles) {
  if (circles.empty()) return 0;
  double low = circles[0].x;
  double high = low;
  for (const Circle& c : circles) {
    low = std::min({low, c.x - c.r, c.y - c.r});
    high = std::max({high, c.x + c.r, c.y + c.r});
  }
  return high - low;
}

/// The ratio of 1e9, a common sentinel, to the side of 60,000 circles at density 1.
constexpr double kFar = 4e6;

Circles withOutlier(Family family, std::size_t count) {
  Circles circles = generate(family, count, kSeed);
  if (count > 0) circles[count / 2] = {kFar * extentOf(circles), 0, 0};
  return circles;
}

Circles withDuplicates(Family family, std::size_t count) {
  Circles circles = generate(family, count, kSeed);
  for (std::size_t i = 0; i < count; i += 4) circles[i] = circles[(i * 7 + 1) % count];
  return circles;
}

Circles inTwoClusters(Family family, std::size_t count) {
  Circles circles = generate(family, count / 2, kSeed);
  const double distance = 1000 * kFar * extentOf(circles);
  for (const Circle& c : generate(family, count - count / 2, kSeed + 1)) {
    circles.push_back({c.x + distance, c.y, c.r});
  }
  return circles;
}

struct Variant {
  const char* name;
  Circles (*make)(Family, std::size_t);
};

constexpr std::array kVariants = {
    Variant{"", [](Family family, std::size_t count) { return generate(family, count, kSeed); }},
    Variant{" + outlier", withOutlier}, Variant{" + duplicates", withDuplicates},
    Variant{" in two clusters", inTwoClusters}};

struct Cost {
  double seconds;  ///< of the processor
  char way[32];
  double flips;
  double inCircle;  ///< signs that took the in-circle test
  double exact;     ///< signs that took integers
};

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

Cost costOf(const Circles& circles) {
  const double start = processorSeconds();
  const auto diagram = compute(circles);
  Cost cost{};
  cost.seconds = processorSeconds() - start;
  if (!diagram) {
    std::strncpy(cost.way, "not certified", sizeof cost.way - 1);
    return cost;
  }
  const Stats& stats = diagram.value().stats;
  std::strncpy(cost.way, stats.way.c_str(), sizeof cost.way - 1);
  cost.flips = static_cast<double>(stats.counts.flips);
  cost.inCircle = static_cast<double>(stats.counts.inCircle);
  cost.exact = static_cast<double>(stats.counts.exact);
  return cost;
}

}  // namespace

void printCliffs(const std::vector<std::string>& names, const std::vector<std::size_t>& sizes, unsigned limitSeconds) {
  for (const std::size_t size : sizes) {
    const auto measure = [&](const Variant& variant, Family family) {
      return runInChild<Cost>(limitSeconds, [&] { return costOf(variant.make(family, size)); });
    };
    const auto uniform = measure(kVariants[0], Family::uniform);
    if (!uniform.value) return;
    const double count = static_cast<double>(size);
    std::printf("%-40s %8s %9s %9s  %-16s %8s %9s %8s\n", "family", "n", "us/circle", "/ uniform", "way", "flips",
                "in-circle", "exact");
    for (const FamilyInfo& family : families()) {
      if (!names.empty() && std::ranges::find(names, family.name) == names.end()) continue;
      for (const Variant& variant : kVariants) {
        const auto [cost, isOver, megabytes] = measure(variant, family.family);
        std::printf("%-40s %8zu ", (std::string(family.name) + variant.name).c_str(), size);
        if (!cost) {
          std::printf("%s\n", isOver ? "over the limit  <--" : "failed  <--");
          continue;
        }
        const double ratio = cost->seconds / uniform.value->seconds;
        std::printf("%9.2f %9.2f  %-16s %8.2f %9.2f %8.2f%s\n", 1e6 * cost->seconds / count, ratio, cost->way,
                    cost->flips / count, cost->inCircle / count, cost->exact / count,
                    ratio > (family.isDegenerate ? kMostOfTies : kMost) ? "  <--" : "");
      }
    }
  }
}
