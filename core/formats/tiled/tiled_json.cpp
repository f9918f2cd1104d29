// Goes over the JSON once, and keeps the first error.
#include "tiled_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <talus/level/placed_picture.h>
#include "../import/hex_color.h"
#include "../text/utf8_text.h"
#include "tiled_cells.h"
#include "tiled_chunks.h"
#include "tiled_node.h"
#include "tiled_object_layers.h"

namespace talus {
namespace {

constexpr std::size_t kMaxPath = 4096;  // bytes; a map may name one file many times, each with its picture's
bool is_long_path(const std::string& path) { return path.size() > kMaxPath && !is_data_name(path); }
std::string long_path() {
  return "names a picture by a path of more than " + std::to_string(kMaxPath) + " bytes";
}

// Whether the data of a layer has no cells, which Tiled takes for empty ones.
bool has_no_cells(const Json& data) {
  if (data.is_null()) return true;
  if (!data.is_string()) return data.is_array() && data.empty();
  return data.get_ref<const std::string&>().find_first_not_of(" \t\r\n") == std::string::npos;
}

// Counts the tile layers in a map or group, which is at most kMaxJsonDepth deep. Values other than lists and
// objects have none.
std::size_t tile_layers_in(const Json& json) {
  const auto layers = json.is_object() ? json.find("layers") : json.end();
  if (layers == json.end()) return 0;
  std::size_t count = 0;
  for (const Json& layer : *layers) {
    const bool has_tiles = layer.is_object() && layer.contains("type") && layer["type"] == "tilelayer";
    count += has_tiles ? 1 : tile_layers_in(layer);
  }
  return count;
}

// Where the position of a tile's object is in its box. Without a word, it is at the bottom left.
Vec2 anchor_of(std::string_view alignment) {
  if (alignment.empty() || alignment == "unspecified") return {0, 1};
  const auto says = [&](std::string_view word) { return alignment.find(word) != alignment.npos; };
  return {says("left") ? 0 : says("right") ? 1 : 0.5, says("top") ? 0 : says("bottom") ? 1 : 0.5};
}

RenderOrder render_order_of(std::string_view word) {
  const auto found = std::find(kRenderOrders.begin(), kRenderOrders.end(), word);
  return found == kRenderOrders.end() ? RenderOrder()
                                      : static_cast<RenderOrder>(found - kRenderOrders.begin());
}

class TiledReader : private TiledNodeReader {
 public:
  TiledReader(const FindTiledTemplate& find_template, ImportDrops& drops)
      : TiledNodeReader(drops), find_template_(find_template) {}

  TiledMap map(const Json& json, const TiledFrame* frame, const Progress& progress);
  TiledTileset tileset(const JsonNode& node);

  using TiledNodeReader::result;

 private:
  bool check_map(const JsonNode& node);
  TileSize tile_size(const JsonNode& node, int most);
  // What layers are in.
  struct Inside {
    int group = -1;                      // index in TiledMap::groups; -1: the map
    int depth = 0;                       // of the groups around them
    std::optional<bool> is_ground = {};  // what layers are that do not say it; nothing: their names tell
  };
  void layers(const JsonNode& node, const Inside& inside, const Progress& progress, TiledMap& map);
  void group(const JsonNode& node, const TiledLayer& group, const Inside& inside, const Progress& progress,
             TiledMap& map);
  void take_looks(const JsonNode& node, const Inside& inside, TiledLayer& layer);
  void tile_layer(const JsonNode& node, const TiledMap& map, TiledLayer& layer);
  std::vector<TiledChunk> chunks_of(const JsonNode& node, TileSize usual);
  std::optional<TiledChunk> chunk(const JsonNode& layer, const JsonNode& node, TileSize usual);
  // The data of a layer or a chunk, in the encoding of the layer.
  std::vector<std::uint32_t> cells(const JsonNode& node, const JsonNode& layer, std::size_t count);
  TiledImage image(const JsonNode& node);
  std::vector<TiledObject> objects(const JsonNode& node);
  TiledObject object(const JsonNode& node);
  std::optional<Json> templated(const JsonNode& node);
  std::uint32_t gid(const JsonNode& node);
  std::vector<Vec2> points(const JsonNode& node, const char* key);
  void points_of_text(const JsonNode& node, const char* key, std::string_view text,
                      std::vector<Vec2>& points);
  bool has_room_for_point(const JsonNode& node, const char* key);
  TiledTile tile(const JsonNode& node);
  bool tiles_have_images(const JsonNode& node);
  bool has_no_tiles(const JsonNode& node);
  void add_to_collection(const JsonNode& node, TiledTileset& tileset);
  TiledProperties properties(const JsonNode& node, const std::string& of);
  std::optional<TiledProperty> property(const JsonNode& node);

  const FindTiledTemplate& find_template_;
  std::size_t objects_ = 0, layers_ = 0, points_ = 0, frames_ = 0;  // read so far
  bool is_infinite_ = false;
  TiledChunks chunks_;                         // of an infinite map
  std::size_t chunk_cells_ = 0;                // of all of them
  std::map<std::string, std::uint32_t> gids_;  // of the map's tilesets, by the paths of their files
  std::size_t templated_bytes_ = 0;            // of templates, once for each object
};

TiledMap TiledReader::map(const Json& json, const TiledFrame* frame, const Progress& progress) {
  const JsonNode node{json, ""};
  TiledMap map;
  if (!json.is_object()) {
    fail(node, "", "is not a Tiled map");
    return map;
  }
  if (!check_map(node)) return map;
  is_infinite_ = truth(node, "infinite");
  const int least = is_infinite_ ? 0 : 1;  // an infinite map has the size of its chunks
  map.width = std::max(1, whole(node, "width", least, kMaxTerrainSide, least));
  map.height = std::max(1, whole(node, "height", least, kMaxTerrainSide, least));
  if (!error_ && !is_terrain_size(map.width, map.height)) {
    fail(node, "width",
         "has " + std::to_string(map.width) + "x" + std::to_string(map.height) +
             " cells, but a level has at most 16777216");
  }
  const std::size_t layer_count = tile_layers_in(json);
  const auto cell_count = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  if (!error_ && !is_infinite_ && layer_count * cell_count > kMaxTiledCells) {
    fail(node, "layers",
         "has " + std::to_string(layer_count) + " layers of " + std::to_string(map.width) + "x" +
             std::to_string(map.height) + " tiles, but all layers of a map may have at most " +
             std::to_string(kMaxTiledCells) + " cells together");
  }
  map.tile_size = tile_size(node, kMaxTileSide);
  if (!error_ && !is_terrain_size(map.width, map.height, map.tile_size))
    fail(node, "width", "is longer than 16777216 px, the most that a level has");
  map.properties = properties(node, "the map");
  map.background = text(node, "backgroundcolor");
  map.order = render_order_of(text(node, "renderorder"));
  for_each(node, "tilesets", [&](const JsonNode& entry) {
    if (map.tilesets.size() == kMaxTiledTilesets)
      return fail(entry, "", tiled_too_many("tileset", kMaxTiledTilesets));
    map.tilesets.push_back(tileset(entry));
    const TiledTileset& added = map.tilesets.back();
    if (!added.source.empty()) gids_.try_emplace(tiled_path("", added.source), added.first_gid);
  });
  if (!error_) layers(node, {}, progress, map);
  if (!error_ && is_infinite_) {
    chunks_.resize(map.layers.size());
    if (auto problem = join_chunks(std::move(chunks_), frame, map)) fail(node, "layers", *std::move(problem));
  }
  const bool has_ground = std::any_of(map.layers.begin(), map.layers.end(),
                                      [](const TiledLayer& layer) { return layer.has_tiles; });
  if (!error_ && !has_ground) {  // a map of objects and pictures alone
    map.layers.emplace_back().has_tiles = true;
    map.layers.back().cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                                   0);
  }
  choose_tile_ground(map);
  drop_others(
      node, "the map",
      {"compressionlevel", "nextlayerid",    "nextobjectid",   "tiledversion", "version",      "type",
       "renderorder",      "editorsettings", "orientation",    "infinite",     "width",        "height",
       "tilewidth",        "tileheight",     "hexsidelength",  "staggeraxis",  "staggerindex", "properties",
       "tilesets",         "layers",         "backgroundcolor"});
  return map;
}

bool TiledReader::check_map(const JsonNode& node) {
  const Json* layers = node.find("layers");
  const std::string orientation = text(node, "orientation");
  if (orientation.empty() || (layers == nullptr && !node.find("tilewidth")))
    fail(node, "", "is not a Tiled map");
  else if (orientation != "orthogonal")
    fail(node, "orientation", "has the orientation " + quoted_name(orientation) + ", but must be orthogonal");
  return !error_;
}

TileSize TiledReader::tile_size(const JsonNode& node, int most) {
  const double width = number(node, "tilewidth"), height = number(node, "tileheight");
  const auto is_side = [&](double side) { return side >= 1 && side <= most && side == std::floor(side); };
  if (is_side(width) && is_side(height)) return {static_cast<int>(width), static_cast<int>(height)};
  fail(node, "tilewidth",
       "has tiles of " + json_number(width).dump() + "x" + json_number(height).dump() + " px, but a " +
           (most == kMaxTileSide ? "level" : "tileset") + " needs tiles of 1 to " + std::to_string(most) +
           " px a side");
  return {};
}

// Numbers out of a level's range are brought into it.
void TiledReader::take_looks(const JsonNode& node, const Inside& inside, TiledLayer& layer) {
  const auto near_zero = [](Vec2 v, double most) {
    return Vec2{std::clamp(v.x, -most, most), std::clamp(v.y, -most, most)};
  };
  TileLayer& looks = layer.looks;
  looks.group = inside.group;
  looks.name = text(node, "name");
  looks.visible = node.find("visible") == nullptr || truth(node, "visible");
  looks.locked = truth(node, "locked");
  looks.opacity = std::clamp(number(node, "opacity", 1), 0.0, 1.0);
  // Pictures of old maps have x and y, which count, as in Tiled, where there is no offset.
  const bool has_offset = node.find("offsetx") != nullptr || node.find("offsety") != nullptr;
  const bool is_old = text(node, "type") == "imagelayer" && !has_offset;
  looks.offset = near_zero({number(node, is_old ? "x" : "offsetx"), number(node, is_old ? "y" : "offsety")},
                           kMaxLayerOffset);
  looks.parallax = near_zero({number(node, "parallaxx", 1), number(node, "parallaxy", 1)}, kMaxParallax);
  const std::string tint = text(node, "tintcolor");
  if (const auto rgb = color_of_hex(tint)) {  // Tiled 1.8 draws a clear tint both darker and clearer
    const double opacity = opacity_of_hex(tint);
    const auto darker = [&](int c) { return static_cast<std::uint8_t>(std::lround(c * opacity)); };
    looks.tint = {darker(rgb->r), darker(rgb->g), darker(rgb->b)};
    looks.opacity *= opacity;
  }
  layer.says_ground = ground_by_word(properties(node, "the layer " + quoted_name(looks.name)));
  if (!layer.says_ground) layer.says_ground = inside.is_ground;
}

void TiledReader::group(const JsonNode& node, const TiledLayer& group, const Inside& inside,
                        const Progress& progress, TiledMap& map) {
  const TileLayer& looks = group.looks;
  if (inside.depth == kMaxGroupDepth) return fail(node, "", "is nested too deep in groups");
  const Inside within{static_cast<int>(map.groups.size()), inside.depth + 1, group.says_ground};
  map.groups.push_back({.name = looks.name,
                        .visible = looks.visible,
                        .locked = looks.locked,
                        .opacity = looks.opacity,
                        .offset = looks.offset,
                        .parallax = looks.parallax,
                        .tint = looks.tint,
                        .group = inside.group});
  layers(node, within, progress, map);
}

void TiledReader::layers(const JsonNode& node, const Inside& inside, const Progress& progress,
                         TiledMap& map) {
  const Json* const all = node.find("layers");
  const double part = 1.0 / static_cast<double>(all == nullptr ? 1 : std::max<std::size_t>(all->size(), 1));
  double done = 0;
  for_each(node, "layers", [&](const JsonNode& entry) {
    const Progress of_entry = progress.part(done, done + part);
    done += part;
    if (!of_entry.at(0)) {
      error_ = was_cancelled().value();
      return;
    }
    if (++layers_ > kMaxTiledLayers) return fail(entry, "", tiled_too_many("layer", kMaxTiledLayers));
    const std::string type = text(entry, "type");
    TiledLayer layer;
    layer.name = text(entry, "name");
    const std::string of = "the layer " + quoted_name(layer.name);
    take_looks(entry, inside, layer);
    if (entry.find("class")) layer.type = text(entry, "class");
    drop_others(entry, of,
                {"id",        "class",    "name",        "type",        "visible",          "locked",
                 "width",     "height",   "offsetx",     "offsety",     "draworder",        "color",
                 "data",      "encoding", "compression", "objects",     "layers",           "properties",
                 "chunks",    "startx",   "starty",      "opacity",     "tintcolor",        "parallaxx",
                 "parallaxy", "image",    "imagewidth",  "imageheight", "transparentcolor", "x",
                 "y",         "repeatx",  "repeaty"});
    if (type == "group") return group(entry, layer, inside, of_entry, map);
    if (type == "tilelayer") {
      tile_layer(entry, map, layer);
    } else if (type == "objectgroup") {
      layer.type = text(entry, class_key(entry));
      layer.properties = properties(entry, of);
      layer.objects = objects(entry);
      layer.by_y = text(entry, "draworder") != "index";
    } else {
      layer.image = image(entry);
    }
    map.layers.push_back(std::move(layer));
  });
}

void TiledReader::tile_layer(const JsonNode& node, const TiledMap& map, TiledLayer& layer) {
  layer.has_tiles = true;
  std::vector<TiledChunk> chunks = chunks_of(node, {map.width, map.height});
  if (error_) return;
  if (is_infinite_) {
    chunks_.resize(map.layers.size());
    chunks_.push_back(std::move(chunks));
    return;
  }
  if (has_tiles_off(chunks, map)) drops_.add("the tiles off the map in the layer " + quoted_name(layer.name));
  layer.cells = cells_of_chunks(std::move(chunks), map);
}

// usual: the size of a layer that does not say it, cells.
std::vector<TiledChunk> TiledReader::chunks_of(const JsonNode& node, TileSize usual) {
  std::vector<TiledChunk> chunks;
  const auto take = [&](std::optional<TiledChunk> chunk) {
    if (chunk) chunks.push_back(*std::move(chunk));
  };
  const Json* data = node.find("data");
  if (data != nullptr && !has_no_cells(*data)) take(chunk(node, node, usual));  // a layer is one, too
  for_each(node, "chunks", [&](const JsonNode& entry) { take(chunk(node, entry, {1, 1})); });
  return chunks;
}

// node: a chunk of the layer, or the layer itself.
std::optional<TiledChunk> TiledReader::chunk(const JsonNode& layer, const JsonNode& node, TileSize usual) {
  TiledChunk chunk;
  if (is_infinite_ || &layer.json != &node.json) {  // layers of finite maps are at (0, 0)
    chunk.x = whole(node, "x", -kMaxTiledChunkPlace, kMaxTiledChunkPlace, 0);
    chunk.y = whole(node, "y", -kMaxTiledChunkPlace, kMaxTiledChunkPlace, 0);
  }
  chunk.width = whole(node, "width", 1, kMaxTerrainSide, usual.width);
  chunk.height = whole(node, "height", 1, kMaxTerrainSide, usual.height);
  const auto count = static_cast<std::size_t>(chunk.width) * static_cast<std::size_t>(chunk.height);
  chunk_cells_ += count;
  if (chunk_cells_ > kMaxTiledCells) {
    fail(node, "",
         "is one chunk too many: all layers of a map may have at most " + std::to_string(kMaxTiledCells) +
             " cells together");
  }
  if (error_) return {};
  chunk.cells = cells(node, layer, count);
  if (error_) return {};
  return chunk;
}

std::vector<std::uint32_t> TiledReader::cells(const JsonNode& node, const JsonNode& layer,
                                              std::size_t count) {
  const Json* data = node.find("data");
  std::vector<std::uint32_t> cells;
  if (data == nullptr || has_no_cells(*data)) {
    cells.assign(count, 0);
  } else if (data->is_string()) {
    auto decoded = decode_tiled_cells(data->get_ref<const std::string&>(), text(layer, "encoding"),
                                      text(layer, "compression"), count);
    if (!decoded) fail(node, "data", decoded.error());
    if (decoded) cells = std::move(*decoded);
  } else if (!data->is_array() || data->size() != count) {
    fail(node, "data", tiled_count_problem(data->is_array() ? data->size() : 0, count));
  } else {
    for (const Json& cell : *data) {
      const std::int64_t number = cell.is_number_integer() ? cell.get<std::int64_t>() : -1;
      const bool fits = number >= 0 && number <= std::numeric_limits<std::uint32_t>::max();
      if (!fits) {
        fail(node, "data", "must have a number as cell " + std::to_string(cells.size() + 1));
        break;
      }
      cells.push_back(static_cast<std::uint32_t>(number));
    }
  }
  return cells;
}

TiledImage TiledReader::image(const JsonNode& node) {
  TiledImage image;
  image.path = text(node, "image");
  if (is_long_path(image.path)) fail(node, "image", long_path());
  image.transparent = color_of_hex(text(node, "transparentcolor"));
  image.repeats_x = truth(node, "repeatx");
  image.repeats_y = truth(node, "repeaty");
  return image;
}

std::vector<TiledObject> TiledReader::objects(const JsonNode& node) {
  std::vector<TiledObject> all;
  for_each(node, "objects", [&](const JsonNode& entry) {
    if (++objects_ > kMaxTiledObjects) return fail(entry, "", tiled_too_many("object", kMaxTiledObjects));
    const auto joined = templated(entry);
    if (!error_) all.push_back(object(joined ? JsonNode{*joined, entry.path} : entry));
  });
  return all;
}

// The object with what its template says; nothing if it has none that can be read.
std::optional<Json> TiledReader::templated(const JsonNode& node) {
  const std::string name = text(node, "template");
  if (name.empty()) return {};
  const auto found = find_template_(name);
  if (!found) {
    drops_.add("the template of an object, " + found.error().place + ": " + found.error().message);
    return {};
  }
  const TiledTemplate& from = **found;
  templated_bytes_ += from.bytes;
  if (templated_bytes_ > kMaxTiledTemplatedBytes) {
    fail(node, "template",
         "takes too much from templates: all objects may take up to " +
             std::to_string(kMaxTiledTemplatedBytes >> 20) + " MiB together");
    return {};
  }
  const auto tileset = gids_.find(from.tileset);
  return with_template(node.json, from, tileset == gids_.end() ? 0 : tileset->second);
}

TiledObject TiledReader::object(const JsonNode& node) {
  TiledObject object;
  object.name = text(node, "name");
  object.type = text(node, class_key(node));
  object.position = {number(node, "x"), number(node, "y")};
  object.size = {number(node, "width"), number(node, "height")};
  object.rotation = number(node, "rotation");
  object.visible = node.find("visible") == nullptr || truth(node, "visible");
  object.properties = properties(node, "an object");
  drop_others(
      node, "an object",
      {"id", "name", "type", "class", "x", "y", "width", "height", "rotation", "visible", "properties",
       "point", "polygon", "polyline", "ellipse", "text", "gid", "template", "capsule"});
  const Keys others = {"text", "capsule"};
  if (node.find("polygon")) {
    object.form = TiledObject::Form::polygon;
    object.points = points(node, "polygon");
  } else if (node.find("polyline")) {
    object.form = TiledObject::Form::polyline;
    object.points = points(node, "polyline");
  } else if (node.find("gid")) {
    object.form = TiledObject::Form::tile;
    object.gid = gid(node);
  } else if (node.find("ellipse")) {
    object.form = TiledObject::Form::ellipse;
  } else if (std::any_of(others.begin(), others.end(), [&](auto key) { return node.find(key) != nullptr; })) {
    object.form = TiledObject::Form::other;
  }
  return object;
}

std::uint32_t TiledReader::gid(const JsonNode& node) {
  constexpr double kMax = std::numeric_limits<std::uint32_t>::max();
  const double value = number(node, "gid");
  if (value >= 0 && value <= kMax && value == std::trunc(value)) return static_cast<std::uint32_t>(value);
  fail(node, "gid", "must have a number of a tile as gid");
  return 0;
}

std::vector<Vec2> TiledReader::points(const JsonNode& node, const char* key) {
  std::vector<Vec2> points;
  const Json* list = node.find(key);
  if (list != nullptr && list->is_string()) {
    points_of_text(node, key, list->get_ref<const std::string&>(), points);
    return points;
  }
  for_each(node, key, [&](const JsonNode& point) {
    if (has_room_for_point(point, "")) points.push_back({number(point, "x"), number(point, "y")});
  });
  return points;
}

// "0,8 16,0.5", as in XML.
void TiledReader::points_of_text(const JsonNode& node, const char* key, std::string_view text,
                                 std::vector<Vec2>& points) {
  const auto coordinate = [&](std::string_view digits) {
    double number = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = problem == std::errc() && end == digits.data() + digits.size();
    if (!is_number || !std::isfinite(number))
      fail(node, key, "must have two numbers for each point of its " + std::string(key));
    return number;
  };
  while (!text.empty() && !error_) {
    const std::string_view pair = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), pair.size() + 1));
    if (pair.empty() || !has_room_for_point(node, key)) continue;
    const std::size_t comma = pair.find(',');
    const double x = coordinate(pair.substr(0, comma));
    points.push_back({x, coordinate(comma == pair.npos ? "" : pair.substr(comma + 1))});
  }
}

bool TiledReader::has_room_for_point(const JsonNode& node, const char* key) {
  if (++points_ > kMaxTiledPoints) fail(node, key, tiled_too_many("point", kMaxTiledPoints));
  return !error_;
}

TiledTileset TiledReader::tileset(const JsonNode& node) {
  constexpr int kMax = 1 << 20, kMaxSpace = 1024;  // px; products of them fit an int
  constexpr std::size_t kMaxName = 200;            // bytes; a map may name one file many times
  TiledTileset tileset;
  if (!node.json.is_object()) {
    fail(node, "", "is not a Tiled tileset");
    return tileset;
  }
  tileset.first_gid =
      static_cast<std::uint32_t>(whole(node, "firstgid", 1, static_cast<int>(kTiledIdBits), 1));
  tileset.source = text(node, "source");
  if (!tileset.source.empty()) return tileset;
  const std::string name = text(node, "name");
  const std::string of = "the tileset " + quoted_name(name);
  tileset.name = shortened(name, kMaxName);
  tileset.is_collection = tiles_have_images(node) || has_no_tiles(node);
  if (!tileset.is_collection) tileset.tile_size = tile_size(node, kMaxTiledTileSide);
  tileset.image = text(node, "image");
  if (is_long_path(tileset.image)) fail(node, "image", long_path());
  tileset.image_width = whole(node, "imagewidth", 0, kMax, 0);
  tileset.image_height = whole(node, "imageheight", 0, kMax, 0);
  tileset.columns = whole(node, "columns", 0, kMax, 0);
  tileset.tile_count = whole(node, "tilecount", 0, kMax, 0);
  tileset.spacing = whole(node, "spacing", 0, kMaxSpace, 0);
  tileset.margin = whole(node, "margin", 0, kMaxSpace, 0);
  if (const Json* offset = node.find("tileoffset"); offset != nullptr && offset->is_object()) {
    const JsonNode place{*offset, node.path_of("tileoffset")};
    tileset.offset_x = whole(place, "x", -kMaxSpace, kMaxSpace, 0);
    tileset.offset_y = whole(place, "y", -kMaxSpace, kMaxSpace, 0);
  }
  tileset.transparent = color_of_hex(text(node, "transparentcolor"));
  tileset.fits_grid = text(node, "tilerendersize") == "grid";
  tileset.keeps_ratio = text(node, "fillmode") == "preserve-aspect-fit";
  tileset.anchor = anchor_of(text(node, "objectalignment"));
  properties(node, of);
  for_each(node, "tiles", [&](const JsonNode& entry) {
    tileset.tiles->push_back(tile(entry));
    if (tileset.is_collection) add_to_collection(entry, tileset);
  });
  std::stable_sort(tileset.tiles->begin(), tileset.tiles->end(),
                   [](const TiledTile& a, const TiledTile& b) { return a.id < b.id; });
  drop_others(node, of, {"firstgid",        "name",           "type",
                         "version",         "tiledversion",   "tilewidth",
                         "tileheight",      "image",          "imagewidth",
                         "imageheight",     "columns",        "tilecount",
                         "spacing",         "margin",         "tiles",
                         "properties",      "editorsettings", "grid",
                         "objectalignment", "tilerendersize", "fillmode",
                         "transformations", "tileoffset",     "transparentcolor"});
  return tileset;
}

// A collection from which all tiles were removed.
bool TiledReader::has_no_tiles(const JsonNode& node) {
  bool has_tile = false;
  for_each(node, "tiles", [&](const JsonNode&) { has_tile = true; });
  return !has_tile && text(node, "image").empty() && node.find("tilewidth") != nullptr &&
         number(node, "tilewidth") == 0 && number(node, "tileheight") == 0;
}

bool TiledReader::tiles_have_images(const JsonNode& node) {
  bool found = false;
  for_each(node, "tiles", [&](const JsonNode& entry) { found = found || entry.find("image") != nullptr; });
  return found && text(node, "image").empty();
}

// The last tile of the set was read from the node.
void TiledReader::add_to_collection(const JsonNode& node, TiledTileset& tileset) {
  constexpr int kMax = kMaxTiledTileSide;
  TiledTile& tile = tileset.tiles->back();
  tile.image = text(node, "image");
  if (is_long_path(tile.image)) fail(node, "image", long_path());
  tile.image_x = whole(node, "x", 0, kMax, 0);
  tile.image_y = whole(node, "y", 0, kMax, 0);
  tile.image_size.width = whole(node, "width", 0, kMax, whole(node, "imagewidth", 0, 1 << 20, 0));
  tile.image_size.height = whole(node, "height", 0, kMax, whole(node, "imageheight", 0, 1 << 20, 0));
  tileset.tile_size = {std::max(tileset.tile_size.width, tile.image_size.width),
                       std::max(tileset.tile_size.height, tile.image_size.height)};
  tileset.tile_count = std::max(tileset.tile_count, tile.id + 1);  // some ids may have no tile
}

TiledTile TiledReader::tile(const JsonNode& node) {
  TiledTile tile;
  tile.id = whole(node, "id", 0, 1 << 20, 0);
  tile.type = text(node, class_key(node));
  tile.probability = std::clamp(number(node, "probability", 1), 0.0, kMaxProbability);
  tile.properties = properties(node, "a tile");
  if (const Json* group = node.find("objectgroup"); group != nullptr && group->is_object())
    tile.objects = objects({*group, node.path_of("objectgroup")});
  for_each(node, "animation", [&](const JsonNode& entry) {
    if (++frames_ > kMaxAnimationFrames) return fail(entry, "", tiled_too_many("frame", kMaxAnimationFrames));
    tile.animation.push_back({whole(entry, "tileid", 0, 1 << 20, 0),
                              whole(entry, "duration", 0, 1 << 30, AnimationFrame().duration)});
  });
  drop_others(node, "a tile",
              {"id", "type", "class", "probability", "objectgroup", "properties", "animation", "image",
               "imagewidth", "imageheight", "x", "y", "width", "height"});
  return tile;
}

// `of`: the owner of properties that mean nothing to a level. What tiles and objects drop is said where the
// level is made.
TiledProperties TiledReader::properties(const JsonNode& node, const std::string& of) {
  TiledProperties all;
  const bool are_read = of == "a tile" || of == "an object" || of == "the map";
  for_each(node, "properties", [&](const JsonNode& entry) {
    const std::string name = text(entry, "name");
    auto read = property(entry);
    const bool is_of_ground =
        std::find(kTiledGroundWords.begin(), kTiledGroundWords.end(), name) != kTiledGroundWords.end() &&
        of.starts_with("the layer ");
    const bool is_kept =
        read && (is_of_ground || (are_read && (of != "the map" || name == kTiledLevelProperty ||
                                               name == kTiledObjectsProperty)));
    if (is_kept)
      all.push_back(std::move(*read));
    else
      drops_.add("the property " + quoted_name(name) + " of " + of);
  });
  return all;
}

std::optional<TiledProperty> TiledReader::property(const JsonNode& node) {
  const std::string name = text(node, "name");
  const Json* value = node.find("value");
  if (value == nullptr) return {};
  if (value->is_boolean()) return TiledProperty{name, value->get<bool>()};
  if (value->is_string()) return TiledProperty{name, value->get<std::string>()};
  const bool is_large = value->is_number_unsigned() && *value > std::numeric_limits<std::int64_t>::max();
  if (value->is_number_integer() && !is_large) return TiledProperty{name, value->get<std::int64_t>()};
  if (value->is_number()) return TiledProperty{name, value->get<double>()};
  return {};
}

}  // namespace

FormatResult<TiledMap> read_tiled_map(const Json& json, const FindTiledTemplate& find_template,
                                      const TiledFrame* frame, ImportDrops& drops, const Progress& progress) {
  TiledReader reader(find_template, drops);
  TiledMap map = reader.map(json, frame, progress);
  return reader.result(std::move(map));
}

FormatResult<TiledTileset> read_tiled_tileset(const Json& json, const FindTiledTemplate& find_template,
                                              ImportDrops& drops) {
  TiledReader reader(find_template, drops);
  TiledTileset tileset = reader.tileset({json, ""});
  return reader.result(std::move(tileset));
}

}  // namespace talus
