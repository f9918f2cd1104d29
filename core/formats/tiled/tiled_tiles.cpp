// Numbers and pixels of tiles.
#include "tiled_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "../import/numbered_box.h"

namespace talus {
namespace {

constexpr std::size_t kCellsAtOnce = 65'536;  // between checks of the progress
constexpr std::uint32_t kTurns = kTiledFlipX | kTiledFlipY | kTiledFlipXY;
constexpr const char* kTakeUsed = "`talus import --tiles-used` takes only those that the map shows";

FormatError whole_error(std::string message, std::string remedy = {}) {
  return {"", std::move(message), std::move(remedy)};
}

// What a cell shows: a tile, and how the cell turns it. A tile that does not have the size of a cell is
// turned elsewhere than the cell, so that a turned one is a tile of its own.
struct ShownTile {
  TiledSource source;
  TileTurn turn = TileTurn::none;
};

// By the number in the layers, with the bits that turn the tile.
using SourceOfCell = std::unordered_map<std::uint32_t, ShownTile>;

class TileNumberer {
 public:
  TileNumberer(const TiledMap& map, const std::vector<const TiledLayer*>& layers,
               const TiledPictures& pictures, const SheetLayout& base, std::optional<Rgb> color_0,
               ImportDrops& drops, const Progress& progress)
      : progress_(progress),
        map_(map),
        layers_(layers),
        pictures_(pictures),
        base_(base),
        color_0_(color_0),
        drops_(drops) {
    for (const TiledLayer* layer : layers) cell_count_ += layer->cells.size();
    for (std::size_t i = 0; i < map.tilesets.size(); ++i) order_.push_back(static_cast<int>(i));
    std::stable_sort(order_.begin(), order_.end(),
                     [&](int a, int b) { return tileset(a).first_gid < tileset(b).first_gid; });
  }

  FormatResult<TiledTiles> as_they_are();
  FormatResult<TiledTiles> used();
  FormatResult<TiledTiles> again(const TiledFrame& frame);

 private:
  const TiledTileset& tileset(int i) const { return map_.tilesets[static_cast<std::size_t>(i)]; }
  // Adds the tiles that animations of these show.
  void add_frames(std::set<TiledSource>& sources) const;
  // The tiles that the different cells show; blank sources for empty cells.
  FormatResult<SourceOfCell> sources_of_cells() const;
  int tileset_of(std::uint32_t gid) const;
  TiledSource source_of(std::uint32_t cell) const;
  ShownTile shown_by(const TiledSource& source) const;
  std::set<int> tilesets_of_objects() const;
  std::vector<int> shown_tilesets(const SourceOfCell& cells);
  SheetLayout layout_of(const std::vector<int>& tilesets) const;
  SheetLayout folded_layout(const std::vector<int>& tilesets) const;
  bool is_better_folded(const SheetLayout& layout, const std::vector<int>& tilesets) const;
  FormatResult<void> place_tilesets(const std::vector<int>& tilesets);
  FormatResult<void> add_turned(const SourceOfCell& cells);
  FormatResult<void> add_tile(const TiledSource& source);
  bool is_blank(const TiledSource& source) const;
  bool shows_tile_0() const;
  // frame: how the map was numbered before; null: it was not.
  FormatResult<void> free_tile_0(const TiledFrame* frame);
  FormatResult<void> fill_map(const SourceOfCell& cells);

  const Progress& progress_;
  const TiledMap& map_;
  const std::vector<const TiledLayer*>& layers_;
  const TiledPictures& pictures_;
  SheetLayout base_;
  std::optional<Rgb> color_0_;  // of a level of Talus
  ImportDrops& drops_;
  std::vector<int> order_;  // tilesets by their first number
  TiledTiles tiles_;
  std::size_t cell_count_ = 0;  // of all layers
  // Of a frame: all tiles that the level has. Cells turn those whose turned form is not among them.
  std::optional<std::set<TiledSource>> known_;
};

FormatResult<SourceOfCell> TileNumberer::sources_of_cells() const {
  constexpr std::size_t kMaxDifferent = std::size_t{kTileTurns} * kMaxTiles;
  SourceOfCell sources;
  std::size_t done = 0;
  for (const TiledLayer* layer : layers_) {
    std::optional<std::uint32_t> last;  // the cell before
    for (const std::uint32_t cell : layer->cells) {
      if (done++ % kCellsAtOnce == 0 && !progress_.at(done, 2 * cell_count_)) return was_cancelled();
      if (std::exchange(last, cell) == cell || sources.contains(cell)) continue;
      if (sources.size() == kMaxDifferent) {
        return tl::unexpected(whole_error("shows more than " + std::to_string(kMaxDifferent) +
                                          " different tiles, turned ones among them, which is too many"));
      }
      sources[cell] = shown_by(source_of(cell));
    }
  }
  return sources;
}

// -1: none has it. gid: without bits that turn it.
int TileNumberer::tileset_of(std::uint32_t gid) const {
  const auto after = std::upper_bound(order_.begin(), order_.end(), gid, [&](std::uint32_t number, int of) {
    return number < tileset(of).first_gid;
  });
  return after == order_.begin() ? -1 : *std::prev(after);
}

// A blank one for an empty cell, or if no tileset has its tile.
TiledSource TileNumberer::source_of(std::uint32_t cell) const {
  const std::uint32_t gid = cell & kTiledIdBits;
  if (gid == 0) return {};
  const int of = tileset_of(gid);
  const auto id = of < 0 ? 0 : gid - tileset(of).first_gid;
  if (of < 0 || id >= static_cast<std::uint32_t>(grid_of(tileset(of)).count)) {
    drops_.add("tile " + std::to_string(gid) + " in cells, which no tileset has");
    return {};
  }
  return {of, static_cast<int>(id), cell & kTurns};
}

ShownTile TileNumberer::shown_by(const TiledSource& source) const {
  if (source.tileset < 0) return {source};
  const bool is_known = known_ && (known_->contains(source) || source.turn == 0);
  const TiledPlace place = place_of_tile(map_, pictures_, {source.tileset, source.id, 0});
  const bool is_cell = place.size == map_.tile_size && place.x == 0 && place.y == 0;
  if (source.turn != 0 && !is_known && (known_ || is_cell))
    return {{source.tileset, source.id, 0}, static_cast<TileTurn>(source.turn >> kTiledTurnShift)};
  return {source};
}

std::set<int> TileNumberer::tilesets_of_objects() const {
  std::set<int> shown;
  for (const TiledLayer& layer : map_.layers) {
    for (const TiledObject& object : layer.objects)
      if (object.gid != 0) shown.insert(tileset_of(object.gid & kTiledIdBits));
  }
  return shown;
}

// The tilesets of which the map's cells show tiles, by their first numbers; if it shows no tile, the first
// tileset that has any.
std::vector<int> TileNumberer::shown_tilesets(const SourceOfCell& cells) {
  std::set<int> shown;
  for (const auto& [cell, tile] : cells) {
    if (tile.source.tileset >= 0) shown.insert(tile.source.tileset);
  }
  const auto first =
      std::find_if(order_.begin(), order_.end(), [&](int i) { return grid_of(tileset(i)).count > 0; });
  if (shown.empty() && first != order_.end()) shown.insert(*first);
  const std::set<int> of_objects = tilesets_of_objects();
  std::vector<int> tilesets;
  for (const int i : order_) {
    if (shown.contains(i))
      tilesets.push_back(i);
    else if (!of_objects.contains(i))
      drops_.add("the tileset " + quoted_name(tileset(i).name) + ", which the map does not show");
  }
  return tilesets;
}

// Whether a level may have such a sheet.
bool is_sheet(const SheetLayout& layout) {
  return layout.columns <= kMaxSheetSide && layout.rows() <= kMaxSheetSide && layout.count <= kMaxTiles;
}

// Puts the tilesets below one another.
FormatResult<void> TileNumberer::place_tilesets(const std::vector<int>& tilesets) {
  SheetLayout layout = layout_of(tilesets);
  const bool is_known = tilesets.size() == 1 && grid_of(tileset(tilesets[0])) == base_;
  if (is_known) layout = base_;
  const bool is_folded = !is_known && is_better_folded(layout, tilesets);
  if (is_folded) layout = folded_layout(tilesets);
  if (!is_sheet(layout)) {
    return tl::unexpected(whole_error("has tilesets of " + std::to_string(layout.columns) + "x" +
                                          std::to_string(layout.rows()) +
                                          " tiles in all, but a level has only 65536, in up to 2048 columns "
                                          "and rows",
                                      kTakeUsed));
  }
  tiles_.columns = layout.columns;
  tiles_.sources.assign(static_cast<std::size_t>(layout.count), {});
  int row = 0, next = 0;
  for (const int i : tilesets) {
    const SheetLayout grid = grid_of(tileset(i));
    for (int id = 0; id < grid.count; ++id) {
      const Cell place = grid.place_of(id);
      const int number = is_folded ? next++ : layout.tile_at({place.x, row + place.y});
      tiles_.sources[static_cast<std::size_t>(number)] = {i, id, 0};
    }
    row += grid.rows();
  }
  return {};
}

// All tiles one behind another, on a sheet that is about as wide as high.
SheetLayout TileNumberer::folded_layout(const std::vector<int>& tilesets) const {
  std::int64_t count = 0;
  for (const int i : tilesets) count += grid_of(tileset(i)).count;
  count = std::min<std::int64_t>(count, kMaxTiles + 1);  // more than a level has
  const double ratio = 1.0 * map_.tile_size.height / map_.tile_size.width;
  const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count) * ratio)));
  return {std::clamp(columns, kCartColumns, kMaxSheetSide), static_cast<int>(count)};
}

// Wide tilesets below narrow ones leave much of the sheet blank. They stay as they are unless only a folded
// sheet has room for them, or for their picture.
bool TileNumberer::is_better_folded(const SheetLayout& layout, const std::vector<int>& tilesets) const {
  const auto has_picture = [&](const SheetLayout& sheet) {
    const std::int64_t width = std::int64_t{sheet.columns} * map_.tile_size.width;
    const std::int64_t height = std::int64_t{sheet.rows()} * map_.tile_size.height;
    return is_sheet(sheet) && width <= kMaxSheetPictureSide && height <= kMaxSheetPictureSide &&
           width * height <= kMaxSheetPicturePixels;
  };
  const SheetLayout more{layout.columns, layout.count + 1};  // the empty tile may come behind the others
  if (has_picture(more)) return false;
  const SheetLayout folded = folded_layout(tilesets);
  return has_picture(folded) || (!is_sheet(more) && is_sheet(folded));
}

// That of a cart if a single tileset fits on it; else one as wide as the widest of them.
SheetLayout TileNumberer::layout_of(const std::vector<int>& tilesets) const {
  int columns = 1, last = 1;
  std::int64_t rows = 0;
  for (const int i : tilesets) columns = std::max(columns, grid_of(tileset(i)).columns);
  for (const int i : tilesets) {
    rows += grid_of(tileset(i)).rows();
    last = (grid_of(tileset(i)).count - 1) % grid_of(tileset(i)).columns + 1;
  }
  const bool fits_cart = tilesets.size() <= 1 && columns <= kCartColumns && rows <= kCartTiles / kCartColumns;
  if (fits_cart) return {};
  constexpr std::int64_t kMax = 1 << 30;  // of a file that lies; no level has so many
  return {columns, static_cast<int>(std::min((rows - 1) * columns + last, kMax))};
}

void TileNumberer::add_frames(std::set<TiledSource>& sources) const {
  const std::set<TiledSource> animated = sources;
  for (const TiledSource& source : animated) {
    const TiledTile* const tile =
        source.tileset < 0 ? nullptr : find_tile(tileset(source.tileset), source.id);
    if (tile == nullptr) continue;
    for (const TiledTile::Frame& frame : tile->animation) {
      if (frame.id < grid_of(tileset(source.tileset)).count)
        sources.insert({source.tileset, frame.id, source.turn});
    }
  }
}

// Adds the tiles that the map turns, and that its cells cannot, behind the others.
FormatResult<void> TileNumberer::add_turned(const SourceOfCell& cells) {
  std::set<TiledSource> turned;
  for (const auto& [cell, tile] : cells) {
    if (tile.source.turn != 0) turned.insert(tile.source);
  }
  if (turned.empty()) return {};
  add_frames(turned);
  drops_.add(
      "that " + std::to_string(turned.size()) +
      " of the tiles are others that are mirrored or turned and do not have the size of a cell: they are "
      "tiles of their own");
  for (const TiledSource& source : turned) {
    if (const auto added = add_tile(source); !added) return added;
  }
  return {};
}

// Takes the first place behind all others, or makes one.
FormatResult<void> TileNumberer::add_tile(const TiledSource& source) {
  const auto is_taken = [](const TiledSource& s) { return s.tileset >= 0; };
  const auto last = std::find_if(tiles_.sources.rbegin(), tiles_.sources.rend(), is_taken);
  if (last != tiles_.sources.rbegin()) {
    *last.base() = source;
    return {};
  }
  const auto full = static_cast<std::size_t>(std::min(kMaxTiles, kMaxSheetSide * tiles_.columns));
  if (tiles_.sources.size() < full) return tiles_.sources.push_back(source), FormatResult<void>();
  return tl::unexpected(
      whole_error("needs more than " + std::to_string(full) + " tiles with those that it turns", kTakeUsed));
}

// A tile that is not drawn and has no properties. In the single layer of a level of Talus, one of colour 0 is
// not seen.
bool TileNumberer::is_blank(const TiledSource& source) const {
  if (source.tileset < 0) return true;
  if (find_tile(tileset(source.tileset), source.id)) return false;
  if (!place_of_tile(map_, pictures_, source).is_in_cell) return false;
  const TiledTiles alone{.columns = 1, .sources = {source}, .cells = {}};
  const SheetPicture picture = picture_of_tiles(alone, map_, pictures_, map_.tile_size);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const Rgb color{picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
    if (picture.rgba[i + 3] != 0 && (layers_.size() > 1 || color != color_0_)) return false;
  }
  return true;
}

// Whether a cell shows the first tile of the sheet.
bool TileNumberer::shows_tile_0() const {
  const TiledSource& first = tiles_.sources[0];
  const std::uint32_t number = tileset(first.tileset).first_gid + static_cast<std::uint32_t>(first.id);
  return std::any_of(layers_.begin(), layers_.end(), [&](const TiledLayer* layer) {
    return std::any_of(layer->cells.begin(), layer->cells.end(),
                       [&](std::uint32_t cell) { return (cell & kTiledIdBits) == number; });
  });
}

// For empty cells, and for those that are emptied later. A map without empty cells may keep its tile 0: one
// that Talus wrote, one that would not fit a cart any more, and one that was numbered so before. In one that
// Talus wrote, the picture of tile 0 may also be that of the empty tile, which no cell shows. The map is not
// filled yet.
FormatResult<void> TileNumberer::free_tile_0(const TiledFrame* frame) {
  const bool has_empty = std::any_of(layers_.begin(), layers_.end(), [](const TiledLayer* layer) {
    return std::find(layer->cells.begin(), layer->cells.end(), 0U) != layer->cells.end();
  });
  tiles_.is_0_empty = true;
  if (is_blank(tiles_.sources[0])) return {};
  auto blank = std::find_if(tiles_.sources.begin(), tiles_.sources.end(),
                            [&](const TiledSource& source) { return is_blank(source); });
  const bool is_own = find_property<std::string>(map_.properties, kTiledLevelProperty) != nullptr;
  const bool is_full_cart = blank == tiles_.sources.end() && tiles_.sources.size() == kCartTiles;
  tiles_.is_0_empty = has_empty || (frame == nullptr ? !is_own && !is_full_cart : frame->is_0_empty);
  if (!tiles_.is_0_empty || (is_own && !shows_tile_0())) return {};
  if (blank == tiles_.sources.end()) {
    if (const auto added = add_tile({}); !added) return added;
    blank = std::prev(tiles_.sources.end());
  }
  std::swap(tiles_.sources[0], *blank);
  return {};
}

FormatResult<void> TileNumberer::fill_map(const SourceOfCell& cells) {
  std::map<TiledSource, TileNumber> numbers;
  for (std::size_t n = 0; n < tiles_.sources.size(); ++n)
    numbers.try_emplace(tiles_.sources[n], static_cast<TileNumber>(n));
  numbers[TiledSource{}] = 0;
  std::unordered_map<std::uint32_t, MapCell> content;
  for (const auto& [cell, tile] : cells) content[cell] = {numbers.at(tile.source), tile.turn};
  std::size_t done = 0;
  for (const TiledLayer* layer : layers_) {
    MapCells& filled = tiles_.cells.emplace_back(layer->cells.size());
    std::size_t i = 0;
    std::pair<std::uint32_t, MapCell> last{0, content.contains(0) ? content.at(0) : MapCell()};
    for (const std::uint32_t cell : layer->cells) {
      if (done++ % kCellsAtOnce == 0 && !progress_.at(cell_count_ + done, 2 * cell_count_))
        return was_cancelled();
      if (cell != last.first) last = {cell, content.at(cell)};
      filled.set(i++, last.second);
    }
  }
  return {};
}

FormatResult<TiledTiles> TileNumberer::as_they_are() {
  const auto cells = sources_of_cells();
  if (!cells) return tl::unexpected(cells.error());
  if (const auto placed = place_tilesets(shown_tilesets(*cells)); !placed)
    return tl::unexpected(placed.error());
  if (const auto added = add_turned(*cells); !added) return tl::unexpected(added.error());
  if (const auto freed = free_tile_0(nullptr); !freed) return tl::unexpected(freed.error());
  if (const auto filled = fill_map(*cells); !filled) return tl::unexpected(filled.error());
  return std::move(tiles_);
}

FormatResult<TiledTiles> TileNumberer::used() {
  const auto cells = sources_of_cells();
  if (!cells) return tl::unexpected(cells.error());
  std::set<TiledSource> shown;
  for (const auto& [cell, tile] : *cells) shown.insert(tile.source);
  shown.erase(TiledSource{});
  add_frames(shown);
  if (shown.size() >= kMaxTiles) {
    return tl::unexpected(whole_error("shows " + std::to_string(shown.size()) +
                                      " different tiles, but a level has only 65535 besides the empty one"));
  }
  const auto columns =
      static_cast<std::size_t>(shown.size() < kCartColumns * kMaxSheetSide ? kCartColumns : 2 * kCartColumns);
  const std::size_t rows =
      std::max<std::size_t>(kCartTiles / kCartColumns, (shown.size() + columns) / columns);
  tiles_.columns = static_cast<int>(columns);
  tiles_.sources.assign(rows * columns, {});
  std::copy(shown.begin(), shown.end(), tiles_.sources.begin() + 1);
  tiles_.keeps_numbers = false;
  if (const auto filled = fill_map(*cells); !filled) return tl::unexpected(filled.error());
  return std::move(tiles_);
}

FormatResult<TiledTiles> TileNumberer::again(const TiledFrame& frame) {
  tiles_.columns = frame.columns;
  tiles_.keeps_numbers = frame.keeps_numbers;
  tiles_.sources.clear();
  for (const std::uint32_t tile : frame.tiles) tiles_.sources.push_back(source_of(tile));
  known_.emplace(tiles_.sources.begin(), tiles_.sources.end());
  const auto cells = sources_of_cells();
  if (!cells) return tl::unexpected(cells.error());
  std::set<TiledSource> added;
  for (const int i : frame.keeps_numbers ? shown_tilesets(*cells) : std::vector<int>()) {
    for (int id = 0; id < grid_of(tileset(i)).count; ++id) added.insert({i, id, 0});
  }
  for (const auto& [cell, tile] : *cells) {
    if (tile.source.tileset >= 0) added.insert(tile.source);
  }
  add_frames(added);
  for (const TiledSource& source : added) {
    if (known_->contains(source)) continue;
    if (const auto done = add_tile(source); !done) return tl::unexpected(done.error());
  }
  if (const auto freed = free_tile_0(&frame); !freed) return tl::unexpected(freed.error());
  if (const auto filled = fill_map(*cells); !filled) return tl::unexpected(filled.error());
  return std::move(tiles_);
}

using Pixel = std::array<std::uint8_t, 4>;
constexpr Pixel kClear{};

// The colour of a pixel of a picture, which is transparent outside of it.
Pixel color_in(const RgbaPicture& rgba, Cell at) {
  if (at.x < 0 || at.y < 0 || at.x >= rgba.width || at.y >= rgba.height) return kClear;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(rgba.bytes.data()) +
                      4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(rgba.width) +
                           static_cast<std::size_t>(at.x));
  return {bytes[0], bytes[1], bytes[2], bytes[3]};
}

// The size that the file says, or else that of the picture, or else that of the map's tiles.
TileSize size_in_collection(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source) {
  const auto of = static_cast<std::size_t>(source.tileset);
  const TiledTile* const tile = find_tile(map.tilesets[of], source.id);
  if (tile == nullptr) return map.tile_size;
  if (tile->image_size.width > 0 && tile->image_size.height > 0) return tile->image_size;
  if (pictures[of] == nullptr) return map.tile_size;
  const auto own = pictures[of]->of_tiles.find(source.id);
  if (own == pictures[of]->of_tiles.end() || own->second == nullptr) return map.tile_size;
  return {std::max(1, own->second->width - tile->image_x), std::max(1, own->second->height - tile->image_y)};
}

// The colour at (x, y) of an image of that size that stands for a tile: of the pixel in the middle of that
// part of the cell.
Pixel color_of(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source, TileSize image,
               int x, int y) {
  const auto of = static_cast<std::size_t>(source.tileset);
  if (source.tileset < 0 || !pictures[of]) return kClear;
  const TiledTileset& tileset = map.tilesets[of];
  const auto own = pictures[of]->of_tiles.find(source.id);
  const bool has_own = own != pictures[of]->of_tiles.end();
  if (has_own ? own->second == nullptr : pictures[of]->is_missing()) {
    const Rgb box =
        color_of_box(source.id, x * kCartTileSize / image.width, y * kCartTileSize / image.height);
    return {box.r, box.g, box.b, 255};
  }
  if (tileset.is_collection && !has_own) return kClear;
  const TiledPlace place = place_of_tile(map, pictures, source);
  const auto [width, height] = place.size;
  const bool is_quarter = (source.turn & kTiledFlipXY) != 0;
  const Vec2 scale = is_quarter ? Vec2{place.scale.y, place.scale.x} : place.scale;
  double at_x = ((2 * x + 1) * map.tile_size.width / (2.0 * image.width) - place.x) / scale.x;
  double at_y = ((2 * y + 1) * map.tile_size.height / (2.0 * image.height) - place.y) / scale.y;
  if (source.turn & kTiledFlipY) at_y = (is_quarter ? width : height) - at_y;
  if (source.turn & kTiledFlipX) at_x = (is_quarter ? height : width) - at_x;
  if (is_quarter) std::swap(at_x, at_y);
  if (at_x < 0 || at_y < 0 || at_x >= width || at_y >= height) return kClear;
  const Cell in_tile = {static_cast<int>(at_x), static_cast<int>(at_y)};
  if (has_own) {
    const TiledTile* const tile = find_tile(tileset, source.id);
    return color_in(*own->second, {tile->image_x + in_tile.x, tile->image_y + in_tile.y});
  }
  const int columns = grid_of(tileset).columns, row = source.id / columns, column = source.id % columns;
  const Pixel color =
      color_in(pictures[of]->file->rgba, {tileset.margin + column * (width + tileset.spacing) + in_tile.x,
                                          tileset.margin + row * (height + tileset.spacing) + in_tile.y});
  return tileset.transparent == Rgb{color[0], color[1], color[2]} ? kClear : color;
}

}  // namespace

SheetLayout grid_of(const TiledTileset& tileset) {
  const auto along = [&](int length, int side) {
    return std::max(0, (length - tileset.margin + tileset.spacing) / (side + tileset.spacing));
  };
  const auto [tile_width, tile_height] = tileset.tile_size;
  const int columns = tileset.columns > 0 ? tileset.columns : along(tileset.image_width, tile_width);
  if (tileset.is_collection) return {columns > 0 ? columns : kCartColumns, tileset.tile_count};
  constexpr std::int64_t kMax = 1 << 20;
  const std::int64_t in_picture = std::int64_t{columns} * along(tileset.image_height, tile_height);
  const int count =
      tileset.tile_count > 0 ? tileset.tile_count : static_cast<int>(std::min(in_picture, kMax));
  return {columns > 0 ? columns : kCartColumns, count > 0 ? count : kCartTiles};
}

TileSize size_in_picture(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source) {
  const TiledTileset& tileset = map.tilesets[static_cast<std::size_t>(source.tileset)];
  return tileset.is_collection ? size_in_collection(map, pictures, source) : tileset.tile_size;
}

TiledPlace place_of_tile(const TiledMap& map, const TiledPictures& pictures, const TiledSource& source) {
  const TiledTileset& tileset = map.tilesets[static_cast<std::size_t>(source.tileset)];
  const auto [cell_width, cell_height] = map.tile_size;
  TiledPlace place{.size = size_in_picture(map, pictures, source)};
  Vec2 box{1.0 * place.size.width, 1.0 * place.size.height};
  if (tileset.fits_grid) {
    box = {1.0 * cell_width, 1.0 * cell_height};
    place.scale = {box.x / place.size.width, box.y / place.size.height};
    if (tileset.keeps_ratio) place.scale.x = place.scale.y = std::min(place.scale.x, place.scale.y);
  }
  Vec2 drawn{place.size.width * place.scale.x, place.size.height * place.scale.y};
  if ((source.turn & kTiledFlipXY) != 0) {
    std::swap(drawn.x, drawn.y);
    std::swap(box.x, box.y);
  }
  place.x = (box.x - drawn.x) / 2 + tileset.offset_x * place.scale.x;
  place.y = cell_height - (box.y + drawn.y) / 2 + tileset.offset_y * place.scale.y;
  place.is_in_cell = place.scale == Vec2{1, 1} && place.x >= 0 && place.y >= 0 &&
                     place.x + drawn.x <= cell_width && place.y + drawn.y <= cell_height;
  return place;
}

TiledSource source_of_gid(const TiledMap& map, std::uint32_t gid) {
  const std::uint32_t number = gid & kTiledIdBits;
  int of = -1;
  for (std::size_t i = 0; i < map.tilesets.size() && number > 0; ++i) {
    const std::uint32_t first = map.tilesets[i].first_gid;
    if (first <= number && (of < 0 || first >= map.tilesets[static_cast<std::size_t>(of)].first_gid))
      of = static_cast<int>(i);
  }
  if (of < 0) return {};
  const TiledTileset& tileset = map.tilesets[static_cast<std::size_t>(of)];
  const std::uint32_t id = number - tileset.first_gid;
  if (id >= static_cast<std::uint32_t>(grid_of(tileset).count)) return {};
  return {of, static_cast<int>(id), gid & kTurns};
}

Vec2 anchor_of_gid(const TiledMap& map, std::uint32_t gid) {
  const TiledSource source = source_of_gid(map, gid);
  return source.tileset < 0 ? TiledTileset().anchor
                            : map.tilesets[static_cast<std::size_t>(source.tileset)].anchor;
}

FormatResult<TiledTiles> number_tiles(const TiledMap& map, const std::vector<const TiledLayer*>& layers,
                                      const TiledPictures& pictures, const ImportChoices& choices,
                                      const SheetLayout& base, std::optional<Rgb> color_0, ImportDrops& drops,
                                      const Progress& progress) {
  TileNumberer numberer(map, layers, pictures, base, color_0, drops, progress);
  if (choices.frame) return numberer.again(*choices.frame);
  return choices.used_tiles ? numberer.used() : numberer.as_they_are();
}

TiledFrame frame_of(const TiledTiles& tiles, const TiledMap& map) {
  TiledFrame frame{.tiles = {},
                   .columns = tiles.columns,
                   .is_0_empty = tiles.is_0_empty,
                   .keeps_numbers = tiles.keeps_numbers,
                   .x = map.first.x,
                   .y = map.first.y,
                   .width = map.width,
                   .height = map.height};
  for (const TiledSource& source : tiles.sources) {
    const std::uint32_t first =
        source.tileset < 0 ? 0 : map.tilesets[static_cast<std::size_t>(source.tileset)].first_gid;
    frame.tiles.push_back(first == 0 ? 0 : (first + static_cast<std::uint32_t>(source.id)) | source.turn);
  }
  return frame;
}

std::vector<Tileset> tilesets_of(const TiledTiles& tiles, const TiledMap& map) {
  std::vector<Tileset> sets;
  if (!tiles.keeps_numbers) return sets;
  const SheetLayout layout{tiles.columns, static_cast<int>(tiles.sources.size())};
  const auto number_in = [&](Cell place) { return std::int64_t{place.y} * layout.columns + place.x; };
  std::map<int, std::map<int, int>> tiles_by_first;  // by tileset
  for (int number = 0; number < layout.count; ++number) {
    const TiledSource& source = tiles.sources[static_cast<std::size_t>(number)];
    if (source.tileset < 0 || source.turn != 0) continue;
    const SheetLayout grid = grid_of(map.tilesets[static_cast<std::size_t>(source.tileset)]);
    const std::int64_t first = number - number_in(grid.place_of(source.id));
    if (first >= 0) ++tiles_by_first[source.tileset][static_cast<int>(first)];
  }
  for (const auto& [tileset, firsts] : tiles_by_first) {
    const TiledTileset& source = map.tilesets[static_cast<std::size_t>(tileset)];
    const SheetLayout grid = grid_of(source);
    const auto most = std::max_element(firsts.begin(), firsts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    Tileset set;
    set.name = source.name;
    set.first = most->first;
    set.columns = std::min(grid.columns, grid.count);
    const std::int64_t count = number_in(grid.place_of(grid.count - 1)) + 1;
    set.count = static_cast<int>(std::min<std::int64_t>(count, layout.count - set.first));
    sets.push_back(std::move(set));
  }
  std::stable_sort(sets.begin(), sets.end(),
                   [](const Tileset& a, const Tileset& b) { return a.first < b.first; });
  if (sets.size() > kMaxTilesets || problem_of(sets, layout)) sets.clear();
  return sets;
}

SheetPicture picture_of_tiles(const TiledTiles& tiles, const TiledMap& map, const TiledPictures& pictures,
                              TileSize image) {
  const SheetLayout layout{tiles.columns, static_cast<int>(tiles.sources.size())};
  SheetPicture sheet{layout.columns * image.width, layout.rows() * image.height, {}};
  sheet.rgba.resize(4 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  for (int tile = 0; tile < layout.count; ++tile) {
    const TiledSource& source = tiles.sources[static_cast<std::size_t>(tile)];
    if (source.tileset < 0) continue;
    const Cell place = layout.place_of(tile);
    for (int y = 0; y < image.height; ++y) {
      const auto row =
          static_cast<std::size_t>(place.y * image.height + y) * static_cast<std::size_t>(sheet.width);
      for (int x = 0; x < image.width; ++x) {
        const Pixel color = color_of(map, pictures, source, image, x, y);
        std::copy(color.begin(), color.end(),
                  &sheet.rgba[4 * (row + static_cast<std::size_t>(place.x * image.width + x))]);
      }
    }
  }
  return sheet;
}

const TiledTile* find_tile(const TiledTileset& tileset, int id) {
  const std::vector<TiledTile>& tiles = *tileset.tiles;
  const auto found = std::lower_bound(tiles.begin(), tiles.end(), id,
                                      [](const TiledTile& tile, int wanted) { return tile.id < wanted; });
  return found == tiles.end() || found->id != id ? nullptr : &*found;
}

}  // namespace talus
