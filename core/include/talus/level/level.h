// A level: what the editor edits, the formats read and write, and the simulation compiles.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/collision/shape.h>
#include <talus/level/auto_tiles.h>
#include <talus/level/body_kind.h>
#include <talus/level/body_picture.h>
#include <talus/level/brushes.h>
#include <talus/level/exports.h>
#include <talus/level/flag_fields.h>
#include <talus/level/flag_roles.h>
#include <talus/level/flag_set.h>
#include <talus/level/ldtk_origin.h>
#include <talus/level/map_cells.h>
#include <talus/level/object_layer.h>
#include <talus/level/picture_part.h>
#include <talus/level/tile_animation.h>
#include <talus/level/tile_layer.h>
#include <talus/level/tile_map.h>
#include <talus/level/tile_note.h>
#include <talus/level/tileset.h>
#include <talus/level/tuning.h>

namespace talus {

inline constexpr double kMinBodySize = 1.0 / 256;  // px, in width and in height
inline constexpr double kMaxBodySize = 1024;       // px, the same

// A place in a level at which a body starts, put there by hand. Ball tiles of the map are bodies without one.
struct Spawn {
  std::string name;                // for people; may be empty or repeated
  Vec2 position;                   // px, top-left corner of the body's box at the start
  Vec2 velocity;                   // px/frame, of the body at the start
  std::string extra;               // JSON object of keys that this version does not know, or empty
  BodyKind kind = BodyKind::ball;  // what moves it, its looks, its default foot
  Vec2 size = {8, 8};              // px, each kMinBodySize..kMaxBodySize
  std::optional<Foot> foot = {};   // what stands on slopes; none: as the kind has it
  BodyPicture picture = {};        // how it is drawn; empty: as the kind says
  // What stands on slopes: its own, or that of its kind.
  Foot used_foot() const { return foot.value_or(traits_of(kind).foot); }
  friend bool operator==(const Spawn&, const Spawn&) = default;
};

// A curve of the level, free of the grid.
struct LevelCurve {
  std::string name;   // for people; may be empty or repeated
  Curve curve;        // px; its ends lie on the map
  std::string extra;  // as Spawn::extra
  friend bool operator==(const LevelCurve&, const LevelCurve&) = default;
};

// The cart that a level came from, kept so that saving gives back every byte that was not edited.
// formats/ alone looks inside.
struct CartOrigin {
  // A cartridge, or a text project.
  enum class Kind { tic, text };
  Kind kind = Kind::tic;  // what the bytes are
  std::string comment;    // text only: the comment prefix, such as "--"
  std::string bytes;      // the whole file, as read
  friend bool operator==(const CartOrigin&, const CartOrigin&) = default;
};

struct Level;
struct PictureTiles;

// How a level numbers the tiles and cells of the map of Tiled that it came from.
struct TiledFrame {
  // By tile of the level, its number in cells of the map, with the bits that turn it. 0: no tileset has it.
  std::vector<std::uint32_t> tiles;
  int columns = kCartColumns;  // of the level's sheet of tiles
  bool is_0_empty = true;      // whether tile 0 stands for empty cells, too
  bool keeps_numbers = true;   // whether tiles have the numbers or the places of their tileset
  int x = 0;       // column of the map at which that of the level begins: not 0 only for infinite maps
  int y = 0;       // row of the map, the same
  int width = 0;   // cells, of the level's map when it was read
  int height = 0;  // cells, the same
  friend bool operator==(const TiledFrame&, const TiledFrame&) = default;
};

// The map or the tileset of Tiled that a level came from, kept so that saving changes nothing of the file but
// what was edited. formats/ alone looks inside.
struct TiledOrigin {
  // A tileset in a file of its own.
  struct File {
    std::string path;   // as it was opened
    std::string bytes;  // the whole file, as read
    friend bool operator==(const File&, const File&) = default;
  };
  std::string extension;                // of the name of the map's file, without the dot
  std::string folder;                   // of the map's file
  std::vector<std::string> outside;     // ImportChoices::outside with which it was read
  std::string bytes;                    // the whole file, as read
  std::vector<File> tilesets;           // each file once
  std::vector<int> layers;              // by layer of the level, which of the map's tile layers it is, from 0
  TiledFrame frame;                     // how the level numbers what is in them
  std::shared_ptr<const Level> opened;  // what the files alone gave, without the cells of its map
  std::shared_ptr<const PictureTiles> pictures;  // which parts of its pictures the level's tiles show
};

// A plain value. Readers return, and writers and compile_scene() expect, a level within the ranges below.
// Values outside are refused by writers (problem_of) and left out of the ground. Cells, brushes and the
// ground's tiles hold numbers below tile_count(); functions that read them assert it.
struct Level {
  std::array<Sheet, 2> sheets;                    // by SheetId
  Palette palette = default_palette();            // the 16 colours
  std::optional<Rgba> background;                 // seen where nothing is drawn; none: colour 0, opaque
  std::array<std::string, kMaxFlags> flag_names;  // what the user calls each flag; empty: unnamed
  std::vector<FlagField> flag_fields;             // none of them shares a flag with another
  FlagRoles roles;                                // which flag means what
  // By tile of the first sheet, as many as it has images; of kind none: the tile's flags give its shape.
  std::vector<TileShape> tile_shapes = std::vector<TileShape>(kCartTiles);
  std::array<TileShape, kMaxFlags> flag_shapes;  // the shape that a flag stands for; kind none: no shape
  std::vector<Tileset> tilesets;                 // parts of the first sheet, see problem_of; none: it is one
  TileAnimations animations;                     // of tiles of the first sheet, see problem_of
  TileNotes tile_notes;                          // of tiles of the first sheet, see problem_of
  LargeTiles large_tiles;                        // of the first sheet
  TileLayers layers;                             // what the map consists of
  TileMap map;                                   // tiles of the first sheet: the cells of the chosen layer
  std::vector<LevelCurve> curves;                // at most kMaxCurves
  std::vector<ObjectLayer> objects;              // layers of them and of pictures, from the back to the front
  Tuning tuning;                                 // the numbers of the physics
  std::vector<Spawn> spawns;                     // at most kMaxSpawns
  std::vector<Brush> brushes;                    // at most kMaxBrushes
  AutoTiles auto_tiles;                          // of the ground that is painted
  std::vector<ExportPreset> exports;             // at most kMaxExports
  std::shared_ptr<const CartOrigin> cart;        // null for a level that never was a cart
  std::shared_ptr<const TiledOrigin> tiled;      // null for a level that did not come from Tiled
  std::shared_ptr<const LdtkOrigin> ldtk;        // null for a level that did not come from LDtk
  std::string extra;  // JSON object of keys that this version does not know, or empty

  // How many tiles it has, 1 to kMaxTiles; they are numbered from 0.
  int tile_count() const { return static_cast<int>(tile_shapes.size()); }
  // Gives the sheet of tiles this layout. New tiles are blank. A picture is dropped if the layout is another.
  // Those tiles that go must not be on the map, in brushes or in the ground's tiles. Tilesets that do not fit
  // any more are taken away, like animations that show tiles which go, and their notes.
  void set_tile_layout(const SheetLayout& layout);
  // The cells of a layer, row by row. layer: index in `layers`.
  const MapCells& cells_of(int layer) const;
  // Makes a layer the chosen one. layer: index in `layers`. Takes time by the number of cells.
  void choose_layer(int layer);
  // One of the two sheets, to be changed.
  Sheet& sheet(SheetId id) { return sheets[static_cast<std::size_t>(id)]; }
  // One of the two sheets.
  const Sheet& sheet(SheetId id) const { return sheets[static_cast<std::size_t>(id)]; }
  // Of a tile of the map.
  FlagSet tile_flags(TileNumber tile) const { return sheet(SheetId::tiles).flags[tile]; }
  // Of the tile in a cell, which must lie inside the map (asserted).
  TileRole role_at(Cell cell) const { return role_of(tile_flags(map.tile_at(cell)), roles); }
};

// The same content, whichever layer is chosen; carts are compared by their bytes, and maps of Tiled
// and projects of LDtk not at all.
bool operator==(const Level& a, const Level& b);

// What is seen where nothing is drawn: its background, or colour 0 of its palette.
Rgba background_of(const Level& level);

// The shape of a tile: its own shape, or, if it has none, the shape of its flags.
TileShape shape_of_tile(const Level& level, TileNumber tile);
// The shape that what a cell holds gives to the ground: the shape of its tile, turned with the picture (see
// turned() in <talus/level/tile_turns.h>).
TileShape shape_of_cell(const Level& level, MapCell cell);
// The shape of the flags' role: a solid tile, or the slope of the article's box, which reaches from the
// tile's left side over so many tiles as `slope_width` needs and is lowest at the tile's height less
// `slope_height`, or at 0. A ball has none. Without a role, it is the shape that the lowest flag with a shape
// stands for. `one_way` and `ceiling` flags change the result.
TileShape shape_of_flags(const Level& level, FlagSet flags);
// The flags that tiles or sprites have, and those with a name, a role, a shape or a place in a field. Takes
// time by the number of tiles.
FlagSet used_flags(const Level& level);

// The kind of body that a tile on the map stands for: that of its flags, if it has no shape of its own;
// nothing if it is ground, or neither.
std::optional<BodyKind> body_kind_of_tile(const Level& level, TileNumber tile);
// Whether the tile stands for a body.
bool is_ball_tile(const Level& level, TileNumber tile);

inline constexpr double kCurveEndSlack = 1.0 / 256;  // px, that an end of a curve may be off the map
// Why a curve cannot be part of a level with this map, in the words of problem_of(curve): it is invalid, or
// an end is more than kCurveEndSlack off the map. Nothing if it can.
std::optional<std::string> problem_of(const Curve& curve, const TileMap& map);

}  // namespace talus
