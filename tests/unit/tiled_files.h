// A level with one of everything that maps of Tiled hold, and maps of it.
#pragma once

#include <gtest/gtest.h>

#include "export/exporter.h"

namespace talus {

inline Level level_for_tiled() {
  Level level;
  level.map = TileMap(6, 4);
  level.map.cells().tiles() = {0, 0, 0, 0, 0, 0,  //
                               0, 0, 4, 0, 5, 0,  //
                               0, 2, 3, 7, 0, 6,  //
                               1, 1, 1, 1, 1, 1};
  Sheet& tiles = level.sheet(SheetId::tiles);
  tiles.flags[1] = 1;           // solid
  tiles.flags[2] = 1 << 2;      // an up-slope of 16x8 px
  tiles.flags[3] = 1 << 4;      // "ice"
  tiles.flags[7] = 1 | 1 << 5;  // solid, and what has no name
  level.flag_names[4] = "ice";
  level.tile_shapes[4] = {
      .kind = TileShape::Kind::profile, .side = TileShape::Side::ceiling, .heights = {2, 0.5, 4}};
  level.tile_shapes[5] = {
      .kind = TileShape::Kind::slope, .one_way = true, .tiles = 2, .heights = {1.00390625, 20}};
  level.tile_shapes[6] = {.kind = TileShape::Kind::solid};
  for (std::size_t i = 1; i < 8; ++i) tiles.images[i].fill(static_cast<std::uint8_t>(i + 1));
  level.sheet(SheetId::sprites).images[9].fill(3);
  level.palette[3] = {1, 2, 3};
  level.spawns.push_back({.name = "a <b> & \"c\"",
                          .position = {12.3456789, 2},
                          .velocity = {0.1, -3},
                          .extra = "",
                          .kind = BodyKind::player,
                          .size = {6, 12}});
  level.spawns.push_back({.name = "", .position = {1, 1}, .velocity = {}, .extra = "", .foot = Foot::centre});
  level.curves.push_back({"ramp", {Segment{{1.25, 2}, {9, 8.5}}, Curve::Faces::both}, ""});
  level.curves.push_back({"hill", {Arc{{24, 24}, 12, 12, 36, true}, Curve::Faces::up}, ""});
  level.tuning.shared.fall_blend = 0.125;
  return level;
}

inline Exported tiled_export_of(const Level& level, const std::string& exporter, const std::string& name) {
  const ReadAsset no_asset;
  return find_exporter(exporter)->write({level, name, no_asset}).value();
}

}  // namespace talus
