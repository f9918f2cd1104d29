#include "tile_note_tools.h"

#include <cassert>
#include <utility>

#include "level/single_change.h"

namespace talus {
namespace {

// The edit that changes the note of each tile of an area.
template <class ChangeNote>
Edit change_notes(const Level& level, const SpriteArea& area, std::string label, ChangeNote change) {
  if (area.sheet != SheetId::tiles) return {std::move(label), {}};
  TileNotes notes = level.tile_notes;
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) {
      const auto tile = static_cast<TileNumber>(area.tile_at(level, x, y));
      TileNote note = note_of(notes, tile);
      change(note);
      put_note(notes, tile, std::move(note));
    }
  }
  return single_change(std::move(label), TileNotesChange{level.tile_notes, std::move(notes)});
}

}  // namespace

std::optional<double> common_probability(const Level& level, const SpriteArea& area) {
  if (area.sheet != SheetId::tiles) return std::nullopt;
  std::optional<double> common;
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) {
      const auto tile = static_cast<TileNumber>(area.tile_at(level, x, y));
      const double probability = note_of(level.tile_notes, tile).probability;
      if (common && *common != probability) return std::nullopt;
      common = probability;
    }
  }
  return common;
}

Edit set_probability(const Level& level, const SpriteArea& area, double probability) {
  assert(probability >= 0 && probability <= kMaxProbability);
  return change_notes(level, area, "Set probability of tiles",
                      [&](TileNote& note) { note.probability = probability; });
}

Edit set_tile_class(const Level& level, const SpriteArea& area, const std::string& type) {
  return change_notes(level, area, "Set class of tiles", [&](TileNote& note) { note.type = type; });
}

Edit change_tile_properties(const Level& level, const SpriteArea& area,
                            FunctionRef<std::string(const std::string&)> change) {
  return change_notes(level, area, "Change properties of tiles",
                      [&](TileNote& note) { note.properties = change(note.properties); });
}

}  // namespace talus
