// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times every method on the same circles, family by family, and prints one table and a JSON file. Each run has a
// process of its own, so that its peak memory is its own. The methods take turns, so that a temporary slowdown of the
// machine affects all methods. Times are medians of the repetitions, and ratios are medians of the ratios within a
// repetition.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "areas.h"
#include "child.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi_families/families.h"
#include "cliffs.h"
#include "edits.h"
#include "files.h"
#include "median.h"
#include "periodic.h"
#include "reference.h"
#include "regions.h"
#include "sphere.h"
#include "touching_disc.h"

namespace {

using namespace circle_voronoi;

using Circles = std::vector<Circle>;

struct Contestant {
  std::string name;
  std::function<void(const Circles&)> run;
  std::size_t largest;  ///< for more circles it takes minutes
};

std::function<void(const Circles&)> computing(Options options) {
  return [options](const Circles& circles) {
    auto result = compute(circles, options);
    if (!result) {
      std::cerr << result.error().message << '\n';
      std::exit(1);
    }
    benchmark::DoNotOptimize(result);
  };
}

std::vector<Contestant> allContestants() {
  const auto referring = [](std::size_t (*run)(std::span<const Circle>)) {
    return [run](const Circles& circles) { benchmark::DoNotOptimize(run(circles)); };
  };
  Options twoThreads;
  twoThreads.threads = 2;
  Options power;
  power.metric = Metric::power;
  return {
      {"cgal-delaunay", referring(reference::delaunay), 10'000'000},
      {"auto", computing({}), 10'000'000},
      {"auto-two-threads", computing(twoThreads), 10'000'000},
      {"power", computing(power), 10'000'000},
      {"touching-disc-0", computing(touchingDisc(Candidates::dynamic, 0)), 1'000'000},
      {"touching-disc-1", computing(touchingDisc(Candidates::dynamic, 1)), 1'000'000},
      {"touching-disc-3", computing(touchingDisc(Candidates::dynamic, 3)), 100'000},
      {"touching-disc-uniform-50", computing(touchingDisc(Candidates::uniform, 50)), 10'000},
      {"touching-disc-all-pairs", computing(touchingDisc(Candidates::allPairs)), 1'000},
      {"cgal-hierarchy", referring(reference::apolloniusHierarchy), 1'000'000},
      {"cgal-exact", referring(reference::apolloniusExact), 1'000},
  };
}

/// Prints how long each stage of `automatic` takes, in milliseconds: the least of some runs.
void printStages(const Circles& circles, int repetitions, unsigned limitSeconds) {
  const auto child = runInChild<Seconds>(limitSeconds, [&] {
    Seconds least;
    for (int i = 0; i < repetitions; ++i) {
      const Seconds seconds = compute(circles).value().stats.seconds;
      for (const auto& [name, member] : kSecondsMembers) {
        if (i == 0 || seconds.*member < least.*member) least.*member = seconds.*member;
      }
    }
    return least;
  });
  if (!child.value) return;
  std::printf("%-24s stages of auto, ms:", "");
  for (const auto& [name, member] : kSecondsMembers) {
    if (const double seconds = (*child.value).*member; seconds > 0) {
      std::printf(" %s %.2f", std::string(name).c_str(), 1e3 * seconds);
    }
  }
  std::printf("\n");
}

/// Keeps the seconds of a run and prints nothing.
class SecondsReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) seconds = run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
  }
  double seconds = 0;
};

/// Returns the mean time. Google Benchmark chooses the number of runs; a long method runs once.
double meanSeconds(const Contestant& method, const Circles& circles) {
  benchmark::RegisterBenchmark("case",
                               [&](benchmark::State& state) {
                                 for (auto _ : state) method.run(circles);
                               })
      ->MinTime(0.25)
      ->Unit(benchmark::kSecond)
      ->UseRealTime();
  SecondsReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return reporter.seconds;
}

/// One method on one input.
struct Measurement {
  std::vector<double> seconds;  ///< the time of each repetition, in order
  bool isOver = false;          ///< stopped at the limit: a repetition takes longer than the one number in `seconds`
  double megabytes = 0;
};

using Measurements = std::map<std::string, Measurement>;

/// Runs every method once in each repetition, in a child process, at most up to the limit for all its repetitions.
/// Failed methods are left out of the result.
Measurements measure(const std::vector<Contestant>& methods, const Circles& circles, int repetitions,
                     unsigned limitSeconds) {
  Measurements measured;
  std::set<std::string> done;
  const unsigned limitEach = std::max(1U, limitSeconds / static_cast<unsigned>(repetitions));
  for (int i = 0; i < repetitions; ++i) {
    for (const Contestant& method : methods) {
      if (circles.size() > 2 * method.largest || done.contains(method.name)) continue;
      const auto child = runInChild<double>(limitEach, [&] { return meanSeconds(method, circles); });
      Measurement& measurement = measured[method.name];
      measurement.megabytes = std::max(measurement.megabytes, child.megabytes);
      if (child.value) {
        measurement.seconds.push_back(*child.value);
        continue;
      }
      done.insert(method.name);
      if (!child.isOver) {
        measured.erase(method.name);
      } else {
        measurement.isOver = true;
        measurement.seconds = {static_cast<double>(limitEach)};
      }
    }
  }
  return measured;
}

struct Input {
  std::string family;
  Circles circles;
};

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> items;
  std::stringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
  return items;
}

std::optional<Input> inputOf(const std::string& family, std::size_t count) {
  if (const auto known = familyFromName(family)) return Input{family, generate(*known, count, 1)};
  std::ifstream file(family);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto circles = readCircles(text, family);
  if (!file || !circles) return std::nullopt;
  return Input{std::filesystem::path(family).stem().string(), circles.value()};
}

/// Formats a number, with a > in front if it is a lower bound.
std::string text(const char* format, double value, bool isOver) {
  char digits[32];
  std::snprintf(digits, sizeof digits, format, value);
  return (isOver ? "> " : "") + std::string(digits);
}

/// The ratio of two methods' times; empty if it cannot be determined.
std::string ratio(const Measurements& measured, const std::string& slow, const std::string& fast) {
  const auto numerator = measured.find(slow);
  const auto denominator = measured.find(fast);
  if (numerator == measured.end() || denominator == measured.end() || denominator->second.isOver) return "";
  const bool isOver = numerator->second.isOver;
  if (isOver) return text("%.2f", numerator->second.seconds[0] / median(denominator->second.seconds), isOver);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < numerator->second.seconds.size(); ++i)
    ratios.push_back(numerator->second.seconds[i] / denominator->second.seconds[i]);
  return text("%.2f", median(ratios), isOver);
}

std::vector<std::size_t> sizesOf(const std::string& list) {
  std::vector<std::size_t> sizes;
  for (const std::string& size : split(list)) sizes.push_back(std::strtoull(size.c_str(), nullptr, 10));
  return sizes;
}

using OptionValues = std::map<std::string, std::string>;

/// The options of each table with their defaults. The name of a table is the optional first argument.
OptionValues defaultsOf(const std::string& table) {
  if (table == "--areas") return {{"--sizes", "300,1000,3000,10000,100000"}, {"--limit", "300"}};
  if (table == "--cliffs") return {{"--families", ""}, {"--sizes", "120000"}, {"--limit", "120"}};
  if (table == "--files")
    return {{"--families", "uniform,log-uniform"}, {"--sizes", "1000000"}, {"--repetitions", "3"}};
  if (table == "--periodic")
    return {{"--families", "points,uniform"}, {"--sizes", "1000,10000,100000,1000000"}, {"--repetitions", "5"}};
  if (table == "--regions") {
    return {{"--families", "uniform,log-uniform"},
            {"--sizes", "100000,1000000"},
            {"--sides", "1000,10000,100000,1000000"},
            {"--repetitions", "3"}};
  }
  if (table == "--sphere") return {{"--sizes", "1000,10000,100000,1000000"}, {"--repetitions", "5"}};
  if (table == "--edits") {
    return {{"--families", "uniform,log-uniform,intersecting,hidden,grid"},
            {"--sizes", "10000,100000,1000000"},
            {"--limit", "300"}};
  }
  return {{"--families", "uniform,log-uniform,hidden,hexagonal,grid,rows,intersecting,one-huge,ring"},
          {"--sizes", "1000,10000,100000,1000000"},
          {"--methods", ""},
          {"--repetitions", "5"},
          {"--limit", "120"},
          {"-o", "build/bench/native.json"}};
}

/// The even circles of an input of twice the size are edited. The odd ones are inserted.
int benchEdits(const std::vector<std::string>& families, const std::vector<std::size_t>& sizes, unsigned limit) {
  std::printf("%-14s %8s  %-37s %10s %10s\n", "family", "n", "", "median us", "99.9 % us");
  for (const std::string& family : families) {
    const bool isFile = !familyFromName(family);
    for (const std::size_t size : isFile ? std::vector<std::size_t>{0} : sizes) {
      const auto input = inputOf(family, 2 * size);
      if (!input) {
        std::cerr << family << " is neither a family nor a file of circles\n";
        return 2;
      }
      bench::EditInput edits = {input->family, {}, {}};
      for (std::size_t i = 0; i < input->circles.size(); ++i) {
        (i % 2 == 0 ? edits.circles : edits.supply).push_back(input->circles[i]);
      }
      bench::printEdits(edits, limit);
    }
  }
  return 0;
}

int usage() {
  std::cerr << "usage: circle-voronoi-bench [--families NAME|FILE.csv,...] [--sizes N,...] [--methods NAME,...]\n"
               "                            [--repetitions N] [--limit SECONDS] [-o FILE.json]\n"
               "       circle-voronoi-bench --areas [--sizes N,...] [--limit SECONDS]\n"
               "       circle-voronoi-bench --cliffs [--families NAME,...] [--sizes N,...] [--limit SECONDS]\n"
               "       circle-voronoi-bench --edits [--families NAME|FILE.csv,...] [--sizes N,...] [--limit SECONDS]\n"
               "       circle-voronoi-bench --files [--families NAME,...] [--sizes N,...] [--repetitions N]\n"
               "       circle-voronoi-bench --periodic [--families NAME,...] [--sizes N,...] [--repetitions N]\n"
               "       circle-voronoi-bench --regions [--families NAME,...] [--sizes N,...] [--sides N,...]\n"
               "                            [--repetitions N]\n"
               "       circle-voronoi-bench --sphere [--sizes N,...] [--repetitions N]\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  static const std::set<std::string> kTables = {"--areas",    "--cliffs",  "--edits", "--files",
                                                "--periodic", "--regions", "--sphere"};
  const bool hasTable = kTables.contains(first);
  OptionValues options = defaultsOf(first);
  for (int i = hasTable ? 2 : 1; i < argc; i += 2) {
    if (!options.contains(argv[i]) || i + 1 == argc) return usage();
    options[argv[i]] = argv[i + 1];
  }
  const int repetitions = std::atoi(options["--repetitions"].c_str());
  const auto limit = static_cast<unsigned>(std::atoi(options["--limit"].c_str()));
  if (first == "--edits") return benchEdits(split(options["--families"]), sizesOf(options["--sizes"]), limit);
  if (first == "--areas") {
    bench::printAreas(sizesOf(options["--sizes"]), limit);
    return 0;
  }
  if (first == "--sphere") {
    bench::benchSphere(sizesOf(options["--sizes"]), repetitions);
    return 0;
  }
  if (hasTable) {
    for (const std::string& family : split(options["--families"])) {
      if (familyFromName(family)) continue;
      std::cerr << family << " is no family\n";
      return 2;
    }
    const auto sizes = sizesOf(options["--sizes"]);
    if (first == "--cliffs") {
      printCliffs(split(options["--families"]), sizes, limit);
    } else if (first == "--periodic") {
      bench::benchPeriodic(split(options["--families"]), sizes, repetitions);
    } else if (first == "--regions") {
      bench::benchRegions(split(options["--families"]), sizes, sizesOf(options["--sides"]), repetitions);
    } else {
      bench::benchFiles(split(options["--families"]), sizes, repetitions);
    }
    return 0;
  }
  const std::vector<std::string> chosen = split(options["--methods"]);
  std::vector<Contestant> methods = allContestants();
  std::erase_if(methods, [&](const Contestant& method) {
    return !chosen.empty() && std::find(chosen.begin(), chosen.end(), method.name) == chosen.end();
  });

  std::ostringstream json;
  json << "[";
  std::printf("%-14s %8s  %-26s %10s %9s %12s %12s\n", "family", "n", "method", "median s", "peak MB", "/ delaunay",
              "hierarchy /");
  for (const std::string& family : split(options["--families"])) {
    const bool isFile = !familyFromName(family);
    for (const std::size_t size : isFile ? std::vector<std::size_t>{0} : sizesOf(options["--sizes"])) {
      const auto input = inputOf(family, size);
      if (!input) {
        std::cerr << family << " is neither a family nor a file of circles\n";
        return 2;
      }
      const Measurements measured = measure(methods, input->circles, repetitions, limit);
      for (const Contestant& method : methods) {
        if (!measured.contains(method.name)) continue;
        const auto& [repeated, isOver, megabytes] = measured.at(method.name);
        const double seconds = median(repeated);
        std::printf("%-14s %8zu  %-26s %10s %9.0f %12s %12s\n", input->family.c_str(), input->circles.size(),
                    method.name.c_str(), text("%.4f", seconds, isOver).c_str(), megabytes,
                    ratio(measured, method.name, "cgal-delaunay").c_str(),
                    ratio(measured, "cgal-hierarchy", method.name).c_str());
        json << (json.tellp() > 1 ? ",\n " : "\n ") << R"({"family": ")" << input->family << R"(", "n": )"
             << input->circles.size() << R"(, "method": ")" << method.name << R"(", ")"
             << (isOver ? "secondsOver" : "seconds") << R"(": )" << seconds << R"(, "repetitions": [)";
        for (std::size_t i = 0; i < repeated.size() && !isOver; ++i) json << (i > 0 ? ", " : "") << repeated[i];
        json << R"(], "peakMegabytes": )" << megabytes << "}";
      }
      if (measured.contains("auto")) printStages(input->circles, repetitions, limit);
      std::fflush(stdout);
    }
  }
  json << "\n]\n";
  const std::filesystem::path path = options["-o"];
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << json.str();
}
