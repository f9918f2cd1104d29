// Tiles are stored in runs of numbers.
#include "tiled_frame_json.h"

#include <talus/level/limits.h>

namespace talus {
namespace {

// Adds the tiles of a run. Returns whether it is one.
bool add_run(const Json& run, TiledFrame& frame) {
  constexpr std::int64_t kMaxNumber = 0xffffffff;
  if (!run.is_array() || run.size() != 2 || !is_whole(run[0], 0, kMaxNumber) ||
      !is_whole(run[1], 1, kMaxTiles - static_cast<std::int64_t>(frame.tiles.size())))
    return false;
  const auto first = run[0].get<std::uint32_t>();
  for (std::uint32_t i = 0; i < run[1].get<std::uint32_t>(); ++i)
    frame.tiles.push_back(first == 0 ? 0 : first + i);
  return true;
}

// Whether it takes over [x, y, width, height].
bool take_area(const Json& area, TiledFrame& frame) {
  constexpr std::int64_t kMaxPlace = 1 << 30;
  if (!area.is_array() || area.size() != 4) return false;
  for (const std::size_t i : {0U, 1U}) {
    if (!is_whole(area[i], -kMaxPlace, kMaxPlace) || !is_whole(area[i + 2], 1, kMaxTerrainSide)) return false;
  }
  frame.x = area[0].get<int>(), frame.y = area[1].get<int>();
  frame.width = area[2].get<int>(), frame.height = area[3].get<int>();
  return true;
}

}  // namespace

Json json_of_tiled_frame(const TiledFrame& frame) {
  Json runs = Json::array();
  std::uint32_t next = 0;  // the number that goes on with the last run
  for (const std::uint32_t tile : frame.tiles) {
    if (runs.empty() || tile != next)
      runs.push_back({tile, 1});
    else
      runs.back()[1] = runs.back()[1].get<int>() + 1;
    next = tile == 0 ? 0 : tile + 1;
  }
  return {{"tiles", runs},
          {"columns", frame.columns},
          {"used", !frame.keeps_numbers},
          {"map", {frame.x, frame.y, frame.width, frame.height}}};
}

std::optional<TiledFrame> tiled_frame_of_json(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  TiledFrame frame;
  const Json runs = json.value("tiles", Json()), columns = json.value("columns", Json());
  if (!runs.is_array() || runs.empty() || !is_whole(columns, 1, kMaxSheetSide)) return std::nullopt;
  for (const Json& run : runs) {
    if (!add_run(run, frame)) return std::nullopt;
  }
  frame.columns = columns.get<int>();
  frame.keeps_numbers = json.value("used", Json()) != true;
  if (!take_area(json.value("map", Json()), frame)) return std::nullopt;
  if (SheetLayout{frame.columns, static_cast<int>(frame.tiles.size())}.rows() > kMaxSheetSide)
    return std::nullopt;
  return frame;
}

}  // namespace talus
