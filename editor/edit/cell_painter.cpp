// Collects painted cells.
#include "cell_painter.h"

#include <algorithm>
#include <utility>

namespace talus {

CellPainter::CellPainter(const TileMap& map, Within within)
    : map_(map),
      within_(within),
      max_listed_(std::max<std::size_t>(256, 2 * map.cells().size() / sizeof(Change))) {}

void CellPainter::paint(Cell cell, MapCell content) {
  if (!map_.contains(cell) || map_.at(cell) == content || (within_ && !within_->contains(cell))) return;
  if (whole_) {
    whole_->set(cell, content);
    return;
  }
  changes_.push_back({cell, map_.at(cell), content});
  if (changes_.size() <= max_listed_) return;
  whole_ = map_;
  for (const CellChange& change : changes_) whole_->set(change.cell, change.after);
}

Edit CellPainter::finish(std::string label) {
  Edit edit{std::move(label), {}};
  if (whole_)
    edit.changes.emplace_back(MapChange{map_, *std::move(whole_)});
  else
    edit.changes.assign(changes_.begin(), changes_.end());
  return edit;
}

}  // namespace talus
