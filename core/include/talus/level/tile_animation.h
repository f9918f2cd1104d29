// Animations of tiles: pictures of other tiles that a tile shows in play, one after another.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

// A picture of an animation.
struct AnimationFrame {
  TileNumber tile = 0;  // whose image is shown
  int duration = 100;   // ms, 1..kMaxFrameDuration
  friend bool operator==(const AnimationFrame&, const AnimationFrame&) = default;
};

using TileAnimation = std::vector<AnimationFrame>;           // not empty; begins anew after the last frame
using TileAnimations = std::map<TileNumber, TileAnimation>;  // by the tile that shows it

inline constexpr int kMaxFrameDuration = 60'000;            // ms
inline constexpr std::size_t kMaxAnimationFrames = 65'536;  // of all animations of a level

// Returns the animation of a tile; null if it has none.
const TileAnimation* find_animation(const TileAnimations& animations, TileNumber tile);

// The tile whose image an animation shows. time: ms since its start; 0 for negative times. The animation must
// not be empty (asserted).
TileNumber tile_shown_at(const TileAnimation& animation, double time);

// Why these cannot be the animations of a level with so many tiles: "of tile 3 has no frames"; nothing if
// they can.
std::optional<std::string> problem_of(const TileAnimations& animations, int tile_count);

}  // namespace talus
