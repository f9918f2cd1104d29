// The parts of a native level that are objects of their own: shapes of tiles, curves and spawns (see
// native.h).
//
// Each take_ function takes the members that it knows out of `json`, which must be an object, leaves the
// others and places its error by key under `path`: "key curves[3].radius". What is read can be used:
// problem_of() says nothing about it.
#pragma once

#include "../text/json_text.h"

namespace talus {

FormatResult<TileShape> take_shape(Json& json, const std::string& path);
// Sets the members that differ from their defaults. A shape that take_shape would refuse is an error.
FormatResult<void> put_shape(const TileShape& shape, const std::string& path, Json& json);

// The lists are read with the unknown keys of each entry in its `extra`. The ends of a curve must lie on the
// map.
FormatResult<std::vector<LevelCurve>> take_curves(Json& list, const std::string& path, const TileMap& map);
FormatResult<Json> json_of(const std::vector<LevelCurve>& curves, const std::string& path,
                           const TileMap& map);
FormatResult<std::vector<Spawn>> take_spawns(Json& list, const std::string& path);
FormatResult<Json> json_of(const std::vector<Spawn>& spawns, const std::string& path);

}  // namespace talus
