// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "circle_voronoi/editor.h"

namespace circle_voronoi {

/// Maps the ids of circles to their slots. Ids are never reused. The memory of removed ids is freed page by page.
class IdTable {
 public:
  /// Returns kNone if there is no such circle.
  int slotOf(CircleId id) const {
    if (id < 0 || pageOf(id) >= pages_.size() || !pages_[pageOf(id)]) return kNone;
    return pages_[pageOf(id)]->slots[at(id)];
  }

  void add(CircleId id, int slot) {
    if (pageOf(id) >= pages_.size()) pages_.resize(pageOf(id) + 1);
    auto& page = pages_[pageOf(id)];
    if (!page) {
      page = std::make_unique<Page>();
      page->slots.fill(kNone);
    }
    page->slots[at(id)] = slot;
    ++page->count;
  }

  void remove(CircleId id) noexcept {
    auto& page = pages_[pageOf(id)];
    page->slots[at(id)] = kNone;
    if (--page->count == 0) page.reset();
  }

  /// Calls function(id, slot) in the order of ids.
  template <class Function>
  void forEach(Function function) const {
    for (std::size_t p = 0; p < pages_.size(); ++p) {
      if (!pages_[p]) continue;
      for (std::size_t i = 0; i < kPage; ++i) {
        if (pages_[p]->slots[i] != kNone)
          function(CircleId(static_cast<std::int32_t>(p * kPage + i)), pages_[p]->slots[i]);
      }
    }
  }

 private:
  static constexpr std::size_t kPage = 1024;
  struct Page {
    std::array<int, kPage> slots;
    int count = 0;
  };
  static std::size_t pageOf(CircleId id) { return static_cast<std::size_t>(id) / kPage; }
  static std::size_t at(CircleId id) { return static_cast<std::size_t>(id) % kPage; }

  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace circle_voronoi
