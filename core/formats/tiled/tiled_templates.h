// Templates of objects, `.tx` and `.tj`: what an object takes from its template.
#pragma once

#include <functional>

#include "../text/json_text.h"
#include "tiled_map.h"

namespace talus {

struct TiledTemplate {
  Json object;                 // as in a map; `gid` is a number of its own tileset
  std::string tileset;         // path of that tileset's file, see tiled_path; empty: it has none
  std::int64_t first_gid = 1;  // of that tileset in the template
  std::size_t bytes = 0;       // of its file
};

// Returns the template of a path as an object of the map names it, or why there is none. It lives as long as
// the function.
using FindTiledTemplate = std::function<FormatResult<const TiledTemplate*>(const std::string& path)>;

// Limits for the templates of one map.
inline constexpr std::size_t kMaxTiledTemplates = 4096;                        // different files
inline constexpr std::size_t kMaxTiledTemplateBytes = std::size_t{1} << 20;    // of one file
inline constexpr std::size_t kMaxTiledTemplatedBytes = std::size_t{64} << 20;  // in all objects together

// json: the file, from TJ or as tiled_xml.h makes it of TX. folder: of the template, from that of the map.
// The number of bytes is not set.
FormatResult<TiledTemplate> read_tiled_template(const Json& json, const std::string& folder);

// Returns the object with all that it does not say itself from the template; of properties with one name it
// keeps its own. first_gid: of the template's tileset in the map; 0: the map does not have it, so that a tile
// that comes from the template has no number.
Json with_template(const Json& object, const TiledTemplate& from, std::uint32_t first_gid);

}  // namespace talus
