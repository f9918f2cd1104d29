// Writes what was edited into the text of the map, and reads the result again: what it lacks is for the
// companion.
#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

#include "../files/real_path.h"
#include "tiled_document.h"
#include "tiled_format.h"
#include "tiled_map.h"
#include "tiled_tile_writer.h"

namespace talus {
namespace {

constexpr const char* kSaveNative = "save the level as .talus.json";

tl::unexpected<FormatError> cannot(std::string why, std::string remedy = kSaveNative) {
  return tl::unexpected(FormatError{"", std::move(why), std::move(remedy)});
}

class TiledSaver {
 public:
  TiledSaver(const Level& level, const FormatContext& context)
      : level_(level), origin_(*level.tiled), context_(context) {}

  FormatResult<WrittenLevel> write();

 private:
  FormatResult<void> check_place() const;
  FormatResult<void> check_tiles() const;
  FormatResult<void> write_layers(TiledDocument& document);
  FormatResult<void> write_layer(int layer, TiledDocument& document);
  TiledBlock resized(const TiledBlock& before) const;
  bool is_resized() const;
  bool takes_cells(TiledBlock& block) const;
  std::vector<bool> covered_by(const std::vector<TiledBlock>& blocks) const;
  std::vector<TiledBlock> new_chunks(const std::vector<TiledBlock>& blocks) const;
  // The tile of the level that a cell with this number shows.
  TileNumber tile_of(std::uint32_t cell) const;
  // The cell of the level at a place of the file; nothing if that is off its map.
  const TileNumber* at(int x, int y) const;
  // What is written: `left_out` are tiles of which the files keep what they have.
  struct Plan {
    bool takes_new_names = true;  // whether flags get the names that the level gives them
    std::set<TileNumber> left_out = {};
  };
  struct Attempt {
    WrittenLevel written;
    FormatResult<Level> held;
    std::set<TileNumber> wrong;  // tiles that were written, and would be read as others
  };
  FormatResult<Attempt> attempt(const Plan& plan);
  bool has_other_tiles() const;
  FormatContext context_again() const;
  FormatResult<Level> read_back(const WrittenLevel& written) const;

  const Level& level_;
  const TiledOrigin& origin_;
  const FormatContext& context_;
  std::optional<TiledContent> model_;                    // if something is taken from it
  const std::vector<TileNumber>* cells_ = nullptr;       // of the layer that is being written
  std::unordered_map<std::uint32_t, TileNumber> tiles_;  // by the number in cells
  bool has_cells_ = false;                               // whether the file has layers of tiles
};

constexpr std::uint32_t kTileBits = kTiledIdBits | kTiledFlipX | kTiledFlipY | kTiledFlipXY;

TileNumber TiledSaver::tile_of(std::uint32_t cell) const {
  const auto found = tiles_.find(cell & kTileBits);
  return found == tiles_.end() ? TileNumber{0} : found->second;
}

const TileNumber* TiledSaver::at(int x, int y) const {
  const Cell cell{x - origin_.frame.x, y - origin_.frame.y};
  if (!level_.map.contains(cell)) return nullptr;
  return &(*cells_)[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(level_.map.width()) +
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

FormatResult<void> TiledSaver::check_tiles() const {
  if (level_.layers.list.size() != origin_.layers.size())
    return cannot("has other layers of tiles than the map");
  std::vector<std::string> names, old_names;
  for (std::size_t i = 0; i < origin_.layers.size(); ++i) {
    names.push_back(level_.layers.list[i].name);
    old_names.push_back(origin_.opened->layers.list[i].name);
  }
  const bool is_moved = names != old_names &&
                        std::is_permutation(names.begin(), names.end(), old_names.begin(), old_names.end());
  if (is_moved) return cannot("has layers of tiles in another order than the map");
  const Sheet &now = level_.sheet(SheetId::tiles), &then = origin_.opened->sheet(SheetId::tiles);
  if (now.layout() != then.layout()) return cannot("has tiles that no tileset of the map has");
  const bool same_picture =
      now.picture == then.picture || (now.picture && then.picture && *now.picture == *then.picture);
  if (now.images != then.images || !same_picture)
    return cannot(
        "has pictures of tiles that were painted, but those of a map of Tiled are in files of their own");
  if (level_.map.tile_size() != origin_.opened->map.tile_size())
    return cannot("has tiles of another size than the map");
  for (int layer = 0; layer < level_.layers.count(); ++layer) {
    for (const TileNumber tile : level_.cells_of(layer)) {
      if (tile != 0 && origin_.frame.tiles[tile] == 0)
        return cannot("shows tile " + std::to_string(tile) + ", which no tileset of the map has");
    }
  }
  return {};
}

// Puts the level's tiles into a block. Returns whether that changed a cell.
bool TiledSaver::takes_cells(TiledBlock& block) const {
  bool has_changed = false;
  std::size_t i = 0;
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x, ++i) {
      const TileNumber* const tile = at(x, y);
      const TileNumber wanted = tile == nullptr ? TileNumber{0} : *tile;
      if (tile_of(block.cells[i]) == wanted) continue;
      block.cells[i] = wanted == 0 && origin_.frame.is_0_empty ? 0 : origin_.frame.tiles[wanted];
      has_changed = true;
    }
  }
  return has_changed;
}

// By cell of the level, whether a block has it.
std::vector<bool> TiledSaver::covered_by(const std::vector<TiledBlock>& blocks) const {
  const int left = origin_.frame.x, top = origin_.frame.y;
  const int width = level_.map.width(), height = level_.map.height();
  std::vector<bool> covered(cells_->size());
  for (const TiledBlock& block : blocks) {
    const int from = std::max(block.x - left, 0), to = std::min(block.x + block.width - left, width);
    for (int y = std::max(block.y - top, 0); y < std::min(block.y + block.height - top, height); ++y) {
      for (int x = from; x < to; ++x)
        covered[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
            true;
    }
  }
  return covered;
}

// Chunks for the tiles that no block has, at places of their size.
std::vector<TiledBlock> TiledSaver::new_chunks(const std::vector<TiledBlock>& blocks) const {
  constexpr int kUsualSide = 16;
  const int wide = blocks.empty() ? kUsualSide : blocks.front().width;
  const int high = blocks.empty() ? kUsualSide : blocks.front().height;
  const auto chunk_at = [](int place, int side) { return place - ((place % side) + side) % side; };
  const std::vector<bool> covered = covered_by(blocks);
  std::set<std::pair<int, int>> places;  // y, x
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (covered[i] || (*cells_)[i] == 0) continue;
    const auto width = static_cast<std::size_t>(level_.map.width());
    places.emplace(chunk_at(origin_.frame.y + static_cast<int>(i / width), high),
                   chunk_at(origin_.frame.x + static_cast<int>(i % width), wide));
  }
  std::vector<TiledBlock> chunks;
  for (const auto& [y, x] : places) {
    TiledBlock chunk{x, y, wide, high, {}, true};
    chunk.cells.assign(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0);
    takes_cells(chunk);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

// The cells of a layer of a finite map with the size that the level has now.
TiledBlock TiledSaver::resized(const TiledBlock& before) const {
  TiledBlock block{0, 0, level_.map.width(), level_.map.height(), {}, false};
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

bool TiledSaver::is_resized() const {
  return level_.map.width() != origin_.frame.width || level_.map.height() != origin_.frame.height;
}

// layer: of the level.
FormatResult<void> TiledSaver::write_layer(int layer, TiledDocument& document) {
  const int number = origin_.layers[static_cast<std::size_t>(layer)];
  cells_ = &level_.cells_of(layer);
  auto blocks = document.blocks(number);
  if (!blocks) return tl::unexpected(blocks.error());
  const bool is_infinite = blocks->empty() || blocks->front().is_chunk;
  if (!is_infinite && is_resized()) {
    if (document.layer_count() != level_.layers.count())
      return cannot("has another size than the map, whose other layers would have to be cut with it");
    TiledBlock block = resized(blocks->front());
    takes_cells(block);
    document.put_cells(number, 0, block);
    if (layer == 0) document.set_size(block.width, block.height);
    return {};
  }
  for (std::size_t i = 0; i < blocks->size(); ++i) {
    if (takes_cells((*blocks)[i])) document.put_cells(number, i, (*blocks)[i]);
  }
  if (!is_infinite) return {};
  if (const std::vector<TiledBlock> chunks = new_chunks(*blocks); !chunks.empty())
    document.add_chunks(number, chunks);
  return {};
}

FormatResult<void> TiledSaver::write_layers(TiledDocument& document) {
  has_cells_ = document.layer_count() > 0;
  if (!has_cells_) return {};  // a tileset, or a map of objects alone
  if (std::any_of(origin_.layers.begin(), origin_.layers.end(),
                  [&](int number) { return number >= document.layer_count(); }))
    return cannot("has other layers of tiles than the map");
  for (std::size_t n = origin_.frame.tiles.size(); n-- > 0;) {
    if (origin_.frame.tiles[n] != 0) tiles_[origin_.frame.tiles[n]] = static_cast<TileNumber>(n);
  }
  for (int layer = 0; layer < level_.layers.count(); ++layer) {
    const auto i = static_cast<std::size_t>(layer);
    document.set_looks(origin_.layers[i], origin_.opened->layers.list[i], level_.layers.list[i]);
    if (const auto written = write_layer(layer, document); !written) return written;
  }
  return {};
}

// Whether both have the same layers with the same cells.
bool has_same_layers(Level a, const Level& b) {
  a.choose_layer(b.layers.chosen);
  return a.map == b.map && a.layers == b.layers;
}

FormatContext TiledSaver::context_again() const {
  FormatContext context{.extension = origin_.extension, .folder = origin_.folder};
  if (origin_.layers.size() == 1) context.choices.layer_number = origin_.layers[0] + 1;
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
         level_.sheet(SheetId::tiles).flags != origin_.opened->sheet(SheetId::tiles).flags;
}

FormatResult<TiledSaver::Attempt> TiledSaver::attempt(const Plan& plan) {
  auto document = tiled_document(origin_.bytes);
  if (!document) return tl::unexpected(document.error());
  if (const auto written = write_layers(**document); !written) return tl::unexpected(written.error());
  TiledTilesetEdits tiles;
  if (model_) {
    const auto names = names_for_tiled(level_, *origin_.opened, plan.takes_new_names);
    tiles = tileset_edits(level_, origin_, *model_, names, plan.left_out);
  }
  for (const auto& [place, edits] : tiles.of) {
    if (place.first.empty()) (*document)->edit_tiles(place.second, edits);
  }
  Attempt attempt{{(*document)->text(), {}}, Level(), {}};
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
        attempt.held->tile_flags(tile) != level_.tile_flags(tile))
      attempt.wrong.insert(tile);
  }
  // The empty tile, alone, may be what moves the numbers.
  if (attempt.held && !is_same && attempt.wrong.contains(0)) attempt.wrong = {0};
  return attempt;
}

FormatResult<WrittenLevel> TiledSaver::write() {
  if (const auto checked = check_place(); !checked) return tl::unexpected(checked.error());
  if (const auto checked = check_tiles(); !checked) return tl::unexpected(checked.error());
  if (has_other_tiles()) {
    auto model = read_tiled_content(origin_.bytes, context_again(), origin_.tilesets);
    if (!model) return cannot("cannot be read again: " + model.error().message);
    model_ = *std::move(model);
  }
  Plan plan;
  auto last = attempt(plan);
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
  if (held->tiled->frame.tiles != origin_.frame.tiles || (has_cells_ && !has_same_layers(*held, level_)))
    return cannot("has layers of tiles that the map cannot hold as they are");
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
