#include "ldtk_turns.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <talus/level/tile_turns.h>
#include "ldtk_meanings.h"

namespace talus {
namespace {

class MirrorTurner {
 public:
  MirrorTurner(const LdtkProject& project, const LdtkMapping& mapping, std::size_t known, LdtkTiles& tiles)
      : project_(project), mapping_(mapping), known_(known), tiles_(tiles) {}

  void run() {
    find_mirrored();
    if (mirrored_.empty()) return;
    compare();
    if (!any_) return;
    renumber();
    turn_cells();
  }

 private:
  // A tile that is another one mirrored.
  struct Mirrored {
    std::size_t tile;
    TileTurn turn;
    LdtkCell upright;
  };

  void find_mirrored();
  std::uint32_t upright_source(const LdtkSource& mirrored);
  void compare();
  bool is_alike(const Mirrored& of, const LdtkTileMeaning& upright, const LdtkTileMeaning& mirrored) const;
  void renumber();
  void turn_cells();

  const LdtkProject& project_;
  const LdtkMapping& mapping_;
  std::size_t known_;
  LdtkTiles& tiles_;
  std::map<LdtkSource, std::uint32_t> uprights_;  // sources that are not mirrored
  std::vector<Mirrored> mirrored_;
  bool any_ = false;                                 // whether one of them is turned
  std::vector<std::optional<LdtkCell>> upright_of_;  // by tile: what is turned
  std::vector<MapCell> cells_;                       // by tile: what shows it now
};

// The source without its flips.
std::uint32_t MirrorTurner::upright_source(const LdtkSource& mirrored) {
  if (uprights_.empty()) {
    for (std::size_t i = 0; i < tiles_.sources.size(); ++i)
      if (tiles_.sources[i].flips == 0)
        uprights_.try_emplace(tiles_.sources[i], static_cast<std::uint32_t>(i));
  }
  LdtkSource upright = mirrored;
  upright.flips = 0;
  const auto [found, is_new] =
      uprights_.try_emplace(upright, static_cast<std::uint32_t>(tiles_.sources.size()));
  if (is_new) tiles_.sources.push_back(upright);
  return found->second;
}

void MirrorTurner::find_mirrored() {
  for (std::size_t tile = std::max<std::size_t>(1, known_); tile < tiles_.cells.size(); ++tile) {
    const LdtkCell& cell = tiles_.cells[tile];
    if (cell.parts.size() != 1) continue;
    const LdtkSource source = tiles_.sources[cell.parts[0].source];
    const bool is_alone = source.tileset >= 0 && source.flips != 0 &&
                          is_in_place(cell.parts[0], source, tiles_.map.tile_size());
    if (!is_alone) continue;
    LdtkCell upright = cell;
    upright.parts[0].source = upright_source(source);
    const TileTurn turn = turn_of(false, (source.flips & 1) != 0, (source.flips & 2) != 0);
    mirrored_.push_back({tile, turn, std::move(upright)});
  }
}

bool MirrorTurner::is_alike(const Mirrored& of, const LdtkTileMeaning& upright,
                            const LdtkTileMeaning& mirrored) const {
  return upright.flags == mirrored.flags && upright.roles == mirrored.roles &&
         turned(upright.shape, of.turn, tiles_.map.tile_size()) == mirrored.shape;
}

void MirrorTurner::compare() {
  LdtkTiles pairs;
  pairs.map = TileMap(1, 1, tiles_.map.tile_size());
  pairs.sources = tiles_.sources;
  for (const Mirrored& each : mirrored_) {
    pairs.cells.push_back(each.upright);
    pairs.cells.push_back(tiles_.cells[each.tile]);
  }
  ImportDrops told_later;
  const auto meanings = ldtk_tile_meanings(project_, mapping_, pairs, told_later);
  upright_of_.resize(tiles_.cells.size());
  for (std::size_t i = 0; i < mirrored_.size(); ++i) {
    if (!is_alike(mirrored_[i], meanings[2 * i], meanings[2 * i + 1])) continue;
    upright_of_[mirrored_[i].tile] = std::move(mirrored_[i].upright);
    any_ = true;
  }
}

// Tiles that are turned take the number of their upright form, or make it one.
void MirrorTurner::renumber() {
  std::map<LdtkCell, TileNumber> numbers;
  std::vector<LdtkCell> kept;
  cells_.resize(tiles_.cells.size());
  const auto number_of = [&](const LdtkCell& cell) {
    const auto [found, is_new] = numbers.try_emplace(cell, static_cast<TileNumber>(kept.size()));
    if (is_new) kept.push_back(cell);
    return found->second;
  };
  for (std::size_t tile = 0; tile < tiles_.cells.size(); ++tile)
    cells_[tile] = {number_of(upright_of_[tile].value_or(tiles_.cells[tile])), TileTurn::none};
  for (const Mirrored& each : mirrored_)
    if (upright_of_[each.tile]) cells_[each.tile].turn = each.turn;
  tiles_.cells = std::move(kept);
}

void MirrorTurner::turn_cells() {
  for (TileLayer& layer : tiles_.layers) {
    MapCells cells(layer.cells->size());
    for (std::size_t i = 0; i < cells.size(); ++i) cells.set(i, cells_[layer.cells->tiles()[i]]);
    layer.cells = std::make_shared<const MapCells>(std::move(cells));
  }
}

}  // namespace

void turn_mirrored_tiles(const LdtkProject& project, const LdtkMapping& mapping, std::size_t known,
                         LdtkTiles& tiles) {
  MirrorTurner(project, mapping, known, tiles).run();
}

}  // namespace talus
