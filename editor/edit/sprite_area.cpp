// Where the pixels of a canvas are on its sheet.
#include "sprite_area.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace talus {
namespace {

constexpr std::uint8_t kOpaque = 255;

// A change of one pixel of an area in 16 colours that changes nothing yet: before == after.
PixelChange pixel_of(const Level& level, const SpriteArea& area, Cell pixel) {
  const int tile = area.tile_at(level, pixel.x / area.tile.width, pixel.y / area.tile.height);
  const int index = pixel.y % area.tile.height * kCartTileSize + pixel.x % area.tile.width;
  const std::uint8_t color = level.sheet(area.sheet).images[tile][index];
  return {area.sheet, tile, index, color, color};
}

void put_indices(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                 CellRect painted, Edit& edit) {
  for (int y = painted.y; y < painted.y + painted.h; ++y) {
    for (int x = painted.x; x < painted.x + painted.w; ++x) {
      const PixelColor color = block.at(x - at.x, y - at.y);
      assert(color >= 0 && color < kColorCount);
      PixelChange change = pixel_of(level, area, {x, y});
      change.after = static_cast<std::uint8_t>(color);
      if (change.before != change.after) edit.changes.emplace_back(change);
    }
  }
}

// The part of a rectangle of the canvas that lies in a tile, px from the tile's corner. tile: columns and
// rows from the area's corner.
CellRect part_in_tile(const SpriteArea& area, CellRect rect, Cell tile) {
  const Cell corner{tile.x * area.tile.width, tile.y * area.tile.height};
  const auto part = shared(rect, {corner.x, corner.y, area.tile.width, area.tile.height});
  assert(part);
  return {part->x - corner.x, part->y - corner.y, part->w, part->h};
}

// Calls use(tile) for the tiles of an area that a rectangle of the canvas touches, in columns and rows from
// the area's corner.
template <class Use>
void for_each_tile(const SpriteArea& area, CellRect rect, Use use) {
  const TileSize size = area.tile;
  for (int y = rect.y / size.height; y <= (rect.y + rect.h - 1) / size.height; ++y)
    for (int x = rect.x / size.width; x <= (rect.x + rect.w - 1) / size.width; ++x) use(Cell{x, y});
}

PixelColor color_in(const TileLook& look, TileSize size, int x, int y) {
  const std::uint8_t* const pixel = &look.rgba[4 * static_cast<std::size_t>(y * size.width + x)];
  return pixel_color({pixel[0], pixel[1], pixel[2], pixel[3]});
}

void put_rgba(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at, CellRect painted,
              Edit& edit) {
  for_each_tile(area, painted, [&](Cell place) {
    const int tile = area.tile_at(level, place.x, place.y);
    TileLookChange change{area.sheet, tile, look_of(level.sheet(area.sheet), area.tile, tile), {}};
    change.after = change.before;
    const CellRect part = part_in_tile(area, painted, place);
    const Cell corner{place.x * area.tile.width - at.x, place.y * area.tile.height - at.y};
    for (int y = part.y; y < part.y + part.h; ++y) {
      for (int x = part.x; x < part.x + part.w; ++x) {
        const PixelColor color = block.at(corner.x + x, corner.y + y);
        if (color == color_in(change.before, area.tile, x, y)) continue;  // what is clear stays as it is
        const Rgba c = rgba_of(color);
        const std::array<std::uint8_t, 4> bytes{c.r, c.g, c.b, c.a};
        std::copy(bytes.begin(), bytes.end(),
                  &change.after.rgba[4 * static_cast<std::size_t>(y * area.tile.width + x)]);
      }
    }
    if (change.after.rgba == change.before.rgba) return;
    change.after.image = image_of(change.after.rgba, area.tile, level.palette);
    edit.changes.emplace_back(std::move(change));
  });
}

}  // namespace

bool SpriteArea::contains(Cell pixel) const {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < width() && pixel.y < height();
}

bool SpriteArea::lies_in_sheet(const Level& level) const {
  const SheetLayout layout = level.sheet(sheet).layout();
  return tiles.w >= 1 && tiles.h >= 1 && layout.contains({tiles.x, tiles.y}) &&
         layout.contains({tiles.x + tiles.w - 1, tiles.y + tiles.h - 1});
}

SpriteArea cut_to_sheet(const Level& level, SpriteArea area) {
  const SheetLayout layout = level.sheet(area.sheet).layout();
  const auto part = shared(area.tiles, {0, 0, layout.columns, layout.rows()});
  area.tiles = part.value_or(CellRect{});
  const bool reaches_over_last = !area.lies_in_sheet(level);  // the last row may be shorter
  if (reaches_over_last && area.tiles.h > 1) --area.tiles.h;
  if (!area.lies_in_sheet(level)) area.tiles = {};
  area.tile = painted_size(level, area.sheet);
  return area;
}

bool is_in_rgba(const Level& level, SheetId sheet) { return level.sheet(sheet).picture != nullptr; }

TileSize painted_size(const Level& level, SheetId sheet) {
  return is_in_rgba(level, sheet) ? level.map.tile_size() : TileSize{kCartTileSize, kCartTileSize};
}

PixelColor pixel_at(const Level& level, const SpriteArea& area, int x, int y) {
  assert(area.lies_in_sheet(level) && area.contains({x, y}) && area.tile == painted_size(level, area.sheet));
  if (!is_in_rgba(level, area.sheet)) return pixel_of(level, area, {x, y}).before;
  const std::uint8_t* const pixel =
      level.sheet(area.sheet)
          .picture->at(area.tiles.x * area.tile.width + x, area.tiles.y * area.tile.height + y);
  return pixel_color({pixel[0], pixel[1], pixel[2], pixel[3]});
}

PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect) {
  PixelBlock block{rect.w, rect.h, {}, is_in_rgba(level, area.sheet)};
  block.colors.reserve(static_cast<std::size_t>(rect.w) * rect.h);
  for (int y = rect.y; y < rect.y + rect.h; ++y)
    for (int x = rect.x; x < rect.x + rect.w; ++x) block.colors.push_back(pixel_at(level, area, x, y));
  return block;
}

Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label) {
  assert(area.lies_in_sheet(level) && block.in_rgba == is_in_rgba(level, area.sheet));
  Edit edit{std::move(label), {}};
  const auto painted = shared(area.canvas(), {at.x, at.y, block.w, block.h});
  if (!painted) return edit;
  if (block.in_rgba)
    put_rgba(level, area, block, at, *painted, edit);
  else
    put_indices(level, area, block, at, *painted, edit);
  return edit;
}

PixelBlock in_colors_of(const Level& level, SheetId sheet, const PixelBlock& block) {
  const bool wanted = is_in_rgba(level, sheet);
  if (wanted == block.in_rgba) return block;
  PixelBlock other{block.w, block.h, {}, wanted};
  other.colors.reserve(block.colors.size());
  for (const PixelColor color : block.colors) {
    if (wanted) {
      const Rgb rgb = level.palette[static_cast<std::size_t>(color)];
      other.colors.push_back(color == 0 ? 0 : pixel_color({rgb.r, rgb.g, rgb.b, kOpaque}));
    } else {
      const Rgba c = rgba_of(color);
      other.colors.push_back(c.a < kHalfOpaque ? 0 : nearest_color({c.r, c.g, c.b}, level.palette));
    }
  }
  return other;
}

void for_each_painted(const Level& level, const SpriteArea& area, const Edit& edit,
                      FunctionRef<void(Cell, PixelColor)> use) {
  const SheetLayout layout = level.sheet(area.sheet).layout();
  const auto corner_of = [&](int tile) {
    const Cell place = layout.place_of(tile);
    return Cell{(place.x - area.tiles.x) * area.tile.width, (place.y - area.tiles.y) * area.tile.height};
  };
  for (const Change& change : edit.changes) {
    if (const auto* pixel = std::get_if<PixelChange>(&change)) {
      const Cell corner = corner_of(pixel->tile);
      use({corner.x + pixel->pixel % kCartTileSize, corner.y + pixel->pixel / kCartTileSize}, pixel->after);
    } else if (const auto* look = std::get_if<TileLookChange>(&change)) {
      const Cell corner = corner_of(look->tile);
      for (int y = 0; y < area.tile.height; ++y) {
        for (int x = 0; x < area.tile.width; ++x) {
          const PixelColor after = color_in(look->after, area.tile, x, y);
          if (after != color_in(look->before, area.tile, x, y)) use({corner.x + x, corner.y + y}, after);
        }
      }
    }
  }
}

}  // namespace talus
