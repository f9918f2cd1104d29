#include "map_paint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <talus/level/placed_picture.h>
#include <talus/level/tile_turns.h>
#include "../level/tile_color.h"

namespace talus {
namespace {

// How a layer changes what it shows.
struct PaintLooks {
  int opacity = 255;
  Rgb tint;
  Vec2 offset;
};

PaintLooks paint_looks(const LayerLooks& layer) {
  constexpr double kMax = 255;
  return {static_cast<int>(std::lround(std::clamp(layer.opacity, 0.0, 1.0) * kMax)), layer.tint,
          layer.offset};
}

std::uint8_t share_of(int value, int of_255) {
  return static_cast<std::uint8_t>((value * of_255 + 127) / 255);
}

class MapPainter {
 public:
  MapPainter(const Level& level, int top, int rows)
      : level_(level),
        tile_(level.map.tile_size()),
        width_(static_cast<int>(level.map.px_width())),
        top_(top),
        height_(rows),
        sheet_(level.sheet(SheetId::tiles)) {
    const auto [r, g, b, a] = level.background ? Rgba() : background_of(level);
    pixels_.reserve(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (std::int64_t i = 0; i < std::int64_t{width_} * height_; ++i)
      pixels_.insert(pixels_.end(), {r, g, b, a});
  }

  bool paint_tiles(int layer, const std::function<bool(double)>& goes_on) {
    const LayerLooks look =
        shown_looks(level_.layers.groups, level_.layers.list[static_cast<std::size_t>(layer)]);
    if (!look.visible) return true;
    looks_ = paint_looks(look);
    is_back_ = layer == 0;
    const MapCells& cells = level_.cells_of(layer);
    const CellOrder order(level_.layers.order);
    const int rows = level_.map.height(), columns = level_.map.width();
    for (int i = 0; i < rows; ++i) {
      if (!goes_on(1.0 * i / rows)) return false;
      Cell cell{0, order.row(i, 0, rows)};
      for (int k = 0; k < columns; ++k) {
        cell.x = order.column(k, 0, columns);
        paint_tile(cells[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(cell.x)],
                   cell);
      }
    }
    return true;
  }

  void paint_others(const ObjectLayer& layer) {
    const LayerLooks look = shown_looks(level_.layers.groups, layer);
    if (!look.visible) return;
    looks_ = paint_looks(look);
    if (layer.image) paint_image(*layer.image);
    for (const std::size_t i : drawn_pictures(layer)) paint(placed(layer.objects[i]));
  }

  std::vector<std::uint8_t> take() { return std::move(pixels_); }

 private:
  // Over what is there. rgba: four bytes.
  void put(int x, int y, const std::uint8_t* rgba) {
    std::uint8_t* under = &pixels_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                        static_cast<std::size_t>(x))];
    const Rgb tint = looks_.tint;
    lay_over(under, {share_of(rgba[0], tint.r), share_of(rgba[1], tint.g), share_of(rgba[2], tint.b),
                     share_of(rgba[3], looks_.opacity)});
  }

  void paint_tile(MapCell shown, Cell cell) {
    if (shown.tile == 0 && !is_back_) return;
    if (const auto large = level_.large_tiles.find(shown.tile); large != level_.large_tiles.end())
      return paint(placed(large->second, cell, tile_, shown.turn));
    const int left = cell.x * tile_.width + static_cast<int>(std::floor(looks_.offset.x + 0.5));
    const int top = cell.y * tile_.height + top_of_turned(tile_, shown.turn) +
                    static_cast<int>(std::floor(looks_.offset.y + 0.5)) - top_;
    const TileSize size = turned(tile_, shown.turn);
    const Cell place = sheet_.layout().place_of(shown.tile);
    for (int y = std::max(0, -top); y < size.height && top + y < height_; ++y) {
      for (int x = std::max(0, -left); x < size.width && left + x < width_; ++x) {
        const Cell from = pixel_before_turn({x, y}, shown.turn, tile_);
        if (sheet_.picture != nullptr)
          put(left + x, top + y,
              sheet_.picture->at(place.x * tile_.width + from.x, place.y * tile_.height + from.y));
        else
          put_color(left + x, top + y, color_at(sheet_.images[shown.tile], tile_, from.x, from.y));
      }
    }
  }

  // Colour 0 is clear.
  void put_color(int x, int y, std::uint8_t color) {
    const Rgb rgb = level_.palette[color];
    const std::uint8_t rgba[] = {rgb.r, rgb.g, rgb.b, 255};
    if (color != 0) put(x, y, rgba);
  }

  void paint(PlacedPicture shown) {
    const PicturePart& part = shown.part;
    shown.corner = shown.corner + looks_.offset - Vec2{0, 1.0 * top_};
    const double area = shown.right.x * shown.down.y - shown.right.y * shown.down.x;
    if (area == 0) return;
    const Rect box = bounds_of(shown);
    const int left = px_from(box.x, width_), right = px_from(box.right(), width_);
    const int top = px_from(box.y, height_), bottom = px_from(box.bottom(), height_);
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const Vec2 from = Vec2{x + 0.5, y + 0.5} - shown.corner;
        const double u = (from.x * shown.down.y - from.y * shown.down.x) / area * part.width;
        const double v = (from.y * shown.right.x - from.x * shown.right.y) / area * part.height;
        if (u < 0 || v < 0 || u >= part.width || v >= part.height) continue;
        put(x, y, part.picture->at(part.x + static_cast<int>(u), part.y + static_cast<int>(v)));
      }
    }
  }

  // The first px whose middle is not before a place.
  static int px_from(double place, int most) {
    return static_cast<int>(std::clamp(std::ceil(place - 0.5), 0.0, 1.0 * most));
  }

  void paint_image(const LayerImage& image) {
    const PicturePart& part = image.part;
    if (part.picture == nullptr) return;
    const int left = static_cast<int>(std::floor(looks_.offset.x + 0.5));
    const int top = static_cast<int>(std::floor(looks_.offset.y + 0.5)) - top_;
    const auto place = [](int px, int from, int length, bool repeats) {
      const int at = px - from;
      if (repeats) return ((at % length) + length) % length;
      return at < length ? at : -1;
    };
    for (int y = 0; y < height_; ++y) {
      const int v = place(y, top, part.height, image.repeats_y);
      for (int x = 0; x < width_ && v >= 0; ++x) {
        const int u = place(x, left, part.width, image.repeats_x);
        if (u >= 0) put(x, y, part.picture->at(part.x + u, part.y + v));
      }
    }
  }

  const Level& level_;
  TileSize tile_;
  int width_, top_, height_;  // px; of the rows that are painted
  const Sheet& sheet_;
  PaintLooks looks_;
  bool is_back_ = false;  // whether the layer is the one at the back, in which tile 0 is drawn
  std::vector<std::uint8_t> pixels_;
};

}  // namespace

std::vector<std::uint8_t> map_pixels(const Level& level, int top, int rows,
                                     const std::function<bool(double)>& goes_on) {
  MapPainter painter(level, top, rows);
  const std::vector<LayerInOrder> layers = layers_in_order(level);
  const auto count = static_cast<double>(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const auto part = [&](double done) { return goes_on((static_cast<double>(i) + done) / count); };
    if (!layers[i].has_tiles)
      painter.paint_others(level.objects[static_cast<std::size_t>(layers[i].index)]);
    else if (!painter.paint_tiles(layers[i].index, part))
      break;
  }
  return painter.take();
}

}  // namespace talus
