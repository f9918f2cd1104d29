// Plain data that any game can read: one file of Lua or JSON.
#include "export_targets.h"
#include "plain_text.h"

namespace talus {

FormatResult<Exported> export_lua(const ExportRequest& request) {
  const std::string head =
      "-- A level exported by Talus: plain data, lengths in px, y down, lists from 1. The tile at a column "
      "and\n"
      "-- row, both from 0, is map[row + 1][column + 1]; its shape, if any, shapes[tile]. floor: how far "
      "below\n"
      "-- the tile's top the ground is, in the middle of each column of pixels. polygons: the ground's "
      "outline,\n"
      "-- x, y, x, y, ..., clockwise on the screen, holes the other way.\n";
  return Exported{{{"", head + "return " + print_plain(plain_json(request.level), Dialect::lua) + "\n"}}, {}};
}

FormatResult<Exported> export_json(const ExportRequest& request) {
  return Exported{{{"", print_plain(plain_json(request.level), Dialect::json) + "\n"}}, {}};
}

}  // namespace talus
