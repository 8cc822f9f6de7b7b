// SPDX-License-Identifier: GPL-3.0-or-later
#include "tile_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "box.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/final_cells.h"
#include "circle_voronoi/tile.h"
#include "command_error.h"
#include "files.h"
#include "number_text.h"

namespace circle_voronoi::cli {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr Box kPlane = {-kInfinite, -kInfinite, kInfinite, kInfinite};

Box boxOf(const std::string& text) {
  Box box = kPlane;
  if (!text.empty()) (void)readBox(text, box, Sides::maybeInfinite);
  return box;
}

/// Closed at its least coordinates and open at its greatest: each point is in one tile of a grid.
bool isIn(const Box& core, const Circle& c) {
  return core.minX <= c.x && c.x < core.maxX && core.minY <= c.y && c.y < core.maxY;
}

/// Whether the core lies inside the known box, farther from all sides than any circle outside reaches. Then it is known
/// which circles of the core are hidden, and by which circles.
bool isDeepInside(const Box& core, const Box& known, double maxRadius) {
  const auto isDeep = [&](double inner, double outer) { return std::isinf(outer) || inner > outer + maxRadius; };
  return isDeep(core.minX, known.minX) && isDeep(core.minY, known.minY) && isDeep(-core.maxX, -known.maxX) &&
         isDeep(-core.maxY, -known.maxY);
}

/// The final part of a tile.
class FinalPart {
 public:
  FinalPart(const Tile& tile, const Diagram& diagram, const FinalCells& cells, const Box& core)
      : tile_(tile), cells_(cells), core_(core) {
    const auto count = static_cast<std::int32_t>(tile.circles.size());
    for (std::int32_t i = 0; i < count; ++i) isOwner_.push_back(isInCore(i) && !isDone(i) && cells.isFinal(i));
    isOpen_.resize(tile.circles.size());
    for (std::int32_t i = 0; i < count; ++i) isOpen_[at(i)] = isInCore(i) && !cells.isFinal(i);
    for (const Edge& edge : diagram.edges) {
      noteNeighbor(edge.left, edge.right);
      noteNeighbor(edge.right, edge.left);
    }
  }

  /// For each circle, whether everything that it owns is written.
  const std::vector<std::uint8_t>& isOwner() const { return isOwner_; }

  /// The circles that the remaining cells need, with the updated `done`. They are the circles of the core that are not
  /// final, and circles with a neighbor that may remain, here or in another tile. A cell depends only on its neighbors:
  /// on a ray from its circle's center, all points beyond the edge with a neighbor are nearer to the neighbor.
  Tile left() const {
    Tile tile = tile_;
    for (std::size_t i = 0; i < tile.done.size(); ++i) tile.done[i] |= isOwner_[i];
    return tile;
  }
  const std::vector<std::uint8_t>& isOpen() const { return isOpen_; }

  /// Returns a sentence with the number of circles of the core that are neither done nor final, and the halo they need;
  /// empty if there are none.
  std::string problem() const {
    std::int64_t bounded = 0;
    std::int64_t unbounded = 0;
    std::int64_t all = 0;
    double halo = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(isOwner_.size()); ++i) {
      if (!isInCore(i) || isDone(i)) continue;
      ++all;
      const double needed = cells_.neededHalo[at(i)];
      if (needed == 0) continue;
      ++(std::isinf(needed) ? unbounded : bounded);
      if (!std::isinf(needed)) halo = std::max(halo, needed);
    }
    if (bounded + unbounded == 0) return "";
    std::string text =
        std::to_string(bounded + unbounded) + " of " + std::to_string(all) + " circles of the core are not final";
    if (bounded > 0) text += "; a halo wider by " + numberText(halo) + " is enough for " + std::to_string(bounded);
    if (unbounded > 0) text += "; none is for " + std::to_string(unbounded) + ", whose cells are unbounded";
    return text + ".";
  }

 private:
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  bool isInCore(std::int32_t i) const { return isIn(core_, tile_.circles[at(i)]); }
  bool isDone(std::int32_t i) const { return tile_.done[at(i)] != 0; }

  void noteNeighbor(CircleIndex circle, CircleIndex neighbor) {
    if (isInCore(circle) && !(isInCore(neighbor) && cells_.isFinal(neighbor))) isOpen_[at(circle)] = 1;
  }

  const Tile& tile_;
  const FinalCells& cells_;
  Box core_;
  std::vector<std::uint8_t> isOwner_;
  std::vector<std::uint8_t> isOpen_;
};

void write(const Output& output, const std::string& name, const Tile& tile, const Diagram& diagram,
           const FinalPart& part) {
  const Selection selection = {tile.ids, part.isOwner()};
  writeText(output.file, [&](std::ostream& out) {
    checkWritten(output.format == "csv" ? writePartsCsv(out, diagram, selection)
                                        : writePartsGeoJsonLines(out, diagram, selection, exportOptions(output)),
                 name + ": ");
  });
}

}  // namespace

void addTileOptions(CLI::App& command, TilePart& part) {
  const auto addBox = [&](const char* name, std::string& text, const char* what) {
    command.add_option(name, text, what)->type_name("MINX,MINY,MAXX,MAXY")->check([](const std::string& value) {
      Box box;
      return readBox(value, box, Sides::maybeInfinite);
    });
  };
  addBox("--known", part.known, "FILE is a tile: no other circle has its center in this box, whose sides may be inf");
  command.add_option("--max-radius", part.maxRadius, "The largest radius of the other circles")
      ->type_name("RADIUS")
      ->check([](const std::string& text) {
        const auto radius = readNumber(text);
        return radius && *radius >= 0 ? "" : "expected a number from 0.";
      });
  addBox("--core", part.core, "Write only the parts whose owner has its center in this box");
  command.add_option("--open", part.open, "The file for the circles that are needed for what is not final")
      ->type_name("FILE");
}

void check(const TilePart& part, const Output& output) {
  if (!part.isAsked()) {
    const char* unused = part.maxRadius ? "--max-radius" : !part.core.empty() ? "--core" : "--open";
    if (part.maxRadius || !part.core.empty() || !part.open.empty())
      throw CommandError{kBadInput, std::string(unused) + " needs --known."};
    return;
  }
  if (!part.maxRadius) throw CommandError{kBadInput, "--known needs --max-radius."};
  if (output.format != "csv" && output.format != "geojsonl") {
    throw CommandError{kBadInput, "--known needs --format csv or geojsonl."};
  }
  if (output.format == "csv" && output.digits) throw CommandError{kBadInput, "--known takes no --digits for csv."};
  // Without the option, each tile would choose its own box and tolerance.
  if (output.format == "geojsonl" && output.bounds.empty() && !output.region)
    throw CommandError{kBadInput, "--known needs --bounds or --region for geojsonl."};
  if (!part.open.empty() && !isDeepInside(boxOf(part.core), boxOf(part.known), *part.maxRadius)) {
    throw CommandError{kBadInput, "--open needs a --core that lies within --known, farther inside than --max-radius."};
  }
}

void computeTilePart(const TilePart& part, const Output& output, const CirclesInput& input, int threads,
                     ProgressLine& progress) {
  const std::string name = inputName(input.file);
  const auto tile = readTile(readText(input.file), name, input.options);
  if (!tile) fail(tile.error(), "");
  const auto& circles = tile.value().circles;
  Options options;
  options.weights = input.weights();
  options.threads = threads;
  options.progress = [&](Stage stage, double done) { progress.show(stageName(stage), done); };
  const auto diagram = compute(circles, options);
  if (!diagram) fail(diagram.error(), name + ": ");
  const auto cells = finalCells(diagram.value(), {boxOf(part.known), *part.maxRadius});
  if (!cells) throw CommandError{kBadInput, name + ": " + cells.error().message};
  const FinalPart found(tile.value(), diagram.value(), cells.value(), boxOf(part.core));
  if (output.file == kStandardStream) progress.end();
  progress.show("write");
  if (!part.open.empty()) {
    writeText(part.open, [&](std::ostream& out) { checkWritten(writeTile(out, found.left(), found.isOpen()), ""); });
  }
  // Written last, so that if this file exists, all files are complete.
  write(output, name, *tile, *diagram, found);
  progress.end();
  if (const std::string problem = found.problem(); !problem.empty())
    throw CommandError{kNotFinal, name + ": " + problem};
}

}  // namespace circle_voronoi::cli
