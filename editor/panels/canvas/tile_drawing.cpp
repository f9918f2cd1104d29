// Draws the layers of a map.
#include "tile_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <talus/level/placed_picture.h>
#include "level/tile_color.h"
#include "picture_drawing.h"
#include "turned_tile.h"

namespace talus {
namespace {

constexpr float kFarZoom = 0.25f;

// The colour, 0..15, that tile 0 shows in all of its pixels; nothing if it has several, or is in true colour.
std::optional<std::uint8_t> plain_color_of_tile_0(const Level& level) {
  if (level.large_tiles.contains(0)) return std::nullopt;
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
// tiles of the whole row; turns: how they are turned, or null.
void draw_row(ImDrawList& list, const TileNumber* row, const TileTurn* turns, Cell from, int end,
              const ShownTiles& shown, const CanvasView& view, const Ui& ui, ImU32 color) {
  int count = 0;
  for (int x = from.x; x < end; ++x) count += shown[row[x]] == kNothing ? 0 : 1;
  if (count == 0) return;
  list.PrimReserve(6 * count, 4 * count);
  for (Cell cell = from; cell.x < end; ++cell.x) {
    const int tile = shown[row[cell.x]];
    if (tile == kNothing) continue;
    const UvRect uv = ui.uv_of(tile);
    const ImVec2 corner = view.corner_of({cell.x, cell.y}),
                 end_corner = view.corner_of({cell.x + 1, cell.y + 1});
    if (turns == nullptr || turns[cell.x] == TileTurn::none) {
      list.PrimRectUV(corner, end_corner, uv.from, uv.to, color);
      continue;
    }
    const auto& [at, uvs] = turned_tile(turns[cell.x], view.tile, corner, end_corner, uv);
    list.PrimQuadUV(at[0], at[1], at[2], at[3], uvs[0], uvs[1], uvs[2], uvs[3], color);
  }
}

// Whether a layer's picture is that of its tiles, without any change. moves: whether parallax counts.
bool is_unchanged(const LayerLooks& layer, bool moves) {
  return layer.visible && layer.opacity == 1 && layer.offset == Vec2{} && layer.tint == Rgb{255, 255, 255} &&
         (!moves || layer.parallax == Vec2{1, 1});
}

// Whether only colour 0 is behind the layer of tiles at the back, and its picture is that of its tiles.
bool is_back_opaque(const Level& level, bool moves) {
  return !level.background &&
         is_unchanged(shown_looks(level.layers.groups, level.layers.list.front()), moves) &&
         layers_in_order(level).front().has_tiles;
}

// What is seen where no layer shows anything. What is clear shows the theme.
void draw_background(ImDrawList& list, Rgba color, const TileMap& map, const CanvasView& view) {
  const CellSpan cells = visible_cells(map, view);
  if (cells.empty()) return;
  const ImVec2 from = view.corner_of({cells.x0, cells.y0}), to = view.corner_of({cells.x1, cells.y1});
  if (color.a < 255) list.AddRectFilled(from, to, theme::color(theme::kBackground));
  list.AddRectFilled(from, to, IM_COL32(color.r, color.g, color.b, color.a));
}

ImU32 layer_color(const LayerLooks& layer) {
  return IM_COL32(layer.tint.r, layer.tint.g, layer.tint.b,
                  static_cast<int>(std::lround(std::clamp(layer.opacity, 0.0, 1.0) * 255)));
}

// layer: index in TileLayers::list.
ImU32 color_of_layer(const Level& level, int layer) {
  return layer_color(shown_looks(level.layers.groups, level.layers.list[static_cast<std::size_t>(layer)]));
}

// The middle of the view of a game, whose camera stays on the map. Layers with parallax cover the map then,
// as they are made to.
Vec2 camera_place(const TileMap& map, const CanvasView& view) {
  const Rect seen = view.visible();
  const auto along = [](double centre, double side, double whole) {
    return side >= whole ? whole / 2 : std::clamp(centre, side / 2, whole - side / 2);
  };
  return {along(seen.center().x, seen.w, map.px_width()), along(seen.center().y, seen.h, map.px_height())};
}

// The view in which the map is where a layer is drawn; nothing if the layer is not drawn.
std::optional<CanvasView> view_of(const LayerLooks& layer, const TileMap& map, const CanvasView& view,
                                  bool moves) {
  if (!layer.visible || layer.opacity <= 0) return std::nullopt;
  Vec2 by = layer.offset;
  if (moves) {
    const Vec2 camera = camera_place(map, view);
    by.x += camera.x * (1 - layer.parallax.x);
    by.y += camera.y * (1 - layer.parallax.y);
  }
  if (by == Vec2{}) return view;
  CanvasView there = view;  // whole px of the screen keep pixel art sharp
  there.origin = {std::round(view.origin.x + by.x * view.zoom), std::round(view.origin.y + by.y * view.zoom)};
  return there;
}

// In play every layer ends where the map does. Else pictures and the layer that is painted on are whole.
bool ends_with_map(const Level& level, bool has_tiles, int layer, bool is_play) {
  return is_play || (has_tiles && layer != level.layers.chosen);
}

// Until it goes out of scope, and if it is on, nothing is drawn beside the map.
class ClipToMap {
 public:
  ClipToMap(ImDrawList& list, const TileMap& map, const CanvasView& view, bool is_on)
      : list_(is_on ? &list : nullptr) {
    if (is_on)
      list.PushClipRect(view.to_screen({0, 0}), view.to_screen({map.px_width(), map.px_height()}), true);
  }
  ClipToMap(const ClipToMap&) = delete;
  ClipToMap& operator=(const ClipToMap&) = delete;
  ~ClipToMap() {
    if (list_ != nullptr) list_->PopClipRect();
  }

 private:
  ImDrawList* list_;
};

// layer: index in Level::objects.
void draw_others(ImDrawList& list, const Level& level, int layer, const CanvasView& view, const Ui& ui,
                 bool moves) {
  const ObjectLayer& others = level.objects[static_cast<std::size_t>(layer)];
  const LayerLooks looks = shown_looks(level.layers.groups, others);
  if (const auto there = view_of(looks, level.map, view, moves))
    draw_pictures(list, others, *there, ui, layer_color(looks));
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

// The cells from which tiles may be seen.
CellSpan cells_in_sight(const Level& level, const CanvasView& view) {
  const CellReach reach = reach_of(level.large_tiles, level.map.tile_size());
  const Cell from = view.to_cell(view.min), to = view.to_cell(view.max);
  const int width = level.map.width(), height = level.map.height();
  return {std::clamp(from.x - reach.right, 0, width), std::clamp(from.y - reach.down, 0, height),
          std::clamp(to.x + 1 + reach.left, 0, width), std::clamp(to.y + 1 + reach.up, 0, height)};
}

// As draw_cells(), one by one, as large tiles lie over others.
void draw_overlapping_cells(ImDrawList& list, const Level& level, int layer, const ShownTiles& shown,
                            ImTextureID texture, const CanvasView& view, const Ui& ui) {
  const CellSpan cells = cells_in_sight(level, view);
  const ImU32 color = color_of_layer(level, layer);
  const MapCells& its = level.cells_of(layer);
  const CellOrder order(level.layers.order);
  for (int i = 0; i < cells.y1 - cells.y0; ++i) {
    Cell cell{0, order.row(i, cells.y0, cells.y1)};
    for (int k = 0; k < cells.x1 - cells.x0; ++k) {
      cell.x = order.column(k, cells.x0, cells.x1);
      const auto at = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(level.map.width()) +
                      static_cast<std::size_t>(cell.x);
      const int tile = shown[its.tiles()[at]];
      if (tile == kNothing) continue;
      const auto large = level.large_tiles.find(static_cast<TileNumber>(tile));
      if (large != level.large_tiles.end()) {
        const TileSize size = level.map.tile_size();
        draw_picture(list, placed(large->second, cell, size, its.turn_of(at)), view, ui, color);
        continue;
      }
      const ImVec2 from = view.corner_of(cell), to = view.corner_of({cell.x + 1, cell.y + 1});
      const auto& [corners, uvs] = turned_tile(its.turn_of(at), view.tile, from, to, ui.uv_of(tile));
      list.AddImageQuad(texture, corners[0], corners[1], corners[2], corners[3], uvs[0], uvs[1], uvs[2],
                        uvs[3], color);
    }
  }
}

void draw_cells(ImDrawList& list, const Level& level, int layer, const ShownTiles& shown, ImTextureID texture,
                const CanvasView& view, const Ui& ui) {
  if (!level.large_tiles.empty()) return draw_overlapping_cells(list, level, layer, shown, texture, view, ui);
  const CellSpan cells = visible_cells(level.map, view);
  if (cells.empty()) return;
  const ImU32 color = color_of_layer(level, layer);
  const MapCells& its = level.cells_of(layer);
  list.PushTextureID(texture);
  for (int y = cells.y0; y < cells.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(level.map.width());
    draw_row(list, its.tiles().data() + row, its.has_turned() ? its.turns().data() + row : nullptr,
             {cells.x0, y}, cells.x1, shown, view, ui, color);
  }
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
  const bool back_is_opaque = is_back_opaque(level, looks.parallax);
  const Rgb of_tile_0 = level.palette[plain.value_or(0)];
  draw_background(list,
                  back_is_opaque ? Rgba{of_tile_0.r, of_tile_0.g, of_tile_0.b, 255} : background_of(level),
                  level.map, view);
  const std::vector<int> tiles = tiles_at(level, looks.time);
  for (const auto& [has_tiles, layer] : layers_in_order(level)) {
    const ClipToMap clip(list, level.map, view, ends_with_map(level, has_tiles, layer, looks.parallax));
    if (!has_tiles) {
      draw_others(list, level, layer, view, ui, looks.parallax);
      continue;
    }
    const TileLayer& look = level.layers.list[static_cast<std::size_t>(layer)];
    const auto there = view_of(shown_looks(level.layers.groups, look), level.map, view, looks.parallax);
    if (!there) continue;
    const bool at_back = layer == 0, is_opaque = at_back && back_is_opaque;
    const bool skip_tile_0 = is_opaque ? plain.has_value() : plain == 0;
    draw_cells(list, level, layer,
               shown_tiles(level, tiles, looks.hide_balls && look.is_ground, at_back, skip_tile_0),
               is_opaque ? ui.sheet(SheetId::tiles) : ui.clear_sheet(SheetId::tiles), *there, ui);
  }
}

bool is_far(const CanvasView& view) { return view.zoom <= kFarZoom; }

void draw_far_tiles(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui,
                    const MapLook& look, bool parallax, const OtherLevel* other) {
  if (ui.map_textures == nullptr) return;
  const int smaller = std::min(view.tile.width, view.tile.height);
  int block = 1;  // cells for each texel; a texel is at least half a pixel
  while (block < kMaxBlock && static_cast<float>(block * smaller) * view.zoom <= 0.5f) block *= 2;
  const bool back_is_opaque = is_back_opaque(level, parallax);
  if (!back_is_opaque) draw_background(list, background_of(level), level.map, view);
  for (const auto& [has_tiles, layer] : layers_in_order(level)) {
    const ClipToMap clip(list, level.map, view, ends_with_map(level, has_tiles, layer, parallax));
    if (!has_tiles) {
      draw_others(list, level, layer, view, ui, parallax);
      continue;
    }
    const LayerLooks its =
        shown_looks(level.layers.groups, level.layers.list[static_cast<std::size_t>(layer)]);
    const auto there = view_of(its, level.map, view, parallax);
    if (!there) continue;
    const CellSpan span = visible_cells(level.map, *there);
    if (span.empty()) continue;
    const CellRect cells{span.x0, span.y0, span.x1 - span.x0, span.y1 - span.y0};
    const LayerLook of_layer{layer, layer == 0 && back_is_opaque, look};
    for (const MapTextures::Piece& piece : ui.map_textures->pieces(cells, block, of_layer, other))
      list.AddImage(piece.texture, there->corner_of({piece.cells.x, piece.cells.y}),
                    there->corner_of({piece.cells.x + piece.cells.w, piece.cells.y + piece.cells.h}), {0, 0},
                    piece.uv, layer_color(its));
  }
}

}  // namespace talus
