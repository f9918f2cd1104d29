// Differences of documents, of lists, of cells and of pictures.
#include "ldtk_additions.h"

#include <algorithm>
#include <map>

#include <talus/level/limits.h>
#include "../native/native.h"
#include "../native/native_bytes.h"
#include "../native/native_document.h"
#include "../native/native_groups.h"
#include "../native/native_layers.h"
#include "../native/native_object_layers.h"
#include "../native/native_turns.h"
#include "../text/base64.h"
#include "../text/unpack.h"
#include "ldtk_background.h"
#include "ldtk_tiles.h"

namespace talus {
namespace {

tl::unexpected<FormatError> no_addition(const std::string& key) {
  return tl::unexpected(FormatError{"key " + key, "is not what Talus writes there"});
}

// The members of `whole` that differ from those of `part`; null for those that it does not have.
Json changes_of(const Json& whole, const Json& part) {
  Json changes = Json::object();
  for (const auto& [key, value] : whole.items()) {
    const auto other = part.find(key);
    if (other != part.end() && *other == value) continue;
    const bool are_both_objects = other != part.end() && value.is_object() && other->is_object();
    changes[key] = are_both_objects ? changes_of(value, *other) : value;
  }
  for (const auto& [key, value] : part.items()) {
    if (!whole.contains(key)) changes[key] = nullptr;
  }
  return changes;
}

void apply_changes(Json& object, const Json& changes, bool keeps_null) {
  for (const auto& [key, value] : changes.items()) {
    const auto known = object.find(key);
    if (known != object.end() && known->is_object() && value.is_object())
      apply_changes(*known, value, key == "roles");
    else if (value.is_null() && !keeps_null)
      object.erase(key);
    else
      object[key] = value;
  }
}

// A level as a document without what is kept in another way. Layers are in a list, without their cells.
struct Parts {
  Json members;
  Json background;  // the layer of the picture behind the level, without that picture; null: there is none
  Json layers = Json::array(), spawns = Json::array(), curves = Json::array();
};

std::vector<ObjectLayer>::const_iterator background_in(const Level& level) {
  return std::find_if(level.objects.begin(), level.objects.end(), is_ldtk_background);
}

ObjectLayer without_picture(ObjectLayer background) {
  if (background.image) background.image->part = {};
  for (MapObject& object : background.objects) object.picture = {};
  return background;
}

FormatResult<Parts> parts_of(const Level& level) {
  Level bare = level;
  bare.cart.reset();
  Parts parts;
  if (const auto background = background_in(level); background != level.objects.end()) {
    bare.objects.erase(bare.objects.begin() + (background - level.objects.begin()));
    auto json = json_of({without_picture(*background)}, "objects", {});
    if (!json) return tl::unexpected(json.error());
    parts.background = std::move((*json)[0]);
  }
  auto document = native_document(bare);
  if (!document) return tl::unexpected(document.error());
  parts.members = *std::move(document);
  const auto take = [&](const char* key, Json& out) {
    if (parts.members.contains(key)) out = parts.members[key];
    parts.members.erase(key);
  };
  take("layers", parts.layers);
  take("spawns", parts.spawns);
  take("curves", parts.curves);
  for (const char* const key : {"map", "picture", "talus", "sheet_size"}) parts.members.erase(key);
  if (parts.layers.empty()) parts.layers.push_back(Json::object());
  for (Json& layer : parts.layers)
    for (const char* const key : {"rows", "packed", "turns", "packed_turns"}) layer.erase(key);
  return parts;
}

// By which a layer is known: the n-th of those with that text counts.
std::string id_of(const Json& layer) {
  const auto id = layer.find(kLdtkLayerKey);
  return id != layer.end() && id->is_string() ? id->get<std::string>() : std::string();
}
std::map<std::string, int> places_of(const Json& layers) {
  std::map<std::string, int> places;
  for (std::size_t i = 0; i < layers.size(); ++i) places.try_emplace(id_of(layers[i]), static_cast<int>(i));
  return places;
}

Json list_changes(const Json& list, const Json& held) {
  Json added = Json::array(), gone = Json::array();
  std::size_t next = 0;  // of the list held, that is not looked at yet
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto from = held.begin() + static_cast<std::ptrdiff_t>(next);
    const auto found = std::find(from, held.end(), list[i]);
    if (found == held.end()) {
      added.push_back({i, list[i]});
      continue;
    }
    for (auto skipped = from; skipped != found; ++skipped) gone.push_back(*skipped);
    next = static_cast<std::size_t>(found - held.begin()) + 1;
  }
  for (; next < held.size(); ++next) gone.push_back(held[next]);
  if (added.empty() && gone.empty()) return nullptr;
  return {{"added", added}, {"gone", gone}};
}

FormatResult<void> apply_list(const Json& changes, const char* key, Json& list, LdtkConflicts& conflicts) {
  if (!changes.contains(key)) return {};
  const Json& of = changes[key];
  const Json added = of.is_object() ? of.value("added", Json::array()) : Json();
  const Json gone = of.is_object() ? of.value("gone", Json::array()) : Json();
  if (!added.is_array() || !gone.is_array()) return no_addition(key);
  for (const Json& entry : gone) {
    const auto found = std::find(list.begin(), list.end(), entry);
    found != list.end() ? static_cast<void>(list.erase(found)) : static_cast<void>(++conflicts.entries);
  }
  for (const Json& entry : added) {
    if (!entry.is_array() || entry.size() != 2 || !is_whole(entry[0], 0, kMaxSpawns)) return no_addition(key);
    const auto place = std::min(entry[0].get<std::size_t>(), list.size());
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), entry[1]);
  }
  return {};
}

// The cells of a layer on a map of another size.
MapCells resized(const MapCells& cells, int width, int height, int new_width, int new_height) {
  MapCells out(static_cast<std::size_t>(new_width) * static_cast<std::size_t>(new_height));
  for (int y = 0; y < std::min(height, new_height); ++y) {
    const std::size_t from = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    const std::size_t to = static_cast<std::size_t>(y) * static_cast<std::size_t>(new_width);
    for (int x = 0; x < std::min(width, new_width); ++x)
      out.set(to + static_cast<std::size_t>(x), cells[from + static_cast<std::size_t>(x)]);
  }
  return out;
}

// A cell as a number: that of its tile, with the turn above the 16 bits of a tile.
int number_of(MapCell cell) { return static_cast<int>(cell.turn) * kMaxTiles + cell.tile; }
MapCell cell_of(int number) {
  return {static_cast<TileNumber>(number % kMaxTiles), static_cast<TileTurn>(number / kMaxTiles)};
}

Json runs_of(const MapCells& cells, const MapCells& before, int width) {
  Json runs = Json::array();
  bool goes_on = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int x = static_cast<int>(i % static_cast<std::size_t>(width));
    if (cells[i] == before[i]) {
      goes_on = false;
      continue;
    }
    if (!goes_on || x == 0)
      runs.push_back({x, i / static_cast<std::size_t>(width), Json::array(), Json::array()});
    runs.back()[2].push_back(number_of(cells[i]));
    runs.back()[3].push_back(number_of(before[i]));
    goes_on = true;
  }
  return runs;
}

bool is_run(const Json& run, int width, int height) {
  if (!run.is_array() || run.size() != 4 || !is_whole(run[0], 0, width - 1) ||
      !is_whole(run[1], 0, height - 1) || !run[2].is_array() || !run[3].is_array() ||
      run[2].size() != run[3].size() || run[2].size() > static_cast<std::size_t>(width - run[0].get<int>()))
    return false;
  const auto is_tile = [](const Json& tile) { return is_whole(tile, 0, kTileTurns * kMaxTiles - 1); };
  return std::all_of(run[2].begin(), run[2].end(), is_tile) &&
         std::all_of(run[3].begin(), run[3].end(), is_tile);
}

// Paints where the cell is what it was.
void apply_run(const Json& run, int width, int tile_count, MapCells& cells, LdtkConflicts& conflicts) {
  const std::size_t first =
      run[1].get<std::size_t>() * static_cast<std::size_t>(width) + run[0].get<std::size_t>();
  for (std::size_t i = 0; i < run[2].size(); ++i) {
    const MapCell painted = cell_of(run[2][i].get<int>()), cell = cells[first + i];
    if (cell == painted) continue;
    if (cell == cell_of(run[3][i].get<int>()) && painted.tile < tile_count)
      cells.set(first + i, painted);
    else
      ++conflicts.cells;
  }
}

std::string pixels_of(const Level& level, int tile) {
  const auto& picture = level.sheet(SheetId::tiles).picture;
  const TileSize size = level.map.tile_size();
  std::string pixels(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), '\0');
  if (picture == nullptr || tile >= level.tile_count()) return pixels;
  const Cell place = level.sheet(SheetId::tiles).layout().place_of(tile);
  const auto row = 4 * static_cast<std::size_t>(size.width);
  for (int y = 0; y < size.height; ++y) {
    const std::uint8_t* from = picture->at(place.x * size.width, place.y * size.height + y);
    std::copy_n(from, row, pixels.begin() + static_cast<std::ptrdiff_t>(row) * y);
  }
  return pixels;
}

Json picture_changes(const Level& level, const Level& held) {
  if (level.sheet(SheetId::tiles).picture == nullptr) return nullptr;
  Json changes = Json::object();
  if (level.sheet(SheetId::tiles).picture == held.sheet(SheetId::tiles).picture) return changes;
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    const std::string pixels = pixels_of(level, tile);
    if (pixels != pixels_of(held, tile)) changes[std::to_string(tile)] = json_of_bytes(pack_zlib(pixels));
  }
  return changes;
}

FormatResult<void> apply_picture(const Json& changes, const Level& held, Level& level) {
  const auto found = changes.find("picture");
  const auto& before = held.sheet(SheetId::tiles).picture;
  if (found != changes.end() && found->is_null()) return {};
  const Json none = Json::object();
  const Json& tiles = found == changes.end() ? none : *found;
  if (!tiles.is_object()) return no_addition("picture");
  if (before == nullptr && tiles.empty()) return {};
  const SheetLayout layout = level.sheet(SheetId::tiles).layout();
  const TileSize size = level.map.tile_size();
  const std::int64_t width = std::int64_t{layout.columns} * size.width;
  const std::int64_t height = std::int64_t{layout.rows()} * size.height;
  if (width > kMaxSheetPictureSide || height > kMaxSheetPictureSide ||
      width * height > kMaxSheetPicturePixels)
    return tl::unexpected(FormatError{"key picture", "would be too large for the tiles of the level"});
  SheetPicture picture{static_cast<int>(width), static_cast<int>(height), {}};
  picture.rgba.resize(4 * static_cast<std::size_t>(width * height));
  const auto row = 4 * static_cast<std::size_t>(size.width);
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    std::string pixels = pixels_of(held, tile);
    if (const auto painted = tiles.find(std::to_string(tile)); painted != tiles.end()) {
      const auto text = base64_of(*painted);
      const auto bytes = text ? decode_base64(*text) : std::nullopt;
      auto unpacked = unpack_zlib(bytes.value_or(""), pixels.size());
      if (!bytes || !unpacked || unpacked->size() != pixels.size())
        return no_addition("picture." + std::to_string(tile));
      pixels = *std::move(unpacked);
    }
    const Cell place = layout.place_of(tile);
    for (int y = 0; y < size.height; ++y) {
      const auto to = 4 * (static_cast<std::ptrdiff_t>(place.y * size.height + y) * picture.width +
                           static_cast<std::ptrdiff_t>(place.x) * size.width);
      std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(row) * y, row, picture.rgba.begin() + to);
    }
  }
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  return {};
}

constexpr int kMaxShort = 256;  // tiles, up to which a cell has two digits

// Brushes of a level with fewer tiles have two digits for a cell, and those of the joined one four.
void widen_brushes(Json& document) {
  const auto brushes = document.find("brushes");
  if (brushes == document.end() || !brushes->is_array()) return;
  for (Json& brush : *brushes) {
    if (!brush.is_object() || !brush.contains("rows") || !brush["rows"].is_array()) continue;
    for (Json& row : brush["rows"]) {
      if (!row.is_string()) continue;
      const std::string cells = row.get<std::string>();
      std::string wide;
      for (std::size_t i = 0; i + 1 < cells.size(); i += 2)
        wide += (cells[i] == '.' ? ".." : "00") + cells.substr(i, 2);
      row = wide;
    }
  }
}

// The sheet as large as both need it.
Json sheet_size_of(const Json& additions, const Level& held) {
  const SheetLayout own = held.sheet(SheetId::tiles).layout();
  const auto wanted = additions.find("sheet");
  const bool is_larger = wanted != additions.end() && wanted->is_array() && wanted->size() == 2 &&
                         is_whole((*wanted)[1], own.count + 1, kMaxTiles);
  return is_larger ? *wanted : Json{own.columns, own.count};
}

}  // namespace

FormatResult<Json> ldtk_additions(const Level& level, const Level& held) {
  const auto own = parts_of(level), theirs = parts_of(held);
  if (!own) return tl::unexpected(own.error());
  if (!theirs) return tl::unexpected(theirs.error());
  Json additions = Json::object();
  const auto put = [&](const char* key, Json value) {
    if (!value.is_null() && !value.empty()) additions[key] = std::move(value);
  };
  put("members", changes_of(own->members, theirs->members));
  if (own->background.is_null() && !theirs->background.is_null())
    additions["background"] = nullptr;
  else if (!theirs->background.is_null())
    put("background", changes_of(own->background, theirs->background));
  put("spawns", list_changes(own->spawns, theirs->spawns));
  put("curves", list_changes(own->curves, theirs->curves));
  const int width = level.map.width(), height = level.map.height();
  const bool is_resized = width != held.map.width() || height != held.map.height();
  if (is_resized) additions["map"] = {width, height};
  const auto places = places_of(theirs->layers);
  std::map<std::string, int> taken;
  Json layers = Json::array(), painted = Json::array();
  for (int i = 0; i < level.layers.count(); ++i) {
    const Json& layer = own->layers[static_cast<std::size_t>(i)];
    const std::string id = id_of(layer);
    const auto place = places.find(id);
    if (place == places.end() || !taken.try_emplace(id, i).second) {
      Json whole = layer;
      whole.erase(kLdtkLayerKey);
      layers.push_back(
          {{"new", whole}, {"runs", runs_of(level.cells_of(i), MapCells(level.cells_of(i).size()), width)}});
      continue;
    }
    layers.push_back(
        {{kLdtkLayerKey, id},
         {"members", changes_of(layer, theirs->layers[static_cast<std::size_t>(place->second)])}});
    const MapCells before =
        resized(held.cells_of(place->second), held.map.width(), held.map.height(), width, height);
    Json runs = runs_of(level.cells_of(i), before, width);
    if (!runs.empty()) painted.push_back({{kLdtkLayerKey, id}, {"runs", std::move(runs)}});
  }
  Json usual = Json::array();
  for (const Json& layer : theirs->layers)
    usual.push_back({{kLdtkLayerKey, id_of(layer)}, {"members", Json::object()}});
  if (layers != usual) {
    put("layers", std::move(layers));
    for (const auto& [id, place] : places) additions["known"].push_back(id);
  }
  put("cells", std::move(painted));
  const Json picture = picture_changes(level, held);
  if (held.sheet(SheetId::tiles).picture != nullptr || !picture.is_null()) {
    if (picture.is_null() || !picture.empty()) additions["picture"] = picture;
  }
  const bool is_same_sheet = level.tile_count() == held.tile_count();
  if (!is_same_sheet || !additions.empty())
    additions["sheet"] = {level.sheet(SheetId::tiles).layout().columns, level.tile_count()};
  return additions;
}

namespace {

// The layers of the joined level.
class LdtkLayerJoiner {
 public:
  LdtkLayerJoiner(const Json& additions, const Json& held_layers, const Level& held, Level& level,
                  LdtkConflicts& conflicts)
      : additions_(additions), theirs_(held_layers), held_(held), level_(level), conflicts_(conflicts) {}

  FormatResult<void> join() {
    places_ = places_of(theirs_);
    if (const auto read = read_runs(); !read) return read;
    if (!additions_.contains("layers")) {
      for (std::size_t i = 0; i < theirs_.size(); ++i) add_held(i, Json::object());
    } else if (const auto ordered = add_in_order(); !ordered) {
      return ordered;
    }
    for (const auto& [id, runs] : runs_) conflicts_.layers += places_.contains(id) || runs->empty() ? 0 : 1;
    if (list_.empty()) return no_addition("layers");
    return take_layers(list_, level_, {});
  }

 private:
  FormatResult<void> read_runs() {
    const auto cells = additions_.find("cells");
    if (cells == additions_.end()) return {};
    if (!cells->is_array()) return no_addition("cells");
    for (const Json& layer : *cells) {
      if (!layer.is_object() || !layer.contains("runs") || !layer["runs"].is_array())
        return no_addition("cells");
      runs_.try_emplace(id_of(layer), &layer["runs"]);
    }
    return {};
  }

  FormatResult<void> add_in_order() {
    const Json& layers = additions_["layers"];
    const Json known = additions_.value("known", Json::array());
    if (!layers.is_array() || !known.is_array() || layers.size() > kMaxLayers) return no_addition("layers");
    std::map<std::string, bool> shown;
    for (const Json& layer : layers) {
      if (!layer.is_object()) return no_addition("layers");
      if (const auto whole = layer.find("new"); whole != layer.end()) {
        const Json runs = layer.value("runs", Json::array());
        if (!whole->is_object() || !runs.is_array()) return no_addition("layers");
        add_layer(*whole, MapCells(level_.map.cells().size()), runs);
        continue;
      }
      const auto place = places_.find(id_of(layer));
      const Json members = layer.value("members", Json::object());
      if (!members.is_object()) return no_addition("layers");
      if (place != places_.end() && shown.try_emplace(place->first, true).second)
        add_held(static_cast<std::size_t>(place->second), members);
    }
    for (std::size_t i = 0; i < theirs_.size(); ++i) {  // new ones of LDtk are in front
      if (std::find(known.begin(), known.end(), Json(id_of(theirs_[i]))) == known.end())
        add_held(i, Json::object());
    }
    return {};
  }

  void add_held(std::size_t place, const Json& members) {
    Json layer = theirs_[place];
    apply_changes(layer, members, false);
    const int width = level_.map.width(), height = level_.map.height();
    MapCells cells = resized(held_.cells_of(static_cast<int>(place)), held_.map.width(), held_.map.height(),
                             width, height);
    const auto runs = runs_.find(id_of(theirs_[place]));
    const bool is_painted = runs != runs_.end() && places_.at(runs->first) == static_cast<int>(place);
    add_layer(std::move(layer), std::move(cells), is_painted ? *runs->second : Json::array());
  }

  void add_layer(Json layer, MapCells cells, const Json& runs) {
    const int width = level_.map.width(), height = level_.map.height();
    for (const Json& run : runs) {
      if (is_run(run, width, height))
        apply_run(run, width, level_.tile_count(), cells, conflicts_);
      else
        ++conflicts_.cells;
    }
    layer["rows"] = json_of_rows(cells.tiles(), level_);
    put_turns(cells, width, false, layer);
    list_.push_back(std::move(layer));
  }

  const Json& additions_;
  const Json& theirs_;
  const Level& held_;
  Level& level_;
  LdtkConflicts& conflicts_;
  std::map<std::string, int> places_;
  std::map<std::string, const Json*> runs_;
  Json list_ = Json::array();
};

// Puts the picture behind the level back, behind all layers. theirs: its layer, as LDtk gives it.
FormatResult<void> apply_background(const Json& additions, Json theirs, const Level& held, Level& level) {
  const auto background = background_in(held);
  if (background == held.objects.end()) return {};
  const auto changes = additions.find("background");
  if (changes != additions.end()) {
    if (changes->is_null()) return {};
    if (!changes->is_object()) return no_addition("background");
    apply_changes(theirs, *changes, false);
  }
  Json list = Json::array({std::move(theirs)});
  auto layers = take_object_layers(list, "background", {});
  if (!layers) return tl::unexpected(layers.error());
  ObjectLayer layer = std::move(layers->front());
  if (layer.image && background->image) layer.image->part = background->image->part;
  for (std::size_t i = 0; i < std::min(layer.objects.size(), background->objects.size()); ++i)
    layer.objects[i].picture = background->objects[i].picture;
  level.objects.insert(level.objects.begin(), std::move(layer));
  return {};
}

}  // namespace

FormatResult<Level> add_to_ldtk(const Json& additions, const Level& held, LdtkConflicts& conflicts) {
  auto parts = parts_of(held);
  if (!parts) return tl::unexpected(parts.error());
  Json document = std::move(parts->members);
  const Json members = additions.value("members", Json::object());
  if (!members.is_object()) return no_addition("members");
  for (const char* const key : {"map", "layers", "picture", "spawns", "curves", "cart", "sheet_size"})
    if (members.contains(key)) return no_addition("members");
  apply_changes(document, members, false);
  for (const auto& [key, list] : {std::pair("spawns", &parts->spawns), std::pair("curves", &parts->curves)}) {
    if (const auto applied = apply_list(additions, key, *list, conflicts); !applied)
      return tl::unexpected(applied.error());
    document[key] = std::move(*list);
  }
  Json size{held.map.width(), held.map.height()};
  if (additions.contains("map")) size = additions["map"];
  if (!size.is_array() || size.size() != 2) return no_addition("map");
  document["map"] = {{"width", size[0]}, {"height", size[1]}, {"rows", Json::array()}};
  const Json sheet = sheet_size_of(additions, held);
  const Json before = additions.value("sheet", Json());
  const bool was_short = before.is_array() && before.size() == 2 && is_whole(before[1], 1, kMaxShort);
  if (was_short && sheet[1].get<int>() > kMaxShort && members.contains("brushes")) widen_brushes(document);
  document["sheet_size"] = sheet;
  document["talus"] = kNativeVersion;
  auto level = level_of_document(std::move(document));
  if (!level) return level;
  LdtkLayerJoiner layers(additions, parts->layers, held, *level, conflicts);
  if (const auto joined = layers.join(); !joined) return tl::unexpected(joined.error());
  if (const auto put = apply_background(additions, std::move(parts->background), held, *level); !put)
    return tl::unexpected(put.error());
  if (!check_groups(*level)) return no_addition("groups");
  tidy_groups(level->layers, level->objects);
  if (const auto painted = apply_picture(additions, held, *level); !painted)
    return tl::unexpected(painted.error());
  return level;
}

}  // namespace talus
