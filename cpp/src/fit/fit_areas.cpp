// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/fit_areas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "box_area.h"
#include "cell_measure.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/limits.h"
#include "circle_voronoi/metric.h"
#include "guarded.h"
#include "named_option.h"
#include "number_text.h"
#include "recompute.h"
#include "rounded.h"
#include "scale.h"
#include "spring_system.h"
#include "two_part.h"

namespace circle_voronoi {
namespace {

[[noreturn]] void refuse(ErrorCode code, std::string message, std::int64_t site = kNone) {
  throw ThrownError{{code, site, std::move(message)}};
}

[[noreturn]] void refuse(ErrorCode code, std::string message, const OptionAdvice& advice) {
  Error error = {code, kNone, std::move(message)};
  append(error, advice);
  throw ThrownError{std::move(error)};
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

void checkSites(std::span<const Circle> sites) {
  if (sites.empty()) refuse(ErrorCode::badInput, "There are no sites.");
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto index = static_cast<std::int64_t>(i);
    const auto& [x, y, r] = sites[i];
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(r)) {
      refuse(ErrorCode::nonFinite, "Site " + std::to_string(i) + ": x, y and the weight must be finite.", index);
    }
  }
  std::vector<std::size_t> order(sites.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto place = [&](std::size_t i) { return std::tuple(sites[i].x, sites[i].y, i); };
  std::ranges::sort(order, {}, place);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Circle& first = sites[order[k - 1]];
    const Circle& second = sites[order[k]];
    if (first.x != second.x || first.y != second.y) continue;
    refuse(ErrorCode::badInput,
           "Site " + std::to_string(order[k]) + " has the same position as site " + std::to_string(order[k - 1]) + ".",
           static_cast<std::int64_t>(order[k]));
  }
}

/// Returns the periods as the fit will round them. Throws if two sites differ by whole periods: as points, they hide
/// one another.
Lattice checkSites(std::span<const Circle> sites, const Lattice& lattice) {
  checkSites(sites);
  std::vector<Circle> points(sites.begin(), sites.end());
  for (Circle& point : points) point.r = 0;
  const auto periodic = computePeriodic(points, lattice);
  if (!periodic) throw ThrownError{periodic.error()};
  for (const HiddenCircle& hidden : periodic->diagram.hidden) {
    if (hidden.circle >= periodic->circleCount) continue;
    const auto [first, second] = std::minmax({hidden.circle, periodic->circleOf[static_cast<std::size_t>(hidden.by)]});
    refuse(
        ErrorCode::badInput,
        "Site " + std::to_string(second) + " has the same position as an image of site " + std::to_string(first) + ".",
        second);
  }
  return periodic->lattice;
}

/// The options of the diagrams of a fit, which differ from the default for powers only.
Options diagramOptions(Metric metric) {
  Options options;
  options.metric = metric;
  options.weights = metric == Metric::power;
  return options;
}

/// The cells that some weights lead to.
struct State {
  std::vector<double> weights;
  PeriodicDiagram found;  ///< in a region: the diagram alone
  CellMeasure cells;
};

/// The density by which areas are measured: 1 inside the region, plus `background` in a box around region and sites
/// that every cell meets. As the background fades, the weights converge to the weights for the region alone.
struct Density {
  double background = 0;
};

double largestIn(const Box& box) { return std::max({-box.minX, -box.minY, box.maxX, box.maxY}); }

/// Returns the caller's coordinates of a point.
Point placeOf(Point p, Point origin) { return {origin.x + p.x, origin.y + p.y}; }

/// Sites and a region, moved nearer to the origin without rounding.
struct Moved {
  Point by = {0, 0};  ///< the point that became the origin
  std::vector<Circle> sites;
  std::optional<Region> region;  ///< nothing if all stays where it is
};

/// Moves sites and a region that are far from the origin for their size, unless a coordinate would be rounded.
Moved movedToOrigin(std::span<const Circle> sites, const Region& region) {
  constexpr double kFar = 64;
  const Box box = region.bounds();
  const double size = std::max(box.maxX - box.minX, box.maxY - box.minY);
  const auto start = [&](double low, double high) { return std::max(-low, high) > kFar * size ? low : 0.0; };
  Moved moved = {{start(box.minX, box.maxX), start(box.minY, box.maxY)}, {}, {}};
  if (moved.by == Point{0, 0}) return moved;
  std::vector<Point> points(region.points().begin(), region.points().end());
  bool isExact = true;
  const auto move = [&](double& x, double by) {
    const TwoPart difference = sum(x, -by);
    isExact &= difference.rest == 0;
    x = difference.value;
  };
  for (Point& p : points) {
    move(p.x, moved.by.x);
    move(p.y, moved.by.y);
  }
  for (Circle c : sites) {
    c = rounded(c);
    move(c.x, moved.by.x);
    move(c.y, moved.by.y);
    moved.sites.push_back(c);
  }
  if (!isExact) return {};
  auto its = Region::fromArrays(points, region.ringOffsets(), region.polygonOffsets());
  if (!its) return {};
  moved.region = std::move(its).value();
  return moved;
}

/// Fits areas in a region or, without one, in the box of a lattice.
class Fitter {
 public:
  Fitter(std::span<const Circle> sites, std::vector<double> targets, const Region* region, const Lattice& lattice,
         const AreaFitOptions& options, Point origin = {})
      : sites_(sites.begin(), sites.end()),
        targets_(std::move(targets)),
        region_(region),
        lattice_(lattice),
        options_(options),
        origin_(origin) {
    placeBox();
  }

  State run() {
    for (int k = 0; k < options_.relax; ++k) moveToCentroids(fitted(std::max(options_.tolerance, kWhileMoving)));
    return fitted(options_.tolerance);
  }

  double errorOf(const State& state) const {
    double error = 0;
    for (std::size_t i = 0; i < sites_.size(); ++i) error = std::max(error, relativeError(state, i));
    return error;
  }

  int steps() const { return steps_; }

  /// Returns the tolerance of the options, or what last bits change if the error of a result is larger.
  double allowedFor(const State& state) const {
    double allowed = options_.tolerance;
    if (errorOf(state) <= allowed) return allowed;
    const std::vector<double> noise = noiseOf(state, largestCoordinate_);
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      allowed = std::max(allowed, std::min(kNearLastBits * noise[i] / targetOf(i), 1.0));
    }
    return std::max(allowed, errorOf(state));
  }

  const std::vector<Circle>& sites() const { return sites_; }

 private:
  /// Accuracy of the areas before sites move.
  static constexpr double kWhileMoving = 1e-3;
  /// Accuracy of the areas before the background fades.
  static constexpr double kRoughly = 0.1;
  static constexpr double kFading = 0.5;
  /// A cell keeps at least this share of the least area, so that the next step finds it.
  static constexpr double kLeastShare = 1e-5;
  /// Springs are hardened if a step would stretch them by more than this share of what the cells allow.
  static constexpr double kStretch = 0.8;
  static constexpr double kHardening = 1.2;
  static constexpr double kMostHardening = 1e5;
  static constexpr int kMostHardenings = 2;
  static constexpr int kMostTrials = 60;
  /// The number of attempts to raise the sites of hidden cells, and the share of the root of their areas by which each
  /// attempt raises them.
  static constexpr int kMostRaises = 6;
  static constexpr double kRaise = 0.1;
  /// If raising is not enough, all weights are multiplied by this factor, until they are nearly equal.
  static constexpr double kScaling = 0.25;
  static constexpr double kLeastScale = 0.01;
  /// A fit that is nearly done ends after this number of steps without better areas.
  static constexpr int kPatience = 16;
  static constexpr double kNearlyThere = 0.01;
  /// Where Newton's method ends within that many times what the last bits of weights change, single bits go on, as long
  /// as each step makes the error smaller by this factor.
  static constexpr double kNearLastBits = 16;
  /// A fit with sites outside that get no cell without background is hopeless after this number of steps times sites.
  static constexpr double kMostWork = 3e5;
  static constexpr double kBetter = 0.999;
  /// A spring less stiff than this, as a share of its length, holds nothing.
  static constexpr double kWeak = 1e-12;

  State fitted(double tolerance) {
    State state = startingState();
    report(state);
    while (density_.background > 0) {
      approach(state, kRoughly);
      fadeBackground(state);
    }
    approach(state, tolerance);
    return state;
  }

  /// Moves the sites to the centers of mass of their cells. The next fit starts from their weights.
  void moveToCentroids(const State& state) {
    const std::vector<Point> centroids = centroidsOf(state);
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      // As a number of the caller's, so that the site can go back there.
      const Point place = placeOf(centroids[i], origin_);
      sites_[i] = {place.x - origin_.x, place.y - origin_.y, state.weights[i]};
    }
    if (region_) {
      checkSites(sites_);
    } else {
      lattice_ = checkSites(sites_, lattice_);
    }
    placeBox();
  }

  std::vector<Point> centroidsOf(const State& state) const {
    const Diagram& diagram = state.found.diagram;
    if (region_) {
      const auto clipped = ClippedDiagram::from(diagram, *region_);
      if (!clipped) throw ThrownError{clipped.error()};
      return clipped->centroids();
    }
    std::vector<Point> centroids;
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      // The diagram may have the site in another box.
      const Point p = centroid(outline(diagram, static_cast<std::int32_t>(i)));
      const Circle& c = diagram.circles[i];
      centroids.push_back({sites_[i].x + (p.x - c.x), sites_[i].y + (p.y - c.y)});
    }
    return centroids;
  }

  /// A state in which every cell has an area. Sites that the first weights hide are raised; if that is not enough, the
  /// weights are brought nearer to one another; and where even equal weights are not enough, as for sites outside the
  /// region, the background helps.
  State startingState() {
    std::vector<double> weights;
    for (const Circle& site : sites_) weights.push_back(site.r);
    for (double scale = 1; scale > kLeastScale; scale *= kScaling) {
      if (std::optional<State> state = stateNear(weights)) return std::move(*state);
      for (double& weight : weights) weight *= kScaling;
    }
    State state = requiredStateAt(std::vector<double>(weights.size(), 0));
    if (leastArea(state) > 0) return state;
    if (!region_) fail(std::move(state), " because two sites are too close to each other");
    isFromOutside_ = true;
    density_.background = 1 / sizeOfBox_;
    return requiredStateAt(std::move(state.weights));
  }

  /// A state in which every cell has an area, at weights of which a few are larger than given; or nothing.
  std::optional<State> stateNear(std::vector<double> weights) const {
    for (int round = 0; round < kMostRaises; ++round) {
      std::optional<State> state = stateAt(std::move(weights));
      if (!state || leastArea(*state) > 0) return state;
      weights = state->weights;
      const Diagram& diagram = state->found.diagram;
      const Finder finder(diagram);
      for (std::size_t i = 0; i < sites_.size(); ++i) {
        const bool isMeasured = diagram.hidden.empty();
        if (isMeasured ? state->cells.areas[i] > 0 : diagram.hasCell(static_cast<std::int32_t>(i))) continue;
        const Point site = {diagram.circles[i].x, diagram.circles[i].y};
        const auto nearest = static_cast<std::size_t>(finder.find(site));
        const double reached = distance(diagram.metric, diagram.circles[nearest], site, diagram.weights);
        const double side = kRaise * std::sqrt(targets_[i]);
        weights[i] = (arePowers() ? side * side : side) - reached;
      }
    }
    return {};
  }

  /// Goes on with less background, or with none if each cell has an area without.
  void fadeBackground(State& state) {
    const double background = std::exchange(density_.background, 0);
    State bare = requiredStateAt(state.weights);
    if (leastArea(bare) > 0) {
      state = std::move(bare);
      return;
    }
    density_.background = background * kFading;
    state = requiredStateAt(state.weights);
  }

  /// Runs Newton's method until the error of each area is at most `tolerance`, or cannot be reduced by the last bits of
  /// the weights.
  void approach(State& state, double tolerance) {
    double best = errorOf(state);
    int idle = 0;
    const double least = kLeastShare * std::min(leastArea(state), *std::ranges::min_element(targets_));
    while (!isWithin(state, tolerance, 1)) {
      if (steps_ == options_.maxSteps) fail(std::move(state), "");
      if (isFromOutside_ && static_cast<double>(steps_) * static_cast<double>(sites_.size()) > kMostWork) {
        fail(std::move(state), " because so many sites lie outside the region");
      }
      const char* reason = nullptr;
      if (step(state, least, idle > kPatience / 2)) {
        count(state);
        const double error = errorOf(state);
        idle = error < best / 2 ? 0 : idle + 1;
        if (idle > kPatience && best < kNearlyThere) reason = " because areas no longer come nearer";
        best = std::min(best, error);
      } else {
        reason = " because no step leads further";
      }
      if (reason == nullptr) continue;
      if (!isWithin(state, tolerance, kNearLastBits, largestCoordinate_)) fail(std::move(state), reason);
      break;
    }
    if (density_.background > 0) return;
    while (errorOf(state) > tolerance && stepByLastBits(state)) count(state);
    if (!(errorOf(state) < 1)) fail(std::move(state), " because the last bits of the weights allow no better areas");
  }

  void count(const State& state) {
    ++steps_;
    report(state);
  }

  /// Takes a step that changes one weight by a few of its last bits, if one makes the largest error smaller: the weight
  /// of the cell with this error, or that of a neighbor. Newton's method ignores rounding, and the curvature of the
  /// area of a cell that is about to vanish.
  bool stepByLastBits(State& state) {
    const double error = errorOf(state);
    std::size_t worst = 0;
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      if (relativeError(state, i) == error) worst = i;
    }
    std::vector<std::size_t> chosen = {worst};
    for (const Spring& spring : state.cells.springs) {
      const auto i = static_cast<std::size_t>(spring.left);
      const auto j = static_cast<std::size_t>(spring.right);
      if (i == worst || j == worst) chosen.push_back(i == worst ? j : i);
    }
    std::ranges::sort(chosen.begin() + 1, chosen.end());
    chosen.erase(std::unique(chosen.begin() + 1, chosen.end()), chosen.end());
    const bool isTooSmall = state.cells.areas[worst] < targetOf(worst);
    for (const int bits : {1, 4, 16}) {
      for (const std::size_t i : chosen) {
        if (state.weights[i] == 0) continue;
        std::vector<double> weights = state.weights;
        const double towards = (i == worst) == isTooSmall ? std::numeric_limits<double>::max() : 0;
        for (int k = 0; k < bits; ++k) weights[i] = std::nextafter(weights[i], towards);
        std::optional<State> next = stateAt(std::move(weights), &state);
        if (!next || !(leastArea(*next) > 0) || !(errorOf(*next) < kBetter * error)) continue;
        if (steps_ == options_.maxSteps) fail(std::move(state), "");
        state = std::move(*next);
        return true;
      }
    }
    return false;
  }

  /// Takes one step that keeps every cell above an area, and returns whether there was one. Where springs are too weak
  /// to lead anywhere, as across a thin bridge, those of the box around the region help.
  bool step(State& state, double least, bool isSlow) const {
    if (stepAlong(state, least, springsOf(state), isSlow)) return true;
    return around_ && density_.background == 0 &&
           stepAlong(state, least, supported(state.cells.springs, state), isSlow);
  }

  /// Springs, first those inside the region.
  struct Springs {
    std::vector<Spring> all;
    std::size_t inside;
  };

  bool stepAlong(State& state, double least, const Springs& its, bool isSlow) const {
    const std::vector<Spring>& springs = its.all;
    std::vector<double> stiffness;
    for (const Spring& spring : springs) stiffness.push_back(spring.stiffness);
    SpringSystem system(sites_.size(), springs);
    const std::vector<double> forces = forcesOn(state);
    const double size = slopeAlong(forces, forces);
    std::vector<double> direction = directionAt(system, state, springs, forces, stiffness);
    const auto stateAtShare = [&](double share) {
      std::vector<double> weights = state.weights;
      for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += share * direction[i];
      return stateAt(std::move(weights), &state);
    };
    const auto isTooFar = [&](const State& next) {
      const std::vector<double> left = forcesOn(next);
      return slopeAlong(direction, left) <= -slopeAlong(direction, forces) / 2 && slopeAlong(left, left) >= size / 4;
    };
    double share = 1;
    double tooFar = 0;
    int losses = 0;
    for (int trial = 0; trial < kMostTrials && !direction.empty(); ++trial) {
      std::optional<State> next = stateAtShare(share);
      const auto isLost = [&](CircleIndex i) { return !(next->cells.areas[static_cast<std::size_t>(i)] > least); };
      if (next && leastArea(*next) > least) {
        if (!isTooFar(*next)) {
          // Where a border comes out of a thin bridge, its stiffness jumps: the best place is beside the jump.
          for (int k = 0; isSlow && k < kMostTrials && share < tooFar; ++k) {
            if (slopeAlong(direction, forcesOn(*next)) < slopeAlong(direction, forces) / 2) break;
            const double middle = (share + tooFar) / 2;
            std::optional<State> between = stateAtShare(middle);
            if (between && leastArea(*between) > least && !isTooFar(*between)) {
              share = middle;
              next = std::move(between);
            } else {
              tooFar = middle;
            }
          }
          state = std::move(*next);
          return true;
        }
        tooFar = share;
      } else if (next && !arePowers() && ++losses % kPatienceWithLosses == 0 && losses <= kMostLosses) {
        hold(its, isLost, stiffness);
        direction = directionAt(system, state, springs, forces, stiffness);
        share = kRenewed;
        tooFar = 0;
        continue;
      }
      share /= 2;
    }
    return false;
  }

  /// The springs of lost cells are made harder after this number of trials that lose cells, up to a total number. After
  /// that, only shorter steps help, as where a cell comes in whose border was just outside the region.
  static constexpr int kPatienceWithLosses = 5;
  static constexpr int kMostLosses = 30;
  static constexpr double kHolding = 4;
  static constexpr double kRenewed = 0.25;

  /// Makes the springs of cells harder that a step would lose. Those inside the region get one factor for each cell, so
  /// that they outweigh those outside and have the proportions that they have by nature: then the area of the cell
  /// grows along the step, if that is small enough, because its force is positive.
  template <class IsLost>
  void hold(const Springs& springs, const IsLost& isLost, std::span<double> stiffness) const {
    std::vector<double> held(sites_.size(), 0);
    std::vector<double> natural(sites_.size(), 0);
    for (std::size_t k = 0; k < springs.all.size(); ++k) {
      for (const CircleIndex i : {springs.all[k].left, springs.all[k].right}) {
        held[static_cast<std::size_t>(i)] += kHolding * stiffness[k];
        if (k < springs.inside) natural[static_cast<std::size_t>(i)] += springs.all[k].stiffness;
      }
    }
    for (std::size_t k = 0; k < springs.inside; ++k) {
      const double its = springs.all[k].stiffness;
      for (const CircleIndex i : {springs.all[k].left, springs.all[k].right}) {
        const auto cell = static_cast<std::size_t>(i);
        if (isLost(i) && natural[cell] > 0) stiffness[k] = std::max(stiffness[k], its * (held[cell] / natural[cell]));
      }
    }
  }

  Springs springsOf(const State& state) const {
    std::vector<Spring> springs = state.cells.springs;
    const std::size_t count = springs.size();
    if (!around_ || density_.background > 0) return {std::move(springs), count};
    // A border through a corner in which parts of the region touch has next to no length inside, and holds nothing.
    std::erase_if(springs, [&](const Spring& spring) { return !(lengthOf(spring) > kWeak * spring.length); });
    if (SpringSystem(sites_.size(), springs).components() > 1) return supported(std::move(springs), state);
    const std::size_t strong = springs.size();
    return {std::move(springs), strong};
  }

  bool arePowers() const { return options_.metric == Metric::power; }

  /// The length of the border that a spring stands for, roughly: how fast its area grows as the border moves.
  double lengthOf(const Spring& spring) const { return spring.stiffness * (arePowers() ? 2 * spring.length : 1); }

  /// Returns springs together with weaker ones in the box around the region.
  Springs supported(std::vector<Spring> springs, const State& state) const {
    const std::size_t inside = springs.size();
    for (Spring spring : measureCells(state.found.diagram, *around_).springs) {
      spring.stiffness *= kRoughly * kRoughly;
      springs.push_back(spring);
    }
    return {std::move(springs), inside};
  }

  std::vector<double> directionAt(SpringSystem& system, const State& state, std::span<const Spring> springs,
                                  std::span<const double> forces, std::span<double> stiffness) const {
    std::vector<double> x;
    for (int round = 0; round <= kMostHardenings; ++round) {
      x = system.solve(stiffness, forces, targets_);
      if (x.empty() || arePowers() || !harden(springs, state.weights, x, stiffness)) break;
    }
    return x;
  }

  /// Returns whether there was anything to harden.
  static bool harden(std::span<const Spring> springs, std::span<const double> weights, std::span<const double> x,
                     std::span<double> stiffness) {
    bool isHarder = false;
    for (std::size_t k = 0; k < springs.size(); ++k) {
      const auto i = static_cast<std::size_t>(springs[k].left);
      const auto j = static_cast<std::size_t>(springs[k].right);
      const double growth = x[i] - x[j];
      const double difference = weights[i] - weights[j];
      const double slack = springs[k].length + (growth > 0 ? -difference : difference);
      if (!(std::abs(growth) > kStretch * slack)) continue;
      stiffness[k] *= std::clamp(std::abs(growth) / (kStretch * slack), kHardening, kMostHardening);
      isHarder = true;
    }
    return isHarder;
  }

  /// Returns the target area minus the actual area of each site.
  std::vector<double> forcesOn(const State& state) const {
    std::vector<double> forces;
    for (std::size_t i = 0; i < sites_.size(); ++i) forces.push_back(targetOf(i) - state.cells.areas[i]);
    return forces;
  }

  static double slopeAlong(std::span<const double> direction, std::span<const double> forces) {
    return std::inner_product(direction.begin(), direction.end(), forces.begin(), 0.0);
  }

  /// Returns the target of a site, including its part of the background.
  double targetOf(std::size_t site) const { return targets_[site] * (1 + density_.background * sizeOfBox_); }

  double relativeError(const State& state, std::size_t site) const {
    return std::abs(state.cells.areas[site] - targetOf(site)) / targetOf(site);
  }

  /// Returns how much the last bits of numbers change each area: of weights, and of coordinates up to a size.
  std::vector<double> noiseOf(const State& state, double coordinate) const {
    std::vector<double> noise(sites_.size(), 0);
    for (const Spring& spring : state.cells.springs) {
      const auto i = static_cast<std::size_t>(spring.left);
      const auto j = static_cast<std::size_t>(spring.right);
      const double ofWeights = spring.stiffness * std::max(state.weights[i], state.weights[j]);
      const double most = 0x1p-52 * std::max(ofWeights, lengthOf(spring) * coordinate);
      noise[i] += most;
      noise[j] += most;
    }
    return noise;
  }

  /// Returns whether the relative error of each area is at most `tolerance`, or its error at most `slack` times the
  /// change that last bits cause.
  bool isWithin(const State& state, double tolerance, double slack, double coordinate = 0) const {
    if (errorOf(state) <= tolerance) return true;
    const std::vector<double> noise = noiseOf(state, coordinate);
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      const double target = targetOf(i);
      if (std::abs(state.cells.areas[i] - target) > std::max(tolerance * target, slack * noise[i])) return false;
    }
    return true;
  }

  static double leastArea(const State& state) { return *std::ranges::min_element(state.cells.areas); }

  /// Returns whether weights let a neighbor of a site in a state hide it.
  bool isHiddenAt(std::span<const double> weights, const State& near) const {
    return !arePowers() && std::ranges::any_of(near.cells.springs, [&](const Spring& spring) {
      const auto i = static_cast<std::size_t>(spring.left);
      const auto j = static_cast<std::size_t>(spring.right);
      return spring.length <= std::abs(weights[i] - weights[j]);
    });
  }

  /// `near`: a state of similar weights, if there is one.
  Result<State> measured(std::vector<double> weights, const State* near = nullptr) const {
    const double least = *std::ranges::min_element(weights);
    std::vector<Circle> circles = sites_;
    for (std::size_t i = 0; i < circles.size(); ++i) circles[i].r = weights[i] -= least;
    State state = {std::move(weights), {}, {}};
    if (near && isHiddenAt(state.weights, *near)) {
      state.cells.areas.assign(sites_.size(), 0);
      return state;
    }
    Result<PeriodicDiagram> found = foundFor(circles, near);
    if (!found) return found.error();
    state.found = std::move(found).value();
    const Diagram& diagram = state.found.diagram;
    if (!diagram.hidden.empty()) {
      state.cells.areas.assign(sites_.size(), 0);
      return state;
    }
    state.cells = region_ ? measureCells(diagram, *region_) : measureCells(state.found);
    if (density_.background > 0) {
      const CellMeasure box = measureCells(diagram, *around_);
      for (std::size_t i = 0; i < sites_.size(); ++i) state.cells.areas[i] += density_.background * box.areas[i];
      for (Spring spring : box.springs) {
        spring.stiffness *= density_.background;
        state.cells.springs.push_back(spring);
      }
    }
    return state;
  }

  Result<PeriodicDiagram> foundFor(std::span<const Circle> circles, const State* near) const {
    const Options options = diagramOptions(options_.metric);
    if (!region_) return computePeriodic(circles, lattice_, options);
    PeriodicDiagram found;
    if (std::optional<Diagram> changed =
            near && !arePowers() ? recompute(near->found.diagram, circles) : std::nullopt) {
      found.diagram = *std::move(changed);
      return found;
    }
    Result<Diagram> diagram = compute(circles, options);
    if (!diagram) return diagram.error();
    found.diagram = std::move(diagram).value();
    return found;
  }

  State requiredStateAt(std::vector<double> weights) const {
    Result<State> state = measured(std::move(weights));
    if (!state) throw ThrownError{state.error()};
    return std::move(state).value();
  }

  /// Returns the state at these weights, or nothing if they have no diagram.
  std::optional<State> stateAt(std::vector<double> weights, const State* near = nullptr) const {
    Result<State> state = guarded([&] { return measured(std::move(weights), near); });
    if (state) return std::move(state).value();
    // Other weights do not help if memory runs out.
    if (state.error().code == ErrorCode::tooManyCircles) throw ThrownError{state.error()};
    return {};
  }

  void report(const State& state) const {
    if (options_.onStep) options_.onStep({steps_, errorOf(state), state.weights});
  }

  /// Reports the error of the last weights, which `onStep` got last.
  [[noreturn]] void fail(State state, const std::string& reason) {
    // The error without the background, which is internal.
    if (std::exchange(density_.background, 0) > 0) state = requiredStateAt(std::move(state.weights));
    refuse(ErrorCode::notConverged, "The fit stopped after " + counted(static_cast<std::size_t>(steps_), "step") +
                                        reason + ": the largest relative error of an area is " +
                                        roughNumberText(errorOf(state)) + ".");
  }

  /// Places the box of the background around region and sites.
  void placeBox() {
    if (!region_) return;
    Box box = region_->bounds();
    for (const Circle& site : sites_) {
      box.minX = std::min(box.minX, site.x);
      box.minY = std::min(box.minY, site.y);
      box.maxX = std::max(box.maxX, site.x);
      box.maxY = std::max(box.maxY, site.y);
    }
    largestCoordinate_ = largestIn(box);
    const double margin = std::max(box.maxX - box.minX, box.maxY - box.minY) / 8;
    auto around = Region::from(Box{box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin});
    if (!around) throw ThrownError{around.error()};
    around_ = *std::move(around);
    sizeOfBox_ = around_->area() / region_->area();
  }

  std::vector<Circle> sites_;
  std::vector<double> targets_;
  const Region* region_;
  Lattice lattice_;
  const AreaFitOptions& options_;
  Point origin_;  ///< the caller's coordinates of the origin
  std::optional<Region> around_;
  double sizeOfBox_ = 0;          ///< its area as a multiple of the region's
  double largestCoordinate_ = 0;  ///< of the region and the sites
  Density density_;
  bool isFromOutside_ = false;  ///< whether the fit began with a background
  int steps_ = 0;
};

/// A fit computes with parts and squares of areas, and with boxes and weights that are larger than the region.
constexpr double kLeastTarget = 0x1p-640;
constexpr double kLargestRegion = kCoordinateLimit / 8;

void checkSize(double size, const std::string& whole) {
  if (size <= kLargestRegion) return;
  refuse(ErrorCode::badInput, "The " + whole + " has a coordinate beyond " + numberText(kLargestRegion) +
                                  ", the limit of fits (" + numberText(size) + ").");
}

/// Returns the target areas, scaled so that they sum to the area of what errors call `whole`.
std::vector<double> targetsFrom(std::span<const double> areas, std::size_t sites, double wholeArea,
                                const std::string& whole, const AreaFitOptions& options) {
  if (areas.size() != sites) {
    refuse(ErrorCode::badInput, (areas.size() == 1 ? "There is " : "There are ") + counted(areas.size(), "area") +
                                    " for " + counted(sites, "site") + ".");
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] > 0 && std::isfinite(areas[i])) continue;
    refuse(ErrorCode::badInput,
           "Area " + std::to_string(i) + " must be positive and finite (got " + numberText(areas[i]) + ").",
           static_cast<std::int64_t>(i));
  }
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (!std::isfinite(sum)) refuse(ErrorCode::badInput, "The areas sum to more than the largest number.");
  const double slack = std::max(options.tolerance / 2, 0x1p-50 * static_cast<double>(areas.size()));
  if (!options.shares && !(std::abs(sum - wholeArea) <= slack * wholeArea)) {
    refuse(
        ErrorCode::badInput,
        "The areas sum to " + numberText(sum) + ", but the area of the " + whole + " is " + numberText(wholeArea) + ".",
        {" Set ", "`shares`", " to scale them.", "shares"});
  }
  std::vector<double> targets;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    targets.push_back(areas[i] / sum * wholeArea);
    if (targets[i] >= kLeastTarget) continue;
    refuse(ErrorCode::badInput,
           "Area " + std::to_string(i) + " is too small: " + numberText(areas[i] / sum) + " of a " + whole +
               " with the area " + numberText(wholeArea) + ".",
           static_cast<std::int64_t>(i));
  }
  return targets;
}

void checkOptions(const AreaFitOptions& options) {
  if (options.metric == Metric::centers) {
    refuse(ErrorCode::badOption, "A fit needs weights, which the metric centers has not.");
  }
  if (!(options.tolerance > 0 && options.tolerance < 1)) {
    refuse(ErrorCode::badOption, "",
           {"", "tolerance", " must be above 0 and below 1 (got " + numberText(options.tolerance) + ").", "tolerance"});
  }
  if (options.maxSteps < 1) {
    refuse(ErrorCode::badOption, "",
           {"", "maxSteps", " must be 1 or more (got " + std::to_string(options.maxSteps) + ").", "maxSteps"});
  }
  if (options.relax < 0) {
    refuse(ErrorCode::badOption, "",
           {"", "relax", " must not be negative (got " + std::to_string(options.relax) + ").", "relax"});
  }
}

}  // namespace

Result<AreaFit> fitAreas(std::span<const Circle> sites, std::span<const double> areas, const Region& region,
                         const AreaFitOptions& options) {
  return guarded([&]() -> Result<AreaFit> {
    checkOptions(options);
    checkSites(sites);
    checkSize(largestIn(region.bounds()), "region");
    AreaFitOptions own = options;
    own.onStep = lettingThrough(options.onStep);
    std::vector<double> targets = targetsFrom(areas, sites.size(), region.area(), "region", options);
    const Moved moved = movedToOrigin(sites, region);
    Fitter fitter(moved.region ? moved.sites : sites, std::move(targets), moved.region ? &*moved.region : &region, {},
                  own, moved.by);
    State state = fitter.run();
    const double error = fitter.errorOf(state);
    const double allowed = fitter.allowedFor(state);
    if (moved.region) {
      std::vector<Circle> circles = fitter.sites();
      for (std::size_t i = 0; i < circles.size(); ++i) {
        const Point place = placeOf({circles[i].x, circles[i].y}, moved.by);
        circles[i] = {place.x, place.y, state.weights[i]};
      }
      Result<Diagram> diagram = compute(circles, diagramOptions(options.metric));
      if (!diagram) return diagram.error();
      state.found.diagram = std::move(diagram).value();
    }
    return AreaFit{std::move(state.weights),
                   std::move(state.found.diagram),
                   std::move(state.cells.areas),
                   error,
                   fitter.steps(),
                   allowed};
  });
}

Result<PeriodicAreaFit> fitAreas(std::span<const Circle> sites, std::span<const double> areas, const Lattice& lattice,
                                 const AreaFitOptions& options) {
  return guarded([&]() -> Result<PeriodicAreaFit> {
    checkOptions(options);
    const Lattice rounded = checkSites(sites, lattice);
    const auto& [a, b] = rounded;
    checkSize(std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}), "box");
    AreaFitOptions own = options;
    own.onStep = lettingThrough(options.onStep);
    Fitter fitter(sites, targetsFrom(areas, sites.size(), boxArea(rounded), "box", options), nullptr, rounded, own);
    State state = fitter.run();
    const double error = fitter.errorOf(state);
    const double allowed = fitter.allowedFor(state);
    return PeriodicAreaFit{
        std::move(state.weights), std::move(state.found), std::move(state.cells.areas), error, fitter.steps(), allowed};
  });
}

}  // namespace circle_voronoi
