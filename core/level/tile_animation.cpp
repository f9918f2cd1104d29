// Animations of tiles.
#include <talus/level/tile_animation.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace talus {
namespace {

std::optional<std::string> problem_of(const AnimationFrame& frame, int tile_count) {
  if (frame.tile >= tile_count)
    return "has a frame with tile " + std::to_string(frame.tile) + ", but the last tile is " +
           std::to_string(tile_count - 1);
  if (frame.duration < 1 || frame.duration > kMaxFrameDuration)
    return "has a frame of " + std::to_string(frame.duration) + " ms, but it must be 1 to " +
           std::to_string(kMaxFrameDuration);
  return std::nullopt;
}

}  // namespace

const TileAnimation* find_animation(const TileAnimations& animations, TileNumber tile) {
  const auto found = animations.find(tile);
  return found == animations.end() ? nullptr : &found->second;
}

TileNumber tile_shown_at(const TileAnimation& animation, double time) {
  assert(!animation.empty());
  const std::int64_t whole =
      std::accumulate(animation.begin(), animation.end(), std::int64_t{0},
                      [](std::int64_t sum, const AnimationFrame& frame) { return sum + frame.duration; });
  double left = std::fmod(std::max(time, 0.0), static_cast<double>(whole));
  for (const AnimationFrame& frame : animation) {
    if (left < frame.duration) return frame.tile;
    left -= frame.duration;
  }
  return animation.back().tile;
}

std::optional<std::string> problem_of(const TileAnimations& animations, int tile_count) {
  std::size_t frames = 0;
  for (const auto& [tile, animation] : animations) {
    const std::string of = "of tile " + std::to_string(tile);
    if (tile >= tile_count)
      return of + " is none of the level's, whose last tile is " + std::to_string(tile_count - 1);
    if (animation.empty()) return of + " has no frames";
    for (const AnimationFrame& frame : animation) {
      if (auto problem = problem_of(frame, tile_count)) return of + " " + *std::move(problem);
    }
    frames += animation.size();
  }
  if (frames > kMaxAnimationFrames)
    return "have " + std::to_string(frames) + " frames, but a level holds at most " +
           std::to_string(kMaxAnimationFrames);
  return std::nullopt;
}

}  // namespace talus
