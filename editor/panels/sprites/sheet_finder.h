// What the sheet marks: the tiles that are found, and those that the map uses.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class SheetFinder {
 public:
  // The field and the switch of the marks. Enter selects the next tile that is found, and Shift+Enter the
  // previous one.
  void draw(const Session& session, Actions& actions, Ui& ui);
  // Whether a text looks for tiles.
  bool is_searching() const { return !found_.empty(); }
  bool is_found(int tile) const { return found_[static_cast<std::size_t>(tile)]; }
  // How many cells of all layers have the tile.
  std::size_t uses_of(const Session& session, int tile);
  // Number, tileset, flags, shape, note and uses.
  std::string text_of(const Session& session, int tile);

 private:
  void find(const Session& session);
  void go_to_found(const Session& session, Actions& actions, Ui& ui, bool forwards);

  std::string text_, searched_;
  std::vector<bool> found_;  // by tile; empty: nothing is searched
  std::vector<std::size_t> uses_;
  std::optional<std::uint64_t> found_revision_, counted_revision_;
};

}  // namespace talus
