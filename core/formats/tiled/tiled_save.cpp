// Writes what was edited into the text of the map, and reads the result again: what it lacks is for the
// companion.
#include <algorithm>
#include <set>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "../files/real_path.h"
#include "tiled_document.h"
#include "tiled_format.h"
#include "tiled_layer_pairs.h"
#include "tiled_layer_tree.h"
#include "tiled_limits.h"
#include "tiled_lost_layer.h"
#include "tiled_map.h"
#include "tiled_object_layers.h"
#include "tiled_object_writer.h"
#include "tiled_properties.h"
#include "tiled_tile_writer.h"

namespace talus {
namespace {

template <class... Remedy>
tl::unexpected<FormatError> cannot(std::string why, Remedy... remedy) {
  return tl::unexpected(not_in_tiled(std::move(why), remedy...));
}

class TiledSaver {
 public:
  TiledSaver(const Level& level, const FormatContext& context)
      : level_(level), origin_(*level.tiled), context_(context) {}

  FormatResult<WrittenLevel> write();

 private:
  FormatResult<void> check_place() const;
  FormatResult<void> find_layers();
  FormatResult<void> read_origin();
  FormatResult<void> write_layers(TiledDocument& document);
  FormatResult<void> write_layer(int layer, TiledDocument& document);
  void write_block(int layer, bool must_put, TiledBlock& block, TiledDocument& document) const;
  // Whether a layer of the level has no cells in the file yet.
  bool is_new(int layer) const { return arranges_ && pairs_[static_cast<std::size_t>(layer)] < 0; }
  TiledBlock with_size(const TiledBlock& before, int width, int height) const;
  bool takes_cells(TiledBlock& block, std::vector<bool>& covered) const;
  std::vector<TiledBlock> new_chunks(TileSize size, const std::vector<bool>& covered) const;
  // What a cell of the level holds if one of the file has this number.
  MapCell content_of(std::uint32_t cell) const;
  // The number of a cell of the file that holds this.
  std::uint32_t number_of(MapCell cell) const;
  // The cell of the level at a place of the file; empty if that is off its map.
  MapCell at(int x, int y) const;
  // What is written: `left_out` are tiles of which the files keep what they have.
  struct Plan {
    bool takes_new_names = true;  // whether flags get the names that the level gives them
    std::set<TileNumber> left_out = {};
    bool writes_objects =
        true;  // whether bodies, curves and objects are written; else the companion has them
  };
  struct Attempt {
    WrittenLevel written;
    FormatResult<Level> held;
    std::set<TileNumber> wrong;  // tiles that were written, and would be read as others
  };
  FormatResult<Attempt> attempt(const Plan& plan);
  FormatResult<TiledObjectEdits> edits_of_objects(bool writes_objects);
  FormatResult<TiledArrangement> arrangement(const TiledObjectEdits& objects) const;
  FormatResult<std::string> with_looks(std::string text, const TiledObjectEdits& objects,
                                       const TiledArrangement& arranged) const;
  // Whether the name of the only layer was not read.
  bool is_unnamed() const {
    const std::vector<TileLayer>& opened = origin_.opened->layers.list;
    return origin_.layers.size() <= 1 && opened.size() == 1 && opened[0].name.empty();
  }
  void take_ground_by_name(TiledMap& map, std::vector<TileLayer>& tiles) const;
  void take_unread(Level& held) const;
  bool has_other_tiles() const;
  bool has_other_objects() const;
  bool has_other_looks() const;
  bool may_move_layers() const;
  FormatContext context_again() const;
  FormatResult<Level> read_back(const WrittenLevel& written) const;

  // What the files hold, as they were opened.
  struct Origin {
    TiledContent content;
    Level level;
    TiledSources sources;
  };

  const Level& level_;
  const TiledOrigin& origin_;
  const FormatContext& context_;
  std::optional<Origin> model_;      // if something is taken from it
  bool is_map_ = false;              // whether the file is a map
  bool is_one_of_many_ = false;      // whether the level is one layer that was chosen
  std::vector<int> pairs_;           // by layer of tiles, that of the opened level; -1: new
  bool arranges_ = false;            // whether these are other layers than those
  const MapCells* cells_ = nullptr;  // of the layer that is being written
  std::unordered_map<std::uint32_t, TileNumber> tiles_;  // by the number in cells
  bool has_cells_ = false;                               // whether the file has layers of tiles
  bool is_infinite_ = false;                             // whether it is an infinite map
};

constexpr std::uint32_t kTileBits = kTiledIdBits | kTiledFlipX | kTiledFlipY | kTiledFlipXY;

// As the reader does, which lets a cell turn a tile unless the level has the turned tile as one of its own.
MapCell TiledSaver::content_of(std::uint32_t cell) const {
  const auto as_it_is = tiles_.find(cell & kTileBits);
  if (as_it_is != tiles_.end()) return as_it_is->second;
  const auto found = tiles_.find(cell & kTiledIdBits);
  if (found == tiles_.end()) return {};
  return {found->second, static_cast<TileTurn>((cell & kTileBits) >> kTiledTurnShift)};
}

std::uint32_t TiledSaver::number_of(MapCell cell) const {
  const std::uint32_t number = origin_.frame.tiles[cell.tile];
  if (number == 0 || (cell == MapCell() && origin_.frame.is_0_empty)) return 0;
  const TileTurn own = static_cast<TileTurn>((number & kTileBits) >> kTiledTurnShift);
  return (number & kTiledIdBits) | static_cast<std::uint32_t>(after_turn(own, cell.turn)) << kTiledTurnShift;
}

MapCell TiledSaver::at(int x, int y) const {
  const Cell cell{x - origin_.frame.x, y - origin_.frame.y};
  if (!level_.map.contains(cell)) return {};
  return (*cells_)[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(level_.map.width()) +
                   static_cast<std::size_t>(cell.x)];
}

FormatResult<void> TiledSaver::check_place() const {
  if (context_.extension != origin_.extension) {
    return cannot("is not the kind of file that the level came from, which ends with ." + origin_.extension,
                  "choose that ending, or save the level as .talus.json");
  }
  const auto now = real_path(context_.folder), then = real_path(origin_.folder);
  if (context_.folder != origin_.folder && (!now || !then || *now != *then)) {
    return cannot(
        "is not in the folder of the map that the level came from, which names its tilesets from there",
        "save it in that folder, or as .talus.json");
  }
  return {};
}

// Puts the level's tiles into a block. Returns whether that changed a cell. covered: by cell of the level,
// whether a block above this one has it, so that this one keeps its own; gets the cells of this block, too.
bool TiledSaver::takes_cells(TiledBlock& block, std::vector<bool>& covered) const {
  bool has_changed = false;
  std::size_t i = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x, ++i) {
      const Cell cell{x - origin_.frame.x, y - origin_.frame.y};
      if (level_.map.contains(cell)) {
        const auto place = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(level_.map.width()) +
                           static_cast<std::size_t>(cell.x);
        if (covered[place]) continue;
        covered[place] = true;
      } else if (!is_infinite_ && was_off_map(cell, origin_.frame)) {
        continue;  // nobody has seen it
      }
      const MapCell wanted = at(x, y);
      if (content_of(block.cells[i]) == wanted) continue;
      block.cells[i] = number_of(wanted);
      has_changed = true;
    }
  }
  return has_changed;
}

// Chunks of that size, in cells, for the tiles that no block has.
std::vector<TiledBlock> TiledSaver::new_chunks(TileSize size, const std::vector<bool>& covered) const {
  const auto chunk_at = [](int place, int side) { return place - ((place % side) + side) % side; };
  const auto [wide, high] = size;
  std::set<std::pair<int, int>> places;  // y, x
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (covered[i] || cells_->tiles()[i] == 0) continue;
    const auto width = static_cast<std::size_t>(level_.map.width());
    places.emplace(chunk_at(origin_.frame.y + static_cast<int>(i / width), high),
                   chunk_at(origin_.frame.x + static_cast<int>(i % width), wide));
  }
  std::vector<TiledBlock> chunks;
  std::vector<bool> by_chunks(covered.size());
  for (const auto& [y, x] : places) {
    TiledBlock chunk{x, y, wide, high, {}, true};
    chunk.cells.assign(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0);
    takes_cells(chunk, by_chunks);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

// The cells of a layer of a finite map with another size; new ones are empty.
TiledBlock TiledSaver::with_size(const TiledBlock& before, int width, int height) const {
  TiledBlock block{0, 0, width, height, {}, false};
  for (int y = 0; y < block.height; ++y) {
    for (int x = 0; x < block.width; ++x) {
      const bool was_there = x < before.width && y < before.height;
      const auto i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(before.width) + static_cast<std::size_t>(x);
      block.cells.push_back(was_there ? before.cells[i] : 0);
    }
  }
  return block;
}

// layer: of the level.
FormatResult<void> TiledSaver::write_layer(int layer, TiledDocument& document) {
  constexpr int kUsualSide = 16;  // cells, of a chunk
  const int number = arranges_ ? layer : origin_.layers[static_cast<std::size_t>(layer)];
  cells_ = &level_.cells_of(layer);
  auto read = document.blocks(number);
  if (!read) return tl::unexpected(read.error());
  std::vector<TiledBlock>& blocks = *read;
  if (layer == 0 && !is_infinite_ && is_resized(level_))
    document.set_size(level_.map.width(), level_.map.height());
  const bool has_chunks =
      std::any_of(blocks.begin(), blocks.end(), [](auto& block) { return block.is_chunk; });
  if (!is_infinite_ && !has_chunks) {
    write_block(number, is_new(layer), blocks.front(), document);
    return {};
  }
  std::vector<bool> covered(cells_->size()), has_changed(blocks.size());
  for (std::size_t i = blocks.size(); i-- > 0;) has_changed[i] = takes_cells(blocks[i], covered);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (has_changed[i] || is_new(layer)) document.put_cells(number, i, blocks[i]);
  }
  TileSize side{kUsualSide, kUsualSide};
  if (!blocks.empty() && !blocks.back().cells.empty()) side = {blocks.back().width, blocks.back().height};
  if (const std::vector<TiledBlock> chunks = new_chunks(side, covered); !chunks.empty())
    document.add_chunks(number, chunks);
  return {};
}

// The cells of a layer of a finite map, whose size may be another one than the map's. layer: of the file.
void TiledSaver::write_block(int layer, bool must_put, TiledBlock& block, TiledDocument& document) const {
  const int width = level_.map.width(), height = level_.map.height();
  std::vector<bool> covered(cells_->size());
  if (is_resized(level_)) {
    block = with_size(block, width, height);
    takes_cells(block, covered);
    return document.put_cells(layer, 0, block);
  }
  const bool has_changed = takes_cells(block, covered);
  bool is_short = false;  // whether it lacks cells that have tiles
  for (std::size_t i = 0; i < covered.size() && !is_short; ++i)
    is_short = !covered[i] && (*cells_)[i] != MapCell();
  if (is_short) {
    block = with_size(block, std::max(block.width, width), std::max(block.height, height));
    covered.assign(covered.size(), false);
    takes_cells(block, covered);
    document.set_layer_size(layer, block.width, block.height);
  }
  if (has_changed || is_short || must_put) document.put_cells(layer, 0, block);
}

FormatResult<void> TiledSaver::write_layers(TiledDocument& document) {
  has_cells_ = document.layer_count() > 0;
  is_infinite_ = document.is_infinite();
  if (!has_cells_) return {};  // a tileset, or a map of objects alone
  for (std::size_t n = origin_.frame.tiles.size(); n-- > 0;) {
    if (origin_.frame.tiles[n] != 0) tiles_[origin_.frame.tiles[n]] = static_cast<TileNumber>(n);
  }
  for (int layer = 0; layer < level_.layers.count(); ++layer) {
    if (const auto written = write_layer(layer, document); !written) return written;
  }
  return {};
}

FormatResult<void> TiledSaver::read_origin() {
  if (model_) return {};
  FormatContext context = context_again();
  context.choices.frame = origin_.frame;
  const auto wrong = [](const FormatError& error) {
    return cannot("cannot be read again: " + error.message);
  };
  auto content = read_tiled_content(origin_.bytes, context, origin_.tilesets);
  if (!content) return wrong(content.error());
  model_ = Origin{*std::move(content), Level(), {}};
  ImportDrops drops;
  auto level = level_of_tiled(model_->content.map, model_->content.pictures, context.choices, drops, {},
                              &model_->sources);
  if (!level) return wrong(level.error());
  model_->level = *std::move(level);
  return {};
}

// Finds out which layers of tiles the level has.
FormatResult<void> TiledSaver::find_layers() {
  const auto document = tiled_document(origin_.bytes);
  if (!document) return tl::unexpected(document.error());
  const int in_file = (*document)->layer_count();
  is_map_ = (*document)->is_map();
  is_one_of_many_ = is_one_of_many(origin_, **document);
  if (auto beyond = layers_beyond_tiled(level_, **document)) return tl::unexpected(*std::move(beyond));
  auto beyond = size_beyond_tiled(level_, **document);
  if (!beyond) return tl::unexpected(beyond.error());
  if (*beyond) return tl::unexpected(**std::move(beyond));
  if (is_map_ && in_file == 0) {  // the level's only layer stands for none; it is made once it has tiles
    const std::vector<TileNumber>& tiles = level_.map.cells().tiles();
    arranges_ = level_.layers.count() > 1 ||
                std::any_of(tiles.begin(), tiles.end(), [](TileNumber tile) { return tile != 0; });
    pairs_.assign(level_.layers.list.size(), -1);
    return {};
  }
  const std::vector<TileLayer>& before = origin_.opened->layers.list;
  if (has_same_names(before, level_.layers.list)) {
    for (int i = 0; i < level_.layers.count(); ++i) pairs_.push_back(i);
    return {};
  }
  if (is_one_of_many_ || in_file == 0) return {};
  if (const auto read = read_origin(); !read) return read;
  pairs_ = pairs_of_tile_layers(model_->level, level_);
  arranges_ = level_.layers.list.size() != before.size();
  for (std::size_t i = 0; i < pairs_.size(); ++i) arranges_ = arranges_ || pairs_[i] != static_cast<int>(i);
  return {};
}

// Which layers and groups the map gets.
FormatResult<TiledArrangement> TiledSaver::arrangement(const TiledObjectEdits& objects) const {
  auto document = tiled_document(origin_.bytes);
  if (!document) return tl::unexpected(document.error());
  TiledLayerSources sources;
  sources.objects = objects;
  sources.opened_tiles.resize(static_cast<std::size_t>((*document)->layer_count()));
  for (const int layer : origin_.layers)
    if (!sources.opened_tiles.empty()) sources.opened_tiles[static_cast<std::size_t>(layer)] = true;
  sources.opened_objects.resize(static_cast<std::size_t>((*document)->object_layer_count()));
  for (const TiledSources::Layer& layer : model_->sources.layers)
    sources.opened_objects[static_cast<std::size_t>(layer.layer)] = true;
  if (arranges_) {
    for (const int pair : pairs_)
      sources.tiles.push_back(pair < 0 ? -1 : origin_.layers[static_cast<std::size_t>(pair)]);
  } else if (!sources.opened_tiles.empty()) {
    sources.tiles = origin_.layers;
  }
  auto arranged = arrange_layers(level_, (*document)->layer_tree(), sources);
  if (is_one_of_many_ && !has_tiles_in_order(arranged.tree))
    return cannot("has layers of objects where the map cannot have them");
  return arranged;
}

template <class Layer>
TileLayer looks_of(const Layer& layer) {
  TileLayer looks;
  looks.name = layer.name;
  looks.visible = layer.visible;
  looks.locked = layer.locked;
  looks.opacity = layer.opacity;
  looks.offset = layer.offset;
  looks.parallax = layer.parallax;
  looks.tint = layer.tint;
  if constexpr (std::is_same_v<Layer, ObjectLayer>) looks.is_ground = layer.is_ground;
  return looks;
}

// The new names of layers of tiles may say which of them are ground, and a named layer that is no ground any
// more no longer speaks for the others. tiles: gets the opposite for layers that have to say it.
void TiledSaver::take_ground_by_name(TiledMap& map, std::vector<TileLayer>& tiles) const {
  std::vector<TiledLayer*> layers;
  for (TiledLayer& layer : map.layers)
    if (layer.has_tiles) layers.push_back(&layer);
  const std::size_t count = std::min({layers.size(), tiles.size(), level_.layers.list.size()});
  for (std::size_t i = 0; i < count; ++i) {
    layers[i]->name = level_.layers.list[i].name;
    tiles[i].is_ground = level_.layers.list[i].is_ground;
  }
  bool is_settled = false;
  while (!is_settled) {  // each turn but the last makes one more layer say it
    is_settled = true;
    choose_tile_ground(map);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_ground = level_.layers.list[i].is_ground;
      if (layers[i]->looks.is_ground == is_ground) continue;
      layers[i]->says_ground = is_ground;
      tiles[i].is_ground = !is_ground;
      is_settled = false;
    }
  }
}

// What the text says of the layers is read from it if they have moved.
FormatResult<std::string> TiledSaver::with_looks(std::string text, const TiledObjectEdits& objects,
                                                 const TiledArrangement& arranged) const {
  if (!arranged.is_new && !has_other_looks()) return text;
  std::vector<TileLayer> tiles = origin_.opened->layers.list;
  std::vector<TiledLayer> others;
  LayerGroups groups;
  const bool has_same_ground = std::equal(
      tiles.begin(), tiles.end(), level_.layers.list.begin(), level_.layers.list.end(),
      [](const TileLayer& a, const TileLayer& b) { return a.name == b.name && a.is_ground == b.is_ground; });
  if (arranged.is_new || !objects.layers.empty() || !arranged.groups.empty() || !has_same_ground) {
    auto content = read_tiled_content(text, context_again(), origin_.tilesets);
    if (!content) return tl::unexpected(content.error());
    groups = content->map.groups;
    if (arranges_) tiles.clear();
    for (const TiledLayer& layer : content->map.layers) {
      if (layer.has_tiles && arranges_) tiles.push_back(layer.looks);
      if (!layer.has_tiles) others.push_back(layer);
    }
    if (has_cells_ && !is_one_of_many_) take_ground_by_name(content->map, tiles);
  }
  auto document = tiled_document(text);
  if (!document) return tl::unexpected(document.error());
  for (std::size_t i = 0; i < level_.layers.list.size() && has_cells_; ++i) {
    const int number = arranges_ ? static_cast<int>(i) : origin_.layers[i];
    TileLayer now = level_.layers.list[i];
    if (now.name.empty() && is_unnamed()) now.name = tiles[i].name;
    (*document)->set_looks(TiledLayerKind::tiles, number, tiles[i], now);
  }
  for (std::size_t i = 0; i < objects.layers.size(); ++i) {
    const int slot = objects.layers[i];
    const int layer = arranged.objects.empty() ? slot : arranged.objects[static_cast<std::size_t>(slot)];
    const ObjectLayer& now = level_.objects[i];
    TiledLayer& renamed = others[static_cast<std::size_t>(layer)];
    ObjectLayer before = object_layer_of(renamed);
    renamed.name = now.name;  // which may say that the layer is ground, or no longer say it
    before.is_ground = object_layer_of(renamed).is_ground;
    (*document)->set_looks(TiledLayerKind::objects, layer, looks_of(before), looks_of(now));
    if (before.by_y != now.by_y && !now.image) (*document)->set_draw_order(layer, now.by_y);
  }
  for (std::size_t i = 0; i < arranged.groups.size(); ++i) {
    const int group = arranged.groups[i];
    if (group >= 0)
      (*document)->set_looks(TiledLayerKind::groups, group, looks_of(groups[static_cast<std::size_t>(group)]),
                             looks_of(level_.layers.groups[i]));
  }
  return (*document)->text();
}

// The layers without groups that hold nothing: a layer of objects whose bodies are removed stays in the file.
TileLayers without_empty_groups(TileLayers layers, std::vector<ObjectLayer> objects) {
  std::erase_if(objects, [](const ObjectLayer& layer) { return layer.objects.empty() && !layer.image; });
  tidy_groups(layers, objects);
  return layers;
}

// Whether both have the same layers with the same cells.
bool has_same_layers(Level a, const Level& b) {
  if (a.layers.count() != b.layers.count()) return false;
  a.choose_layer(b.layers.chosen);
  return a.map == b.map &&
         without_empty_groups(a.layers, a.objects) == without_empty_groups(b.layers, b.objects);
}

FormatContext TiledSaver::context_again() const {
  FormatContext context{.extension = origin_.extension, .folder = origin_.folder};
  if (is_one_of_many_) context.choices.layer_number = origin_.layers[0] + 1;
  context.choices.outside = origin_.outside;
  context.choices.frame = origin_.frame;
  context.choices.frame->width = level_.map.width();
  context.choices.frame->height = level_.map.height();
  return context;
}

// The level that the files give after saving.
FormatResult<Level> TiledSaver::read_back(const WrittenLevel& written) const {
  std::vector<TiledOrigin::File> tilesets;
  for (const WrittenFile& file : written.others) tilesets.push_back({file.path, file.bytes});
  auto held = read_tiled_again(written.bytes, context_again(), tilesets);
  if (!held) return cannot("cannot be written so that Talus reads it again: " + held.error().message);
  return held;
}

bool TiledSaver::has_other_tiles() const {
  return level_.tile_shapes != origin_.opened->tile_shapes ||
         level_.sheet(SheetId::tiles).flags != origin_.opened->sheet(SheetId::tiles).flags ||
         level_.tile_notes != origin_.opened->tile_notes || level_.animations != origin_.opened->animations;
}

bool TiledSaver::has_other_objects() const {
  const Level& opened = *origin_.opened;
  return level_.spawns != opened.spawns || level_.curves != opened.curves || level_.objects != opened.objects;
}

bool TiledSaver::has_other_looks() const {
  const auto same_looks = [](TileLayer a, TileLayer b) {
    a.cells = b.cells = nullptr;
    return a == b;
  };
  const std::vector<TileLayer>&now = level_.layers.list, &then = origin_.opened->layers.list;
  return has_other_objects() || level_.layers.groups != origin_.opened->layers.groups ||
         !std::equal(now.begin(), now.end(), then.begin(), then.end(), same_looks);
}

// Whether layers may have other places in the map, or other groups.
bool TiledSaver::may_move_layers() const {
  const auto same_group = [](const TileLayer& a, const TileLayer& b) { return a.group == b.group; };
  const TileLayers &now = level_.layers, &then = origin_.opened->layers;
  return arranges_ || has_other_objects() || now.groups != then.groups ||
         !std::equal(now.list.begin(), now.list.end(), then.list.begin(), then.list.end(), same_group);
}

// Takes over what the files hold, but is not read from them: how a layer that was chosen looks, and the name
// of one that was the only one of a level of Talus. Layers without objects count only in the files.
void TiledSaver::take_unread(Level& held) const {
  const std::vector<TileLayer>& layers = level_.layers.list;
  for (std::size_t i = 0; i < layers.size() && layers.size() == held.layers.list.size(); ++i) {
    TileLayer& its = held.layers.list[i];
    if (is_one_of_many_ || (layers[i].name.empty() && is_unnamed())) its.name = layers[i].name;
    if (!is_one_of_many_) continue;
    its.visible = layers[i].visible;
    its.is_ground = layers[i].is_ground;
  }
  const auto without_empty = [this](std::vector<ObjectLayer> all) {
    std::erase_if(all, [](const ObjectLayer& layer) { return layer.objects.empty() && !layer.image; });
    for (ObjectLayer& layer : all) layer.place = std::clamp(layer.place, 0, level_.layers.count());
    std::stable_sort(all.begin(), all.end(),  // as they are drawn
                     [](const ObjectLayer& a, const ObjectLayer& b) { return a.place < b.place; });
    return all;
  };
  if (without_empty(held.objects) == without_empty(level_.objects)) held.objects = level_.objects;
}

// Whether the files hold what can be written of a note.
bool is_written(const TileNote& note, const TileNote& held) {
  return note.type == held.type && note.probability == held.probability &&
         have_same_values(note.properties, held.properties);
}

// Without edits, if the companion has the objects.
FormatResult<TiledObjectEdits> TiledSaver::edits_of_objects(bool writes_objects) {
  TiledObjectEdits objects;
  if (!is_map_ || !may_move_layers()) return objects;
  if (const auto read = read_origin(); !read) return tl::unexpected(read.error());
  const bool is_as_opened = model_->level.spawns == origin_.opened->spawns &&
                            model_->level.curves == origin_.opened->curves &&
                            model_->level.objects == origin_.opened->objects &&
                            model_->sources.layers.size() == model_->level.objects.size();
  if (writes_objects && is_as_opened)
    return object_edits(level_, model_->level, model_->content.map, model_->sources);
  for (const TiledLayer& layer : model_->content.map.layers)
    if (!layer.has_tiles) objects.order.push_back({static_cast<int>(objects.order.size())});
  return objects;
}

FormatResult<TiledSaver::Attempt> TiledSaver::attempt(const Plan& plan) {
  const auto objects = edits_of_objects(plan.writes_objects);
  if (!objects) return tl::unexpected(objects.error());
  TiledArrangement arranged;
  if (is_map_ && may_move_layers()) {
    auto found = arrangement(*objects);
    if (!found) return tl::unexpected(found.error());
    arranged = *std::move(found);
  }
  std::string text = origin_.bytes;
  if (arranged.is_new) {
    auto document = tiled_document(text);
    if (!document) return tl::unexpected(document.error());
    (*document)->arrange(arranged.tree);
    text = (*document)->text();
  }
  auto document = tiled_document(text);
  if (!document) return tl::unexpected(document.error());
  if (model_ && objects->order.size() > static_cast<std::size_t>((*document)->object_layer_count()))
    return cannot("has layers of objects that the map cannot hold");
  for (const auto& [slot, edits] : objects->of) {
    const int layer = arranged.objects.empty() ? slot : arranged.objects[static_cast<std::size_t>(slot)];
    if (layer >= 0) (*document)->edit_objects(layer, edits);
  }
  if (const auto written = write_layers(**document); !written) return tl::unexpected(written.error());
  if (is_map_ && level_.background != origin_.opened->background)
    (*document)->set_background(tiled_background(level_));
  TiledTilesetEdits tiles;
  if (model_) {
    const auto names = names_for_tiled(level_, *origin_.opened, plan.takes_new_names);
    tiles = tileset_edits(level_, origin_, model_->content, names, plan.left_out);
  }
  for (const auto& [place, edits] : tiles.of) {
    if (place.first.empty()) (*document)->edit_tiles(place.second, edits);
  }
  auto map = with_looks((*document)->text(), *objects, arranged);
  if (!map) return tl::unexpected(map.error());
  Attempt attempt{{*std::move(map), {}}, Level(), {}};
  for (const TiledOrigin::File& file : origin_.tilesets) {
    std::string bytes = file.bytes;
    if (const auto found = tiles.of.find({file.path, 0}); found != tiles.of.end()) {
      auto tileset = tiled_document(file.bytes);
      if (!tileset) return tl::unexpected(tileset.error());
      (*tileset)->edit_tiles(0, found->second);
      bytes = (*tileset)->text();
    }
    attempt.written.others.push_back({file.path, std::move(bytes)});
  }
  attempt.held = read_back(attempt.written);
  const bool is_same = attempt.held && attempt.held->tiled->frame.tiles == origin_.frame.tiles;
  for (const TileNumber tile : tiles.tiles) {
    if (!is_same || attempt.held->tile_shapes[tile] != level_.tile_shapes[tile] ||
        attempt.held->tile_flags(tile) != level_.tile_flags(tile) ||
        !is_written(note_of(level_.tile_notes, tile), note_of(attempt.held->tile_notes, tile)))
      attempt.wrong.insert(tile);
  }
  // The empty tile, alone, may be what moves the numbers.
  if (attempt.held && !is_same && attempt.wrong.contains(0)) attempt.wrong = {0};
  return attempt;
}

FormatResult<WrittenLevel> TiledSaver::write() {
  if (const auto checked = check_place(); !checked) return tl::unexpected(checked.error());
  if (auto beyond = tiles_beyond_tiled(level_)) return tl::unexpected(*std::move(beyond));
  if (const auto found = find_layers(); !found) return tl::unexpected(found.error());
  if (has_other_tiles()) {
    if (const auto read = read_origin(); !read) return tl::unexpected(read.error());
  }
  Plan plan;
  auto last = attempt(plan);
  if (has_other_objects() && (!last || !last->held)) {
    plan.writes_objects = false;
    last = attempt(plan);
  }
  if (last && !last->wrong.empty() && level_.flag_names != origin_.opened->flag_names) {
    plan.takes_new_names = false;
    last = attempt(plan);
  }
  for (int tries = 0; last && !last->wrong.empty() && tries < 3; ++tries) {
    plan.left_out.merge(last->wrong);
    last = attempt(plan);
  }
  if (!last) return tl::unexpected(last.error());
  FormatResult<Level>& held = last->held;
  if (!held) return tl::unexpected(held.error());
  take_unread(*held);
  if (held->tiled->frame.tiles != origin_.frame.tiles)
    return cannot("has tiles that would have other numbers in the map");
  if (has_cells_ && !has_same_layers(*held, level_)) {
    if (held->layers.count() > level_.layers.chosen) held->choose_layer(level_.layers.chosen);
    return tl::unexpected(lost_layer(*held, level_));
  }
  held->choose_layer(level_.layers.chosen);
  // Pictures that were painted elsewhere meanwhile are no edits.
  held->sheet(SheetId::tiles).images = level_.sheet(SheetId::tiles).images;
  held->sheet(SheetId::tiles).picture = level_.sheet(SheetId::tiles).picture;
  if (level_.palette == origin_.opened->palette) held->palette = level_.palette;
  last->written.held = std::make_shared<const Level>(*std::move(held));
  return std::move(last->written);
}

}  // namespace

FormatResult<WrittenLevel> write_tiled(const Level& level, const FormatContext& context) {
  if (!level.tiled) {
    return cannot("is a map of Tiled, into which only a level that came from it can be saved",
                  "export the level for Tiled, or save it as .talus.json");
  }
  return TiledSaver(level, context).write();
}

}  // namespace talus
