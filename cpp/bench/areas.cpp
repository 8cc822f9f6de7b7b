// SPDX-License-Identifier: GPL-3.0-or-later
#include "areas.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "child.h"
#include "circle_voronoi/fit_areas.h"
#include "random.h"

namespace circle_voronoi::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// A line of the table.
struct Fit {
  double seconds = 0;
  double error = 0;
  int steps = 0;
};

struct Problem {
  std::vector<Circle> sites;
  std::vector<double> shares;
};

/// Random sites in the unit square, as in scripts/bench-areas.mjs.
Problem problemOf(std::size_t count, double decades) {
  Problem problem;
  Random random(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit();
    problem.sites.push_back({x, random.unit(), 0});
    problem.shares.push_back(random.logUniform(0, decades));
  }
  return problem;
}

Fit fitOf(std::size_t count, double decades, bool isWarm) {
  Problem problem = problemOf(count, decades);
  const Region region = Region::from(Box{0, 0, 1, 1}).value();
  AreaFitOptions options;
  options.shares = true;
  if (isWarm) {
    const AreaFit before = fitAreas(problem.sites, problem.shares, region, options).value();
    for (std::size_t i = 0; i < count; ++i) problem.sites[i].r = before.weights[i];
    problem.sites[count / 2].x += 0.1 / std::sqrt(static_cast<double>(count));
  }
  const auto start = Clock::now();
  const auto fit = fitAreas(problem.sites, problem.shares, region, options);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!fit) {
    std::fprintf(stderr, "%s\n", fit.error().message.c_str());
    std::exit(1);
  }
  return {seconds, fit->error, fit->steps};
}

}  // namespace

void printAreas(const std::vector<std::size_t>& sizes, unsigned limitSeconds) {
  std::printf("%8s  %-12s %-5s %6s %10s %10s %9s\n", "sites", "areas", "start", "steps", "seconds", "error", "peak MB");
  for (const std::size_t size : sizes) {
    for (const double decades : {0.0, 2.0}) {
      for (const bool isWarm : {false, true}) {
        const auto child = runInChild<Fit>(limitSeconds, [&] { return fitOf(size, decades, isWarm); });
        const char* areas = decades == 0 ? "equal" : "two decades";
        const char* start = isWarm ? "warm" : "cold";
        if (!child.value) {
          std::printf("%8zu  %-12s %-5s %s\n", size, areas, start, child.isOver ? "over the limit" : "failed");
          continue;
        }
        const auto& [seconds, error, steps] = *child.value;
        std::printf("%8zu  %-12s %-5s %6d %10.4f %10.1e %9.0f\n", size, areas, start, steps, seconds, error,
                    child.megabytes);
      }
    }
  }
}

}  // namespace circle_voronoi::bench
