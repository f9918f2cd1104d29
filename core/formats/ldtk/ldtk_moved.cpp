#include "ldtk_moved.h"

#include <algorithm>

#include "../native/moved_members.h"

namespace talus {
namespace {

// The lists of a member of the additions: of entries, and of [place in the list, entry].
template <class Move>
void move_changes(Json& additions, const char* key, Move move) {
  if (!additions.contains(key) || !additions[key].is_object()) return;
  Json& of = additions[key];
  if (of.contains("gone")) move(of["gone"]);
  if (!of.contains("added") || !of["added"].is_array()) return;
  Json kept = Json::array();
  for (Json& entry : of["added"]) {
    if (!entry.is_array() || entry.size() != 2) continue;
    Json list = Json::array({entry[1]});
    move(list);
    if (!list.empty()) kept.push_back({entry[0], list[0]});
  }
  of["added"] = std::move(kept);
}

// Cuts off what is left of the map now. Returns how many cells that are.
int move_run(Json& run, Cell by) {
  const auto is_place = [](const Json& n) { return is_whole(n, 0, kMaxTerrainSide); };
  if (!run.is_array() || run.size() != 4 || !is_place(run[0]) || !is_place(run[1]) || !run[2].is_array() ||
      run[2].size() != run[3].size())
    return 0;
  const int x = run[0].get<int>() + by.x, y = run[1].get<int>() + by.y;
  const auto cut = static_cast<std::ptrdiff_t>(y < 0 ? run[2].size()
                                                     : std::min<std::size_t>(run[2].size(), std::max(0, -x)));
  for (const std::size_t i : {2U, 3U}) {
    if (run[i].is_array()) run[i].erase(run[i].begin(), run[i].begin() + cut);
  }
  run[0] = std::max(0, x);
  run[1] = std::max(0, y);
  return static_cast<int>(cut);
}

int move_runs(Json& layer, Cell by) {
  if (!layer.is_object() || !layer.contains("runs") || !layer["runs"].is_array()) return 0;
  int lost = 0;
  for (Json& run : layer["runs"]) lost += move_run(run, by);
  auto& runs = layer["runs"].get_ref<Json::array_t&>();
  std::erase_if(runs, [](const Json& run) { return run.is_array() && run.size() == 4 && run[2].empty(); });
  return lost;
}

// The map of a level with what was added to it.
TileMap map_of_additions(const Json& additions, int width, int height, TileSize tile) {
  const Json size = additions.value("map", Json());
  const auto side = [&](std::size_t i) { return size.is_array() && size.size() == 2 ? size[i] : Json(); };
  return map_with_sides(side(0), side(1), width, height, tile);
}

}  // namespace

int move_ldtk_places(Json& additions, Cell by, const GroundPlace& place, const Level& held,
                     LdtkConflicts& conflicts) {
  const TileSize tile = held.map.tile_size();
  const Vec2 px = held.map.corner_of(by);
  const bool has_curves = additions.contains("curves");
  const TileMap from =
      has_curves ? map_of_additions(additions, place.width, place.height, tile) : TileMap(1, 1, tile);
  if (Json& size = additions["map"]; size.is_array() && size.size() == 2) {
    const Cell growth = growth_at_corner(place, held.map, by);
    for (const auto& [i, cells] : {std::pair(0U, growth.x), std::pair(1U, growth.y)})
      if (is_whole(size[i], 1, kMaxTerrainSide)) size[i] = std::max(1, size[i].get<int>() + cells);
  } else {
    additions.erase("map");
  }
  for (const char* const key : {"layers", "cells"}) {
    if (!additions.contains(key) || !additions[key].is_array()) continue;
    for (Json& layer : additions[key]) conflicts.cells += move_runs(layer, by);
  }
  move_changes(additions, "spawns", [&](Json& list) { move_spawns(list, px); });
  if (const auto members = additions.find("members"); members != additions.end() && members->is_object()) {
    if (members->contains("objects")) move_objects((*members)["objects"], px);
  }
  int lost = 0;
  if (has_curves) {
    const TileMap now = map_of_additions(additions, held.map.width(), held.map.height(), tile);
    move_changes(additions, "curves", [&](Json& list) { lost += move_curves(list, px, from, now); });
  }
  return lost;
}

}  // namespace talus
