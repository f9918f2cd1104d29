#include "lua_parts.h"

#include <algorithm>
#include <array>
#include <set>

#include <talus/level/ground.h>
#include "../collision/tile_outlines.h"
#include "plain_data.h"

namespace talus {
namespace {

constexpr std::size_t kMaxFiles = 7, kMaxNeeds = 2;
struct LuaPart {
  std::string_view name;
  std::array<std::string_view, kMaxFiles> files;
  std::array<std::string_view, kMaxNeeds> needs = {};
};

// In the order in which they are joined. The first and the last one are in every module.
constexpr LuaPart kLuaParts[] = {
    {"core", {"base", "terrain", "cast", "queries"}},
    {"bodies", {"mover", "world"}},
    {"slopes", {"slopes", "details", "cast_slopes", "queries_slopes"}},
    {"one_way", {"one_way"}, {"slopes"}},
    {"polygons", {"polygons"}, {"slopes"}},
    {"segments", {"segments"}, {"slopes"}},
    {"curves", {"zeros", "curves"}, {"segments", "slopes"}},
    {"balls", {"balls"}},
    {"sides", {"sides"}, {"balls", "slopes"}},
    {"flight", {"flight"}, {"balls"}},
    {"walk", {"walk", "walk_slopes", "walk_curves"}},
    {"players", {"players"}, {"walk"}},
    {"pairs", {"pairs"}},
    {"mouse", {"mouse"}},
    {"meet", {"meet"}, {"balls"}},
    {"round", {"zeros", "forms", "round_ground", "spins", "tracks", "crowd", "round"}, {"meet", "balls"}},
    {"conveyors", {"conveyors"}},
    {"events", {"events"}},
    {"steer", {"steer"}, {"events"}},
    {"data", {"data"}},
    {"end", {"luajit", "module"}},
};

// Files that are there only with another part, too.
struct SharedFile {
  std::string_view file, part;
};
constexpr SharedFile kSharedFiles[] = {{"walk_slopes", "slopes"}, {"walk_curves", "curves"}};

// The part that has the rule.
std::string_view part_of(BodyRule rule) {
  switch (rule) {
    case BodyRule::fall:
      return "balls";
    case BodyRule::run:
      return "players";
  }
  return {};
}

// Polygons need no part for one-way ground.
bool has_one_way_line(const TileShape& shape) {
  if (shape.kind == TileShape::Kind::group)
    return std::any_of(shape.parts.begin(), shape.parts.end(), has_one_way_line);
  return shape.one_way && shape.kind != TileShape::Kind::polygon && is_line_shape(shape);
}

bool is_always_there(const LuaPart& part) {
  return part.name == "core" || part.name == "bodies" || part.name == "end";
}

using PartNames = std::set<std::string, std::less<>>;

PartNames used_parts(const Level& level) {
  const TerrainSource ground = ground_of(level);
  const auto any_cell = [&](auto is) { return std::any_of(ground.cells.begin(), ground.cells.end(), is); };
  const auto any_curve = [&](auto is) { return std::any_of(ground.curves.begin(), ground.curves.end(), is); };
  PartNames used;
  std::size_t bodies = level.spawns.size();
  bool has_centre = false;  // a body that stands on its centre
  bool has_circle = false;
  for (const Spawn& spawn : level.spawns) {
    used.emplace(part_of(traits_of(spawn.kind).rule));
    has_centre = has_centre || spawn.used_foot() == Foot::centre;
    has_circle = has_circle || traits_of(spawn.kind).shape == BodyShape::circle;
  }
  std::vector<std::size_t> counts(ground.shapes.size());  // of cells, by tile
  for (const TileNumber tile : ground.cells) ++counts[tile];
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    const auto kind = body_kind_of_tile(level, static_cast<TileNumber>(tile));
    if (!kind) continue;
    if (counts[tile] > 0) {
      used.emplace("balls");  // which places them
      used.emplace(part_of(traits_of(*kind).rule));
      has_circle = has_circle || traits_of(*kind).shape == BodyShape::circle;
    }
    bodies += counts[tile];
  }
  const auto is_line = [&](TileNumber tile) { return is_line_shape(ground.shapes[tile]); };
  if (any_cell(is_line)) used.emplace("slopes");
  if (any_cell([&](TileNumber tile) { return has_one_way_line(ground.shapes[tile]); }))
    used.emplace("one_way");
  // The mere shape of a tile that is set later changes how lines are rounded.
  if (std::any_of(ground.shapes.begin(), ground.shapes.end(), has_parts)) used.emplace("polygons");
  if (!ground.curves.empty()) used.emplace("segments");
  if (any_curve([](const Curve& curve) {
        return !std::holds_alternative<Segment>(curve.form) && !std::holds_alternative<Polyline>(curve.form);
      }))
    used.emplace("curves");
  const auto is_conveyor = [](const auto& part) { return part.conveyor != 0; };
  if (any_cell([&](TileNumber tile) { return is_conveyor(ground.shapes[tile]); }) || any_curve(is_conveyor))
    used.emplace("conveyors");
  const bool has_slopes = used.contains("slopes") || used.contains("polygons") || used.contains("segments");
  if (has_centre && has_slopes) used.emplace("walk");
  if (level.tuning.shared.pairs() != BodyPairs::pass && bodies > 1) used.emplace("pairs");
  const bool meets = level.tuning.shared.pairs() == BodyPairs::meet;
  // Boxes go along curves with a corner, as circles without a radius do.
  if (meets && (has_circle || (used.contains("balls") && used.contains("curves")))) used.emplace("round");
  const ExactTuning& exact = level.tuning.exact;
  if (used.contains("balls") && !meets && exact.rebound != 0 && exact.gravity > 0) used.emplace("flight");
  return used;
}

const LuaPart* find_part(std::string_view name) {
  const auto found = std::find_if(std::begin(kLuaParts), std::end(kLuaParts),
                                  [&](const LuaPart& p) { return p.name == name; });
  return found == std::end(kLuaParts) || is_always_there(*found) ? nullptr : &*found;
}

// Adds what the parts need.
void add_needs(PartNames& parts) {
  const PartNames asked = parts;
  for (const std::string& name : asked) {
    for (const std::string_view need : find_part(name)->needs) {
      if (!need.empty()) parts.emplace(need);
    }
  }
}

}  // namespace

std::string lua_part_names() {
  std::string names;
  for (const LuaPart& part : kLuaParts) {
    if (!is_always_there(part)) names.append(names.empty() ? "" : ", ").append(part.name);
  }
  return names;
}

FormatResult<std::vector<std::string>> lua_parts(const Level& level, std::string_view more) {
  PartNames wanted = used_parts(level);
  while (!more.empty()) {
    std::string_view word = more.substr(0, more.find(','));
    more.remove_prefix(std::min(word.size() + 1, more.size()));
    while (word.starts_with(' ')) word.remove_prefix(1);
    while (word.ends_with(' ')) word.remove_suffix(1);
    if (word.empty()) continue;
    if (find_part(word) == nullptr) {
      return tl::unexpected(FormatError{
          "",
          "\"" + std::string(word) + "\" is not a part of the runtime; the parts are " + lua_part_names()});
    }
    wanted.emplace(word);
  }
  const bool meets = level.tuning.shared.pairs() == BodyPairs::meet;
  if (meets && wanted.contains("balls")) wanted.emplace("meet");
  add_needs(wanted);
  if (!meets && wanted.contains("balls") && wanted.contains("slopes")) wanted.emplace("sides");
  std::vector<std::string> parts;
  for (const LuaPart& part : kLuaParts) {
    if (wanted.contains(part.name)) parts.emplace_back(part.name);
  }
  return parts;
}

std::vector<std::string> lua_part_files(const std::vector<std::string>& parts) {
  std::vector<std::string> files;
  const auto has = [&](std::string_view part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  };
  for (const LuaPart& part : kLuaParts) {
    if (!is_always_there(part) && !has(part.name)) continue;
    for (const std::string_view file : part.files) {
      const bool is_new = std::find(files.begin(), files.end(), file) == files.end();
      const bool is_used = std::all_of(std::begin(kSharedFiles), std::end(kSharedFiles),
                                       [&](const SharedFile& s) { return s.file != file || has(s.part); });
      if (!file.empty() && is_new && is_used) files.emplace_back(file);  // two parts may share one
    }
  }
  return files;
}

}  // namespace talus
