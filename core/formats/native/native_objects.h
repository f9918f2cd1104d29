// Objects in a native level (see native.h): shapes of tiles, curves and spawns.
//
// Each take_ function takes the members that it knows out of `json`, which must be an object, and leaves the
// others. Its error has its place by key under `path`: "key curves[3].radius". What was read can be used:
// problem_of() finds nothing wrong.
#pragma once

#include "../text/json_text.h"

namespace talus {

// tile: the size of the tiles that it is a shape of.
FormatResult<TileShape> take_shape(Json& json, const std::string& path, TileSize tile);
// Sets the members that differ from their defaults. A shape that take_shape would refuse is an error.
FormatResult<void> put_shape(const TileShape& shape, const std::string& path, TileSize tile, Json& json);

// Reads a list; the unknown keys of each entry go into its `extra`. The ends of a curve must lie on the map.
FormatResult<std::vector<LevelCurve>> take_curves(Json& list, const std::string& path, const TileMap& map);
FormatResult<Json> json_of(const std::vector<LevelCurve>& curves, const std::string& path,
                           const TileMap& map);
FormatResult<Spawn> take_spawn(Json& json, const std::string& path);
FormatResult<Json> json_of(const Spawn& spawn, const std::string& path);
FormatResult<std::vector<Spawn>> take_spawns(Json& list, const std::string& path);
FormatResult<Json> json_of(const std::vector<Spawn>& spawns, const std::string& path);

}  // namespace talus
