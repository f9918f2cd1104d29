// Spreads the tiles of all layers over the cells, and numbers the different cells.
#include "ldtk_tiles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include <talus/level/limits.h>
#include "../text/utf8_text.h"
#include "ldtk_keys.h"
#include "ldtk_names.h"

namespace talus {
namespace {

tl::unexpected<FormatError> ldtk_error(std::string message, std::string remedy = {}) {
  return tl::unexpected(FormatError{"", std::move(message), std::move(remedy)});
}

int divided_down(int value, int by) { return value >= 0 ? value / by : -1 - (-1 - value) / by; }

struct PlacedPart {
  std::uint32_t cell;
  LdtkPart part;
};

// Gives each different value a number, from 0.
template <class Value>
class Numbering {
 public:
  std::uint32_t number_of(const Value& value) {
    const auto [known, is_new] = numbers_.try_emplace(value, static_cast<std::uint32_t>(numbers_.size()));
    if (is_new) values_.push_back(value);
    return known->second;
  }
  std::size_t size() const { return values_.size(); }
  const Value& operator[](std::size_t number) const { return values_[number]; }
  std::vector<Value> take() { return std::move(values_); }

 private:
  std::map<Value, std::uint32_t> numbers_;
  std::vector<Value> values_;
};

class LdtkNumberer {
 public:
  LdtkNumberer(const LdtkProject& project, const LdtkLevel& level, int ground, const LdtkPictures& pictures,
               ImportDrops& drops, const Progress& progress)
      : project_(project), level_(level), pictures_(pictures), drops_(drops), progress_(progress) {
    if (ground >= 0) ground_ = &level.layers[static_cast<std::size_t>(ground)];
    cells_.number_of({});
  }

  FormatResult<LdtkTiles> number(const std::vector<std::string>& known);

 private:
  struct Cover {  // of a part
    bool is_clear = true, is_opaque = true;
  };

  bool is_ground(const LdtkLayer& layer) const;
  FormatResult<void> make_map();
  const LdtkValue* find_value(const LdtkLayer& layer, int value) const;
  FormatResult<void> place_layer(const LdtkLayer& layer);
  FormatResult<void> place_colors(const LdtkLayer& layer);
  FormatResult<void> place_tile(const LdtkLayer& layer, const LdtkTile& tile);
  FormatResult<void> place(const LdtkSource& source, int x, int y);
  FormatResult<std::vector<const LdtkLayer*>> taken_layers() const;
  FormatResult<void> take_layer(const LdtkLayer& layer, const Progress& progress);
  void take_parallax(const LdtkLayer& layer, TileLayer& taken);
  FormatResult<std::vector<TileNumber>> number_cells(const Progress& progress);
  FormatResult<LdtkCell> cell_of(LdtkCellValue value, std::span<const PlacedPart> parts);
  bool has_tags(const LdtkSource& source);
  std::string id_of_layer(const LdtkLayer& layer);
  FormatResult<void> number_known(const std::vector<std::string>& known);
  FormatResult<Cover> cover_of(const LdtkPart& part);
  FormatResult<void> count_pixels(std::size_t parts);

  const LdtkProject& project_;
  const LdtkLevel& level_;
  const LdtkPictures& pictures_;
  ImportDrops& drops_;
  const Progress& progress_;
  const LdtkLayer* ground_ = nullptr;  // null: there is none
  TileMap map_;
  Numbering<LdtkSource> sources_;
  Numbering<LdtkCell> cells_;
  std::set<std::string> layer_ids_;             // of the layers that are taken
  std::vector<TileLayer> layers_;               // that are taken
  int ground_index_ = -1;                       // of ground_ in layers_; -1: it is not in them
  const LdtkLayer* valued_ = nullptr;           // the layer, if its values are those of the cells; or null
  std::vector<PlacedPart> parts_;               // of a layer
  std::size_t part_count_ = 0;                  // of all layers
  std::map<std::pair<int, int>, bool> tagged_;  // by tileset and tile
  std::map<LdtkPart, Cover> covers_;
  std::size_t pixels_ = 0;  // that are looked at or drawn
};

// Values of a layer with another grid or place cannot be those of the cells.
bool LdtkNumberer::is_ground(const LdtkLayer& layer) const {
  return layer.type == LdtkLayer::Type::int_grid && layer.side == ground_->side &&
         layer.offset_x == ground_->offset_x && layer.offset_y == ground_->offset_y &&
         layer.columns == ground_->columns && layer.rows == ground_->rows;
}

FormatResult<void> LdtkNumberer::make_map() {
  const int side = ground_ != nullptr ? ground_->side : kCartTileSize;
  const int columns = ground_ != nullptr ? ground_->columns : (level_.head.width + side - 1) / side;
  const int rows = ground_ != nullptr ? ground_->rows : (level_.head.height + side - 1) / side;
  if (side > kMaxTileSide) {
    return ldtk_error("has a grid of " + std::to_string(side) + " px, but a level needs one of 1 to " +
                      std::to_string(kMaxTileSide));
  }
  if (!is_terrain_size(columns, rows, {side, side})) {
    return ldtk_error("has " + std::to_string(columns) + "x" + std::to_string(rows) +
                      " cells, but a level has 1 to 16777216 of them, and is at most 16777216 px long");
  }
  map_ = TileMap(columns, rows, {side, side});
  return {};
}

const LdtkValue* LdtkNumberer::find_value(const LdtkLayer& layer, int value) const {
  if (layer.def < 0) return nullptr;
  const auto& values = project_.layers[static_cast<std::size_t>(layer.def)].values;
  const auto found =
      std::find_if(values.begin(), values.end(), [&](const LdtkValue& each) { return each.value == value; });
  return found == values.end() ? nullptr : &*found;
}

// Adds the parts of a tile to all cells that it reaches into. x, y: px, of its corner on the map.
FormatResult<void> LdtkNumberer::place(const LdtkSource& source, int x, int y) {
  const int side = map_.tile_size().width;
  const int left = std::max(0, divided_down(x, side));
  const int right = std::min(map_.width() - 1, divided_down(x + source.side - 1, side));
  const int bottom = std::min(map_.height() - 1, divided_down(y + source.side - 1, side));
  const int top = std::max(0, divided_down(y, side));
  if (source.opacity == 0 || left > right || top > bottom) return {};
  const auto count = static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(bottom - top + 1);
  if (count > kMaxLdtkParts - part_count_) {
    return ldtk_error("shows too many tiles: all cells together may show parts of " +
                      std::to_string(kMaxLdtkParts));
  }
  part_count_ += count;
  const std::uint32_t number = sources_.number_of(source);
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      const auto cell = static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(map_.width()) +
                        static_cast<std::uint32_t>(column);
      parts_.push_back({cell, {number, x - column * side, y - row * side}});
    }
  }
  return {};
}

FormatResult<void> LdtkNumberer::place_tile(const LdtkLayer& layer, const LdtkTile& tile) {
  LdtkSource source;
  source.tileset = layer.tileset;
  source.x = tile.source_x;
  source.y = tile.source_y;
  source.id = tile.id;
  source.side = project_.tilesets[static_cast<std::size_t>(layer.tileset)].side;
  source.flips = (tile.flip_x ? 1 : 0) + (tile.flip_y ? 2 : 0);
  // LDtk draws each tile of a layer with the layer's opacity, also over others of the layer.
  source.opacity = static_cast<int>(tile.opacity * layer.opacity * 255 + 0.5);
  const Vec2 pivot = layer.def < 0 ? Vec2() : project_.layers[static_cast<std::size_t>(layer.def)].pivot;
  const int room = layer.side - source.side;  // that a tile of another size leaves
  const auto shift = [&](double of_pivot, bool flips) {
    return static_cast<int>(room * (flips ? 1 - of_pivot : of_pivot));
  };
  const int origin_x = ground_ != nullptr ? ground_->offset_x : 0;
  const int origin_y = ground_ != nullptr ? ground_->offset_y : 0;
  return place(source, tile.x + layer.offset_x - origin_x + shift(pivot.x, tile.flip_x),
               tile.y + layer.offset_y - origin_y + shift(pivot.y, tile.flip_y));
}

// LDtk draws an IntGrid without a tileset in the colours of its values.
FormatResult<void> LdtkNumberer::place_colors(const LdtkLayer& layer) {
  for (std::size_t i = 0; i < layer.values.size(); ++i) {
    if (layer.values[i] == 0) continue;
    const LdtkValue* const value = find_value(layer, layer.values[i]);
    const Rgb color = value != nullptr ? value->color : Rgb();
    LdtkSource source;
    source.side = layer.side;
    source.opacity = static_cast<int>(layer.opacity * 255 + 0.5);
    source.rgb = static_cast<std::uint32_t>(color.r << 16 | color.g << 8 | color.b);
    const int column = static_cast<int>(i) % layer.columns, row = static_cast<int>(i) / layer.columns;
    const auto placed = place(source, column * layer.side + layer.offset_x - ground_->offset_x,
                              row * layer.side + layer.offset_y - ground_->offset_y);
    if (!placed) return placed;
  }
  return {};
}

FormatResult<void> LdtkNumberer::place_layer(const LdtkLayer& layer) {
  const std::string of = "the layer " + quoted_name(layer.name);
  if (layer.type == LdtkLayer::Type::int_grid && layer.tileset < 0) return place_colors(layer);
  if (layer.tileset < 0) {
    if (!layer.tiles.empty()) drops_.add("the tiles of " + of + ", which has no tileset");
    return {};
  }
  for (const LdtkTile& tile : layer.tiles) {
    if (const auto placed = place_tile(layer, tile); !placed) return placed;
  }
  return {};
}

bool LdtkNumberer::has_tags(const LdtkSource& source) {
  if (source.tileset < 0) return false;
  const auto [known, is_new] = tagged_.try_emplace({source.tileset, source.id});
  if (!is_new) return known->second;
  const LdtkTileset& tileset = project_.tilesets[static_cast<std::size_t>(source.tileset)];
  known->second = std::any_of(tileset.tags.begin(), tileset.tags.end(), [&](const LdtkTag& tag) {
    return std::binary_search(tag.tiles.begin(), tag.tiles.end(), source.id);
  });
  return known->second;
}

// Of so many parts of cells, each of which may have all pixels of a cell.
FormatResult<void> LdtkNumberer::count_pixels(std::size_t parts) {
  const auto side = static_cast<std::size_t>(map_.tile_size().width);
  pixels_ += parts * side * side;
  if (pixels_ <= kMaxLdtkPixels) return {};
  return ldtk_error("shows too many different tiles: their parts in cells may have up to " +
                    std::to_string(kMaxLdtkPixels) + " pixels together");
}

// Whether a part of a tile can be seen in its cell, and whether anything below it can.
FormatResult<LdtkNumberer::Cover> LdtkNumberer::cover_of(const LdtkPart& part) {
  const auto [known, is_new] = covers_.try_emplace(part);
  Cover& cover = known->second;
  if (!is_new) return cover;
  const LdtkSource& source = sources_[part.source];
  const int side = map_.tile_size().width;
  const int left = std::max(0, part.x), right = std::min(side, part.x + source.side);
  const int top = std::max(0, part.y), bottom = std::min(side, part.y + source.side);
  if (const auto counted = count_pixels(1); !counted) return tl::unexpected(counted.error());
  cover.is_opaque = right - left == side && bottom - top == side;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      constexpr int kOpaque = 255;
      const int opacity = color_in_ldtk_source(source, pictures_, x - part.x, y - part.y).a;
      cover.is_clear = cover.is_clear && opacity == 0;
      cover.is_opaque = cover.is_opaque && opacity == kOpaque;
    }
  }
  return cover;
}

// parts: from the lowest.
FormatResult<LdtkCell> LdtkNumberer::cell_of(LdtkCellValue value, std::span<const PlacedPart> parts) {
  LdtkCell cell{{}, value};
  bool is_covered = false;
  for (auto each = parts.rbegin(); each != parts.rend(); ++each) {
    LdtkPart part = each->part;
    const bool is_tagged =
        is_in_place(part, sources_[part.source], map_.tile_size()) && has_tags(sources_[part.source]);
    const auto cover = is_covered ? Cover() : cover_of(part);
    if (!cover) return tl::unexpected(cover.error());
    part.is_hidden = cover->is_clear;
    if (!part.is_hidden || is_tagged) cell.parts.push_back(part);
    is_covered = is_covered || cover->is_opaque;
  }
  if (cell.parts.size() > kMaxLdtkCellParts) {
    return ldtk_error("shows too many tiles over one another: a cell may show " +
                      std::to_string(kMaxLdtkCellParts));
  }
  std::reverse(cell.parts.begin(), cell.parts.end());
  return cell;
}

// The tiles of the layer whose parts are there.
FormatResult<std::vector<TileNumber>> LdtkNumberer::number_cells(const Progress& progress) {
  constexpr std::size_t kCellsAtOnce = 4096;  // between checks of the progress
  std::stable_sort(parts_.begin(), parts_.end(),
                   [](const PlacedPart& a, const PlacedPart& b) { return a.cell < b.cell; });
  const std::size_t count = map_.cells().size();
  std::vector<TileNumber> tiles(count);
  auto first = parts_.begin();
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kCellsAtOnce == 0 && !progress.at(i, count)) return was_cancelled();
    auto end = first;
    while (end != parts_.end() && end->cell == i) ++end;
    const int number_in_grid = valued_ != nullptr ? valued_->values[i] : 0;
    if (first == end && number_in_grid == 0) continue;
    const LdtkCellValue value =
        number_in_grid == 0 ? LdtkCellValue() : LdtkCellValue{valued_->def, number_in_grid};
    auto cell = cell_of(value, {first, end});
    if (!cell) return tl::unexpected(cell.error());
    first = end;
    const std::size_t known = cells_.size();
    const std::uint32_t number = cells_.number_of(*cell);
    if (cells_.size() > known) {
      if (const auto counted = count_pixels(cell->parts.size()); !counted)
        return tl::unexpected(counted.error());
    }
    if (number >= kMaxTiles) {
      return ldtk_error("has more than " + std::to_string(kMaxTiles) +
                        " different cells, but a level has only as many tiles");
    }
    tiles[i] = static_cast<TileNumber>(number);
  }
  return tiles;
}

// Those with tiles or values, and that of the ground, from the back.
FormatResult<std::vector<const LdtkLayer*>> LdtkNumberer::taken_layers() const {
  std::vector<const LdtkLayer*> taken;
  for (auto layer = level_.layers.rbegin(); layer != level_.layers.rend(); ++layer) {
    if (is_taken(*layer, &*layer == ground_)) taken.push_back(&*layer);
  }
  if (taken.size() <= kMaxLayers && taken.size() * map_.cells().size() <= kMaxLayerCells) return taken;
  return ldtk_error("has too many layers: a level has up to " + std::to_string(kMaxLayers) + ", of up to " +
                    std::to_string(kMaxLayerCells) + " cells together");
}

void LdtkNumberer::take_parallax(const LdtkLayer& layer, TileLayer& taken) {
  if (layer.def < 0) return;
  const LdtkLayerDef& def = project_.layers[static_cast<std::size_t>(layer.def)];
  taken.parallax = {1 - def.parallax.x, 1 - def.parallax.y};
  if (def.scales_by_parallax && def.parallax != Vec2())
    drops_.add("that its parallax scales the layer " + quoted_name(layer.name));
}

// By which the layer is known (see ldtk_additions.h). Others may have its name.
std::string LdtkNumberer::id_of_layer(const LdtkLayer& layer) {
  const std::string name = printable(layer.iid.empty() ? layer.name : layer.iid);
  std::string id = name;
  for (int number = 2; !layer_ids_.insert(id).second; ++number) id = name + "#" + std::to_string(number);
  return id;
}

FormatResult<void> LdtkNumberer::take_layer(const LdtkLayer& layer, const Progress& progress) {
  parts_.clear();
  valued_ = layer.type == LdtkLayer::Type::int_grid && is_ground(layer) ? &layer : nullptr;
  if (valued_ == nullptr && layer.type == LdtkLayer::Type::int_grid)
    drops_.add("the values of the layer " + quoted_name(layer.name) + ", which has another grid");
  if (const auto placed = place_layer(layer); !placed) return placed;
  auto cells = number_cells(progress);
  if (!cells) return tl::unexpected(cells.error());
  TileLayer& taken = layers_.emplace_back();
  taken.name = layer.name;
  taken.visible = layer.is_visible;
  taken.is_ground = false;
  take_parallax(layer, taken);
  taken.extra = Json{{kLdtkLayerKey, id_of_layer(layer)}}.dump();
  taken.cells = std::make_shared<const MapCells>(*std::move(cells));
  if (&layer == ground_) ground_index_ = static_cast<int>(layers_.size()) - 1;
  return {};
}

// Gives each of the first tiles its number again.
FormatResult<void> LdtkNumberer::number_known(const std::vector<std::string>& known) {
  for (std::size_t i = 1; i < std::min<std::size_t>(known.size(), kMaxTiles); ++i) {
    const LdtkCell none{{}, {LdtkCellValue::kNoCell, static_cast<int>(i)}};
    const auto key = read_ldtk_key(known[i], project_, map_.tile_size());
    LdtkCell cell = none;
    if (key) {
      cell = {{}, key->value};
      for (const LdtkKey::Part& part : key->parts)
        cell.parts.push_back({sources_.number_of(part.source), part.x, part.y, part.is_hidden});
    }
    if (const auto counted = count_pixels(cell.parts.size()); !counted) return counted;
    if (cells_.number_of(cell) != i) cells_.number_of(none);
  }
  return {};
}

FormatResult<LdtkTiles> LdtkNumberer::number(const std::vector<std::string>& known) {
  if (const auto made = make_map(); !made) return tl::unexpected(made.error());
  if (const auto numbered = number_known(known); !numbered) return tl::unexpected(numbered.error());
  const auto layers = taken_layers();
  if (!layers) return tl::unexpected(layers.error());
  for (std::size_t i = 0; i < layers->size(); ++i) {
    const auto share = [&](std::size_t done) {
      return static_cast<double>(done) / static_cast<double>(layers->size());
    };
    const auto taken = take_layer(*(*layers)[i], progress_.part(share(i), share(i + 1)));
    if (!taken) return tl::unexpected(taken.error());
  }
  if (layers_.empty()) {
    layers_.emplace_back().cells = std::make_shared<const MapCells>(map_.cells().size());
  }
  const int ground = ground_index_ >= 0 ? ground_index_ : static_cast<int>(layers_.size()) - 1;
  return LdtkTiles{std::move(map_), std::move(layers_), ground, cells_.take(), sources_.take()};
}

std::size_t filled_cells(const LdtkLayer& layer) {
  return layer.values.size() -
         static_cast<std::size_t>(std::count(layer.values.begin(), layer.values.end(), 0));
}

// What decides which IntGrid is the ground's: whether it has values, then its name, then how many it has.
std::tuple<bool, int, std::size_t> rank_as_ground(const LdtkLayer& layer) {
  const auto ground = ldtk_ground_of_name(layer.name, {layer.side, layer.side});
  const int by_name = !ground ? 1 : ground->shape.kind == TileShape::Kind::none ? 0 : 2;
  const std::size_t values = filled_cells(layer);
  return {values > 0, by_name, values};
}

}  // namespace

FormatResult<int> ldtk_ground_layer(const LdtkLevel& level, const ImportChoices& choices) {
  std::vector<int> grids;
  std::string names;
  int most_tiles = -1;
  for (std::size_t i = 0; i < level.layers.size(); ++i) {
    const LdtkLayer& layer = level.layers[i];
    const int index = static_cast<int>(i);
    if (layer.type == LdtkLayer::Type::int_grid) {
      grids.push_back(index);
      names += (names.empty() ? "" : ", ") + quoted_name(layer.name);
    } else if (layer.type == LdtkLayer::Type::tiles &&
               (most_tiles < 0 ||
                layer.tiles.size() > level.layers[static_cast<std::size_t>(most_tiles)].tiles.size())) {
      most_tiles = index;
    }
  }
  const auto layer_at = [&](int i) -> const LdtkLayer& { return level.layers[static_cast<std::size_t>(i)]; };
  const bool by_number = choices.layer_number > 0;
  if (by_number || !choices.layer.empty()) {
    auto chosen = std::find_if(grids.begin(), grids.end(),
                               [&](int i) { return !by_number && layer_at(i).name == choices.layer; });
    if (by_number && choices.layer_number <= std::ssize(grids))
      chosen = grids.begin() + (choices.layer_number - 1);
    if (chosen != grids.end()) return *chosen;
    return ldtk_error("has no IntGrid with the name " + quoted_name(choices.layer) +
                      (names.empty() ? "" : ", but " + names));
  }
  if (grids.empty()) return most_tiles;
  return *std::max_element(grids.begin(), grids.end(), [&](int a, int b) {
    return rank_as_ground(layer_at(a)) < rank_as_ground(layer_at(b));
  });
}

bool is_taken(const LdtkLayer& layer, bool is_ground) {
  const bool is_empty = layer.tiles.empty() && std::all_of(layer.values.begin(), layer.values.end(),
                                                           [](int value) { return value == 0; });
  return layer.type != LdtkLayer::Type::entities && (!is_empty || is_ground);
}

FormatResult<LdtkTiles> ldtk_tiles_of(const LdtkProject& project, const LdtkLevel& level, int ground,
                                      const std::vector<std::string>& known, const LdtkPictures& pictures,
                                      ImportDrops& drops, const Progress& progress) {
  return LdtkNumberer(project, level, ground, pictures, drops, progress).number(known);
}

}  // namespace talus
