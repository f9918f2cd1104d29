// Reads and writes the tilesets of a native level.
#include "native_tilesets.h"

#include <optional>
#include <utility>

#include "native_members.h"

namespace talus {
namespace {

constexpr std::size_t kMaxLinkPath = 4096;  // bytes

tl::unexpected<FormatError> tileset_error(std::string message) {
  return tl::unexpected(FormatError{"key tilesets", std::move(message)});
}

void take_whole(MemberTaker& take, const char* key, int min, int max, int& value) {
  take.member(key, [&](const Json& json) {
    if (!is_whole(json, min, max)) return take.fail(key, range_text(min, max, "", true));
    value = json.get<int>();
  });
}

void take_two(MemberTaker& take, const char* key, int min, int max, int& x, int& y) {
  take.member(key, [&](const Json& json) {
    const bool good =
        json.is_array() && json.size() == 2 && is_whole(json[0], min, max) && is_whole(json[1], min, max);
    if (!good)
      return take.fail(
          key, "must be two whole numbers from " + std::to_string(min) + " to " + std::to_string(max));
    x = json[0].get<int>(), y = json[1].get<int>();
  });
}

FormatResult<Tileset> take_tileset(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  Tileset set;
  take.optional("name", set.name);
  take.require("first");
  take_whole(take, "first", 0, kMaxTiles - 1, set.first);
  take.require("count");
  take_whole(take, "count", 1, kMaxTiles, set.count);
  take.require("columns");
  take_whole(take, "columns", 1, kMaxSheetSide, set.columns);
  TilesetLink link;
  take.text("image", kMaxLinkPath, link.path);
  if (!link.path.empty()) {
    take_two(take, "tile_size", 1, kMaxTileSide, link.cut.tile.width, link.cut.tile.height);
    take_whole(take, "spacing", 0, kMaxTileGap, link.cut.spacing);
    take_whole(take, "margin", 0, kMaxTileGap, link.cut.margin);
    take_two(take, "offset", -kMaxTileGap, kMaxTileGap, link.cut.offset_x, link.cut.offset_y);
    set.link = std::move(link);
  }
  set.extra = take.rest();
  return take.result(std::move(set));
}

FormatResult<Json> put_tileset(const Tileset& set, const std::string& path) {
  auto parsed = parse_extra(set.extra);
  if (!parsed) return parsed;
  Json& json = *parsed;
  if (!set.name.empty()) json["name"] = set.name;
  json["first"] = set.first;
  json["count"] = set.count;
  json["columns"] = set.columns;
  if (!set.link) return parsed;
  if (set.link->path.empty() || set.link->path.size() > kMaxLinkPath)
    return tl::unexpected(FormatError{"key " + path + ".image", length_text(kMaxLinkPath)});
  const TileCut& cut = set.link->cut;
  json["image"] = set.link->path;
  if (cut.tile != TileSize()) json["tile_size"] = {cut.tile.width, cut.tile.height};
  if (cut.spacing != 0) json["spacing"] = cut.spacing;
  if (cut.margin != 0) json["margin"] = cut.margin;
  if (cut.offset_x != 0 || cut.offset_y != 0) json["offset"] = {cut.offset_x, cut.offset_y};
  return parsed;
}

}  // namespace

FormatResult<std::vector<Tileset>> take_tilesets(Json& list, const SheetLayout& layout) {
  auto sets = take_list<Tileset>(list, "tilesets", take_tileset, kMaxTilesets,
                                 "must be a list of up to 1024 tilesets");
  if (!sets) return sets;
  if (auto problem = problem_of(*sets, layout)) return tileset_error("has an entry, " + *std::move(problem));
  return sets;
}

FormatResult<Json> json_of(const std::vector<Tileset>& tilesets, const SheetLayout& layout) {
  if (auto problem = problem_of(tilesets, layout))
    return tileset_error("has an entry, " + *std::move(problem));
  return put_list(tilesets, "tilesets", put_tileset);
}

}  // namespace talus
