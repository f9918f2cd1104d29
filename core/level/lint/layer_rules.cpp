// Finds ground that is not where its layer is drawn.
#include "layer_rules.h"

#include <algorithm>
#include <cmath>

#include "../ground_level.h"
#include "rule_group.h"

namespace talus {
namespace {

constexpr LintRule kMovedGround{
    .code = "ground-not-where-drawn",
    .label = "ground that is drawn elsewhere",
    .by_hand = "Set the layer's offset to 0 in the Layers tab, or paint its ground where its picture is."};

bool has_ground(const Level& level, const MapCells& cells) {
  std::vector<bool> is_ground(static_cast<std::size_t>(level.tile_count()));
  for (std::size_t tile = 0; tile < is_ground.size(); ++tile)
    is_ground[tile] = shape_of_tile(level, static_cast<TileNumber>(tile)).kind != TileShape::Kind::none;
  return std::any_of(cells.tiles().begin(), cells.tiles().end(),
                     [&](TileNumber tile) { return is_ground[tile]; });
}

// px, in up to three decimals.
std::string px_of(double length) {
  std::string text = std::to_string(std::round(length * 1000) / 1000);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void check_layers(const LintContext& context, std::vector<Problem>& out) {
  const TileLayer& layer = context.level.layers.list.front();
  const Vec2 offset = shown_looks(context.level.layers.groups, layer).offset;
  if (!layer.is_ground || offset == Vec2() || !has_ground(context.level, context.level.map.cells())) return;
  report(out, kMovedGround,
         "bodies do not stop where the layer" + (layer.name.empty() ? "" : " \"" + layer.name + "\"") +
             " is drawn: its picture has an offset of " + px_of(offset.x) + ", " + px_of(offset.y) +
             " px, and its ground has none");
}

}  // namespace

Level linted_level(const Level& level, GroundNames* names) {
  Level flat = ground_level(level, names);
  TileLayer& front = flat.layers.list.front();
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const TileLayer& look = level.layers.list[static_cast<std::size_t>(layer)];
    const Vec2 offset = shown_looks(level.layers.groups, look).offset;
    if (!look.is_ground || offset == Vec2() || !has_ground(level, level.cells_of(layer))) continue;
    front.name = look.name;
    front.offset = offset;
    return flat;
  }
  return flat;
}

const RuleGroup& layer_rules() {
  static constexpr const LintRule* kRules[] = {&kMovedGround};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_level = check_layers};
  return kGroup;
}

}  // namespace talus
