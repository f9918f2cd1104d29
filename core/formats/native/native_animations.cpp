// Animations of tiles as JSON.
#include "native_animations.h"

#include <utility>

#include "native_members.h"

namespace talus {
namespace {

tl::unexpected<FormatError> animation_error(const std::string& key, std::string message) {
  return tl::unexpected(FormatError{"key " + key, std::move(message)});
}

std::optional<AnimationFrame> frame_of(const Json& json) {
  const bool good = json.is_array() && json.size() == 2 && is_whole(json[0], 0, kMaxTiles - 1) &&
                    is_whole(json[1], 1, kMaxFrameDuration);
  if (!good) return std::nullopt;
  return AnimationFrame{json[0].get<TileNumber>(), json[1].get<int>()};
}

}  // namespace

FormatResult<TileAnimations> take_animations(const Json& json, int tile_count) {
  if (!json.is_object()) return animation_error("animations", "must be an object");
  TileAnimations animations;
  for (const auto& [key, frames] : json.items()) {
    const auto tile = number_of_key(key, kMaxTiles);
    if (!tile) return animation_error("animations", no_tile_text(key));
    const std::string path = "animations." + key;
    if (!frames.is_array() || frames.size() > kMaxAnimationFrames)
      return animation_error(path, "must be a list of frames");
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto frame = frame_of(frames[i]);
      if (!frame)
        return animation_error(path + "[" + std::to_string(i) + "]",
                               "must be a frame [tile, ms] of 1 to 60000 ms");
      animations[static_cast<TileNumber>(*tile)].push_back(*frame);
    }
    if (frames.empty()) return animation_error(path, "must have frames");
  }
  if (auto problem = problem_of(animations, tile_count))
    return animation_error("animations", "has one that cannot be: " + *std::move(problem));
  return animations;
}

FormatResult<Json> json_of(const TileAnimations& animations, int tile_count) {
  if (auto problem = problem_of(animations, tile_count))
    return animation_error("animations", "has one that cannot be: " + *std::move(problem));
  Json json = Json::object();
  for (const auto& [tile, animation] : animations) {
    Json& frames = json[std::to_string(tile)] = Json::array();
    for (const AnimationFrame& frame : animation) frames.push_back({frame.tile, frame.duration});
  }
  return json;
}

}  // namespace talus
