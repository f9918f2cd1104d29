// Projects of LDtk as text.
#pragma once

#include <string>

namespace talus {

// One tileset, 1, of 8x8 px tiles in t.png, with these members, such as enumTags.
inline std::string ldtk_tileset(const std::string& members = "") {
  return R"({"uid":1,"identifier":"Tiles","relPath":"t.png","tileGridSize":8)" +
         (members.empty() ? "" : "," + members) + "}";
}

// The definition of layer 2, an IntGrid with these values: {"value":1,"identifier":"wall"}, ...
inline std::string ldtk_values(const std::string& values, const std::string& members = "") {
  return R"({"uid":2,"intGridValues":[)" + values + "]" + (members.empty() ? "" : "," + members) + "}";
}

// A layer of 8 px cells. members: those that differ between kinds of layers.
inline std::string ldtk_layer(const std::string& type, const std::string& name, int columns, int rows,
                              const std::string& members, int side = 8) {
  return R"({"__type":")" + type + R"(","__identifier":")" + name + R"(","__cWid":)" +
         std::to_string(columns) + R"(,"__cHei":)" + std::to_string(rows) + R"(,"__gridSize":)" +
         std::to_string(side) + R"(,"layerDefUid":2,)" + members + "}";
}

// An IntGrid with these values, without pictures of its own.
inline std::string ldtk_grid(int columns, int rows, const std::string& values,
                             const std::string& members = R"("__tilesetDefUid":1)") {
  return ldtk_layer("IntGrid", "Grid", columns, rows, R"("intGridCsv":[)" + values + "]," + members);
}

// A tile at (x, y) px of its layer that shows the tile at `column` of the first row of the tileset.
inline std::string ldtk_tile(int x, int y, int column, int flips = 0, const std::string& opacity = "1") {
  return R"({"px":[)" + std::to_string(x) + "," + std::to_string(y) + R"(],"src":[)" +
         std::to_string(8 * column) + R"(,0],"t":)" + std::to_string(column) + R"(,"f":)" +
         std::to_string(flips) + R"(,"a":)" + opacity + "}";
}
inline std::string ldtk_tiles(int columns, int rows, const std::string& tiles,
                              const std::string& members = "") {
  return ldtk_layer("Tiles", "Tiles", columns, rows,
                    R"("__tilesetDefUid":1,"gridTiles":[)" + tiles + "]" + members);
}

// layers: from the top.
inline std::string ldtk_level(const std::string& layers, const std::string& name = "Cave",
                              const std::string& members = "") {
  return R"({"identifier":")" + name + R"(","pxWid":32,"pxHei":16,"__bgColor":"#102030",)" + members +
         R"("layerInstances":[)" + layers + "]}";
}

inline std::string ldtk_project(const std::string& levels, const std::string& values = "",
                                const std::string& tileset = ldtk_tileset(), const std::string& worlds = "") {
  return R"({"__header__":{"fileType":"LDtk Project JSON"},"defs":{"tilesets":[)" + tileset +
         R"(],"layers":[)" + (values.empty() ? "" : ldtk_values(values)) + R"(]},"levels":[)" + levels +
         R"(],"worlds":[)" + worlds + "]}";
}

}  // namespace talus
