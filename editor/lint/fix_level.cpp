// Fixes of flags, pictures, shapes, roles, curves and the solver.
#include <algorithm>
#include <cmath>

#include "edit/single_change.h"
#include "fix_parts.h"
#include "level/level_text.h"
#include "level/slope_tiles.h"

namespace talus {
namespace {

// Whether the middle of a pixel of the tile's own cell is inside of the ground; of a ball, inside of it.
bool is_inside(const TileShape& shape, int x, int y) {
  const double at = x + 0.5, down = y + 0.5;
  if (shape.kind == TileShape::Kind::none) return std::hypot(at - 4, down - 4) < 4;
  if (shape.heights.size() < 2) return true;
  const double step = shape.tiles * kTileSize / static_cast<double>(shape.heights.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at / step), shape.heights.size() - 2);
  const double part = at / step - static_cast<double>(i);
  const double height = shape.heights[i] + (shape.heights[i + 1] - shape.heights[i]) * part;
  return shape.side == TileShape::Side::floor ? kTileSize - down <= height : down <= height;
}

Edit draw_shape(const Level& level, std::uint8_t tile) {
  const TileShape shape = shape_of_tile(level, tile);
  Edit edit{"Draw " + tile_text(tile) + " as what it is", {}};
  for (int pixel = 0; pixel < kTileSize * kTileSize; ++pixel) {
    const std::uint8_t before = level.sheet(SheetId::tiles).images[tile][static_cast<std::size_t>(pixel)];
    if (is_inside(shape, pixel % kTileSize, pixel / kTileSize))
      edit.changes.push_back(
          PixelChange{SheetId::tiles, tile, pixel, before, SlopeTilesOptions{}.ground_color});
  }
  return edit;
}

Edit change_flags(const Level& level, std::uint8_t tile, int after, std::string label) {
  return single_change(std::move(label), FlagsChange{SheetId::tiles, tile, level.tile_flags(tile),
                                                     static_cast<std::uint8_t>(after)});
}

void fix_conflict(const Level& level, const LintTiles& tiles, std::uint8_t tile, std::vector<Edit>& out) {
  const TileRole kept = tiles[tile].role;
  int flags = level.tile_flags(tile), kept_flag = FlagRoles::kUnused;
  std::string labels;
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (info.role == kept && kept_flag == FlagRoles::kUnused) kept_flag = level.roles.*info.flag;
  }
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = level.roles.*info.flag;
    if (info.role == TileRole::none || flag == kept_flag) continue;
    if (!has_flag(static_cast<std::uint8_t>(flags), flag)) continue;
    flags &= ~(1 << flag);
    labels += (labels.empty() ? "" : " and ") + std::string(info.label);
  }
  out.push_back(change_flags(level, tile, flags,
                             "Clear the " + labels + " flag of " + tile_text(tile) + ", which is " +
                                 role_label(kept) + " as before"));
}

void fix_idle_flag(const Level& level, std::uint8_t tile, std::vector<Edit>& out) {
  int flags = level.tile_flags(tile);
  for (const int flag : {level.roles.one_way, level.roles.ceiling}) {
    if (flag != FlagRoles::kUnused) flags &= ~(1 << flag);
  }
  out.push_back(
      change_flags(level, tile, flags, "Clear the flags of " + tile_text(tile) + " that change nothing"));
}

}  // namespace

void fix_tile(const Level& level, const LintTiles& tiles, const Problem& problem, std::vector<Edit>& out) {
  const auto tile = static_cast<std::uint8_t>(problem.tile);
  if (problem.code == "flags-conflict") fix_conflict(level, tiles, tile, out);
  if (problem.code == "flag-idle") fix_idle_flag(level, tile, out);
  if (problem.code != "invisible") return;
  out.push_back(draw_shape(level, tile));
  if (level.tile_flags(tile) != 0)
    out.push_back(change_flags(level, tile, 0, "Clear all flags of " + tile_text(tile)));
}

void fix_level(const Level& level, const Problem& problem, std::vector<Edit>& out) {
  const auto object = static_cast<std::size_t>(problem.object);
  if (problem.code == "bad-shape" && problem.tile >= 0) {
    out.push_back(
        single_change("Remove the shape of " + tile_text(problem.tile),
                      TileShapeChange{problem.tile, level.tile_shapes[static_cast<std::size_t>(problem.tile)],
                                      TileShape()}));
  } else if (problem.code == "bad-shape") {
    out.push_back(single_change("Remove the shape of flag " + std::to_string(problem.object),
                                FlagShapeChange{problem.object, level.flag_shapes[object], TileShape()}));
  } else if (problem.code == "bad-curve" || problem.code == "curve-leaves-map") {
    if (object >= level.curves.size()) return;
    std::vector<LevelCurve> curves = level.curves;
    curves.erase(curves.begin() + problem.object);
    const std::string& name = level.curves[object].name;
    out.push_back(
        single_change("Remove curve " + (name.empty() ? std::to_string(problem.object) : "\"" + name + "\""),
                      CurvesChange{level.curves, std::move(curves)}));
  } else if (problem.code == "curves-need-exact") {
    Tuning tuning = level.tuning;
    tuning.solver = SolverKind::exact;
    out.push_back(
        single_change("Choose the exact solver for this level", TuningChange{level.tuning, tuning}));
  } else if (problem.code == "shared-flag") {
    const FlagRoleInfo& second = flag_role_infos()[object];
    const int flag = level.roles.*second.flag;
    FlagRoles roles = level.roles;
    roles.*second.flag = FlagRoles::kUnused;
    out.push_back(single_change(
        "Let flag " + std::to_string(flag) + " no longer stand for " + std::string(second.label),
        RolesChange{level.roles, roles}));
  }
}

}  // namespace talus
