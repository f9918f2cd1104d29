// What a tile says beside its picture, flags and shape: its class, how likely it is, and what its user wrote.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include <talus/collision/shape.h>

namespace talus {

// Of a tile that says something of it.
struct TileNote {
  std::string type = {};        // its class; may be empty
  double probability = 1;       // its weight among tiles that are chosen at random, 0..kMaxProbability
  std::string properties = {};  // JSON object of what its user wrote there, or empty
  friend bool operator==(const TileNote&, const TileNote&) = default;
};

using TileNotes = std::map<TileNumber, TileNote>;  // by tile; none of them equals TileNote()

inline constexpr double kMaxProbability = 1'000'000;  // of a tile
// Bytes of classes and properties of all tiles of a level.
inline constexpr std::size_t kMaxNoteBytes = std::size_t{16} << 20;

// The note of a tile; TileNote() if it has none.
const TileNote& note_of(const TileNotes& notes, TileNumber tile);
// Gives a tile a note; TileNote() removes it.
void put_note(TileNotes& notes, TileNumber tile, TileNote note);

// Why these cannot be the notes of a level with so many tiles: "of tile 3 has a probability of -1, but ...";
// nothing if they can.
std::optional<std::string> problem_of(const TileNotes& notes, int tile_count);

}  // namespace talus
