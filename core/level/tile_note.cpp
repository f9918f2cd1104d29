#include <talus/level/tile_note.h>

#include <utility>

namespace talus {

const TileNote& note_of(const TileNotes& notes, TileNumber tile) {
  static const TileNote kNone;
  const auto found = notes.find(tile);
  return found == notes.end() ? kNone : found->second;
}

void put_note(TileNotes& notes, TileNumber tile, TileNote note) {
  if (note == TileNote())
    notes.erase(tile);
  else
    notes[tile] = std::move(note);
}

std::optional<std::string> problem_of(const TileNotes& notes, int tile_count) {
  std::size_t bytes = 0;
  for (const auto& [tile, note] : notes) {
    const std::string of = "of tile " + std::to_string(tile);
    if (tile >= tile_count)
      return of + " is none of the level's, whose last tile is " + std::to_string(tile_count - 1);
    if (!(note.probability >= 0 && note.probability <= kMaxProbability))
      return of + " has a probability that is not from 0 to 1000000";
    bytes += note.type.size() + note.properties.size();
  }
  if (bytes > kMaxNoteBytes)
    return "have " + std::to_string(bytes) + " bytes of classes and properties, but a level holds at most " +
           std::to_string(kMaxNoteBytes);
  return std::nullopt;
}

}  // namespace talus
