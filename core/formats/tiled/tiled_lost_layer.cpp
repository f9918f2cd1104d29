#include "tiled_lost_layer.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "../import/import_drops.h"

namespace talus {
namespace {

FormatError lost(std::string place, std::string why, const std::string& remedy) {
  return {std::move(place), std::move(why), remedy + ", or save the level as .talus.json"};
}

// place: "layer" or "group", with its number from 0 if it has no name.
std::string place_of(const char* noun, const std::string& name, std::size_t number) {
  return std::string(noun) + " " + (name.empty() ? std::to_string(number + 1) : quoted_name(name));
}

// What of a layer of tiles or a group the map does not hold; nothing if it holds all of it.
template <class Layer>
std::optional<FormatError> lost_looks(const std::string& place, const Layer& held, const Layer& now) {
  if (held.name != now.name)
    return lost(place, "has a name that maps of Tiled cannot hold", "give it another name");
  if (held.group != now.group)
    return lost(place, "is in a group that the map cannot hold", "take it out of the group");
  const auto field = [&](const char* word) {
    return lost(place, std::string("has ") + word + " that the map cannot hold", "change it");
  };
  if (held.opacity != now.opacity) return field("an opacity");
  if (held.offset != now.offset) return field("an offset");
  if (held.parallax != now.parallax) return field("a parallax");
  if (held.tint != now.tint) return field("a tint");
  if (held.visible != now.visible)
    return lost(place, "is shown or hidden as the map cannot hold it", "change that");
  if (held.locked != now.locked)
    return lost(place, "is locked or unlocked as the map cannot hold it", "change that");
  if (held.extra != now.extra)
    return lost(place, "has keys that maps of Tiled cannot hold", "add it anew without them");
  return std::nullopt;
}

// What of its cells and its ground.
std::optional<FormatError> lost_cells(const std::string& place, const Level& held, const Level& level,
                                      int layer) {
  const MapCells &then = held.cells_of(layer), &now = level.cells_of(layer);
  const auto width = static_cast<std::size_t>(level.map.width());
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (i < then.size() && then[i] == now[i]) continue;
    return lost(place,
                "shows tile " + std::to_string(now[i].tile) + " in column " + std::to_string(i % width) +
                    ", row " + std::to_string(i / width) + ", which the map cannot hold there",
                "paint another tile there");
  }
  const auto at = static_cast<std::size_t>(layer);
  if (held.layers.list[at].is_ground == level.layers.list[at].is_ground) return std::nullopt;
  return lost(place, "is ground, or is not, as the map cannot hold it", "change that");
}

}  // namespace

FormatError lost_layer(const Level& held, const Level& level) {
  if (held.map.width() != level.map.width() || held.map.height() != level.map.height())
    return lost("", "has another size than the map can have", "take back the new size");
  for (std::size_t i = 0; i < level.layers.list.size(); ++i) {
    const TileLayer& now = level.layers.list[i];
    const std::string place = place_of("layer", now.name, i);
    if (i >= held.layers.list.size())
      return lost(place, "is a layer of tiles that the map cannot hold", "remove it");
    if (auto looks = lost_looks(place, held.layers.list[i], now)) return *std::move(looks);
    if (auto cells = lost_cells(place, held, level, static_cast<int>(i))) return *std::move(cells);
  }
  if (held.layers.list.size() > level.layers.list.size()) {
    const std::size_t first = level.layers.list.size();
    return lost(place_of("layer", held.layers.list[first].name, first), "was removed, but stays in the map",
                "add it again");
  }
  for (std::size_t i = 0; i < level.layers.groups.size(); ++i) {
    const LayerGroup& now = level.layers.groups[i];
    const std::string place = place_of("group", now.name, i);
    if (i >= held.layers.groups.size())
      return lost(place, "is a group that the map cannot hold", "ungroup its layers");
    if (auto looks = lost_looks(place, held.layers.groups[i], now)) return *std::move(looks);
  }
  return lost("", "has layers in another order than the map can have", "take that back");
}

}  // namespace talus
