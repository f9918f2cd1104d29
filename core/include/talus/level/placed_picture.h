// Where pictures are drawn on the map, and in which order its layers are.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <talus/level/level.h>

namespace talus {

// A part of a picture as a parallelogram on the map.
struct PlacedPicture {
  PicturePart part;  // has a picture
  Vec2 corner;       // px of the map, where the top left corner of the part is
  Vec2 right;        // px of the map, along the upper side of the part, from left to right
  Vec2 down;         // px of the map, along its left side, from top to bottom
};

// Puts a part into a box, as Tiled does. part: with a picture; corner: px, the top left of the box; size: px.
PlacedPicture placed(const PicturePart& part, Vec2 corner, Vec2 size);
// In a cell of a map with tiles of that size. turn: that of the cell, besides that of the tile's part.
PlacedPicture placed(const LargeTile& tile, Cell cell, TileSize size, TileTurn turn = TileTurn::none);
// The picture of an object, without the offset of its layer. object: its picture has one.
PlacedPicture placed(const MapObject& object);
// Gives an object the place at which its picture fills its box, with its position at the bottom left, so that
// it is drawn as before without the part's shift, turn and ratio and without the anchor. object: its picture
// has one. plain: a copy of it.
void put_upright(const MapObject& object, MapObject& plain);
// px of the map, where the top left corner of an object's box is.
Vec2 top_left_of(const MapObject& object);
// The least box around it, px of the map.
Rect bounds_of(const PlacedPicture& shown);

// The objects of a layer that have a picture and are drawn, from the back to the front; as indices.
std::vector<std::size_t> drawn_pictures(const ObjectLayer& layer);

// A layer of tiles, or another one.
struct LayerInOrder {
  bool has_tiles = true;  // whether it is one of Level::layers; else one of Level::objects
  int index = 0;          // of the layer, in that list
  friend bool operator==(const LayerInOrder&, const LayerInOrder&) = default;
};
// All layers of a level, from the back to the front.
std::vector<LayerInOrder> layers_in_order(const Level& level);
// The same of so many layers of tiles, at least 1, and others.
std::vector<LayerInOrder> layers_in_order(int tile_layers, const std::vector<ObjectLayer>& others);

// The words for orders of drawing in files, by their values.
inline constexpr std::array<std::string_view, 4> kRenderOrders = {"right-down", "right-up", "left-down",
                                                                  "left-up"};
// The word for an order.
constexpr std::string_view word_of(RenderOrder order) {
  return kRenderOrders[static_cast<std::size_t>(order)];
}

// The tiles of a map's rows and columns in the order in which they are drawn.
struct CellOrder {
  bool is_leftwards = false;  // whether each row goes from right to left
  bool is_upwards = false;    // whether rows go from bottom to top
  // The order in which layers of a level are drawn.
  explicit CellOrder(RenderOrder order)
      : is_leftwards(order == RenderOrder::left_down || order == RenderOrder::left_up),
        is_upwards(order == RenderOrder::right_up || order == RenderOrder::left_up) {}
  // The column that is the `number`th, from 0, of those from `from` to before `to`.
  int column(int number, int from, int to) const { return is_leftwards ? to - 1 - number : from + number; }
  // The row, as above.
  int row(int number, int from, int to) const { return is_upwards ? to - 1 - number : from + number; }
};

// How far the pictures of large tiles reach beyond their cells, turned or not, in cells to each side.
struct CellReach {
  int left = 0;   // cells, at least 0; so are the others
  int right = 0;  // cells
  int up = 0;     // cells
  int down = 0;   // cells
};
// How far those of these tiles reach. size: that of a cell, px.
CellReach reach_of(const LargeTiles& tiles, TileSize size);

}  // namespace talus
