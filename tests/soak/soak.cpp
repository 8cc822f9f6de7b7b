// SPDX-License-Identifier: GPL-3.0-or-later
// Random inputs of every family, for a given time or number. Each diagram is certified and compared with the exact one;
// after random edits, a diagram must equal that of the current circles. Prints how to repeat each failure, with its
// shrunk input; the exit status is 1 if there was any.
#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <chrono>
#include <iostream>
#include <limits>
#include <mutex>
#include <random>
#include <thread>

#include "edit_script.h"
#include "report.h"
#include "tie_inputs.h"
#include "trial.h"

namespace circle_voronoi::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kManyCircles = 100'000;
constexpr std::uint64_t kRoundsBetweenMany = 50;

/// The exact graph would take hours for the last two families.
struct Many {
  Family family;
  bool isCompared;
};
constexpr std::array kMany = {Many{Family::uniform, true},      Many{Family::logUniform, true},
                              Many{Family::dense, true},        Many{Family::clustered, true},
                              Many{Family::intersecting, true}, Many{Family::hidden, true},
                              Many{Family::oneHuge, false},     Many{Family::grid, false}};

std::string commandOf(Family family, std::size_t count, std::uint64_t seed) {
  return "circle-voronoi generate " + std::string(familyName(family)) + " " + std::to_string(count) + " --seed " +
         std::to_string(seed);
}

class Soak {
 public:
  Soak(std::uint64_t seed, std::uint64_t rounds, bool editsAlone, Clock::time_point end)
      : seed_(seed), rounds_(rounds), editsAlone_(editsAlone), end_(end) {}

  /// The loop of one worker thread.
  void work() {
    for (std::uint64_t i = round_++; i < rounds_ && Clock::now() < end_; i = round_++) round(seed_ + i);
  }

  int report() const {
    std::cout << table_.text() << table_.trials() << " inputs, " << table_.problems() << " problems\n\n"
              << edits_.text() << edits_.edits() << " edits, " << edits_.problems() << " problems\n";
    return table_.problems() + edits_.problems() == 0 ? 0 : 1;
  }

 private:
  /// One input of every family and of every kind of tie, and one script of edits; now and then many circles.
  void round(std::uint64_t seed) {
    for (const FamilyInfo& family : families()) {
      edit(family, seed);
      if (editsAlone_) continue;
      Random random(seed);
      const std::size_t count = 3 + random.below(198);
      attempt(std::string(family.name), commandOf(family.family, count, seed), generate(family.family, count, seed),
              [&](std::span<const Circle> circles) { return tryAutomatic(circles, family.isDegenerate); });
      const auto tiny = besideFarPoint(generate(family.family, 2 + random.below(39), seed), random);
      // Beside their outlier the other circles are so small that rounding moves them to a few places.
      const bool hasTies = family.isDegenerate || family.family == Family::farOutlier;
      attempt(std::string(family.name) + ", beside a far point", "--seed " + std::to_string(seed), tiny,
              [&](std::span<const Circle> circles) { return tryTiny(circles, hasTies); });
    }
    if (editsAlone_) return;
    {
      Random random(seed);
      const auto nested = nestedTightly(2 + random.below(8), random);
      attempt("nested tightly", "--seed " + std::to_string(seed), nested,
              [](std::span<const Circle> circles) { return tryTiny(circles, true); });
    }
    for (const TieKind& kind : tieKinds()) {
      Random random(seed);
      std::vector<Circle> circles = kind.make(3 + random.below(60), random);
      disturb(circles, Disturbance{static_cast<int>(random.below(kDisturbances))}, random);
      attempt("ties, " + std::string(kind.name), "--seed " + std::to_string(seed), circles, tryCertified);
      // Subnormal squares of slacks may mislead a search for hiding circles.
      const auto tiny = besideFarPoint(kind.make(3 + random.below(20), random), random);
      attempt("ties, " + std::string(kind.name) + ", beside a far point", "--seed " + std::to_string(seed), tiny,
              [](std::span<const Circle> some) { return tryTiny(some, true); });
    }
    if (seed % kRoundsBetweenMany == 0) {
      const auto [family, isCompared] = kMany[seed / kRoundsBetweenMany % kMany.size()];
      const std::string name = std::string(familyName(family)) + ", 100,000";
      attempt(name, commandOf(family, kManyCircles, seed), generate(family, kManyCircles, seed),
              [&, compared = isCompared](std::span<const Circle> circles) {
                return compared ? tryAutomatic(circles, false) : tryCertified(circles);
              });
    }
  }

  void edit(const FamilyInfo& family, std::uint64_t seed) {
    if (Clock::now() >= end_) return;
    constexpr int kEdits = 100;
    const std::size_t count = Random(seed).below(64);
    const ScriptResult result = runScript(family, count, kEdits, seed);
    const std::lock_guard lock(mutex_);
    edits_.add(std::string(family.name), result);
    if (result.problem.empty()) return;
    std::cout << "edits of " << family.name << " (" << count << " circles, --seed " << seed << "): " << result.problem
              << std::endl;
  }

  template <class Try>
  void attempt(const std::string& name, const std::string& repeat, const std::vector<Circle>& circles, Try tryOnce) {
    if (Clock::now() >= end_) return;
    const TrialResult result = tryOnce(circles);
    const std::lock_guard lock(mutex_);
    table_.add(name, result);
    if (result.problem.empty()) return;
    const auto fails = [&](std::span<const Circle> fewer) { return !tryOnce(fewer).problem.empty(); };
    const auto shrunk = circles.size() < kManyCircles ? shrink(circles, fails) : std::vector<Circle>{};
    std::cout << name << " (" << repeat << "): " << result.problem << describe(shrunk) << std::endl;
  }

  std::uint64_t seed_;
  std::uint64_t rounds_;
  bool editsAlone_;
  Clock::time_point end_;
  std::atomic<std::uint64_t> round_ = 0;
  std::mutex mutex_;
  WayTable table_;
  EditTable edits_;
};

}  // namespace
}  // namespace circle_voronoi::test

int main(int argumentCount, char** arguments) {
  using namespace circle_voronoi::test;
  double minutes = 1;
  std::uint64_t rounds = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t seed = std::random_device{}();
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  CLI::App program("Computes and checks diagrams of random circles", "circle-voronoi-soak");
  auto* time = program.add_option("--minutes", minutes, "How long at most; 1 if the rounds are not given either");
  time->check(CLI::PositiveNumber);
  auto* count = program.add_option("--rounds", rounds, "How many inputs of each family at most");
  count->check(CLI::PositiveNumber);
  bool editsAlone = false;
  program.add_flag("--edits", editsAlone, "Edits alone: a script of a hundred for each family a round");
  program.add_option("--seed", seed, "The same seed gives the same inputs; random if not given");
  program.add_option("--threads", threads, "How many inputs at a time")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  CLI11_PARSE(program, argumentCount, arguments);

  std::cout << "--seed " << seed << std::endl;
  const bool isTimed = time->count() > 0 || count->count() == 0;
  const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(60 * minutes));
  Soak soak(seed, rounds, editsAlone, isTimed ? Clock::now() + limit : Clock::time_point::max());
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < threads; ++i) workers.emplace_back([&] { soak.work(); });
  workers.clear();  // Waits for the workers.
  return soak.report();
}
