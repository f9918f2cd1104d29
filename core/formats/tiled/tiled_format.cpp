// The files of a map: the map, its tilesets, their pictures.
#include "tiled_format.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "../files/atomic_file.h"
#include "../files/real_path.h"
#include "../last_catch.h"
#include "../text/utf8_text.h"
#include "tiled_json.h"
#include "tiled_level.h"
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

// An error in a file that another file names.
tl::unexpected<FormatError> error_in(const std::string& file, const FormatError& error) {
  return tl::unexpected(error_within("file " + file, error));
}

// Where a file is that has this name in the map. Absolute paths would lead to other places on other machines.
FormatResult<std::string> place_in(const std::string& folder, const std::string& name) {
  std::error_code failure;
  const fs::path path(name);
  const bool is_drive = name.size() > 1 && name[1] == ':';
  if (name.find('\0') != name.npos || path.is_absolute() || is_drive || name.find("://") != name.npos)
    return error_in(name, {"", "must be relative to the folder of the map"});
  const fs::path file = fs::path(folder) / path;
  if (fs::exists(file, failure) && !fs::is_regular_file(file, failure))
    return error_in(name, {"", "is not a file"});
  return file.string();
}

std::string with_slashes(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

bool is_xml_name(const std::string& extension) { return extension == "tmx" || extension == "tsx"; }

bool is_utf16(std::string_view bytes) {
  using namespace std::string_view_literals;
  const std::string_view start = bytes.substr(0, 2);
  return start == "\xff\xfe"sv || start == "\xfe\xff"sv || start == "<\0"sv || start == "\0<"sv;
}

// A file of either form may have either extension.
FormatResult<Json> tiled_json_of(std::string_view bytes, const std::string& extension,
                                 const Progress& progress) {
  const auto wrong = [](std::string message) { return tl::unexpected(FormatError{"", std::move(message)}); };
  if (bytes.empty()) return wrong("is empty");
  if (is_utf16(bytes)) return wrong("is text in UTF-16, but must be UTF-8");
  if (first_character(bytes) == '<') return tiled_json_of_xml(bytes, progress);
  if (is_xml_name(extension) && first_character(bytes) != '{')
    return wrong("is not XML, which begins with \"<\"");
  auto json = parse_json(bytes, progress);
  if (!json && is_xml_name(extension) && !json.error().place.empty())
    json.error().message += ", and not XML either";
  return json;
}

std::shared_ptr<const TiledPicture> missing_picture() {
  TiledPicture picture;
  picture.is_missing = true;
  return std::make_shared<const TiledPicture>(std::move(picture));
}

// Tilesets whose files are missing get the map's size of tiles, and as many of them as the cells show.
void measure_missing_tilesets(TiledMap& map) {
  constexpr std::size_t kMostName = 200;           // bytes
  std::map<std::uint32_t, std::uint32_t> last_of;  // by first number, the last number that a cell has
  for (const TiledTileset& tileset : map.tilesets) last_of[tileset.first_gid] = tileset.first_gid;
  const bool is_any_missing = std::any_of(map.tilesets.begin(), map.tilesets.end(),
                                          [](const TiledTileset& tileset) { return tileset.is_missing; });
  if (!is_any_missing) return;
  for (const TiledLayer& layer : map.layers) {
    for (const std::uint32_t cell : layer.cells) {
      const std::uint32_t gid = cell & kTiledIdBits;
      const auto after = last_of.upper_bound(gid);
      if (after == last_of.begin()) continue;
      std::uint32_t& last = std::prev(after)->second;
      last = std::max(last, gid);
    }
  }
  for (TiledTileset& tileset : map.tilesets) {
    if (!tileset.is_missing) continue;
    tileset.name = shortened(tileset.source, kMostName);
    tileset.tile_size = map.tile_size;
    tileset.tile_count = static_cast<int>(last_of[tileset.first_gid] - tileset.first_gid) + 1;
  }
}

// The number of pixels that a picture claims; 0 if it would be refused for its size.
std::size_t pixels_of_png(std::string_view bytes) {
  constexpr std::size_t kSides = 8;  // bytes
  const auto header = find_png_chunk(bytes, "IHDR");
  if (!header || header->size() < kSides) return 0;
  const auto side_at = [&](std::size_t at) {
    std::size_t side = 0;
    for (std::size_t i = at; i < at + kSides / 2; ++i)
      side = side << 8 | static_cast<std::uint8_t>((*header)[i]);
    return side <= kMaxTiledPictureSide ? side : 0;  // a larger picture is refused without being read
  };
  return side_at(0) * side_at(kSides / 2);
}

class TiledFiles {
 public:
  TiledFiles(const FormatContext& context, TiledDrops& drops) : context_(context), drops_(drops) {}

  FormatResult<TiledMap> read_map(std::string_view bytes);
  TiledPictures read_pictures(TiledMap& map);

 private:
  FormatResult<void> read_tileset(TiledTileset& tileset);
  FormatResult<TiledTileset> tileset_in(const std::string& source, const std::string& place);
  FormatResult<const TiledTemplate*> find_template(const std::string& name);
  FormatResult<TiledTemplate> template_in(const std::string& name, const std::string& place);
  FormatResult<std::string> read_beside(const std::string& name, const std::string& place,
                                        std::size_t most = kMaxFileBytes);
  std::shared_ptr<const TiledPicture> picture_in(const std::string& image, const std::string& of);
  FormatResult<TiledPicture> read_picture(const std::string& name, const std::string& place);

  const FormatContext& context_;
  TiledDrops& drops_;
  std::size_t bytes_ = 0;  // bytes read from files beside the map so far
  // A map may name one file by many names, each time another.
  std::map<FileNumber, TiledTileset> tilesets_;
  std::map<FileNumber, std::shared_ptr<const TiledPicture>> pictures_;
  std::size_t pixels_ = 0;  // of pictures_
  using Template = FormatResult<TiledTemplate>;
  std::map<FileNumber, std::shared_ptr<const Template>> templates_;
  std::map<std::string, std::shared_ptr<const Template>> templates_by_name_;
};

// The limit is for all files together: a thousand tilesets could name one large file each.
FormatResult<std::string> TiledFiles::read_beside(const std::string& name, const std::string& place,
                                                  std::size_t most) {
  std::error_code failure;
  const auto size = fs::file_size(place, failure);
  if (!failure && size <= most && size > kMaxFileBytes - bytes_) {
    return error_in(name, {"", "is too large: all files that a map names may have up to " +
                                   std::to_string(kMaxFileBytes >> 20) + " MiB together"});
  }
  auto bytes = read_file(place, std::min(most, kMaxFileBytes - bytes_));
  if (!bytes) return error_in(name, bytes.error());
  if (context_.linked != nullptr) context_.linked->push_back(place);
  bytes_ += bytes->size();
  return bytes;
}

// A tileset without a map gets an empty map.
FormatResult<TiledMap> TiledFiles::read_map(std::string_view bytes) {
  const auto json = tiled_json_of(bytes, context_.extension, context_.progress.part(0, kTiledParsed));
  if (!json) return tl::unexpected(json.error());
  const auto find = [&](const std::string& name) { return find_template(name); };
  const bool is_tileset = json->is_object() && json->value("type", Json()) == "tileset";
  FormatResult<TiledMap> map;
  if (is_tileset) {
    auto tileset = read_tiled_tileset(*json, find, drops_);
    if (!tileset) return tl::unexpected(tileset.error());
    map->width = kTicMapWidth;
    map->height = kTicMapHeight;
    map->tile_size = {std::clamp(tileset->tile_size.width, 1, kMaxTileSide),
                      std::clamp(tileset->tile_size.height, 1, kMaxTileSide)};
    TiledLayer layer;
    layer.has_tiles = true;
    layer.cells.resize(kTicMapWidth * kTicMapHeight);
    map->layers.push_back(std::move(layer));
    map->tilesets.push_back(*std::move(tileset));
  } else {
    map = read_tiled_map(*json, find, drops_, context_.progress.part(kTiledParsed, kTiledMapRead));
  }
  if (!map) return map;
  for (TiledTileset& tileset : map->tilesets) {
    if (const auto read = read_tileset(tileset); !read) return tl::unexpected(read.error());
  }
  measure_missing_tilesets(*map);
  return map;
}

// A tileset in a file of its own.
FormatResult<void> TiledFiles::read_tileset(TiledTileset& tileset) {
  if (tileset.source.empty()) return {};
  const std::string source = with_slashes(tileset.source);
  if (context_.folder.empty())
    return error_in(source, {"", "is a tileset in a file beside the map, but the map has no file"});
  const auto place = place_in(context_.folder, source);
  if (!place) return tl::unexpected(place.error());
  const auto number = file_number(*place);
  const auto known = number ? tilesets_.find(*number) : tilesets_.end();
  const bool is_known = known != tilesets_.end();
  std::error_code failure;
  if (!is_known && !fs::exists(*place, failure)) {
    const auto missing = error_in(source, {"", "does not exist"});
    drops_.add("the tileset, " + missing.value().place + ": " + missing.value().message);
    tileset.is_missing = true;
    return {};
  }
  auto read = is_known ? known->second : tileset_in(source, *place);
  if (!read) return tl::unexpected(read.error());
  if (number) tilesets_.try_emplace(*number, *read);
  read->first_gid = tileset.first_gid;
  const auto from_map = [&](std::string& image) {  // it is relative to the tileset's folder
    if (!image.empty()) image = (fs::path(source).parent_path() / with_slashes(image)).string();
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
  const auto bytes = read_beside(source, place);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = tiled_json_of(*bytes, context_for_file(source).extension, {});
  if (!json) return error_in(source, json.error());
  const fs::path folder = fs::path(source).parent_path();
  const auto find = [&](const std::string& name) {  // from the folder of the tileset
    return find_template(name.starts_with('/') ? name : (folder / with_slashes(name)).string());
  };
  auto read = read_tiled_tileset(*json, find, drops_);
  if (!read) return error_in(source, read.error());
  if (!read->source.empty()) return error_in(source, {"", "is a tileset that names another file"});
  return read;
}

// Templates that cannot be read are remembered, too: many objects may have the same one.
FormatResult<const TiledTemplate*> TiledFiles::find_template(const std::string& name) {
  std::shared_ptr<const Template>& known = templates_by_name_[name];
  if (known == nullptr) {
    const std::string path = with_slashes(name);
    const auto place = place_in(context_.folder, path);
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
  }
  if (!*known) return tl::unexpected(known->error());
  return &**known;
}

FormatResult<TiledTemplate> TiledFiles::template_in(const std::string& name, const std::string& place) {
  const auto bytes = read_beside(name, place, kMaxTiledTemplateBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = tiled_json_of(*bytes, context_for_file(name).extension, {});
  if (!json) return error_in(name, json.error());
  auto read = read_tiled_template(*json, fs::path(name).parent_path().string());
  if (!read) return error_in(name, read.error());
  read->bytes = bytes->size();
  return read;
}

// A picture that cannot be read is dropped. Tilesets that do not say the size of theirs get it.
TiledPictures TiledFiles::read_pictures(TiledMap& map) {
  TiledPictures pictures;
  for (TiledTileset& tileset : map.tilesets) {
    const std::string of = "the picture of the tileset " + tiled_quoted(tileset.name);
    const bool has_one = tileset.is_collection || !tileset.image.empty();
    pictures.emplace_back();
    if (tileset.is_missing) {
      pictures.back() = missing_picture();
    } else if (!has_one || context_.folder.empty()) {
      drops_.add(of);
    } else if (!tileset.is_collection) {
      pictures.back() = picture_in(tileset.image, of);
      if (tileset.image_width == 0) tileset.image_width = pictures.back()->rgba.width;
      if (tileset.image_height == 0) tileset.image_height = pictures.back()->rgba.height;
    } else {
      TiledPicture all;
      for (const TiledTile& tile : *tileset.tiles) {
        if (tile.image.empty()) continue;
        const auto own = picture_in(tile.image, "a picture of the tileset " + tiled_quoted(tileset.name));
        all.of_tiles[tile.id] =
            own->is_missing ? nullptr : std::shared_ptr<const RgbaPicture>(own, &own->rgba);
      }
      pictures.back() = std::make_shared<const TiledPicture>(std::move(all));
    }
  }
  return pictures;
}

// of: what it is the picture of, for a message that it cannot be read.
std::shared_ptr<const TiledPicture> TiledFiles::picture_in(const std::string& image, const std::string& of) {
  const auto dropped = [&](const FormatError& error) {
    drops_.add(of + ", " + error.place + ": " + error.message);
    return missing_picture();
  };
  const std::string name = with_slashes(image);
  const auto place = place_in(context_.folder, name);
  if (!place) return dropped(place.error());
  const auto number = file_number(*place);
  if (const auto known = number ? pictures_.find(*number) : pictures_.end(); known != pictures_.end())
    return known->second;
  auto picture = read_picture(name, *place);
  const auto shared =
      picture ? std::make_shared<const TiledPicture>(*std::move(picture)) : dropped(picture.error());
  if (number) pictures_[*number] = shared;
  return shared;
}

FormatResult<TiledPicture> TiledFiles::read_picture(const std::string& name, const std::string& place) {
  const auto bytes = read_beside(name, place);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::size_t pixels = pixels_of_png(*bytes);
  if (pixels > kMaxTiledPixels - pixels_) {
    return error_in(name, {"", "is too large: all pictures that a map names may have up to " +
                                   std::to_string(kMaxTiledPixels) + " pixels together"});
  }
  pixels_ += pixels;
  auto rgba = read_rgba(*bytes, kMaxTiledPictureSide);
  if (!rgba) return error_in(name, rgba.error());
  const auto chunk = find_png_chunk(*bytes, "PLTE");
  TiledPicture picture;
  picture.rgba = *std::move(rgba);
  for (std::size_t i = 0; chunk && i + 3 <= chunk->size(); i += 3)
    picture.palette.push_back({static_cast<std::uint8_t>((*chunk)[i]),
                               static_cast<std::uint8_t>((*chunk)[i + 1]),
                               static_cast<std::uint8_t>((*chunk)[i + 2])});
  return picture;
}

FormatResult<Level> read_files(std::string_view bytes, const FormatContext& context, TiledDrops& drops) {
  TiledFiles files(context, drops);
  auto map = files.read_map(bytes);
  if (!map) return tl::unexpected(map.error());
  const TiledPictures pictures = files.read_pictures(*map);
  return level_of_tiled(*map, pictures, context.choices, drops, context.progress.part(kTiledMapRead, 1));
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
  TiledDrops drops;
  const auto map = read_guarded([&] { return TiledFiles(context, drops).read_map(*bytes); });
  if (!map) return layers;
  for (const TiledLayer& layer : map->layers) {
    if (!layer.has_tiles) continue;
    const auto empty = std::count(layer.cells.begin(), layer.cells.end(), 0U);
    layers.push_back({printable(layer.name), layer.cells.size() - static_cast<std::size_t>(empty)});
  }
  return layers;
}

FormatResult<Level> read_tiled(std::string_view bytes, const FormatContext& context) {
  TiledDrops drops;
  auto level = read_files(bytes, context, drops);
  if (level && context.dropped != nullptr) {
    for (std::string& phrase : drops.phrases()) context.dropped->push_back(std::move(phrase));
  }
  return level;
}

}  // namespace talus
