// Draws layers of tiles.
#include "tile_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "level/tile_color.h"
#include "overlay/visible.h"

namespace talus {
namespace {

constexpr float kFarZoom = 0.25f;

// The colour, 0..15, that tile 0 shows in all of its pixels; nothing if it has several, or is in true colour.
std::optional<std::uint8_t> plain_color_of_tile_0(const Level& level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  if (sheet.picture != nullptr)
    return is_clear(*sheet.picture, sheet.layout(), 0, level.map.tile_size()) ? std::optional(std::uint8_t{0})
                                                                              : std::nullopt;
  const TileImage& image = sheet.images[0];
  const bool is_plain = std::all_of(image.begin(), image.end(), [&](int pixel) { return pixel == image[0]; });
  return is_plain ? std::optional(image[0]) : std::nullopt;
}

constexpr int kNothing = -1;
using ShownTiles = std::vector<int>;  // by tile: what is drawn for it, or kNothing

// The cells from `from` to column `end` of a row, all at once: a screen may have a hundred thousand. row: the
// tiles of the whole row.
void draw_row(ImDrawList& list, const TileNumber* row, Cell from, int end, const ShownTiles& shown,
              const CanvasView& view, const Ui& ui, ImU32 color) {
  int count = 0;
  for (int x = from.x; x < end; ++x) count += shown[row[x]] == kNothing ? 0 : 1;
  if (count == 0) return;
  list.PrimReserve(6 * count, 4 * count);
  for (Cell cell = from; cell.x < end; ++cell.x) {
    const int tile = shown[row[cell.x]];
    if (tile == kNothing) continue;
    const UvRect uv = ui.uv_of(tile);
    list.PrimRectUV(view.corner_of({cell.x, cell.y}), view.corner_of({cell.x + 1, cell.y + 1}), uv.from,
                    uv.to, color);
  }
}

// Whether a layer's picture is that of its tiles, without any change. moves: whether parallax counts.
bool is_unchanged(const TileLayer& layer, bool moves) {
  return layer.visible && layer.opacity == 1 && layer.offset == Vec2{} && layer.tint == Rgb{255, 255, 255} &&
         (!moves || layer.parallax == Vec2{1, 1});
}

ImU32 layer_color(const TileLayer& layer) {
  return IM_COL32(layer.tint.r, layer.tint.g, layer.tint.b,
                  static_cast<int>(std::lround(std::clamp(layer.opacity, 0.0, 1.0) * 255)));
}

// The view in which the map is where a layer is drawn; nothing if it is out of sight there.
std::optional<CanvasView> view_of(const TileLayer& layer, const TileMap& map, const CanvasView& view,
                                  bool moves) {
  if (!layer.visible || layer.opacity <= 0) return std::nullopt;
  const Rect visible = view.visible();
  Vec2 by = layer.offset;
  if (moves) {
    by.x += visible.center().x * (1 - layer.parallax.x);
    by.y += visible.center().y * (1 - layer.parallax.y);
  }
  if (by == Vec2{}) return view;
  if (!meet(Rect{by.x, by.y, map.px_width(), map.px_height()}, visible)) return std::nullopt;
  CanvasView there = view;  // whole px of the screen keep pixel art sharp
  there.origin = {std::round(view.origin.x + by.x * view.zoom), std::round(view.origin.y + by.y * view.zoom)};
  return there;
}

// The tiles by their numbers, or what their animations show for them.
std::vector<int> tiles_at(const Level& level, std::optional<double> time) {
  std::vector<int> tiles(static_cast<std::size_t>(level.tile_count()));
  std::iota(tiles.begin(), tiles.end(), 0);
  if (!time) return tiles;
  for (const auto& [tile, animation] : level.animations) tiles[tile] = tile_shown_at(animation, *time);
  return tiles;
}

// What is drawn for each tile of a layer. tiles: see tiles_at.
ShownTiles shown_tiles(const Level& level, const std::vector<int>& tiles, bool hide_balls, bool at_back,
                       bool skip_tile_0) {
  ShownTiles shown(tiles.size());
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    const bool hidden = hide_balls && is_ball_tile(level, static_cast<TileNumber>(tile));
    const int looks = hidden ? 0 : tiles[static_cast<std::size_t>(tile)];  // a ball's cell shows tile 0
    shown[static_cast<std::size_t>(tile)] = looks == 0 && (skip_tile_0 || !at_back) ? kNothing : looks;
  }
  return shown;
}

void draw_cells(ImDrawList& list, const Level& level, int layer, const ShownTiles& shown, ImTextureID texture,
                const CanvasView& view, const Ui& ui) {
  const CellSpan cells = visible_cells(level.map, view);
  if (cells.empty()) return;
  const ImU32 color = layer_color(level.layers.list[static_cast<std::size_t>(layer)]);
  const TileNumber* tiles = level.cells_of(layer).data();
  list.PushTextureID(texture);
  for (int y = cells.y0; y < cells.y1; ++y)
    draw_row(list, tiles + static_cast<std::size_t>(y) * level.map.width(), {cells.x0, y}, cells.x1, shown,
             view, ui, color);
  list.PopTextureID();
}

}  // namespace

CellSpan visible_cells(const TileMap& map, const CanvasView& view) {
  const Cell from = view.to_cell(view.min), to = view.to_cell(view.max);
  return {std::clamp(from.x, 0, map.width()), std::clamp(from.y, 0, map.height()),
          std::clamp(to.x + 1, 0, map.width()), std::clamp(to.y + 1, 0, map.height())};
}

std::vector<LayerCells> ground_layers(const Level& level) {
  std::vector<LayerCells> layers;
  for (int layer = 0; layer < level.layers.count(); ++layer)
    if (level.layers.list[static_cast<std::size_t>(layer)].is_ground)
      layers.push_back(&level.cells_of(layer));
  return layers;
}

void draw_tiles(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui, TileLooks looks) {
  list.AddRectFilled(view.min, view.max, theme::color(theme::kOutside));
  // Most cells of most maps hold tile 0 in one colour: one rectangle below all replaces a square for each.
  const std::optional<std::uint8_t> plain = plain_color_of_tile_0(level);
  const bool back_is_unchanged = is_unchanged(level.layers.list.front(), looks.parallax);
  const CellSpan cells = visible_cells(level.map, view);
  if (!cells.empty())
    list.AddRectFilled(view.corner_of({cells.x0, cells.y0}), view.corner_of({cells.x1, cells.y1}),
                       theme::color(level.palette[back_is_unchanged ? plain.value_or(0) : 0]));
  const std::vector<int> tiles = tiles_at(level, looks.time);
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const TileLayer& look = level.layers.list[static_cast<std::size_t>(layer)];
    const auto there = view_of(look, level.map, view, looks.parallax);
    if (!there) continue;
    const bool at_back = layer == 0, is_opaque = at_back && back_is_unchanged;
    const bool skip_tile_0 = is_opaque ? plain.has_value() : plain == 0;
    draw_cells(list, level, layer,
               shown_tiles(level, tiles, looks.hide_balls && look.is_ground, at_back, skip_tile_0),
               is_opaque ? ui.sheet(SheetId::tiles) : ui.clear_tiles, *there, ui);
  }
}

bool is_far(const CanvasView& view) { return view.zoom <= kFarZoom; }

void draw_far_tiles(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui,
                    const MapLook& look, bool parallax, const OtherLevel* other) {
  if (ui.map_textures == nullptr) return;
  const int smaller = std::min(view.tile.width, view.tile.height);
  int block = 1;  // cells for each texel; a texel is at least half a pixel
  while (block < kMaxBlock && static_cast<float>(block * smaller) * view.zoom <= 0.5f) block *= 2;
  const bool back_is_unchanged = is_unchanged(level.layers.list.front(), parallax);
  if (const CellSpan cells = visible_cells(level.map, view); !back_is_unchanged && !cells.empty())
    list.AddRectFilled(view.corner_of({cells.x0, cells.y0}), view.corner_of({cells.x1, cells.y1}),
                       theme::color(level.palette[0]));
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const TileLayer& its = level.layers.list[static_cast<std::size_t>(layer)];
    const auto there = view_of(its, level.map, view, parallax);
    if (!there) continue;
    const CellSpan span = visible_cells(level.map, *there);
    if (span.empty()) continue;
    const CellRect cells{span.x0, span.y0, span.x1 - span.x0, span.y1 - span.y0};
    const LayerLook of_layer{layer, layer == 0 && back_is_unchanged, look};
    for (const MapTextures::Piece& piece : ui.map_textures->pieces(cells, block, of_layer, other))
      list.AddImage(piece.texture, there->corner_of({piece.cells.x, piece.cells.y}),
                    there->corner_of({piece.cells.x + piece.cells.w, piece.cells.y + piece.cells.h}), {0, 0},
                    piece.uv, layer_color(its));
  }
}

}  // namespace talus
