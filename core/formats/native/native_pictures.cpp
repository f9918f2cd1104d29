#include "native_pictures.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <set>
#include <utility>

#include "../pictures/png_picture.h"
#include "../text/base64.h"
#include "native_bytes.h"
#include "native_picture.h"

namespace talus {
namespace {

using SharedPicture = std::shared_ptr<const SheetPicture>;

constexpr const char* kRectText = "must be [x, y, width, height] of a part of its picture, in whole px";
constexpr const char* kShiftText = "must be [x, y], whole numbers from -1024 to 1024 px";

// The place of a picture in the list, or of one with the same content: reading a file again makes others.
NativePictures::const_iterator find_picture(const NativePictures& pictures, const SharedPicture& picture) {
  const auto same = std::find(pictures.begin(), pictures.end(), picture);
  if (same != pictures.end()) return same;
  return std::find_if(pictures.begin(), pictures.end(),
                      [&](const SharedPicture& other) { return *other == *picture; });
}

tl::unexpected<FormatError> part_error(std::string place, std::string message) {
  return tl::unexpected(FormatError{std::move(place), std::move(message)});
}

FormatResult<SharedPicture> take_png(Json& lines, const std::string& path, std::size_t& pixels) {
  const auto text = base64_of(lines);
  const auto bytes = text ? decode_base64(*text) : std::nullopt;
  if (!bytes) return part_error("key " + path, "must be a list of strings with a PNG in Base64");
  const auto rgba = read_rgba(*bytes, kMaxSheetPicturePixels);
  if (!rgba) return part_error("key " + path, rgba.error().message);
  pixels += rgba->bytes.size() / 4;
  if (pixels > kMaxPartPixels)
    return part_error("key " + path, "is one picture too many: all together may have " +
                                         std::to_string(kMaxPartPixels) + " px");
  return shared_picture(*rgba);
}

// The whole numbers of a list of that length; nothing if it is another.
template <std::size_t count>
std::optional<std::array<int, count>> whole_numbers(const Json& json) {
  if (!json.is_array() || json.size() != count) return {};
  std::array<int, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    constexpr int kMax = 1 << 20;
    const bool is_good = json[i].is_number_integer() && json[i] >= -kMax && json[i] <= kMax;
    if (!is_good) return {};
    numbers[i] = json[i].get<int>();
  }
  return numbers;
}

FormatResult<LargeTile> take_large_tile(Json& json, const std::string& path, const NativePictures& pictures) {
  MemberTaker take(json, path);
  LargeTile tile;
  take_part(take, pictures, tile.part);
  take.require("size");
  take.member("size", [&](const Json& size) {
    const auto numbers = whole_numbers<2>(size);
    const auto is_side = [](int side) { return side >= 1 && side <= kMaxLargeTileSide; };
    if (!numbers || !is_side((*numbers)[0]) || !is_side((*numbers)[1]))
      return take.fail("size", "must be [width, height], each a whole number from 1 to 4096 px");
    tile.size = {(*numbers)[0], (*numbers)[1]};
  });
  std::optional<std::string> problem;
  if (tile.part.picture == nullptr) problem = "must have a picture";
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no large tile has";
  return take.result(std::move(tile), std::move(problem));
}

}  // namespace

NativePictures pictures_of(const Level& level) {
  NativePictures pictures;
  std::set<SharedPicture> known;
  const auto add = [&](const PicturePart& part) {
    if (part.picture == nullptr || !known.insert(part.picture).second) return;
    if (find_picture(pictures, part.picture) == pictures.end()) pictures.push_back(part.picture);
  };
  for (const auto& [number, tile] : level.large_tiles) add(tile.part);
  for (const ObjectLayer& layer : level.objects) {
    if (layer.image) add(layer.image->part);
    for (const MapObject& object : layer.objects) add(object.picture);
  }
  return pictures;
}

FormatResult<NativePictures> take_pictures(Json& list) {
  std::size_t pixels = 0;
  return take_list<SharedPicture>(
      list, "pictures", [&](Json& json, const std::string& path) { return take_png(json, path, pixels); });
}

FormatResult<Json> json_of(const NativePictures& pictures) {
  return put_list(pictures, "pictures",
                  [](const SharedPicture& picture, const std::string&) { return json_of(*picture); });
}

void take_part(MemberTaker& take, const NativePictures& pictures, PicturePart& part) {
  take.member("picture", [&](const Json& number) {
    if (!is_whole(number, 0, static_cast<std::int64_t>(pictures.size()) - 1))
      return take.fail("picture", "must be the number of one of \"pictures\", from 0");
    part.picture = pictures[number.get<std::size_t>()];
    part.width = part.picture->width;
    part.height = part.picture->height;
  });
  take.member("rect", [&](const Json& its) {
    const auto rect = whole_numbers<4>(its);
    if (rect) part.x = (*rect)[0], part.y = (*rect)[1], part.width = (*rect)[2], part.height = (*rect)[3];
    if (!rect || !is_valid(part)) take.fail("rect", kRectText);
  });
  take.member("shift", [&](const Json& its) {
    const auto shift = whole_numbers<2>(its);
    if (shift) part.shift_x = (*shift)[0], part.shift_y = (*shift)[1];
    if (!shift || !is_valid(part)) take.fail("shift", kShiftText);
  });
  take.optional("keeps_ratio", part.keeps_ratio);
  take.optional("swaps_axes", part.swaps_axes);
  take.optional("mirrors_x", part.mirrors_x);
  take.optional("mirrors_y", part.mirrors_y);
}

void put_part(const PicturePart& part, const NativePictures& pictures, Json& json) {
  if (part.picture == nullptr) return;
  const auto found = find_picture(pictures, part.picture);
  assert(found != pictures.end() && is_valid(part));
  json["picture"] = static_cast<std::size_t>(found - pictures.begin());
  const bool is_whole =
      part.x == 0 && part.y == 0 && part.width == part.picture->width && part.height == part.picture->height;
  if (!is_whole) json["rect"] = {part.x, part.y, part.width, part.height};
  if (part.shift_x != 0 || part.shift_y != 0) json["shift"] = {part.shift_x, part.shift_y};
  if (part.keeps_ratio) json["keeps_ratio"] = true;
  if (part.swaps_axes) json["swaps_axes"] = true;
  if (part.mirrors_x) json["mirrors_x"] = true;
  if (part.mirrors_y) json["mirrors_y"] = true;
}

FormatResult<LargeTiles> take_large_tiles(Json& json, const NativePictures& pictures, int tile_count) {
  if (!json.is_object()) return part_error("key large_tiles", "must be an object");
  LargeTiles tiles;
  for (auto& [key, entry] : json.items()) {
    const auto number = number_of_key(key, tile_count);
    if (!number) return part_error("key large_tiles", no_tile_text(key));
    auto tile = take_large_tile(entry, "large_tiles." + key, pictures);
    if (!tile) return tl::unexpected(tile.error());
    tiles[static_cast<TileNumber>(*number)] = *std::move(tile);
  }
  return tiles;
}

FormatResult<Json> json_of(const LargeTiles& tiles, const NativePictures& pictures) {
  Json json = Json::object();
  for (const auto& [number, tile] : tiles) {
    Json& entry = json[std::to_string(number)] = Json::object();
    put_part(tile.part, pictures, entry);
    entry["size"] = {tile.size.width, tile.size.height};
  }
  return json;
}

}  // namespace talus
