#include <talus/level/tile_layer.h>

namespace talus {

bool operator==(const TileLayer& a, const TileLayer& b) {
  const bool same_cells = a.cells == b.cells || (a.cells && b.cells && *a.cells == *b.cells);
  return same_cells && a.name == b.name && a.is_ground == b.is_ground && a.visible == b.visible &&
         a.locked == b.locked && a.opacity == b.opacity && a.offset == b.offset && a.parallax == b.parallax &&
         a.tint == b.tint && a.group == b.group && a.extra == b.extra;
}

bool TileLayers::is_plain() const {
  TileLayer plain;
  plain.name = list.front().name;
  plain.cells = list.front().cells;
  return count() == 1 && list.front() == plain;
}

}  // namespace talus
