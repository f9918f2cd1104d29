// Keeps the last changes.
#include "sheet_changes.h"

#include <algorithm>
#include <type_traits>

namespace talus {

void SheetChanges::note(const Edit& edit, std::uint64_t revision) {
  constexpr std::size_t kMax = 4096;
  for (const Change& change : edit.changes) {
    if (const auto* look = std::get_if<TileLookChange>(&change); look && look->sheet == SheetId::tiles) {
      tiles_.emplace_back(revision, look->tile);
    } else if (look != nullptr || std::holds_alternative<PixelChange>(change) ||
               std::holds_alternative<ColorChange>(change) || std::holds_alternative<LevelChange>(change)) {
      return note_all(revision);
    }
  }
  while (tiles_.size() > kMax) {
    all_ = tiles_.front().first;
    tiles_.pop_front();
  }
}

void SheetChanges::note_all(std::uint64_t revision) {
  all_ = revision;
  tiles_.clear();
}

std::optional<std::vector<int>> SheetChanges::tiles_since(std::uint64_t revision) const {
  if (revision < all_) return std::nullopt;
  std::vector<int> tiles;
  for (auto entry = tiles_.rbegin(); entry != tiles_.rend() && entry->first > revision; ++entry)
    tiles.push_back(entry->second);
  return tiles;
}

}  // namespace talus
