// Painting flags by dragging over tiles: on the sheet, or on the map, through the tiles that it shows.
#pragma once

#include <optional>
#include <string>

#include <talus/collision/function_ref.h>
#include "session/session.h"

namespace talus {

class FlagBrush {
 public:
  // The number of the tile in a place; nothing outside.
  using TileAt = FunctionRef<std::optional<int>(Cell)>;

  // Call in every frame in which the mouse may act: `at` is under it, `pressed` in the frame of the press,
  // `down` while it is held. The first tile says whether the stroke sets the chosen flag or clears it.
  void update(const Session& session, Actions& actions, SheetId sheet, Cell at, TileAt tile_at, bool pressed,
              bool down);
  void cancel(const Session& session, Actions& actions);  // cancels the stroke
  bool active() const { return last_.has_value(); }
  // Says what the stroke does to a tile, or what a press on it would do: "tile 12: clears flag 0  solid".
  // tile: 0..255, or empty for a place outside.
  std::string text(const Session& session, SheetId sheet, std::optional<int> tile) const;

 private:
  std::optional<Cell> last_;  // the last place of the stroke
  bool sets_ = true;
  int stroke_ = 0;
};

// The tiles of the map's cells, for FlagBrush.
struct TileOfMap {
  const TileMap& map;
  std::optional<int> operator()(Cell cell) const {
    return map.contains(cell) ? std::optional<int>(map.tile_at(cell)) : std::nullopt;
  }
};

}  // namespace talus
