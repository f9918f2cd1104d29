#include "ground_cells.h"

#include <algorithm>
#include <map>
#include <utility>

namespace talus {
namespace {

bool counts(const Level& level, TileNumber tile) {
  return shape_of_tile(level, tile).kind != TileShape::Kind::none || is_ball_tile(level, tile);
}

std::vector<int> layers_of_ground(const Level& level) {
  std::vector<int> layers;
  for (int layer = 0; layer < level.layers.count(); ++layer)
    if (level.layers.list[static_cast<std::size_t>(layer)].is_ground) layers.push_back(layer);
  return layers;
}

// Of cells with the same shape the one in front stays.
TileStack reduced(const Level& level, const TileStack& tiles) {
  TileStack stack;
  for (auto tile = tiles.begin(); tile != tiles.end(); ++tile) {
    const bool is_hidden = std::any_of(tile + 1, tiles.end(), [&](MapCell in_front) {
      return *tile == in_front || (!is_ball_tile(level, tile->tile) &&
                                   shape_of_cell(level, *tile) == shape_of_cell(level, in_front));
    });
    if (!is_hidden) stack.push_back(*tile);
  }
  return stack;
}

// Leaves out turns that change nothing of the ground. Each turned tile is looked at once.
class TurnFilter {
 public:
  explicit TurnFilter(const Level& level) : level_(level) {}
  MapCell operator()(MapCell cell) {
    if (cell.turn == TileTurn::none) return cell;
    const auto [known, is_new] = known_.try_emplace(cell, cell);
    if (is_new &&
        (is_ball_tile(level_, cell.tile) || shape_of_cell(level_, cell) == shape_of_tile(level_, cell.tile)))
      known->second.turn = TileTurn::none;
    return known->second;
  }

 private:
  const Level& level_;
  std::map<MapCell, MapCell> known_;
};

// Whether it needs no number of its own.
bool is_plain(const TileStack& stack) { return stack.size() == 1 && stack.front().turn == TileTurn::none; }

// Numbers the stacks of a level in the order in which they are met.
class StackCounter {
 public:
  explicit StackCounter(const Level& level) : level_(level) {}

  // The number of the tiles in a cell, all of which count; more than TileNumber holds if there are too many
  // stacks.
  std::size_t number_of(const TileStack& tiles) {
    const auto [known, is_new] = numbers_.try_emplace(tiles, 0);
    if (is_new) known->second = number_of_reduced(reduced(level_, tiles));
    return known->second;
  }
  std::vector<TileStack> take_stacks() { return std::move(stacks_); }

 private:
  std::size_t number_of_reduced(TileStack stack) {
    if (is_plain(stack)) return stack.front().tile;
    const auto [known, is_new] = stack_numbers_.try_emplace(stack, first() + stacks_.size());
    if (is_new) stacks_.push_back(std::move(stack));
    return known->second;
  }
  std::size_t first() const { return static_cast<std::size_t>(level_.tile_count()); }

  const Level& level_;
  std::map<TileStack, std::size_t> numbers_;        // by all tiles that count
  std::map<TileStack, std::size_t> stack_numbers_;  // by those that stay
  std::vector<TileStack> stacks_;
};

// Puts the stacks in order, so that another order of cells gives the same numbers.
void sort_stacks(GroundCells& ground, std::size_t tile_count) {
  std::vector<std::size_t> order(ground.stacks.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ground.stacks[a] < ground.stacks[b]; });
  std::vector<TileNumber> place(order.size());
  std::vector<TileStack> sorted;
  for (const std::size_t from : order) {
    place[from] = static_cast<TileNumber>(tile_count + sorted.size());
    sorted.push_back(std::move(ground.stacks[from]));
  }
  ground.stacks = std::move(sorted);
  for (TileNumber& number : ground.own)
    if (number >= tile_count) number = place[number - tile_count];
}

GroundCells nothing(const Level& level) {
  GroundCells ground;
  const auto tile_count = static_cast<std::size_t>(level.tile_count());
  ground.stacks.emplace_back();
  if (tile_count >= kMaxTiles) return {.cells = {}, .stacks = {}, .overflow = 1, .own = {}};
  ground.own.assign(level.map.cells().size(), static_cast<TileNumber>(tile_count));
  ground.cells = ground.own;
  return ground;
}

}  // namespace

GroundCells ground_cells(const Level& level) {
  const std::vector<int> layers = layers_of_ground(level);
  if (layers.empty()) return nothing(level);
  if (layers.size() == 1 && !level.cells_of(layers.front()).has_turned())
    return {.cells = level.cells_of(layers.front()).tiles(), .stacks = {}, .overflow = 0, .own = {}};

  const auto tile_count = static_cast<std::size_t>(level.tile_count());
  std::vector<bool> is_counted(tile_count);
  for (std::size_t tile = 0; tile < tile_count; ++tile)
    is_counted[tile] = counts(level, static_cast<TileNumber>(tile));
  std::vector<const MapCells*> cells;
  cells.reserve(layers.size());
  for (const int layer : layers) cells.push_back(&level.cells_of(layer));

  GroundCells ground;
  ground.own.resize(level.map.cells().size());
  StackCounter counter(level);
  TurnFilter filtered(level);
  TileStack stack;
  for (std::size_t cell = 0; cell < ground.own.size(); ++cell) {
    stack.clear();
    for (const MapCells* layer : cells)
      if (is_counted[layer->tiles()[cell]]) stack.push_back(filtered((*layer)[cell]));
    // Without a tile that counts, the one in front stands for nothing.
    std::size_t number = stack.empty() ? cells.back()->tiles()[cell] : stack.front().tile;
    if (!stack.empty() && !is_plain(stack)) number = counter.number_of(stack);
    if (number >= kMaxTiles)
      return {.cells = {}, .stacks = {}, .overflow = number + 1 - tile_count, .own = {}};
    ground.own[cell] = static_cast<TileNumber>(number);
  }
  ground.stacks = counter.take_stacks();
  sort_stacks(ground, tile_count);
  ground.cells = ground.own;
  return ground;
}

std::optional<TileNumber> ground_number(const Level& level, std::span<const TileStack> stacks, Cell cell) {
  const std::vector<int> layers = layers_of_ground(level);
  const auto at = static_cast<std::size_t>(cell.y) * level.map.width() + cell.x;
  if (layers.empty()) return static_cast<TileNumber>(level.tile_count());
  TurnFilter filtered(level);
  TileStack stack;
  for (const int layer : layers) {
    const MapCell its = level.cells_of(layer)[at];
    if (layers.size() == 1 && its.turn == TileTurn::none) return its.tile;
    if (counts(level, its.tile)) stack.push_back(filtered(its));
  }
  if (stack.empty()) return level.cells_of(layers.back()).tiles()[at];
  stack = reduced(level, stack);
  if (is_plain(stack)) return stack.front().tile;
  const auto found = std::lower_bound(stacks.begin(), stacks.end(), stack);
  if (found == stacks.end() || *found != stack) return std::nullopt;
  return static_cast<TileNumber>(level.tile_count() + (found - stacks.begin()));
}

TileStack tiles_of(TileNumber number, std::span<const TileStack> stacks, int tile_count) {
  if (number < tile_count) return {number};
  return stacks[static_cast<std::size_t>(number - tile_count)];
}

TileShape shape_of_number(const Level& level, std::span<const TileStack> stacks, TileNumber number) {
  if (number < level.tile_count()) return shape_of_tile(level, number);
  const TileStack& stack = stacks[static_cast<std::size_t>(number - level.tile_count())];
  if (stack.size() == 1) return shape_of_cell(level, stack.front());
  TileShape group{.kind = TileShape::Kind::group};
  for (const MapCell cell : stack) {
    TileShape shape = shape_of_cell(level, cell);
    if (shape.kind == TileShape::Kind::none || problem_of(shape, level.map.tile_size())) continue;
    // The one in front counts, even if it is no conveyor.
    group.conveyor = std::exchange(shape.conveyor, 0);
    if (shape.kind == TileShape::Kind::group)
      std::move(shape.parts.begin(), shape.parts.end(), std::back_inserter(group.parts));
    else
      group.parts.push_back(std::move(shape));
  }
  if (group.parts.size() == 1) {
    group.parts.front().conveyor = group.conveyor;
    return std::move(group.parts.front());
  }
  return group.parts.empty() ? TileShape() : group;
}

Level without_tiles(const Level& level) {
  Level bare;
  bare.map = TileMap(level.map.width(), level.map.height(), level.map.tile_size());
  bare.curves = level.curves;
  bare.spawns = level.spawns;
  bare.tuning = level.tuning;
  return bare;
}

}  // namespace talus
