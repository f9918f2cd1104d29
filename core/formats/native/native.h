// Talus's own levels, `.talus.json`: JSON that people can read, and that diffs row by row.
// docs/native-format.md lists all keys with their types, limits, defaults and versions;
// assets/talus.schema.json is its JSON schema. Both change with the readers: tests/games/schema_test compares
// the three.
//
// With the member "companion" a file is not a level, but what a cart's level has beyond the cart (see
// companion.h).
//
// Unknown keys are kept (see unknown_keys.h), except in objects that have no place for them, such as the
// chunks of "cart", where they are errors. A value outside of its range, or of another type, is an error with
// its place; so is a shape or curve that cannot be used (see problem_of in collision/shape.h and
// level/level.h). What a reader would refuse is not written. Keys that came after the first version are
// written only if they are not the default, so that older files keep their bytes.
#pragma once

#include <talus/formats/format.h>

namespace talus {

// The version of a level is the lowest that has what it holds, as older programs could not read it otherwise.
inline constexpr int kNativeVersion = 8;  // of levels with a background
inline constexpr int kGroupVersion = 7;   // of levels without, but with groups of layers
// Of levels without these, but with flags above 7, turned tiles, notes of tiles, pictures besides the
// sheet's, or objects that are hidden or have other anchors.
inline constexpr int kNoteVersion = 6;
inline constexpr int kTilesetVersion = 5;  // of levels without, but with tilesets or layers of objects
inline constexpr int kLayerVersion = 4;    // of levels without, but with layers of tiles
// Of levels without all of these, but with another sheet, a picture in true colour, polygons or groups.
inline constexpr int kSheetVersion = 3;
inline constexpr int kTileSizeVersion = 2;  // of levels with none of that, but tiles of other than 8x8 px

bool accepts_native(std::string_view bytes, const FormatContext& context);
FormatResult<Level> read_native(std::string_view bytes, const FormatContext& context);
FormatResult<WrittenLevel> write_native(const Level& level, const FormatContext& context);

}  // namespace talus
