// SheetChanges: which images of the sheets changed when, so that a stroke on a large picture need not show
// all of it again.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "level/edit.h"

namespace talus {

class SheetChanges {
 public:
  // Notes an edit that was done or undone. revision: of the level after it, as in Session.
  void note(const Edit& edit, std::uint64_t revision);
  // Notes that anything may have changed.
  void note_all(std::uint64_t revision);
  // The tiles whose looks in true colour changed after that revision, also several times; nothing if other
  // images or colours changed, too, or it is too long ago.
  std::optional<std::vector<int>> tiles_since(std::uint64_t revision) const;

 private:
  std::deque<std::pair<std::uint64_t, int>> tiles_;  // by revision, the oldest first
  std::uint64_t all_ = 0;                            // the last revision with other changes
};

}  // namespace talus
