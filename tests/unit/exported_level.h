// Small levels, exported in memory, for tests of exporters that need none of the program's files.
#pragma once

#include <string>

#include "export/exporter.h"
#include "unit/test_map.h"

namespace talus {

// A map of the test shapes' tiles; see TestMap.
inline Level level_of_shapes(const std::vector<std::string>& rows) {
  const TestMap map(rows);
  Level level;
  level.map = TileMap(map.width, map.height);
  level.map.cells() = map.cells;
  level.tile_shapes = test_shapes();
  return level;
}

// Two tiles and a curve that are conveyors.
inline Level level_of_conveyors() {
  Level level;
  level.map = TileMap(2, 1);
  level.map.set({0, 0}, 1);
  level.map.set({1, 0}, 2);
  level.tile_shapes[1] = level.tile_shapes[2] = {.kind = TileShape::Kind::solid, .conveyor = 1};
  level.curves.push_back({"", {Segment{{0, 0}, {8, 0}}, Curve::Faces::up, 2.0}, ""});
  return level;
}

inline FormatResult<Exported> exported(const char* id, const Level& level, const std::string& name) {
  const ReadAsset nothing = [](const std::string& asset) -> FormatResult<std::string> {
    return tl::unexpected(FormatError{asset, "is missing"});
  };
  return find_exporter(id)->write({level, name, nothing});
}

// The bytes of the file with that name; "" stands for the main file of the export.
inline std::string exported_file(const char* id, const Level& level, const std::string& file = "") {
  const FormatResult<Exported> files = exported(id, level, "cave");
  if (!files) return files.error().message;
  for (const ExportedFile& f : files->files)
    if (f.name == file) return f.bytes;
  return "no file " + file;
}

}  // namespace talus
