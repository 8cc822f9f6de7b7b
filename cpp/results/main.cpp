// SPDX-License-Identifier: GPL-3.0-or-later
// circle-voronoi-results EXPERIMENT [--sizes N,...] [--seed N] [--trials N] [--folder PATH]: one of the paper's
// experiments, as JSON on standard output.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "experiments.h"

namespace {

using namespace circle_voronoi::results;

const std::map<std::string, Json (*)(const Parameters&)> kExperiments = {
    {"table-1", sampleTable},     {"counts", countDiscs},          {"needed-samples", neededSamples},
    {"correctness", correctness}, {"printed-rules", printedRules}, {"degenerate", degeneratePositions},
    {"figures", drawFigures},
};

int usage() {
  std::cerr << "usage: circle-voronoi-results EXPERIMENT [--sizes N,...] [--seed N] [--trials N] [--folder PATH]\n"
               "experiments:";
  for (const auto& [name, run] : kExperiments) std::cerr << ' ' << name;
  std::cerr << '\n';
  return 2;
}

std::vector<std::size_t> numbersOf(const std::string& list) {
  std::vector<std::size_t> numbers;
  std::stringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');) numbers.push_back(std::stoull(item));
  return numbers;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2 || argc % 2 != 0 || !kExperiments.contains(argv[1])) return usage();
  Parameters parameters;
  for (int i = 2; i < argc; i += 2) {
    const std::string key = argv[i];
    const std::string value = argv[i + 1];
    if (key == "--sizes") {
      parameters.sizes = numbersOf(value);
    } else if (key == "--seed") {
      parameters.seed = std::stoull(value);
    } else if (key == "--trials") {
      parameters.trials = std::stoull(value);
    } else if (key == "--folder") {
      parameters.folder = value;
    } else {
      return usage();
    }
  }
  std::cout << kExperiments.at(argv[1])(parameters).dump(1) << '\n';
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
