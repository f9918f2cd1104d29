// TiledMap: what a map of Tiled holds that levels have, too. It stands between levels on one side and TMJ,
// TMX and Lua on the other.
//
// How a level looks there (tiled_objects.h makes the objects):
//   one tileset   "tiles", with its picture beside the map. A tile has the int `flags`; a bool
//                 for each flag that is set (see tiled_flag_names); words for its shape (`shape`,
//                 `shape_side`, `shape_one_way`, `shape_heights`); and the shape as a polygon or box, with
//                 the bool `one_way` if it is one-way, as importers of engines look for it there
//   background    the level's; none if that is clear
//   layer "map"   the tiles; cells with tile 0 are empty if tile 0 is blank
//   other layers  those of the level, in its order; an object with a picture shows a tile of the tileset
//                 "pictures", a collection of images
//   "spawns"      boxes whose type is the word of a kind, such as "ball", with `vx`, `vy`, `foot`
//   "curves"      polylines of the type "curve", at most kTiledTolerance off, with the exact numbers
//   `talus_level` a property of the map: the rest of the level as a native one in one line, without its
//                 cells and pixels. Numbers that Tiled rounds to six digits are taken from there when the
//                 map is read, unless they were changed in Tiled.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <talus/level/level.h>
#include "../import/import_drops.h"
#include "../import/linked_files.h"

namespace talus {

inline constexpr std::uint32_t kTiledIdBits =
    0x0fffffff;  // bits of a cell's number; the others say how the tile is turned
inline constexpr std::uint32_t kTiledFlipX = 0x80000000, kTiledFlipY = 0x40000000, kTiledFlipXY = 0x20000000;
// Shifted right by this, the three bits are a TileTurn.
inline constexpr int kTiledTurnShift = 29;
// A property of a tile: its speed as a conveyor, px/frame.
inline constexpr std::string_view kTiledConveyor = "shape_conveyor";
inline constexpr std::string_view kTiledLevelProperty = "talus_level";
// A property of the map: whether all layers of objects of `talus_level` are layers of the map.
inline constexpr std::string_view kTiledObjectsProperty = "talus_objects";
inline constexpr std::string_view kTiledSpawnLayer = "spawns", kTiledCurveLayer = "curves",
                                  kTiledTileLayer = "map";
inline constexpr std::string_view kTiledBodyLayer = "bodies";  // of new bodies in maps of others
inline constexpr std::string_view kTiledCurveType = "curve";

// Limits for a map that is read, over all of its layers and tilesets.
inline constexpr std::size_t kMaxTiledCells = std::size_t{4} * kMaxTerrainCells;
inline constexpr std::size_t kMaxTiledObjects = 262'144;
inline constexpr std::size_t kMaxTiledPoints = std::size_t{1} << 21;  // of polygons and polylines
inline constexpr std::size_t kMaxTiledLayers = 4096;                  // groups count, too
inline constexpr std::size_t kMaxTiledTilesets = 4096;
inline constexpr int kMaxTiledTileSide = 4096;  // px, of a tile of a tileset

struct TiledProperty {
  std::string name;
  std::variant<bool, std::int64_t, double, std::string> value;
  friend bool operator==(const TiledProperty&, const TiledProperty&) = default;
};
using TiledProperties = std::vector<TiledProperty>;

// Returns the value of that name; null if there is none, or one of another type.
template <class Value>
const Value* find_property(const TiledProperties& properties, std::string_view name) {
  for (const TiledProperty& property : properties) {
    if (property.name == name) return std::get_if<Value>(&property.value);
  }
  return nullptr;
}

// Properties of tiles that are true or false: a tile without an outline is solid if one is true. Phaser and
// STI have them.
inline constexpr std::array<std::string_view, 2> kTiledSolidWords = {"collides", "collidable"};
bool is_solid_by_word(const TiledProperties& properties);
// Those of layers and groups, which say whether they are ground. The last one counts most.
inline constexpr std::array<std::string_view, 4> kTiledGroundWords = {"collides", "collidable", "solid",
                                                                      "ground"};
// What these say; nothing if there is none.
std::optional<bool> ground_by_word(const TiledProperties& properties);

struct TiledObject {
  enum class Form : std::uint8_t {
    box,  // also a point, which has no size
    polygon,
    polyline,
    ellipse,  // within a box
    tile,     // a picture of a tile
    other     // a text or a capsule, which no level holds
  };
  Form form = Form::box;
  std::string name, type;
  std::uint32_t gid = 0;  // of a tile: its number, as in cells; 0: not known
  Vec2 position, size;    // px
  double rotation = 0;    // degrees
  bool visible = true;
  std::vector<Vec2> points;  // px, from the position; for polygons and polylines
  TiledProperties properties;
  friend bool operator==(const TiledObject&, const TiledObject&) = default;
};

// Whether it marks a place, and has no outline.
inline bool is_point(const TiledObject& object) {
  return object.form == TiledObject::Form::box && object.gid == 0 && object.size == Vec2();
}

struct TiledTile {
  int id = 0;              // in the tileset
  std::string type;        // that of objects which show it, unless they have one
  double probability = 1;  // weight among tiles that are chosen at random
  TiledProperties properties;
  std::vector<TiledObject> objects;  // its collision shapes
  struct Frame {
    int id = 0;          // of a tile in the same tileset
    int duration = 100;  // ms, 1..kMaxFrameDuration
  };
  std::vector<Frame> animation;  // empty: it shows itself
  std::string image;             // of a collection: its own picture, as that of a tileset
  // px: the part of that picture that it shows, from there to its end if the size is 0.
  int image_x = 0, image_y = 0;
  TileSize image_size = {0, 0};
};

struct TiledTileset {
  std::uint32_t first_gid = 1;  // number of its first tile in cells of the map
  std::string name;
  std::string source;              // its own file, relative to the map's folder; empty: it is in the map
  std::string file;                // path of its own file, as it was opened; empty: it is in the map
  std::string image;               // relative to the map's folder or that of its own file; empty: it has none
  bool is_missing = false;         // whether its file does not exist
  bool is_collection = false;      // whether its tiles have pictures of their own
  TileSize tile_size;              // of its tiles in the picture; of a collection, of the largest
  int offset_x = 0, offset_y = 0;  // px, by which its tiles are drawn right of and below their places
  bool fits_grid = false;          // whether its tiles are drawn in the size of cells; else in their own
  bool keeps_ratio = false;        // whether they keep their ratio then, and as objects of another size
  Vec2 anchor = {0, 1};            // where the position of its objects is in their box, shares of its size
  std::optional<Rgb> transparent;  // colour of its picture that is not drawn
  int columns = 0, tile_count = 0;
  int spacing = 0, margin = 0;  // px, between and around the tiles in the picture
  int image_width = 0, image_height = 0;
  // Those that have properties or shapes, by ascending id. Tilesets of one file share them.
  std::shared_ptr<std::vector<TiledTile>> tiles = std::make_shared<std::vector<TiledTile>>();
};

// The picture of an image layer.
struct TiledImage {
  std::string path;  // relative to the map's folder; may be empty
  std::optional<Rgb> transparent;
  bool repeats_x = false, repeats_y = false;
  std::shared_ptr<const LinkedPicture> picture;  // null: not read yet
};

struct TiledLayer {
  bool has_tiles = false;  // whether it is a tile layer; else one of objects or a picture
  bool is_hidden = false;  // for writing; a layer that is read counts even if it is hidden
  std::string name;
  std::string type;            // its class
  TiledProperties properties;  // of an object layer
  // Of a tile layer, what its properties, or those of the groups around it, say; nothing: they do not say it.
  std::optional<bool> says_ground;
  TileLayer looks;                   // its own, with the number of its group; without its cells
  std::vector<std::uint32_t> cells;  // row by row: 0, or a tile's number with the bits that turn it
  std::vector<TiledObject> objects;
  bool by_y = false;  // whether objects are drawn in the order of their y
  std::optional<TiledImage> image;
};

struct TiledMap {
  int width = 0, height = 0;  // cells
  Cell first;                 // place of its first cell in the file; (0, 0) unless the map is infinite
  TileSize tile_size;         // of each cell
  RenderOrder order = RenderOrder::right_down;
  std::string background;  // colour, see tiled_background; empty: not set
  std::vector<TiledTileset> tilesets;
  std::vector<TiledLayer> layers;  // in the order of the file, also those in groups
  LayerGroups groups;              // in the order of the file, each before those in it; some have no layers
  TiledProperties properties;
};

// The path of a file that is named in a file of that folder, without "." and with "/" alone.
std::string tiled_path(const std::string& folder, std::string name);

std::string tiled_color(Rgb color);  // "#1a1c2c"
// What a map says of the background of a level: "#1a1c2c", or "#801a1c2c" if it is not opaque; empty if it is
// clear.
std::string tiled_background(const Level& level);

// "is one layer too many: a map may have at most 4096", for what a map has one of above a limit.
std::string tiled_too_many(std::string_view thing, std::size_t most);

}  // namespace talus
