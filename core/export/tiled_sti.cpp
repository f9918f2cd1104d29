// Maps for Simple Tiled Implementation. Its plugin for bump.lua knows no tile wider than a cell, so slopes
// are cut into what of them is in each cell.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "../formats/number_text.h"
#include "../formats/png_sheet.h"
#include "export_targets.h"
#include "tiled_model.h"

namespace talus {
namespace {

// What of a tile's shape is in one cell.
struct StiPart {
  int owner = -1;            // the tile whose shape it is; -1: nothing
  int column = 0, rows = 0;  // cells from the owner's: to the right; up from a floor, down from a ceiling
  friend auto operator<=>(const StiPart&, const StiPart&) = default;
};

// A tile as it stands in a cell.
struct StiTile {
  int image = 0;  // tile of the level
  StiPart part;
  friend auto operator<=>(const StiTile&, const StiTile&) = default;
};

// The height of a line `x` px to the right of its left end.
double height_at(const TileShape& shape, double x) {
  const auto last = static_cast<double>(shape.heights.size() - 1);
  const double at = x / (shape.tiles * kTileSize) * last;
  const double from = std::min(std::floor(at), last - 1);
  const double a = shape.heights[static_cast<std::size_t>(from)],
               b = shape.heights[static_cast<std::size_t>(from) + 1];
  return a + (b - a) * (at - from);
}

// The least and the greatest height over one of its columns.
std::pair<double, double> range_of(const TileShape& shape, int column) {
  std::pair<double, double> range = {1000, -1000};
  const auto note = [&](double height) {
    range = {std::min(range.first, height), std::max(range.second, height)};
  };
  note(height_at(shape, column * kTileSize));
  note(height_at(shape, (column + 1) * kTileSize));
  const auto last = static_cast<double>(shape.heights.size() - 1);
  for (std::size_t i = 0; i < shape.heights.size(); ++i) {
    const double x = shape.tiles * kTileSize * (static_cast<double>(i) / last);
    if (x > column * kTileSize && x < (column + 1) * kTileSize) note(shape.heights[i]);
  }
  return range;
}

class StiMaker {
 public:
  explicit StiMaker(const Level& level) : level_(level), parts_(level.map.cells().size()) {
    for (int tile = 0; tile < kTileCount; ++tile) {
      TileShape shape = shape_of_tile(level, static_cast<std::uint8_t>(tile));
      if (!problem_of(shape)) shapes_[static_cast<std::size_t>(tile)] = std::move(shape);
    }
    spread();
  }

  int overlaps() const { return overlaps_; }  // cells that two slopes reach into
  // Puts the cells and the tiles into a map, and gives the images of the tiles from 256 on.
  std::vector<int> fill(TiledMap& map) const;

 private:
  const TileShape& shape(int tile) const { return shapes_[static_cast<std::size_t>(tile)]; }
  bool is_line(int tile) const {
    const auto kind = shape(tile).kind;
    return kind == TileShape::Kind::slope || kind == TileShape::Kind::profile;
  }
  void spread();
  void reach(Cell cell, const StiPart& part);
  // The tile as it stands anywhere, without what reaches into its cell.
  StiPart own_part(int tile) const;
  TiledTile described(const StiTile& tile, int id) const;

  const Level& level_;
  std::array<TileShape, kTileCount> shapes_;
  std::vector<StiPart> parts_;  // by cell
  int overlaps_ = 0;
};

StiPart StiMaker::own_part(int tile) const {
  const TileShape& own = shape(tile);
  if (own.kind == TileShape::Kind::none) return {};
  if (is_line(tile)) {
    const auto [least, greatest] = range_of(own, 0);
    if (greatest <= 0 || (own.one_way && least >= kTileSize)) return {};
  }
  return {tile, 0, 0};
}

void StiMaker::spread() {
  const TileMap& map = level_.map;
  std::array<StiPart, kTileCount> own;
  for (int tile = 0; tile < kTileCount; ++tile) own[static_cast<std::size_t>(tile)] = own_part(tile);
  for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i] = own[map.cells()[i]];
  for (Cell cell; cell.y < map.height(); ++cell.y) {
    for (cell.x = 0; cell.x < map.width(); ++cell.x) {
      const int tile = map.at(cell);
      if (!is_line(tile)) continue;
      const TileShape& line = shape(tile);
      const int up = line.side == TileShape::Side::floor ? -1 : 1;
      for (int column = 0; column < line.tiles; ++column) {
        const auto [least, greatest] = range_of(line, column);
        for (int row = column == 0 ? 1 : 0; row * kTileSize < greatest; ++row) {
          if (!line.one_way || least < (row + 1) * kTileSize)
            reach({cell.x + column, cell.y + up * row}, {tile, column, row});
        }
      }
    }
  }
}

void StiMaker::reach(Cell cell, const StiPart& part) {
  const TileMap& map = level_.map;
  if (!map.contains(cell)) return;
  StiPart& there = parts_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(map.width()) +
                          static_cast<std::size_t>(cell.x)];
  if (there.owner < 0)
    there = part;
  else if (is_line(there.owner))
    ++overlaps_;
}

TiledTile StiMaker::described(const StiTile& tile, int id) const {
  TiledTile described;
  described.id = id;
  described.properties =
      tiled_flag_properties(level_, level_.tile_flags(static_cast<std::uint8_t>(tile.image)));
  if (tile.part.owner < 0) return described;
  TiledProperties& properties = described.properties;
  const TileShape& of = shape(tile.part.owner);
  const auto put = [&](std::string_view name, auto value) {  // in place of a flag's bool of that name
    std::erase_if(properties, [&](const TiledProperty& property) { return property.name == name; });
    properties.push_back({std::string(name), value});
  };
  put("collidable", true);
  if (of.one_way) put("one_way", true);
  if (!is_line(tile.part.owner)) return described;
  const auto height = [&](double x) {
    return height_at(of, tile.part.column * kTileSize + x) - tile.part.rows * kTileSize;
  };
  put("slope", std::string(of.side == TileShape::Side::floor ? "floor" : "ceiling"));
  put("h0", height(0));
  put("h1", height(kTileSize));
  if (of.kind != TileShape::Kind::profile) return described;
  std::string heights;
  for (int x = 0; x <= kTileSize; ++x) {
    if (x > 0) heights += ' ';
    append_number(heights, height(x));
  }
  put("heights", heights);
  return described;
}

std::vector<int> StiMaker::fill(TiledMap& map) const {
  TiledTileset& tileset = map.tilesets.front();
  std::map<StiTile, int> ids;
  const auto old = std::move(tileset.tiles);
  tileset.tiles.clear();
  for (int tile = 0; tile < kTileCount; ++tile) {
    const StiTile plain = {tile, own_part(tile)};
    ids.emplace(plain, tile);
    TiledTile entry = described(plain, tile);
    const auto outlined =
        std::find_if(old.begin(), old.end(), [&](const TiledTile& t) { return t.id == tile; });
    if (outlined != old.end()) entry.objects = outlined->objects;
    if (!entry.properties.empty() || !entry.objects.empty()) tileset.tiles.push_back(std::move(entry));
  }
  std::vector<int> more;
  std::vector<std::uint32_t>& cells = map.layers.front().cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const StiTile tile = {level_.map.cells()[i], parts_[i]};
    const auto [found, is_new] = ids.try_emplace(tile, kTileCount + static_cast<int>(more.size()));
    if (is_new) {
      more.push_back(tile.image);
      tileset.tiles.push_back(described(tile, found->second));
    }
    const bool stays_empty = cells[i] == 0 && found->second == 0;
    if (!stays_empty) cells[i] = static_cast<std::uint32_t>(found->second) + 1;
  }
  return more;
}

// The sheet, and below it in rows of 16 the images of more tiles.
std::string sti_picture(const Level& level, const std::vector<int>& more, TiledTileset& tileset) {
  const int rows = (static_cast<int>(more.size()) + kSheetColumns - 1) / kSheetColumns;
  tileset.image_height = kSheetSide + rows * kTileSize;
  tileset.tile_count = kTileCount + rows * kSheetColumns;
  if (more.empty()) return write_png_part(level, PngPart::tiles);
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < tileset.image_height; ++y) {
    for (int x = 0; x < kSheetSide; ++x) {
      const int tile = y / kTileSize * kSheetColumns + x / kTileSize, further = tile - kTileCount;
      const bool is_blank = further >= static_cast<int>(more.size());
      const int image = further < 0 ? tile : is_blank ? 0 : more[static_cast<std::size_t>(further)];
      const auto pixel = static_cast<std::size_t>(y % kTileSize * kTileSize + x % kTileSize);
      const Rgb color =
          level.palette[level.sheet(SheetId::tiles).images[static_cast<std::size_t>(image)][pixel]];
      bytes.insert(bytes.end(), {color.r, color.g, color.b});
    }
  }
  return encode_png(kSheetSide, tileset.image_height, 3, bytes.data());
}

}  // namespace

FormatResult<Exported> export_sti(const ExportRequest& request) {
  const Level& level = request.level;
  TiledMap map = tiled_map_of(request);
  const StiMaker maker(level);
  if (!request.progress.at(0.3)) return Exported();
  const std::vector<int> more = maker.fill(map);
  if (!request.progress.at(0.8)) return Exported();
  std::string picture = sti_picture(level, more, map.tilesets.front());
  std::vector<std::string> dropped;
  const auto drop = [&](const std::string& what, std::size_t count, const std::string& of) {
    if (count > 0) dropped.push_back(what + std::to_string(count) + of + (count == 1 ? "" : "s"));
  };
  drop("the second of two slopes that reach into ", static_cast<std::size_t>(maker.overlaps()), " cell");
  drop("collision, which bump.lua has none of, with ", map.layers.back().objects.size(), " curve");
  return tiled_files(request, tiled_lua_text(map), std::move(picture), std::move(dropped));
}

}  // namespace talus
