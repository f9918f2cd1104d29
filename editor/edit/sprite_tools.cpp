// The tools of the sprite canvas, the flags and the palette.
#include "sprite_tools.h"

#include <cassert>
#include <utility>

#include "raster.h"
#include "single_change.h"

namespace talus {
namespace {

[[maybe_unused]] bool lies_in_sheet(const SpriteArea& area) {
  const CellRect& t = area.tiles;
  constexpr int kRows = kTileCount / kSheetColumns;
  return t.x >= 0 && t.y >= 0 && t.w >= 1 && t.h >= 1 && t.x + t.w <= kSheetColumns && t.y + t.h <= kRows;
}

bool lies_in_area(const SpriteArea& area, Cell pixel) {
  return pixel.x >= 0 && pixel.y >= 0 && pixel.x < area.width() && pixel.y < area.height();
}

// A change of one pixel of the area to nothing yet: before == after.
PixelChange pixel_of(const Level& level, const SpriteArea& area, Cell pixel) {
  assert(lies_in_sheet(area) && lies_in_area(area, pixel));
  const int tile = area.tile_at(pixel.x / kTileSize, pixel.y / kTileSize);
  const int index = pixel.y % kTileSize * kTileSize + pixel.x % kTileSize;
  const std::uint8_t color = level.sheet(area.sheet).images[tile][index];
  return {area.sheet, tile, index, color, color};
}

void paint_pixel(Edit& edit, const Level& level, const SpriteArea& area, Cell pixel, std::uint8_t color) {
  assert(color < kColorCount);
  PixelChange change = pixel_of(level, area, pixel);
  change.after = color;
  if (change.before != change.after) edit.changes.emplace_back(change);
}

// Gives each pixel of the area the colour that `color_at` says.
template <class ColorAt>
Edit redraw(const Level& level, const SpriteArea& area, std::string label, ColorAt color_at) {
  Edit edit{std::move(label), {}};
  for (int y = 0; y < area.height(); ++y) {
    for (int x = 0; x < area.width(); ++x) paint_pixel(edit, level, area, {x, y}, color_at(x, y));
  }
  return edit;
}

// Gives each tile of the area the flags that `flags_after` makes of its own.
template <class FlagsAfter>
void change_flags(Edit& edit, const Level& level, const SpriteArea& area, FlagsAfter flags_after) {
  assert(lies_in_sheet(area));
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x) {
      const int tile = area.tile_at(x, y);
      const std::uint8_t before = level.sheet(area.sheet).flags[tile];
      const auto after = static_cast<std::uint8_t>(flags_after(before));
      if (before != after) edit.changes.emplace_back(FlagsChange{area.sheet, tile, before, after});
    }
  }
}

}  // namespace

std::uint8_t pixel_at(const Level& level, const SpriteArea& area, int x, int y) {
  return pixel_of(level, area, {x, y}).before;
}

PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect) {
  PixelBlock block{rect.w, rect.h, {}};
  block.colors.reserve(static_cast<std::size_t>(rect.w) * rect.h);
  for (int y = rect.y; y < rect.y + rect.h; ++y)
    for (int x = rect.x; x < rect.x + rect.w; ++x) block.colors.push_back(pixel_at(level, area, x, y));
  return block;
}

Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label) {
  Edit edit{std::move(label), {}};
  for (int y = 0; y < block.h; ++y) {
    for (int x = 0; x < block.w; ++x) {
      const Cell pixel{at.x + x, at.y + y};
      if (lies_in_area(area, pixel)) paint_pixel(edit, level, area, pixel, block.at(x, y));
    }
  }
  return edit;
}

Edit fill_pixels(const Level& level, const SpriteArea& area, Cell at, std::uint8_t color) {
  Edit edit{"Fill pixels", {}};
  if (!lies_in_area(area, at)) return edit;
  const auto same = [&, old = pixel_at(level, area, at.x, at.y)](Cell c) {
    return pixel_at(level, area, c.x, c.y) == old;
  };
  for (const Span& span : flood_area(area.width(), area.height(), at, same)) {
    for (int x = span.first; x <= span.last; ++x) paint_pixel(edit, level, area, {x, span.y}, color);
  }
  return edit;
}

Edit replace_color(const Level& level, const SpriteArea& area, std::uint8_t from, std::uint8_t to) {
  return redraw(level, area, "Replace colour", [&](int x, int y) {
    const std::uint8_t color = pixel_at(level, area, x, y);
    return color == from ? to : color;
  });
}

Edit turn_pixels(const Level& level, const SpriteArea& area, PixelTurn turn) {
  assert(turn != PixelTurn::rotate || area.tiles.w == area.tiles.h);
  const PixelBlock canvas = copy_pixels(level, area, {0, 0, area.width(), area.height()});
  return put_pixels(level, area, turned(canvas, turn), {0, 0}, label_of(turn));
}

Edit clear_area(const Level& level, const SpriteArea& area, std::uint8_t color) {
  Edit edit = redraw(level, area, "Clear", [&](int, int) { return color; });
  change_flags(edit, level, area, [](std::uint8_t) { return 0; });
  return edit;
}

Edit clear_pixels(const Level& level, const SpriteArea& area, CellRect rect, std::uint8_t color) {
  const PixelBlock block{rect.w, rect.h,
                         std::vector<std::uint8_t>(static_cast<std::size_t>(rect.w) * rect.h, color)};
  return put_pixels(level, area, block, {rect.x, rect.y}, "Clear");
}

FlagLamp flag_lamp(const Level& level, const SpriteArea& area, int flag) {
  assert(lies_in_sheet(area) && flag >= 0 && flag < kFlagCount);
  int set = 0;
  for (int y = 0; y < area.tiles.h; ++y) {
    for (int x = 0; x < area.tiles.w; ++x)
      set += level.sheet(area.sheet).flags[area.tile_at(x, y)] >> flag & 1;
  }
  if (set == 0) return FlagLamp::none;
  return set == area.tiles.w * area.tiles.h ? FlagLamp::all : FlagLamp::some;
}

Edit set_flag(const Level& level, const SpriteArea& area, int flag, bool on) {
  assert(flag >= 0 && flag < kFlagCount);
  const int bit = 1 << flag;
  Edit edit{(on ? "Set flag " : "Clear flag ") + std::to_string(flag), {}};
  change_flags(edit, level, area, [&](std::uint8_t flags) { return on ? flags | bit : flags & ~bit; });
  return edit;
}

Edit set_flags(const Level& level, const SpriteArea& area, const std::vector<std::uint8_t>& flags) {
  assert(flags.size() == static_cast<std::size_t>(area.tiles.w) * area.tiles.h);
  Edit edit{"Set flags", {}};
  auto next = flags.begin();
  change_flags(edit, level, area, [&](std::uint8_t) { return *next++; });
  return edit;
}

Edit toggle_flag(const Level& level, const SpriteArea& area, int flag) {
  return set_flag(level, area, flag, flag_lamp(level, area, flag) == FlagLamp::none);
}

Edit set_color(const Level& level, int color, Rgb rgb) {
  assert(color >= 0 && color < kColorCount);
  return single_change("Change colour " + std::to_string(color),
                       ColorChange{color, level.palette[color], rgb});
}

Edit rename_flag(const Level& level, int flag, std::string name) {
  assert(flag >= 0 && flag < kFlagCount);
  return single_change("Rename flag " + std::to_string(flag),
                       FlagNameChange{flag, level.flag_names[flag], std::move(name)});
}

Edit set_roles(const Level& level, const FlagRoles& roles) {
  return single_change("Change flag roles", RolesChange{level.roles, roles});
}

Edit set_tuning(const Level& level, const Tuning& tuning) {
  return single_change("Change tuning", TuningChange{level.tuning, tuning});
}

Edit set_spawns(const Level& level, std::vector<Spawn> spawns, std::string label) {
  return single_change(std::move(label), SpawnsChange{level.spawns, std::move(spawns)});
}

}  // namespace talus
