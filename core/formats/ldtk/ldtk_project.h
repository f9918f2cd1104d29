// LdtkProject: what a project of LDtk holds that levels have, too.
//
// A level is a stack of layers. Layers of the kind IntGrid have a value in each cell; all but layers of
// entities may have tiles, which need not lie on the grid, and several of which may lie in one cell.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/level/level.h>
#include "../import/linked_files.h"
#include "../text/json_text.h"

namespace talus {

// Limits for a project, and for the level that is read of it.
inline constexpr std::size_t kMaxLdtkTilesets = 4096;
inline constexpr std::size_t kMaxLdtkLayers = 4096;
inline constexpr std::size_t kMaxLdtkEntities = 65'536;  // types of them
inline constexpr std::size_t kMaxLdtkLevels = 65'536;
inline constexpr int kMaxLdtkTileSide = 4096;  // px, of a tile of a tileset
inline constexpr int kMaxLdtkPlace = 1 << 26;  // px, of a tile or an entity from the corner of its level

// A value of an enum, and the tiles of a tileset that have it.
struct LdtkTag {
  std::string name;
  std::vector<int> tiles;  // ids, ascending
};

struct LdtkTileset {
  int uid = 0;
  std::string name;
  std::string path;  // of its picture, from the folder of the project; empty: it has none
  int side = 1;      // px, of a tile, 1..kMaxLdtkTileSide
  std::vector<LdtkTag> tags;
  std::map<int, std::string> data;  // custom data of tiles by their ids
};

// A value of an IntGrid.
struct LdtkValue {
  int value = 0;
  std::string name;  // may be empty
  Rgb color;
};

struct LdtkLayerDef {
  int uid = 0;
  std::string name;                // may be empty
  Vec2 pivot;                      // 0..1, by which tiles of another size than the grid's lie in their cells
  Vec2 parallax;                   // factors: 0 moves with the level, 1 with the view
  bool scales_by_parallax = true;  // whether LDtk draws it smaller or larger by them
  std::vector<LdtkValue> values;
};

// What the project says of a level without its layers.
struct LdtkLevelHead {
  std::string iid;            // empty: it has none
  std::string name;           // may be the same as that of others
  std::string world;          // the name of its world; empty: the project has no worlds
  int x = 0, y = 0;           // px, in its world
  int depth = 0;              // greater is above
  int width = 0, height = 0;  // px
  Rgb color;                  // of its background
  std::string file;  // with its layers, from the folder of the project; empty: they are in the project
  std::string path;  // in the JSON of the project
  const Json* json = nullptr;  // of the project, which must stay alive
};

struct LdtkEntityDef {
  std::string name;
  Rgb color;
};

struct LdtkProject {
  std::string iid;  // empty: it has none
  std::vector<LdtkTileset> tilesets;
  std::vector<LdtkLayerDef> layers;
  std::vector<LdtkEntityDef> entities;
  std::vector<LdtkLevelHead> levels;  // of all worlds
};

struct LdtkTile {
  int x = 0, y = 0;                // px, in the layer
  int source_x = 0, source_y = 0;  // px, of its corner in the tileset's picture
  int id = 0;                      // in the tileset
  bool flip_x = false, flip_y = false;
  double opacity = 1;  // 0..1
};

struct LdtkEntity {
  std::string type;              // the identifier of its definition
  std::string name;              // the text of its field `name`; may be empty
  Vec2 position;                 // px, of its pivot in the layer
  Vec2 size;                     // px
  Vec2 pivot;                    // 0..1, of the size
  Vec2 velocity;                 // px/frame, of its fields `vx` and `vy`
  Json fields = Json::object();  // values by name, without those that are null
};

struct LdtkLayer {
  enum class Type : std::uint8_t { int_grid, tiles, entities };
  Type type = Type::tiles;
  std::string iid;  // empty: it has none
  std::string name;
  int columns = 0, rows = 0;       // cells
  int side = 1;                    // px, of a cell
  int offset_x = 0, offset_y = 0;  // px
  double opacity = 1;              // 0..1
  bool is_visible = true;
  int def = -1;                 // index in LdtkProject::layers; -1: unknown
  int tileset = -1;             // index in LdtkProject::tilesets; -1: none
  std::vector<int> values;      // of an IntGrid: row by row, 0 is empty; of others: empty
  std::vector<LdtkTile> tiles;  // from the lowest
  std::vector<LdtkEntity> entities;
};

// A picture that lies behind a level.
struct LdtkBackground {
  std::string path;  // of its file, from the folder of the project
  // px of the picture, of the part that is shown; nothing: all of it is.
  std::optional<Rect> part;
  Vec2 corner;                                   // px, of the top left corner of that part in the level
  Vec2 scale = {1, 1};                           // px of the level for each of the picture; above 0
  bool repeats = false;                          // in both directions
  std::shared_ptr<const LinkedPicture> picture;  // null: not read yet
};

struct LdtkLevel {
  LdtkLevelHead head;
  std::optional<LdtkBackground> background;
  std::vector<LdtkLayer> layers;  // from the top
};

}  // namespace talus
