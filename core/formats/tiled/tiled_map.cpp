// Paths and colours in Tiled's notation.
#include "tiled_map.h"

#include <algorithm>
#include <filesystem>

#include "../import/hex_color.h"

namespace talus {

std::string tiled_path(const std::string& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return (std::filesystem::path(folder) / name).lexically_normal().string();
}

bool is_solid_by_word(const TiledProperties& properties) {
  return std::any_of(kTiledSolidWords.begin(), kTiledSolidWords.end(), [&](std::string_view word) {
    const bool* const value = find_property<bool>(properties, word);
    return value != nullptr && *value;
  });
}

std::optional<bool> ground_by_word(const TiledProperties& properties) {
  std::optional<bool> is_ground;
  for (const std::string_view word : kTiledGroundWords)
    if (const bool* const value = find_property<bool>(properties, word)) is_ground = *value;
  return is_ground;
}

std::string tiled_color(Rgb color) { return hex_of({color.r, color.g, color.b, 255}); }

std::string tiled_background(const Level& level) {
  const Rgba color = background_of(level);
  return color.a == 0 ? "" : hex_of(color);
}

std::string tiled_too_many(std::string_view thing, std::size_t most) {
  return "is one " + std::string(thing) + " too many: a map may have at most " + std::to_string(most);
}

}  // namespace talus
