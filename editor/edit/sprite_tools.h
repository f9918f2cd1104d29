// Tools of the sprite canvas, the flags and the palette. Each makes an Edit and changes nothing itself.
#pragma once

#include "edit.h"
#include "pixel_block.h"

namespace talus {

// A square of images on a sheet, seen as one canvas of pixels: 1, 2, 4 or 8 tiles wide and high.
struct SpriteArea {
  SheetId sheet = SheetId::tiles;
  CellRect tiles;  // in tiles of the sheet (16x16); must lie inside it (asserted)
  int width() const { return tiles.w * kTileSize; }                                        // px
  int height() const { return tiles.h * kTileSize; }                                       // px
  int tile_at(int x, int y) const { return (tiles.y + y) * kSheetColumns + tiles.x + x; }  // by tile
  friend bool operator==(const SpriteArea&, const SpriteArea&) = default;
};

std::uint8_t pixel_at(const Level& level, const SpriteArea& area, int x, int y);

// A rectangle of px of the canvas, inside it (asserted), as a block, and a block put there with its top left
// corner at `at`; what lies outside the canvas is left out.
PixelBlock copy_pixels(const Level& level, const SpriteArea& area, CellRect rect);
Edit put_pixels(const Level& level, const SpriteArea& area, const PixelBlock& block, Cell at,
                std::string label);

// The 4-connected area of one colour around a pixel.
Edit fill_pixels(const Level& level, const SpriteArea& area, Cell at, std::uint8_t color);
Edit replace_color(const Level& level, const SpriteArea& area, std::uint8_t from, std::uint8_t to);
// To rotate, the area must be square (asserted).
Edit turn_pixels(const Level& level, const SpriteArea& area, PixelTurn turn);
// Fills the area with a colour and clears its flags, as TIC-80 does when it erases a whole sprite.
Edit clear_area(const Level& level, const SpriteArea& area, std::uint8_t color);
// Fills a rectangle of px of the canvas; what lies outside is left out.
Edit clear_pixels(const Level& level, const SpriteArea& area, CellRect rect, std::uint8_t color);

// Whether a flag is set in none, some or all of the area's tiles.
enum class FlagLamp { none, some, all };
FlagLamp flag_lamp(const Level& level, const SpriteArea& area, int flag);
Edit set_flag(const Level& level, const SpriteArea& area, int flag, bool on);
// The flags of each tile of the area, row by row.
Edit set_flags(const Level& level, const SpriteArea& area, const std::vector<std::uint8_t>& flags);
// TIC-80's click: clears the flag if any tile has it, else sets it in all.
Edit toggle_flag(const Level& level, const SpriteArea& area, int flag);

Edit set_color(const Level& level, int color, Rgb rgb);
Edit rename_flag(const Level& level, int flag, std::string name);
Edit set_roles(const Level& level, const FlagRoles& roles);
Edit set_tuning(const Level& level, const Tuning& tuning);
Edit set_spawns(const Level& level, std::vector<Spawn> spawns, std::string label);

}  // namespace talus
