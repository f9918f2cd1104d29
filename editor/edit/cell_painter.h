// CellPainter: collects the cells that a tool paints into an Edit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "level/edit.h"

namespace talus {

// The cells that a tool may paint, such as the selection; empty: the whole map.
using Within = std::optional<CellRect>;

// Beyond this number of cells a copy of the map takes less memory than their list.
class CellPainter {
 public:
  // Cells outside the map, or outside `within`, are left out.
  explicit CellPainter(const TileMap& map, Within within = {});
  // A cell may be painted once.
  void paint(Cell cell, MapCell content);
  Edit finish(std::string label);  // the last call; only once

 private:
  const TileMap& map_;
  Within within_;
  std::size_t max_listed_;
  std::vector<CellChange> changes_;
  std::optional<TileMap> whole_;
};

}  // namespace talus
