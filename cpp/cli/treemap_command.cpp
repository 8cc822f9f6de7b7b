// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "circle_voronoi/table.h"
#include "circle_voronoi/treemap.h"
#include "command_error.h"
#include "commands.h"
#include "files.h"
#include "metrics.h"
#include "number_text.h"
#include "output.h"
#include "progress_line.h"
#include "whole_number.h"

namespace circle_voronoi::cli {
namespace {

const std::vector<std::string> kTreemapFormats = {"json", "csv", "svg", "geojson", "geojsonl"};
/// The columns of the output besides those of the path and of the values.
const std::vector<std::string> kOwnColumns = {"level", "area", "x", "y", "weight", "polygons"};
constexpr const char* kMissing = "null";

struct TreemapArguments {
  std::string file;
  std::vector<std::string> path;
  std::string values;
  std::string metric{metricName(TreemapOptions{}.metric)};
  std::optional<int> relax;
  double areaTolerance = TreemapOptions{}.tolerance;
  std::string previous;
  Output output;
  std::string progress = "auto";
};

/// The values of a row in the columns of the path, from the first.
using Path = std::vector<std::string>;

/// The nodes of a table, parents first: level by level, and in the order of the rows. The root has the empty path.
struct PathTree {
  std::vector<Path> paths;
  std::vector<TreemapNode> nodes;
  std::map<Path, std::size_t> nodeOf;

  std::size_t add(const Path& path) {
    const auto [at, isNew] = nodeOf.try_emplace(path, paths.size());
    if (!isNew) return at->second;
    paths.push_back(path);
    TreemapNode& node = nodes.emplace_back();
    if (!path.empty()) node.parent = static_cast<std::int32_t>(nodeOf.at(Path(path.begin(), path.end() - 1)));
    return at->second;
  }
};

Table readColumns(const std::string& file, const std::vector<std::string>& columns) {
  auto table = readTable(readText(file), inputName(file), columns);
  if (!table) fail(table.error(), "");
  return *std::move(table);
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

[[noreturn]] void refuseRow(const std::string& file, const Table& table, std::size_t row, const std::string& problem) {
  throw CommandError{kBadInput, inputName(file) + ":" + std::to_string(table.lines[row]) + ": row " +
                                    std::to_string(row) + " " + problem};
}

/// Values of rows with the same path are added.
PathTree treeOf(const TreemapArguments& arguments) {
  const Table table = readColumns(arguments.file, joined(arguments.path, {arguments.values}));
  const std::size_t levels = arguments.path.size();
  const std::vector<std::string>& values = table.columns[levels].values;
  if (values.empty()) throw CommandError{kBadInput, inputName(arguments.file) + ": There are no rows."};
  std::vector<Path> paths(values.size());
  std::vector<double> numbers;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto refuse = [&](const std::string& problem) { refuseRow(arguments.file, table, row, problem); };
    for (std::size_t level = 0; level < levels; ++level) {
      const std::string& key = table.columns[level].values[row];
      if (key == kMissing) refuse("has no \"" + arguments.path[level] + "\".");
      paths[row].push_back(key);
    }
    const auto number = numberOf(values[row]);
    if (!number) refuse("has no number \"" + arguments.values + "\".");
    if (*number < 0) refuse("has the number \"" + arguments.values + "\" below 0 (" + values[row] + ").");
    numbers.push_back(*number);
  }
  PathTree tree;
  tree.add({});
  for (std::size_t level = 1; level <= levels; ++level) {
    for (const Path& path : paths) tree.add(Path(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(level)));
  }
  for (std::size_t row = 0; row < paths.size(); ++row) tree.nodes[tree.nodeOf.at(paths[row])].value += numbers[row];
  return tree;
}

/// Returns the site of each node in an earlier output; nothing for a new one.
std::vector<std::optional<Circle>> previousSites(const TreemapArguments& arguments, const PathTree& tree) {
  const Table table = readColumns(arguments.previous, joined(arguments.path, {"x", "y", "weight"}));
  std::vector<std::optional<Circle>> sites(tree.nodes.size());
  for (std::size_t row = 0; row < table.lines.size(); ++row) {
    Path path;
    while (path.size() < arguments.path.size() && table.columns[path.size()].values[row] != kMissing) {
      path.push_back(table.columns[path.size()].values[row]);
    }
    if (table.columns[arguments.path.size()].values[row] == kMissing) continue;  // it had no cell
    const auto number = [&](std::size_t k) {
      const Column& column = table.columns[arguments.path.size() + k];
      const auto found = numberOf(column.values[row]);
      if (!found) refuseRow(arguments.previous, table, row, "has no number \"" + column.name + "\".");
      return *found;
    };
    const Circle site = {number(0), number(1), number(2)};
    if (const auto found = tree.nodeOf.find(path); found != tree.nodeOf.end()) sites[found->second] = site;
  }
  return sites;
}

/// "North", "Bonn"
std::string textOf(const Path& path) {
  std::string text;
  for (const std::string& key : path) text += (text.empty() ? "" : ", ") + key;
  return text.empty() ? "the whole region" : text;
}

/// Throws CommandError with an error of the library, which names a node by its path.
[[noreturn]] void failAtNode(Error error, const PathTree& tree, const std::string& name) {
  if (error.circle >= 0) {
    const std::string node = "node " + std::to_string(error.circle);
    if (const std::size_t at = error.message.find(node); at != std::string::npos) {
      const std::string path = textOf(tree.paths[static_cast<std::size_t>(error.circle)]);
      error.message.replace(at, node.size(), path);
      if (error.option.offset > at) error.option.offset += path.size() - node.size();
    }
  }
  fail(error, name + ": ");
}

/// The rows of the output: all nodes but the root.
std::vector<Column> columnsOf(const TreemapArguments& arguments, const PathTree& tree, const Treemap& map) {
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, const std::function<std::string(std::size_t)>& valueOf) {
    Column& column = columns.emplace_back(Column{name});
    for (std::size_t node = 1; node < tree.nodes.size(); ++node) column.values.push_back(valueOf(node));
  };
  for (std::size_t level = 0; level < arguments.path.size(); ++level) {
    add(arguments.path[level], [&](std::size_t node) {
      return level < tree.paths[node].size() ? tree.paths[node][level] : std::string(kMissing);
    });
  }
  add(arguments.values, [&](std::size_t node) { return numberText(map.values[node]); });
  add("level", [&](std::size_t node) { return std::to_string(tree.paths[node].size()); });
  add("area", [&](std::size_t node) { return numberText(map.areas[node]); });
  const auto addNumber = [&](const std::string& name, double Circle::*number) {
    add(name, [&map, number](std::size_t node) {
      return map.values[node] > 0 ? numberText(map.sites[node].*number) : std::string(kMissing);
    });
  };
  addNumber("x", &Circle::x);
  addNumber("y", &Circle::y);
  addNumber("weight", &Circle::r);
  return columns;
}

/// Returns the polygons of all nodes but the root, whose polygons come first.
ClippedPolygons withoutRoot(ClippedPolygons all) {
  const auto drop = [](std::vector<std::int32_t>& offsets, std::int32_t count) {
    offsets.erase(offsets.begin(), offsets.begin() + count);
    const std::int32_t begin = offsets.front();
    for (std::int32_t& offset : offsets) offset -= begin;
    return begin;
  };
  const std::int32_t polygons = drop(all.polygonOffsets, 1);
  const std::int32_t rings = drop(all.ringOffsets, polygons);
  const std::int32_t points = drop(all.pointOffsets, rings);
  all.points.erase(all.points.begin(), all.points.begin() + points);
  return all;
}

void writeTreemap(const TreemapArguments& arguments, const PathTree& tree, Treemap map, const Region& region,
                  ProgressLine& progress) {
  const std::vector<Column> columns = columnsOf(arguments, tree, map);
  const ClippedPolygons polygons = withoutRoot(std::move(map.polygons));
  write(arguments.output, inputName(arguments.file), progress, [&](std::ostream& out) {
    const std::string& format = arguments.output.format;
    if (format == "csv") return writeTableCsv(out, columns);
    if (format == "geojson") return writeTableGeoJson(out, columns, polygons);
    if (format == "geojsonl") return writeTableGeoJsonLines(out, columns, polygons);
    if (format == "json") return writeTableJson(out, columns, polygons);
    std::vector<int> levels;
    for (std::size_t node = 1; node < tree.nodes.size(); ++node) {
      levels.push_back(static_cast<int>(tree.paths[node].size()));
    }
    return writeTableSvg(out, std::span(columns).first(arguments.path.size() + 1), polygons, levels, region.bounds());
  });
}

/// Throws CommandError if two columns of the output would have one name, in any case.
void checkColumns(const TreemapArguments& arguments) {
  std::vector<std::string> names = kOwnColumns;
  for (const std::string& name : joined(arguments.path, {arguments.values})) {
    std::string lower = name;
    std::ranges::transform(lower, lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c; });
    if (std::ranges::find(names, lower) != names.end()) {
      throw CommandError{kBadInput,
                         "The output has another column called " + name + "; rename the column of the input."};
    }
    names.push_back(lower);
  }
}

void runTreemap(TreemapArguments& arguments) {
  checkColumns(arguments);
  Output& output = arguments.output;
  output.isRegionNeeded = true;
  settle(output);
  if (std::ranges::find(kTreemapFormats, output.format) == kTreemapFormats.end()) {
    throw CommandError{kBadInput, "treemap needs --format json, csv, svg, geojson or geojsonl."};
  }
  refuseSharedFiles({arguments.file, output.regionFile, arguments.previous}, {{"--output", output.file}});
  ProgressLine progress(arguments.progress);
  progress.show("read");
  const PathTree tree = treeOf(arguments);
  TreemapOptions options;
  options.metric = kWeightedMetrics.at(arguments.metric);
  options.relax = arguments.relax;
  options.tolerance = arguments.areaTolerance;
  std::vector<std::optional<Circle>> previous;
  if (!arguments.previous.empty()) previous = previousSites(arguments, tree);
  options.previous = previous;
  options.progress = [&](std::size_t done, std::size_t count) {
    progress.show("treemap", count == 0 ? 0 : static_cast<double>(done) / static_cast<double>(count));
  };
  const Region region = output.region ? *output.region : Region::from(Box{0, 0, 1, 1}).value();
  auto map = treemap(tree.nodes, region, options);
  if (!map) failAtNode(map.error(), tree, inputName(arguments.file));
  writeTreemap(arguments, tree, *std::move(map), region, progress);
}

}  // namespace

void addTreemapCommand(CLI::App& program) {
  const auto arguments = std::make_shared<TreemapArguments>();
  CLI::App* command = program.add_subcommand("treemap", "Divide a region among the rows of a table, level by level");
  command
      ->add_option("FILE", arguments->file, "A table: CSV with a header, an array of JSON objects, or GeoJSON features")
      ->type_name("")
      ->required();
  command->add_option("--path", arguments->path, "The columns with the levels of the hierarchy, the highest first")
      ->type_name("COLUMN,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->required();
  command
      ->add_option("--values", arguments->values,
                   "The column with the values, to which areas are in proportion; those of the same path are added")
      ->type_name("COLUMN")
      ->required();
  addRegionOptions(*command, arguments->output,
                   "A file with the region to divide, as GeoJSON or well-known text; by default the unit square");
  command
      ->add_option("--metric", arguments->metric,
                   "The borders between the cells of the last level: straight (power) or curved (circles)")
      ->type_name("METRIC")
      ->check(CLI::IsMember(&kWeightedMetrics))
      ->capture_default_str();
  command
      ->add_option("--relax", arguments->relax,
                   "How many times sites move to the centroids of their cells; by default 8, and 0 for cells of "
                   "--previous")
      ->type_name("COUNT")
      ->transform(wholeNumber(std::numeric_limits<int>::max()));
  command->add_option("--area-tolerance", arguments->areaTolerance, "The largest relative error allowed for each area")
      ->type_name("NUMBER")
      ->capture_default_str();
  command
      ->add_option("--previous", arguments->previous,
                   "An earlier output as json, csv or geojson, whose cells stay where they are")
      ->type_name("FILE");
  addOutputFile(*command, arguments->output);
  addFormatOption(*command, arguments->output, kTreemapFormats);
  addProgressOption(*command, arguments->progress);
  command->footer(
      "The output has a row for each cell of each level: the columns of --path, which have no value below the row's\n"
      "level, the value, the level, the area, the site and its weight. All formats but csv have the polygons, too.");
  command->callback([arguments] { runTreemap(*arguments); });
}

}  // namespace circle_voronoi::cli
