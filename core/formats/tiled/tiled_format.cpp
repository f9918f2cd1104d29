// The files of a map: the map, its tilesets, their pictures.
#include "tiled_format.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "../files/atomic_file.h"
#include "../import/linked_files.h"
#include "../last_catch.h"
#include "../text/utf8_text.h"
#include "../text/xml_encoding.h"
#include "tiled_content.h"
#include "tiled_json.h"
#include "tiled_level.h"
#include "tiled_old_json.h"
#include "tiled_tiles.h"
#include "tiled_xml.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr double kTiledParsed = 0.5, kTiledMapRead = 0.8;  // shares of the time

char first_character(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);  // the byte order mark
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first == bytes.npos ? '\0' : bytes[first];
}

bool is_xml_name(const std::string& extension) { return extension == "tmx" || extension == "tsx"; }

// A file of either form may have either extension.
FormatResult<Json> tiled_json_of(std::string_view bytes, const std::string& extension,
                                 const Progress& progress) {
  const auto wrong = [](std::string message) { return tl::unexpected(FormatError{"", std::move(message)}); };
  if (bytes.empty()) return wrong("is empty");
  const auto converted = xml_in_utf8(bytes);
  if (!converted) return tl::unexpected(converted.error());
  const std::string_view text = *converted ? std::string_view(**converted) : bytes;
  if (first_character(text) == '<') return tiled_json_of_xml(text, progress);
  if (is_utf16(bytes)) return wrong("is text in UTF-16, but must be UTF-8");
  if (is_xml_name(extension) && first_character(bytes) != '{')
    return wrong("is not XML, which begins with \"<\"");
  auto json = parse_json(bytes, progress);
  if (json) modernise_tiled_json(*json);
  if (!json && is_xml_name(extension) && !json.error().place.empty())
    json.error().message += ", and not XML either";
  return json;
}

// Tilesets whose files are missing get the map's size of tiles, and as many of them as the cells show.
// frame: as in ImportChoices.
void measure_missing_tilesets(const std::optional<TiledFrame>& frame, TiledMap& map) {
  constexpr std::size_t kMaxName = 200;            // bytes
  std::map<std::uint32_t, std::uint32_t> last_of;  // by first number, the last number that a cell has
  for (const TiledTileset& tileset : map.tilesets) last_of[tileset.first_gid] = tileset.first_gid;
  const bool is_any_missing = std::any_of(map.tilesets.begin(), map.tilesets.end(),
                                          [](const TiledTileset& tileset) { return tileset.is_missing; });
  if (!is_any_missing) return;
  const auto add = [&](std::uint32_t cell) {
    const std::uint32_t gid = cell & kTiledIdBits;
    const auto after = last_of.upper_bound(gid);
    if (after == last_of.begin()) return;
    std::uint32_t& last = std::prev(after)->second;
    last = std::max(last, gid);
  };
  for (const TiledLayer& layer : map.layers) std::for_each(layer.cells.begin(), layer.cells.end(), add);
  if (frame) std::for_each(frame->tiles.begin(), frame->tiles.end(), add);
  for (TiledTileset& tileset : map.tilesets) {
    if (!tileset.is_missing) continue;
    tileset.name = shortened(tileset.source, kMaxName);
    tileset.tile_size = map.tile_size;
    tileset.tile_count = static_cast<int>(last_of[tileset.first_gid] - tileset.first_gid) + 1;
  }
}

// A tileset in a file of its own may have grown since the map was saved. Its last numbers are those of the
// next tileset then, so no cell can show these tiles.
void leave_out_hidden_tiles(ImportDrops& drops, TiledMap& map) {
  std::map<std::uint32_t, TiledTileset*> by_number;
  for (TiledTileset& tileset : map.tilesets) by_number.try_emplace(tileset.first_gid, &tileset);
  const TiledTileset* next = nullptr;
  for (auto it = by_number.rbegin(); it != by_number.rend(); next = it->second, ++it) {
    TiledTileset& tileset = *it->second;
    if (next == nullptr) continue;
    const std::uint32_t room = next->first_gid - tileset.first_gid;
    const int count = grid_of(tileset).count;
    if (static_cast<std::uint32_t>(count) <= room) continue;
    tileset.tile_count = static_cast<int>(room);
    drops.add("the last tiles of the tileset " + quoted_name(tileset.name) + ", from number " +
              std::to_string(room) + " on: their numbers are those of the next tileset");
  }
}

// A map for a tileset that comes without one: it shows each tile once, in its place, with room around them,
// so that their shapes can be tried with a body.
TiledMap map_of_tileset(TiledTileset tileset) {
  constexpr int kAround = 3;  // cells
  SheetLayout grid = grid_of(tileset);
  grid.columns = std::clamp(grid.count, 1, grid.columns);
  if (grid.columns > kMaxSheetSide || grid.rows() > kMaxSheetSide) grid = {1, 0};  // which no level can have
  TiledMap map;
  map.width = grid.columns + 2 * kAround;
  map.height = grid.rows() + 2 * kAround;
  map.tile_size = {std::clamp(tileset.tile_size.width, 1, kMaxTileSide),
                   std::clamp(tileset.tile_size.height, 1, kMaxTileSide)};
  TiledLayer layer;
  layer.has_tiles = true;
  layer.cells.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  tileset.first_gid = 1;
  for (int id = 0; id < grid.count; ++id) {
    if (tileset.is_collection && find_tile(tileset, id) == nullptr) continue;  // ids may have gaps
    const Cell place = grid.place_of(id);
    const auto row = static_cast<std::size_t>(kAround + place.y) * static_cast<std::size_t>(map.width);
    layer.cells[row + static_cast<std::size_t>(kAround + place.x)] = static_cast<std::uint32_t>(id) + 1;
  }
  map.layers.push_back(std::move(layer));
  map.tilesets.push_back(std::move(tileset));
  return map;
}

class TiledFiles {
 public:
  // known: tilesets that are taken from here, not from their files.
  TiledFiles(const FormatContext& context, std::span<const TiledOrigin::File> known, ImportDrops& drops)
      : context_(context), known_(known), drops_(drops), files_(context, drops) {}

  FormatResult<TiledMap> read_map(std::string_view bytes);
  TiledPictures read_pictures(TiledMap& map);
  void read_images(TiledMap& map);
  // Those in files of their own that were read.
  std::vector<TiledOrigin::File> take_tilesets() { return std::move(tileset_files_); }

 private:
  FormatResult<void> read_tileset(TiledTileset& tileset);
  FormatResult<TiledTileset> tileset_in(const std::string& source, const std::string& place);
  FormatResult<const TiledTemplate*> find_template(const std::string& name);
  FormatResult<TiledTemplate> template_in(const std::string& name, const std::string& place);

  const FormatContext& context_;
  std::span<const TiledOrigin::File> known_;
  std::vector<TiledOrigin::File> tileset_files_;
  ImportDrops& drops_;
  LinkedFiles files_;
  // A map may name one file by many names, each time another.
  std::map<FileNumber, TiledTileset> tilesets_;
  using Template = FormatResult<TiledTemplate>;
  std::map<FileNumber, std::shared_ptr<const Template>> templates_;
  std::map<std::string, std::shared_ptr<const Template>> templates_by_name_;
};

FormatResult<TiledMap> TiledFiles::read_map(std::string_view bytes) {
  const auto json = tiled_json_of(bytes, context_.extension, context_.progress.part(0, kTiledParsed));
  if (!json) return tl::unexpected(json.error());
  const auto find = [&](const std::string& name) { return find_template(name); };
  const bool is_tileset = json->is_object() && json->value("type", Json()) == "tileset";
  FormatResult<TiledMap> map;
  if (is_tileset) {
    auto tileset = read_tiled_tileset(*json, find, drops_);
    if (!tileset) return tl::unexpected(tileset.error());
    map = map_of_tileset(*std::move(tileset));
  } else {
    const auto& frame = context_.choices.frame;
    map = read_tiled_map(*json, find, frame ? &*frame : nullptr, drops_,
                         context_.progress.part(kTiledParsed, kTiledMapRead));
  }
  if (!map) return map;
  for (TiledTileset& tileset : map->tilesets) {
    if (const auto read = read_tileset(tileset); !read) return tl::unexpected(read.error());
  }
  measure_missing_tilesets(context_.choices.frame, *map);
  return map;
}

// A tileset in a file of its own.
FormatResult<void> TiledFiles::read_tileset(TiledTileset& tileset) {
  if (tileset.source.empty()) return {};
  const std::string source = with_slashes(tileset.source);
  if (context_.folder.empty())
    return error_in(source, {"", "is a tileset in a file beside the map, but the map has no file"});
  const auto miss = [&](const FormatError& error) {
    drops_.add("the tileset, " + error.place + ": " + error.message);
    files_.note_missing(source);
    tileset.is_missing = true;
    return FormatResult<void>();
  };
  const auto place = files_.place_of(source);
  if (!place) return miss(place.error());
  const auto number = file_number(*place);
  const auto known = number ? tilesets_.find(*number) : tilesets_.end();
  const bool is_known = known != tilesets_.end();
  std::error_code failure;
  if (!is_known && !fs::exists(*place, failure)) {
    files_.note(*place);
    return miss(error_in(source, {"", "does not exist"}).value());
  }
  auto read = is_known ? known->second : tileset_in(source, *place);
  if (!read) return tl::unexpected(read.error());
  if (number) tilesets_.try_emplace(*number, *read);
  read->first_gid = tileset.first_gid;
  const auto from_map = [&](std::string& image) {  // it is relative to the tileset's folder
    if (!image.empty() && !is_data_name(image))
      image = (fs::path(source).parent_path() / with_slashes(image)).string();
  };
  from_map(read->image);
  // The tiles are shared by all tilesets of the file, so the first one moves their pictures.
  if (!is_known) {
    for (TiledTile& tile : *read->tiles) from_map(tile.image);
  }
  tileset = *std::move(read);
  return {};
}

FormatResult<TiledTileset> TiledFiles::tileset_in(const std::string& source, const std::string& place) {
  const auto known = std::find_if(known_.begin(), known_.end(),
                                  [&](const TiledOrigin::File& file) { return file.path == place; });
  auto bytes = known == known_.end() ? files_.read(source, place) : FormatResult<std::string>(known->bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = tiled_json_of(*bytes, context_for_file(source).extension, {});
  if (!json) return error_in(source, json.error());
  const Json type = json->is_object() ? json->value("type", Json()) : Json();
  if (type == "map" || type == "template")
    return error_in(source, {"", "is a " + type.get<std::string>() + " of Tiled, but must be a tileset"});
  if (!type.is_null() && type != "tileset") return error_in(source, {"type", "is not \"tileset\""});
  tileset_files_.push_back({place, *std::move(bytes)});
  const fs::path folder = fs::path(source).parent_path();
  const auto find = [&](const std::string& name) {  // from the folder of the tileset
    return find_template(name.starts_with('/') ? name : (folder / with_slashes(name)).string());
  };
  auto read = read_tiled_tileset(*json, find, drops_);
  if (!read) return error_in(source, read.error());
  if (!read->source.empty()) return error_in(source, {"", "is a tileset that names another file"});
  read->file = place;
  return read;
}

// Templates that cannot be read are remembered, too: many objects may have the same one.
FormatResult<const TiledTemplate*> TiledFiles::find_template(const std::string& name) {
  std::shared_ptr<const Template>& known = templates_by_name_[name];
  if (known == nullptr) {
    const std::string path = with_slashes(name);
    const auto place = files_.place_of(path);
    const auto number = place ? file_number(*place) : std::nullopt;
    std::shared_ptr<const Template>& of_file = templates_[number.value_or(FileNumber())];
    const auto wrong = [](tl::unexpected<FormatError> error) {
      return std::make_shared<const Template>(std::move(error));
    };
    if (context_.folder.empty())
      known = wrong(error_in(path, {"", "is beside the map, but the map has no file"}));
    else if (!place)
      known = wrong(tl::unexpected(place.error()));
    else if (number && of_file != nullptr)
      known = of_file;
    else if (templates_.size() > kMaxTiledTemplates)
      known = wrong(error_in(path, {"", tiled_too_many("template", kMaxTiledTemplates)}));
    else
      known = of_file = std::make_shared<const Template>(template_in(path, *place));
    if (!*known) files_.note_missing(path);
  }
  if (!*known) return tl::unexpected(known->error());
  return &**known;
}

FormatResult<TiledTemplate> TiledFiles::template_in(const std::string& name, const std::string& place) {
  const auto bytes = files_.read(name, place, kMaxTiledTemplateBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = tiled_json_of(*bytes, context_for_file(name).extension, {});
  if (!json) return error_in(name, json.error());
  auto read = read_tiled_template(*json, fs::path(name).parent_path().string());
  if (!read) return error_in(name, read.error());
  read->bytes = bytes->size();
  return read;
}

// The picture counts, not what the file says of it: it may have changed since. Tiles that it lacks are clear.
void take_size(const RgbaPicture& picture, TiledTileset& tileset) {
  tileset.image_width = picture.width;
  tileset.image_height = picture.height;
  tileset.columns = 0;
  const int said = std::exchange(tileset.tile_count, 0);
  tileset.tile_count = std::max(said, grid_of(tileset).count);
}

// A picture that cannot be read is dropped.
TiledPictures TiledFiles::read_pictures(TiledMap& map) {
  TiledPictures pictures;
  for (TiledTileset& tileset : map.tilesets) {
    const std::string of = "the picture of the tileset " + quoted_name(tileset.name);
    const bool has_one = tileset.is_collection || !tileset.image.empty();
    pictures.emplace_back();
    if (tileset.is_missing) {
      LinkedPicture missing;
      missing.is_missing = true;
      pictures.back() = std::make_shared<const TiledPicture>(
          TiledPicture{std::make_shared<const LinkedPicture>(std::move(missing))});
    } else if (!has_one || context_.folder.empty()) {
      drops_.add(of);
    } else if (!tileset.is_collection) {
      const auto file = files_.picture(tileset.image, of);
      pictures.back() = std::make_shared<const TiledPicture>(TiledPicture{file});
      if (!file->is_missing) take_size(file->rgba, tileset);
    } else {
      TiledPicture all;
      for (const TiledTile& tile : *tileset.tiles) {
        if (tile.image.empty()) continue;
        const auto own = files_.picture(tile.image, "a picture of the tileset " + quoted_name(tileset.name));
        all.of_tiles[tile.id] =
            own->is_missing ? nullptr : std::shared_ptr<const RgbaPicture>(own, &own->rgba);
        all.paths_of_tiles[tile.id] = own->path;
      }
      pictures.back() = std::make_shared<const TiledPicture>(std::move(all));
    }
  }
  leave_out_hidden_tiles(drops_, map);  // the sizes of all tilesets are known now
  read_images(map);
  return pictures;
}

// The pictures of image layers.
void TiledFiles::read_images(TiledMap& map) {
  for (TiledLayer& layer : map.layers) {
    if (!layer.image || layer.image->path.empty()) continue;
    const std::string of = "the picture of the layer " + quoted_name(layer.name);
    if (context_.folder.empty())
      drops_.add(of);
    else
      layer.image->picture = files_.picture(layer.image->path, of);
  }
}

// Completes the origin of a level that was read.
void keep_origin(std::string_view bytes, const FormatContext& context,
                 std::vector<TiledOrigin::File> tilesets, Level& level) {
  auto origin = std::make_shared<TiledOrigin>(*level.tiled);
  level.tiled.reset();
  TileMap map = std::exchange(level.map, TileMap(1, 1, level.map.tile_size()));
  auto opened = std::make_shared<Level>(level);
  for (TileLayer& layer : opened->layers.list) layer.cells = nullptr;
  origin->opened = std::move(opened);
  level.map = std::move(map);
  origin->extension = context.extension;
  origin->folder = context.folder;
  origin->outside = context.choices.outside;
  origin->bytes = bytes;
  origin->tilesets = std::move(tilesets);
  level.tiled = std::move(origin);
}

FormatResult<Level> read_files(std::string_view bytes, const FormatContext& context,
                               std::span<const TiledOrigin::File> known, ImportDrops& drops) {
  TiledFiles files(context, known, drops);
  auto map = files.read_map(bytes);
  if (!map) return tl::unexpected(map.error());
  const TiledPictures pictures = files.read_pictures(*map);
  auto level =
      level_of_tiled(*map, pictures, context.choices, drops, context.progress.part(kTiledMapRead, 1));
  map->layers.clear();  // 4 bytes a cell, which the level does not need
  if (level) keep_origin(bytes, context, files.take_tilesets(), *level);
  return level;
}

}  // namespace

bool accepts_tiled_json(std::string_view bytes, const FormatContext& context) {
  if (first_character(bytes) != '{') return false;
  if (context.extension == "tmj" || context.extension == "tsj") return true;
  const auto has = [&](std::string_view key) { return bytes.find(key) != bytes.npos; };
  return has("\"tilewidth\"") && !has("\"talus\"") && (has("\"tilesets\"") || has("\"tilecount\""));
}

bool accepts_tiled_xml(std::string_view bytes, const FormatContext& context) {
  if (first_character(bytes) != '<') return false;
  return is_xml_name(context.extension) || bytes.find("<map ") != bytes.npos ||
         bytes.find("<tileset ") != bytes.npos;
}

std::vector<TiledLayerName> tiled_layers_of_file(const std::string& path, const Progress& progress) {
  std::vector<TiledLayerName> layers;
  const auto bytes = read_file(path);
  if (!bytes) return layers;
  FormatContext context = context_for_file(path);
  context.progress = progress;
  ImportDrops drops;
  const auto map = read_guarded([&] { return TiledFiles(context, {}, drops).read_map(*bytes); });
  if (!map) return layers;
  for (const TiledLayer& layer : map->layers) {
    if (!layer.has_tiles) continue;
    const auto empty = std::count(layer.cells.begin(), layer.cells.end(), 0U);
    layers.push_back({printable(layer.name), layer.cells.size() - static_cast<std::size_t>(empty)});
  }
  return layers;
}

FormatResult<Level> read_tiled(std::string_view bytes, const FormatContext& context) {
  ImportDrops drops;
  auto level = read_files(bytes, context, {}, drops);
  if (level && context.dropped != nullptr) {
    for (std::string& phrase : drops.phrases()) context.dropped->push_back(std::move(phrase));
  }
  return level;
}

FormatResult<TiledContent> read_tiled_content(std::string_view bytes, const FormatContext& context,
                                              std::span<const TiledOrigin::File> tilesets) {
  ImportDrops drops;
  return read_guarded([&]() -> FormatResult<TiledContent> {
    TiledFiles files(context, tilesets, drops);
    auto map = files.read_map(bytes);
    if (!map) return tl::unexpected(map.error());
    TiledContent model{*std::move(map), {}};
    model.pictures = files.read_pictures(model.map);
    return model;
  });
}

FormatResult<Level> read_tiled_again(std::string_view bytes, const FormatContext& context,
                                     std::span<const TiledOrigin::File> tilesets) {
  ImportDrops drops;
  return read_guarded([&] { return read_files(bytes, context, tilesets, drops); });
}

}  // namespace talus
