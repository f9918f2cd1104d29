// Plain data that any game can read: one file of Lua or JSON.
#include "export_targets.h"
#include "plain_data.h"
#include "plain_text.h"

namespace talus {
namespace {

FormatResult<Exported> export_plain(const ExportRequest& request, Dialect dialect, const std::string& head) {
  auto text = plain_text(request.level, request.whole(), dialect, request.progress);
  if (!text) return tl::unexpected(text.error());
  return exported_file(head + *text);
}

}  // namespace

FormatResult<Exported> export_lua(const ExportRequest& request) {
  const std::string head =
      R"(-- A level exported by Talus: plain data. Lengths are px, y goes down, velocities are px a frame.
-- The tile at a column and row, both from 0, is map[row + 1][column + 1], its flags flags.tiles[tile + 1],
-- and its shape, if it has one, shapes[tile]. floor: how far below the tile's top the ground is, in the
-- middle of each column of pixels. polygons: the ground's outline, x, y, x, y, ..., clockwise on the screen,
-- holes the other way. lines: what stops bodies on their left hand side alone, and curves.
-- layers: those of the level with their own tiles; left out where map is the only one. objects: those of all
-- layers, with class, name, place and properties. bodies: all that move, at their start; `tile` where a tile
-- of the map is one, which is not to be drawn then.
)";
  return export_plain(request, Dialect::lua, head);
}

FormatResult<Exported> export_json(const ExportRequest& request) {
  return export_plain(request, Dialect::json, "");
}

}  // namespace talus
