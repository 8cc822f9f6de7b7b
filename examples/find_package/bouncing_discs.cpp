// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand bouncing discs in a box: bouncing_discs [FRAMES]
//
// Two discs that touch are neighbors in their Voronoi diagram, so only discs that share an edge can collide. Edits keep
// the diagram up to date: each disc moves, and the program applies the change to its list of edges.
#include <circle_voronoi/editor.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace cv = circle_voronoi;

namespace {

constexpr int kDiscs = 1000;
constexpr int kColumns = 40;
constexpr double kWidth = kColumns;
constexpr double kHeight = kDiscs / kColumns;
constexpr double kTimeStep = 1.0 / 60;

struct Disc {
  cv::Circle circle;
  cv::Point velocity;
};

double between0And1(std::uint32_t& state) {
  state = state * 1664525 + 1013904223;
  return state / 4294967296.0;
}

std::vector<Disc> discsAtTheStart() {
  std::uint32_t random = 1;
  std::vector<Disc> discs;
  for (int i = 0; i < kDiscs; ++i) {
    const double radius = 0.15 + 0.25 * between0And1(random);
    const double x = between0And1(random) - 0.5;
    const double y = between0And1(random) - 0.5;
    discs.push_back({{i % kColumns + 0.5, i / kColumns + 0.5, radius}, {4 * x, 4 * y}});
  }
  return discs;
}

/// Moves a disc. It turns back at the walls.
void move(Disc& disc) {
  auto& [x, y, r] = disc.circle;
  x += disc.velocity.x * kTimeStep;
  y += disc.velocity.y * kTimeStep;
  if (x < r || x > kWidth - r) disc.velocity.x = std::copysign(disc.velocity.x, x < r ? 1 : -1);
  if (y < r || y > kHeight - r) disc.velocity.y = std::copysign(disc.velocity.y, y < r ? 1 : -1);
}

/// Lets two discs bounce if they touch and approach each other. Their masses are their areas.
void bounce(Disc& a, Disc& b) {
  const cv::Point d = {b.circle.x - a.circle.x, b.circle.y - a.circle.y};
  const double distance = std::hypot(d.x, d.y);
  if (distance == 0 || distance > a.circle.r + b.circle.r) return;
  const double nearing = ((a.velocity.x - b.velocity.x) * d.x + (a.velocity.y - b.velocity.y) * d.y) / distance;
  if (nearing <= 0) return;
  const double massA = a.circle.r * a.circle.r;
  const double massB = b.circle.r * b.circle.r;
  const double impulse = 2 * nearing * massA * massB / (massA + massB) / distance;
  a.velocity = {a.velocity.x - impulse / massA * d.x, a.velocity.y - impulse / massA * d.y};
  b.velocity = {b.velocity.x + impulse / massB * d.x, b.velocity.y + impulse / massB * d.y};
}

/// Applies a change to the edges, which are listed by number. An edge that does not exist has no circles.
void follow(std::vector<cv::Edge>& edges, const cv::Change& change) {
  for (const auto number : change.removedEdges) edges[static_cast<std::size_t>(number)] = {};
  for (std::size_t i = 0; i < change.addedEdges.size(); ++i) {
    const auto number = static_cast<std::size_t>(change.addedEdges[i]);
    if (number >= edges.size()) edges.resize(number + 1);
    edges[number] = change.edges[i];
  }
}

int fail(const cv::Error& error) {
  std::cerr << error.message << '\n';
  return 1;
}

}  // namespace

int main(int count, char** arguments) {
  const int frames = count > 1 ? std::atoi(arguments[1]) : 600;
  if (frames < 1) {
    std::cerr << "Usage: bouncing_discs [FRAMES]\n";
    return 2;
  }
  std::vector<Disc> discs = discsAtTheStart();
  std::vector<cv::Circle> circles;
  for (const Disc& disc : discs) circles.push_back(disc.circle);
  auto made = cv::DiagramEditor::from(circles);
  if (!made) return fail(made.error());
  cv::DiagramEditor& editor = made.value();
  const auto all = editor.all();
  if (!all) return fail(all.error());
  std::vector<cv::Edge> edges;
  follow(edges, all.value());

  std::vector<double> milliseconds;
  std::size_t changedCells = 0;
  for (int frame = 0; frame < frames; ++frame) {
    for (const auto& [left, right, start, end] : edges) {
      if (left != cv::kNone) bounce(discs[static_cast<std::size_t>(left)], discs[static_cast<std::size_t>(right)]);
    }
    for (Disc& disc : discs) move(disc);
    const auto begin = std::chrono::steady_clock::now();
    for (cv::CircleId id = 0; id < kDiscs; ++id) {
      const auto change = editor.replace(id, discs[static_cast<std::size_t>(id)].circle);
      if (!change) return fail(change.error());
      follow(edges, change.value());
      changedCells += change.value().cells.size();
    }
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(taken.count());
  }
  const auto certificate = editor.certificate();
  if (!certificate) return fail(certificate.error());
  std::sort(milliseconds.begin(), milliseconds.end());
  std::cout << kDiscs << " discs, " << frames << " frames, " << changedCells << " changes of cells; "
            << (certificate.value().certified() ? "certified" : "not certified") << '\n'
            << "the edits of a frame take " << milliseconds[milliseconds.size() / 2] << " ms, "
            << milliseconds[milliseconds.size() * 99 / 100] << " ms in one of a hundred\n";
}
