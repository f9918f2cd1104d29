#include "tile_animation_tools.h"

#include <algorithm>
#include <utility>

#include "level/single_change.h"

namespace talus {
namespace {

TileAnimation frames_of(const Level& level, TileNumber tile) {
  const TileAnimation* const animation = find_animation(level.animations, tile);
  return animation == nullptr ? TileAnimation() : *animation;
}

bool has_frame(const TileAnimation& frames, int index) {
  return index >= 0 && index < static_cast<int>(frames.size());
}

bool has_tile(const Level& level, TileNumber tile) { return tile < level.tile_count(); }

// The edit that gives a tile these frames; without any, none.
Edit set_animation(const Level& level, TileNumber tile, TileAnimation frames, std::string label) {
  if (!has_tile(level, tile)) return {std::move(label), {}};
  TileAnimations animations = level.animations;
  if (frames.empty())
    animations.erase(tile);
  else
    animations[tile] = std::move(frames);
  return single_change(std::move(label), TileAnimationsChange{level.animations, std::move(animations)});
}

}  // namespace

Edit add_frames(const Level& level, TileNumber tile, const std::vector<TileNumber>& shown) {
  TileAnimation frames = frames_of(level, tile);
  const int duration = frames.empty() ? AnimationFrame().duration : frames.back().duration;
  for (const TileNumber each : shown)
    if (has_tile(level, each)) frames.push_back({each, duration});
  return set_animation(level, tile, std::move(frames), "Add frames of an animation");
}

Edit change_frame(const Level& level, TileNumber tile, int index, AnimationFrame frame) {
  const std::string label = "Change a frame of an animation";
  TileAnimation frames = frames_of(level, tile);
  if (!has_frame(frames, index) || !has_tile(level, frame.tile)) return {label, {}};
  frame.duration = std::clamp(frame.duration, 1, kMaxFrameDuration);
  frames[static_cast<std::size_t>(index)] = frame;
  return set_animation(level, tile, std::move(frames), label);
}

Edit remove_frame(const Level& level, TileNumber tile, int index) {
  const std::string label = "Remove a frame of an animation";
  TileAnimation frames = frames_of(level, tile);
  if (!has_frame(frames, index)) return {label, {}};
  frames.erase(frames.begin() + index);
  return set_animation(level, tile, std::move(frames), label);
}

Edit move_frame(const Level& level, TileNumber tile, int index, int to) {
  const std::string label = "Move a frame of an animation";
  TileAnimation frames = frames_of(level, tile);
  if (!has_frame(frames, index) || !has_frame(frames, to)) return {label, {}};
  const AnimationFrame moved = frames[static_cast<std::size_t>(index)];
  frames.erase(frames.begin() + index);
  frames.insert(frames.begin() + to, moved);
  return set_animation(level, tile, std::move(frames), label);
}

Edit remove_animation(const Level& level, TileNumber tile) {
  return set_animation(level, tile, {}, "Remove an animation");
}

}  // namespace talus
