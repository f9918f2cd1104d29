// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "layers.h"

#include <talus/level/ground.h>

#include <algorithm>
#include <cmath>

namespace game {

using talus::Vec2;

namespace {

// Whether nothing is seen of tile 0.
bool is_0_blank(const talus::Level& level) {
  if (level.large_tiles.contains(0)) return false;
  const talus::PicturePart tile = sheet_of(level, talus::SheetId::tiles).part(0);
  for (int i = 0; i < tile.width * tile.height; ++i)
    if (tile.picture->at(tile.x + i % tile.width, tile.y + i / tile.width)[3] > 0) return false;
  return true;
}

// Columns or rows, from the first to before the last.
struct Span {
  int from, to;
};

// What is seen of `count` cells of a side from `place` on, px, and `before` and `after` that, whose pictures
// reach into the view.
Span seen(double place, double length, int side, int count, int before, int after) {
  const auto cell = [&](double at) {
    return static_cast<int>(std::clamp(std::floor(at / side), -1.0, 1.0 * count));
  };
  return {std::max(0, cell(place) - before), std::min(count, cell(place + length) + 1 + after)};
}

}  // namespace

// A layer in the view.
struct Layers::View {
  Painter& painter;
  Vec2 shift;  // px, of the layer
  Shade shade;

  View(Painter& to, const talus::LayerLooks& looks) : painter(to), shade{looks.tint, looks.opacity} {
    const talus::Rect view = to.view();
    const Vec2 middle{view.x + view.w / 2, view.y + view.h / 2};
    shift = to.on_whole_pixels(looks.offset +
                               Vec2{middle.x * (1 - looks.parallax.x), middle.y * (1 - looks.parallax.y)});
  }
};

Layers::Layers(const talus::Level& level)
    : level_(level), sheet_(sheet_of(level, talus::SheetId::tiles)), is_0_blank_(is_0_blank(level)) {
  if (!level.curves.empty()) ground_ = talus::terrain_of(level);
}

talus::Rgb Layers::background() const {
  const talus::Rgba color = talus::background_of(level_);
  const auto over_black = [&](std::uint8_t part) {
    return static_cast<std::uint8_t>((part * color.a + 127) / 255);
  };
  return {over_black(color.r), over_black(color.g), over_black(color.b)};
}

void Layers::draw(Painter& painter, double time) const {
  bool skips_empty = is_0_blank_;
  for (const auto& [has_tiles, index] : talus::layers_in_order(level_)) {
    const auto at = static_cast<std::size_t>(index);
    const auto& groups = level_.layers.groups;
    const talus::LayerLooks looks =
        has_tiles ? shown_looks(groups, level_.layers.list[at]) : shown_looks(groups, level_.objects[at]);
    const View view(painter, looks);
    if (looks.visible && has_tiles)
      draw_tiles(view, index, skips_empty, time);
    else if (looks.visible)
      draw_others(view, level_.objects[at]);
    skips_empty = skips_empty || has_tiles;  // in layers in front of that one
  }
  draw_curves(painter);
}

void Layers::draw_tiles(const View& view, int layer, bool skips_empty, double time) const {
  const talus::TileSize size = level_.map.tile_size();
  const talus::CellReach reach = talus::reach_of(level_.large_tiles, size);
  const talus::Rect area = view.painter.view();
  const Span columns =
      seen(area.x - view.shift.x, area.w, size.width, level_.map.width(), reach.right, reach.left);
  const Span rows =
      seen(area.y - view.shift.y, area.h, size.height, level_.map.height(), reach.down, reach.up);
  const talus::MapCells& cells = level_.cells_of(layer);
  const bool has_bodies = level_.layers.list[static_cast<std::size_t>(layer)].is_ground;
  const talus::CellOrder order(level_.layers.order);
  for (int i = 0; i < rows.to - rows.from; ++i) {
    for (int k = 0; k < columns.to - columns.from; ++k) {
      const talus::Cell cell{order.column(k, columns.from, columns.to), order.row(i, rows.from, rows.to)};
      talus::MapCell its =
          cells[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(level_.map.width()) +
                static_cast<std::size_t>(cell.x)];
      if (has_bodies && talus::is_ball_tile(level_, its.tile)) its.tile = 0;  // the body has left it
      if (its.tile == 0 && skips_empty) continue;
      const auto large = level_.large_tiles.find(its.tile);
      const auto* animation = talus::find_animation(level_.animations, its.tile);
      if (animation != nullptr) its.tile = talus::tile_shown_at(*animation, time);
      const talus::LargeTile tile =
          large != level_.large_tiles.end() ? large->second : talus::LargeTile{sheet_.part(its.tile), size};
      view.painter.draw(talus::placed(tile, cell, size, its.turn), view.shift, view.shade);
    }
  }
}

void Layers::draw_others(const View& view, const talus::ObjectLayer& layer) const {
  for (const std::size_t i : talus::drawn_pictures(layer))
    view.painter.draw(talus::placed(layer.objects[i]), view.shift, view.shade);
  if (!layer.image || layer.image->part.picture == nullptr) return;
  const talus::PicturePart& part = layer.image->part;
  const Vec2 size{1.0 * part.width, 1.0 * part.height};
  const talus::Rect area = view.painter.view();
  // The first place, and how often it is repeated from there.
  const auto span = [](double from, double length, double side, bool repeats) {
    const double first = repeats ? std::floor(from / side) * side : 0;
    return std::pair(first, repeats ? static_cast<int>((from + length - first) / side) + 1 : 1);
  };
  const auto [left, columns] = span(area.x - view.shift.x, area.w, size.x, layer.image->repeats_x);
  const auto [top, rows] = span(area.y - view.shift.y, area.h, size.y, layer.image->repeats_y);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      view.painter.draw(talus::placed(part, {left + column * size.x, top + row * size.y}, size), view.shift,
                        view.shade);
}

void Layers::draw_curves(Painter& painter) const {
  constexpr talus::Rgb kWhite{255, 255, 255};
  constexpr double kStep = 0.5, kWidth = 1;  // px
  if (level_.curves.empty()) return;
  const talus::TileSize size = level_.map.tile_size();
  const talus::Rect area = painter.view();
  const Span columns = seen(area.x, area.w, size.width, level_.map.width(), 0, 0);
  const Span rows = seen(area.y, area.h, size.height, level_.map.height(), 0, 0);
  for (int row = rows.from; row < rows.to; ++row) {
    for (int column = columns.from; column < columns.to; ++column) {
      for (const talus::Piece<double>& piece : ground_.pieces_in({column, row})) {
        if (piece.origin >= 0) continue;  // of a tile
        if (piece.is_wall()) painter.line({piece.x0, piece.y0}, {piece.x1, piece.y1}, kWidth, kWhite);
        const double left = std::max(piece.x0, level_.map.x_of(column));
        const double right = std::min(piece.x1, level_.map.x_of(column + 1));
        for (double x = left; x < right; x += kStep) {
          const double next = std::min(x + kStep, right);
          painter.line({x, piece.y_at(x, ground_.stretches())}, {next, piece.y_at(next, ground_.stretches())},
                       kWidth, kWhite);
        }
      }
    }
  }
}

}  // namespace game
