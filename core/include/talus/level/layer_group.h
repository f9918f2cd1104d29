// Groups of the layers of a level, as in Tiled.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/level/tileset.h>

namespace talus {

// Layers that stand together and are shown, hidden, locked and moved together. Its fields mean what those of
// Tiled's groups mean: they join those of the layers in it.
struct LayerGroup {
  std::string name = {};       // for people; may be empty or repeated
  bool visible = true;         // whether its layers are drawn, if they are visible, too
  bool locked = false;         // whether tools leave its layers alone
  double opacity = 1;          // 0..1, multiplies that of its layers
  Vec2 offset = {};            // px, added to that of its layers; each within kMaxLayerOffset
  Vec2 parallax = {1, 1};      // multiplies that of its layers, each within kMaxParallax
  Rgb tint = {255, 255, 255};  // multiplies the colours of its layers
  int group = -1;          // the group that it is in, an index in TileLayers::groups below its own; -1: none
  std::string extra = {};  // JSON object of keys that this version does not know, or empty
  friend bool operator==(const LayerGroup&, const LayerGroup&) = default;
};
// All groups of a level, by their index.
using LayerGroups = std::vector<LayerGroup>;

inline constexpr std::size_t kMaxLayerGroups = 4096;  // of a level
inline constexpr int kMaxGroupDepth = 32;             // of groups in groups

// How a layer or a group looks, by itself or with all groups that it is in. See ObjectLayer for the fields.
struct LayerLooks {
  bool visible = true;         // whether it is drawn; with its groups, if all of them are
  bool locked = false;         // whether tools leave it alone; with its groups, if one of them is locked
  double opacity = 1;          // 0..1
  Vec2 offset = {};            // px, each within kMaxLayerOffset
  Vec2 parallax = {1, 1};      // each within kMaxParallax
  Rgb tint = {255, 255, 255};  // multiplies the colours
  friend bool operator==(const LayerLooks&, const LayerLooks&) = default;
};

}  // namespace talus
