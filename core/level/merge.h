// Merges a level that was changed in two places, such as the window and the file.
#pragma once

#include <string>
#include <vector>

#include <talus/level/level.h>

namespace talus {

enum class MergeSide { mine, theirs };

struct MergedLevel {
  Level level;
  // What both sides changed, each in another way: "12 cells", "1 shape". Empty: they do not meet.
  std::vector<std::string> conflicts = {};
  // Why the level is one side's as a whole: "the tiles have 16x16 px there, and 8x8 px here". Empty: it was
  // merged part by part.
  std::string apart = {};
};

// What only one side changed since `base` is taken from that side: cell by cell, tile by tile, body by body.
// side: whose state those places get that both changed. The origin of the level is theirs, its chosen layer
// mine. Where the ground lies in its map (see moved_ground.h) is merged in the same way: if only one side
// moved it, what the other one changed moves with it.
MergedLevel merge_levels(const Level& base, const Level& mine, const Level& theirs, MergeSide side);
// The same where all three count cells and px from the same corner.
MergedLevel merge_in_place(const Level& base, const Level& mine, const Level& theirs, MergeSide side);

// The layer of `other` that a layer of `level` is; -1 if there is none. If both have the same names, or not
// the same number of layers, they are found by name; else by their place.
int matching_layer(const Level& level, int layer, const Level& other);

}  // namespace talus
