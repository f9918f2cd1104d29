#include "export_layers.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <talus/level/placed_picture.h>
#include <talus/level/tile_turns.h>
#include "../formats/import/import_drops.h"
#include "../formats/pictures/png_picture.h"
#include "../formats/tiled/tiled_object_layers.h"
#include "../formats/tiled/tiled_properties.h"

namespace talus {
namespace {

constexpr std::size_t kMaxPictures = 1000;

TileTurn turn_of_part(const PicturePart& part) {
  return turn_of(part.swaps_axes, part.mirrors_x, part.mirrors_y);
}

// The pixels of a part as it is drawn.
SheetPicture turned_picture(const PicturePart& part) {
  const TileSize size{part.width, part.height};
  const TileSize drawn = turned(size, turn_of_part(part));
  SheetPicture made{drawn.width, drawn.height, {}};
  made.rgba.reserve(4 * static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(drawn.height));
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      const Cell from = pixel_before_turn({x, y}, turn_of_part(part), size);
      const std::uint8_t* const rgba = part.picture->at(part.x + from.x, part.y + from.y);
      made.rgba.insert(made.rgba.end(), rgba, rgba + 4);
    }
  }
  return made;
}

// Whether its place in the map is at another height than in the level: at another corner of its picture.
bool moves_upright(const MapObject& object) {
  if (object.form != MapObject::Form::tile || object.picture.picture == nullptr) return false;
  MapObject plain;
  put_upright(object, plain);
  return plain.position.y != object.position.y;
}

bool is_higher(const MapObject& a, const MapObject& b) { return a.position.y < b.position.y; }

class LayerExporter {
 public:
  LayerExporter(const ExportRequest& request, std::uint32_t first_gid)
      : request_(request), first_gid_(first_gid) {}

  ExportedLayers make(const Level& level);

 private:
  // A file with the pixels of a part.
  struct Written {
    std::string name;
    TileSize size;
    std::optional<std::uint32_t> gid;  // of the tile that shows it
  };

  Written* written(const PicturePart& part);
  std::uint32_t gid_of(Written& picture);
  MapObject placed_object(const MapObject& object, std::uint32_t& gid);
  TiledObject tiled(const MapObject& object, std::uint32_t gid) const;
  TiledLayer tiled(const ObjectLayer& layer, ObjectLayer& plain);
  void put_image(const LayerImage& image, ObjectLayer& plain, TiledLayer& made);
  void tell();

  using Key = std::tuple<const SheetPicture*, int, int, int, int, TileTurn>;
  const ExportRequest& request_;
  std::uint32_t first_gid_;
  std::map<Key, Written> pictures_;
  ExportedLayers made_;
  std::size_t boxes_ = 0, others_ = 0, too_many_ = 0;  // objects and pictures that are written as less
};

// Null if it is too large for a tile, or one picture too many.
LayerExporter::Written* LayerExporter::written(const PicturePart& part) {
  const Key key{part.picture.get(), part.x, part.y, part.width, part.height, turn_of_part(part)};
  if (const auto known = pictures_.find(key); known != pictures_.end()) return &known->second;
  if (pictures_.size() == kMaxPictures || std::max(part.width, part.height) > kMaxTiledTileSide)
    return nullptr;
  const SheetPicture pixels = turned_picture(part);
  const std::string name = request_.picture_name(static_cast<int>(pictures_.size()) + 1);
  made_.pictures.push_back({name, encode_png(pixels.width, pixels.height, 4, pixels.rgba.data())});
  return &pictures_.emplace(key, Written{name, {pixels.width, pixels.height}, {}}).first->second;
}

std::uint32_t LayerExporter::gid_of(Written& picture) {
  if (picture.gid) return *picture.gid;
  if (!made_.tileset) {
    made_.tileset.emplace();
    made_.tileset->first_gid = first_gid_;
    made_.tileset->name = "pictures";
    made_.tileset->is_collection = true;
  }
  TiledTileset& set = *made_.tileset;
  TiledTile tile;
  tile.id = set.tile_count++;
  tile.image = picture.name;
  tile.image_size = picture.size;
  set.tiles->push_back(std::move(tile));
  const TileSize largest = set.tile_count == 1 ? TileSize{1, 1} : set.tile_size;
  set.tile_size = {std::max(largest.width, picture.size.width),
                   std::max(largest.height, picture.size.height)};
  picture.gid = first_gid_ + static_cast<std::uint32_t>(set.tile_count - 1);
  return *picture.gid;
}

// gid: of the tile that it shows, or 0.
MapObject LayerExporter::placed_object(const MapObject& object, std::uint32_t& gid) {
  using Form = MapObject::Form;
  gid = 0;
  if (object.form != Form::tile && object.form != Form::other) return object;
  MapObject plain = object;
  plain.picture = {};
  plain.anchor = MapObject().anchor;
  const bool is_drawn = object.picture.picture != nullptr && object.size.x > 0 && object.size.y > 0;
  Written* const picture = object.form == Form::tile && is_drawn ? written(object.picture) : nullptr;
  if (picture != nullptr) {
    put_upright(object, plain);
    gid = gid_of(*picture);
    return plain;
  }
  if (object.form == Form::other)
    ++others_;
  else
    ++(is_drawn ? too_many_ : boxes_);
  plain.form = Form::box;
  plain.tile = 0;
  plain.position = top_left_of(object);
  return plain;
}

TiledObject LayerExporter::tiled(const MapObject& object, std::uint32_t gid) const {
  TiledObject made = tiled_object(object);
  made.gid = gid;
  made.properties = properties_of_json(object.properties);
  const bool* const one_way = find_property<bool>(made.properties, "one_way");
  if (object.one_way == (one_way != nullptr && *one_way)) return made;
  put_property(made.properties, {"one_way", object.one_way});
  return made;
}

void LayerExporter::put_image(const LayerImage& image, ObjectLayer& plain, TiledLayer& made) {
  plain.image->part = {};
  made.image.emplace();
  made.image->repeats_x = image.repeats_x;
  made.image->repeats_y = image.repeats_y;
  const Written* const picture = image.part.picture == nullptr ? nullptr : written(image.part);
  if (picture != nullptr)
    made.image->path = picture->name;
  else if (!image.path.empty() || image.part.picture != nullptr)
    made_.dropped.push_back("the picture of the layer " + quoted_name(plain.name) +
                            (image.part.picture == nullptr ? ", which is missing" : ", which is too large"));
}

TiledLayer LayerExporter::tiled(const ObjectLayer& layer, ObjectLayer& plain) {
  TiledLayer made;
  made.name = layer.name;
  made.looks.visible = layer.visible;
  made.looks.locked = layer.locked;
  made.looks.opacity = layer.opacity;
  made.looks.offset = layer.offset;
  made.looks.parallax = layer.parallax;
  made.looks.tint = layer.tint;
  made.looks.group = layer.group;
  if (layer.image) put_image(*layer.image, plain, made);
  if (object_layer_of(made).is_ground != layer.is_ground)
    made.properties.push_back({"ground", layer.is_ground});
  std::vector<MapObject> objects = std::exchange(plain.objects, {});
  plain.by_y = layer.by_y && std::none_of(objects.begin(), objects.end(), moves_upright);
  made.by_y = plain.by_y;
  if (layer.by_y && !plain.by_y) std::stable_sort(objects.begin(), objects.end(), is_higher);
  for (const MapObject& object : objects) {
    std::uint32_t gid = 0;
    plain.objects.push_back(placed_object(object, gid));
    made.objects.push_back(tiled(plain.objects.back(), gid));
  }
  return made;
}

std::string counted_objects(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " object" : " objects");
}

void LayerExporter::tell() {
  if (boxes_ > 0)
    made_.dropped.push_back("the missing pictures of " + counted_objects(boxes_) + ": boxes stand for them");
  if (others_ > 0)
    made_.dropped.push_back("the text or form of " + counted_objects(others_) +
                            " that Talus does not draw: boxes stand for them");
  if (too_many_ > 0)
    made_.dropped.push_back("the pictures of " + counted_objects(too_many_) +
                            ", which are too large or too many: boxes stand for them");
  if (request_.name == "-" && !made_.pictures.empty())
    made_.dropped.emplace_back("the pictures of layers and objects, which go beside a file");
}

ExportedLayers LayerExporter::make(const Level& level) {
  made_.level = level.objects;
  for (std::size_t i = 0; i < level.objects.size(); ++i)
    made_.layers.push_back(tiled(level.objects[i], made_.level[i]));
  tell();
  return std::move(made_);
}

}  // namespace

ExportedLayers export_layers(const Level& level, const ExportRequest& request, std::uint32_t first_gid) {
  return LayerExporter(request, first_gid).make(level);
}

}  // namespace talus
