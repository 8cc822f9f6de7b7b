// SPDX-License-Identifier: GPL-3.0-or-later
#include "chains.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scale.h"

namespace circle_voronoi {
namespace {

void append(std::vector<OutlinePiece>& loop, const Ring::Element& element) {
  loop.push_back({segment(element.start, element.end), kNone, kNone, element.r});
}

/// Returns a place in one of the largest gaps between entries and exits: of several places the one that is deepest
/// inside or outside. The largest gap alone may lie on the boundary of both the ring and what is cut. In a gap that is
/// only rounding, it is not known on which side of the entry or exit a place is.
double clearPlace(const Ring& ring, const std::vector<Chain>& chains, const std::function<double(Point)>& depth) {
  struct Gap {
    double size;
    double start;
  };
  std::vector<double> places;
  for (const Chain& chain : chains) places.insert(places.end(), {chain.entry, chain.exit});
  std::ranges::sort(places);
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double next = i + 1 < places.size() ? places[i + 1] : places.front() + ring.total();
    gaps.push_back({next - places[i], places[i]});
  }
  constexpr std::size_t kTried = 4;
  const auto tried = gaps.begin() + static_cast<std::ptrdiff_t>(std::min(kTried, gaps.size()));
  std::ranges::partial_sort(gaps, tried, std::ranges::greater(), &Gap::size);
  double best = -1;
  double place = 0;
  for (auto gap = gaps.begin(); gap != tried && (gap == gaps.begin() || gap->size > kRounding * ring.total()); ++gap) {
    for (const double share : {0.5, 0.3, 0.8}) {
      const double ahead = gap->start + share * gap->size;
      const double candidate = ahead < ring.total() ? ahead : ahead - ring.total();
      const double difference = std::abs(depth(ring.at(candidate)));
      if (difference > best) {
        best = difference;
        place = candidate;
      }
    }
  }
  return place;
}

}  // namespace

std::vector<OutlinePiece> wholeLoop(const Ring& ring) {
  std::vector<OutlinePiece> loop;
  for (const Ring::Element& element : ring.elements()) append(loop, element);
  return loop;
}

// Along the ring exits and entries alternate. To pair the k-th exit with the k-th entry, or the one after it, is right
// wherever rounding confuses the order of an exit and an entry next to each other; it takes a place to begin that is
// neither, and is known to be inside or not.
Outline joined(const Ring& ring, std::vector<Chain> chains, const std::function<double(Point)>& depth) {
  const double begin = clearPlace(ring, chains, depth);
  const bool beginsInside = depth(ring.at(begin)) > 0;
  const auto ahead = [&](double place) { return place < begin ? place + ring.total() : place; };
  const std::size_t count = chains.size();
  std::vector<std::size_t> byExit(count);
  for (std::size_t i = 0; i < count; ++i) byExit[i] = i;
  std::vector<std::size_t> byEntry = byExit;
  std::ranges::sort(byExit, {}, [&](std::size_t i) { return ahead(chains[i].exit); });
  std::ranges::sort(byEntry, {}, [&](std::size_t i) { return ahead(chains[i].entry); });

  std::vector<std::size_t> next(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = byExit[k];
    const std::size_t j = byEntry[beginsInside ? (k + 1) % count : k];
    next[i] = j;
    const double from = ahead(chains[i].exit);
    const double to = ahead(chains[j].entry) + (beginsInside && k + 1 == count ? ring.total() : 0);
    const Point start = chains[i].pieces.back().curve.end;
    const Point end = chains[j].pieces.front().curve.start;
    for (const Ring::Element& part : ring.between(from, to, start, end)) append(chains[i].pieces, part);
  }

  Outline outline;
  std::vector<bool> isDone(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (isDone[i]) continue;
    auto& loop = outline.emplace_back();
    for (std::size_t j = i; !isDone[j]; j = next[j]) {
      isDone[j] = true;
      std::ranges::move(chains[j].pieces, std::back_inserter(loop));
    }
  }
  return outline;
}

}  // namespace circle_voronoi
