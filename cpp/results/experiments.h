// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace circle_voronoi::results {

using Json = nlohmann::ordered_json;

/// The parameters of all experiments. Each experiment reads only some of them.
struct Parameters {
  std::vector<std::size_t> sizes = {100, 1000};  ///< numbers of circles
  std::uint64_t seed = 1;                        ///< the seed of the first input; the others follow
  std::uint64_t trials = 5;                      ///< the number of inputs of each kind
  std::filesystem::path folder = ".";            ///< the folder for drawings
};

/// Table 1: samples on the circles of figure 7 at N_s = 3.
Json sampleTable(const Parameters&);

/// Figure 16 a: samples, antipodal and three-touch discs of random circles at N_s = 1, by size and seed; and the part
/// of the time that each stage takes.
Json countDiscs(const Parameters& parameters);

/// Figure 6: the number of samples per circle with which each way of sampling leads to the right diagram, by family.
Json neededSamples(const Parameters& parameters);

/// The rate at which the touching disc method differs from the exact diagram, by family and way.
Json correctness(const Parameters& parameters);

/// The rate at which Algorithms 2 and 3 as printed differ from the exact diagram. Draws the smallest inputs for which
/// they fail.
Json printedRules(const Parameters& parameters);

/// Figure 15: the degrees of merged vertices, the quasi-triangulation, and section 8.1: three-touch discs of circles
/// around one disc.
Json degeneratePositions(const Parameters&);

/// Draws the other figures.
Json drawFigures(const Parameters& parameters);

}  // namespace circle_voronoi::results
