// The pixels of tilesets whose pictures are files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <talus/formats/format.h>
#include "../pictures/png_picture.h"

namespace talus {

// A tileset of a level, and what it shows.
struct ShownTileset {
  int tileset = 0;                       // index in Level::tilesets
  TileCut cut = {};                      // of the picture
  const RgbaPicture* picture = nullptr;  // null: numbered boxes
};

// Draws the tiles of these tilesets, in true colour and, for 16-colour tools, in the level's palette. A tile
// of another size than the map's fills its cell. What lies outside of the picture is clear. A sheet that
// would be too large for a picture is an error.
FormatResult<void> draw_tilesets(std::span<const ShownTileset> shown, Level& level);

// The sheet of tiles without the pixels of those of the tilesets that are linked.
Sheet without_linked_pixels(const Level& level, const std::vector<Tileset>& tilesets);

// Reads the pictures of a level's linked tilesets, whose paths become absolute. One that cannot be read is
// missing, and numbered boxes stand for its tiles. A tileset at the end of the sheet gets the rows that its
// picture has more than before. Without a folder of the context nothing is read. Paths that lead out of that
// folder are read by the rules of LinkedFiles, and become FOLDER/../NAME; those that are not read stay as
// they are.
FormatResult<void> read_linked_tilesets(const FormatContext& context, Level& level);

// The path as it stands in a file of that folder: relative, with '/'. Empty if it does not lie below the
// folder.
std::string linked_path_in(const std::string& folder, const std::string& path);
// The path of a link as a file of that folder stores it: the same, or ../NAME for one that was read so from a
// file of that folder, or that was not read. Empty for others: a level that is saved elsewhere gets the
// pixels.
std::string stored_link(const std::string& folder, const std::string& path);

}  // namespace talus
