// Finds the tiles of a sheet that are ground.
#include <algorithm>
#include <cmath>
#include <vector>

#include "auto_tile.h"
#include "collision/tile_outlines.h"
#include "level/tile_color.h"
#include "tile_shapes.h"

namespace talus {
namespace {

constexpr int kMiddle = 2;  // px from the sides, where the middle of a tile begins
// Of 8; so many pixels of a colour that the middle does not have make a side an edge.
constexpr int kEdgePixels = 6;
// Of 64 pixels; an edge with fewer pixels like the inside's belongs to another ground.
constexpr int kLikeInside = 20;
constexpr double kSameHeight = 0.5;  // px

// Colours as bits, one for each colour of the palette.
using ColorSet = std::uint16_t;

ColorSet middle_colors(const TileImage& image) {
  unsigned colors = 0;
  for (int y = kMiddle; y < kCartTileSize - kMiddle; ++y)
    for (int x = kMiddle; x < kCartTileSize - kMiddle; ++x) colors |= 1u << image[y * kCartTileSize + x];
  return static_cast<ColorSet>(colors);
}

struct Edges {
  bool top, left, right, bottom;
  friend bool operator==(const Edges&, const Edges&) = default;
};

Edges edges_of(const TileImage& image) {
  const ColorSet middle = middle_colors(image);
  const auto is_edge = [&](int first, int step) {
    int others = 0;
    for (int i = 0; i < kCartTileSize; ++i)
      others += (middle >> image[static_cast<std::size_t>(first + i * step)] & 1) == 0 ? 1 : 0;
    return others >= kEdgePixels;
  };
  constexpr int kLast = kCartTileSize - 1;
  return {is_edge(0, 1), is_edge(0, kCartTileSize), is_edge(kLast, kCartTileSize),
          is_edge(kLast * kCartTileSize, 1)};
}

struct EdgedPart {
  GroundPart part;
  Edges edges;
};
constexpr EdgedPart kEdgedParts[] = {{GroundPart::top, {true, false, false, false}},
                                     {GroundPart::left, {false, true, false, false}},
                                     {GroundPart::right, {false, false, true, false}},
                                     {GroundPart::bottom, {false, false, false, true}},
                                     {GroundPart::top_left, {true, true, false, false}},
                                     {GroundPart::top_right, {true, false, true, false}},
                                     {GroundPart::bottom_left, {false, true, false, true}},
                                     {GroundPart::bottom_right, {false, false, true, true}}};

// Makes a tile without a shape solid, once.
void solidify(const Level& level, TileNumber tile, std::vector<bool>& is_done, Edit& edit) {
  if (tile == 0 || is_done[tile] || shape_of_tile(level, tile).kind != TileShape::Kind::none) return;
  is_done[tile] = true;
  edit.changes.emplace_back(TileShapeChange{tile, level.tile_shapes[tile], {.kind = TileShape::Kind::solid}});
}

// A floor between two heights, as wide as `tiles`.
bool is_slope(const TileShape& shape, int tiles, double from, double to) {
  return shape.kind == TileShape::Kind::slope && shape.side == TileShape::Side::floor && !shape.one_way &&
         shape.tiles == tiles && std::abs(shape.heights[0] - from) < kSameHeight &&
         std::abs(shape.heights[1] - to) < kSameHeight;
}

class Proposal {
 public:
  Proposal(const Level& level, std::span<const TileNumber> among) : level_(level) {
    std::copy_if(among.begin(), among.end(), std::back_inserter(tiles_), [](int tile) { return tile != 0; });
    const auto has_shape = [&](TileNumber tile) { return is_full(shape_of_tile(level, tile)); };
    takes_opaque_ = level.sheet(SheetId::tiles).picture != nullptr &&
                    std::none_of(tiles_.begin(), tiles_.end(), has_shape);
  }

  AutoTiles make() {
    choose_full_tiles();
    if (set_.of(GroundPart::inside) == 0) return {};
    const int high = level_.map.tile_size().height;
    choose_slope(GroundPart::slope_up, 0, high);
    choose_slope(GroundPart::slope_down, high, 0);
    choose_halves(GroundPart::slope_up_left, GroundPart::slope_up_right, 0, high);
    choose_halves(GroundPart::slope_down_left, GroundPart::slope_down_right, high, 0);
    return set_;
  }

 private:
  const TileImage& image(TileNumber tile) const { return level_.sheet(SheetId::tiles).images[tile]; }

  // The first tile that satisfies the condition and looks most like the inside; 0 if there is none.
  template <class Holds>
  TileNumber best(Holds holds) const {
    TileNumber found = 0;
    for (const TileNumber tile : tiles_)
      if (holds(tile) && (found == 0 || likeness(tile) > likeness(found))) found = tile;
    return found;
  }

  // The number of pixels of a tile whose colours the inside mostly has.
  int likeness(TileNumber tile) const {
    const TileNumber inside = set_.of(GroundPart::inside);
    if (inside == 0) return 0;
    return static_cast<int>(std::count(image(tile).begin(), image(tile).end(), main_color(image(inside))));
  }

  void choose_full_tiles() {
    const auto solid = [&](TileNumber tile) {
      const TileShape shape = shape_of_tile(level_, tile);
      if (shape.kind != TileShape::Kind::none) return is_full(shape);
      return takes_opaque_ && level_.tile_flags(tile) == 0 &&
             suggest_shape(level_, tile) == TileShape{.kind = TileShape::Kind::solid};
    };
    TileNumber& inside = set_.of(GroundPart::inside);
    inside = best([&](TileNumber tile) { return solid(tile) && edges_of(image(tile)) == Edges{}; });
    if (inside == 0) inside = best(solid);
    for (const EdgedPart& edged : kEdgedParts)
      set_.of(edged.part) = best([&](TileNumber tile) {
        return solid(tile) && edges_of(image(tile)) == edged.edges && likeness(tile) >= kLikeInside;
      });
  }

  void choose_slope(GroundPart part, double from, double to) {
    set_.of(part) = best([&](TileNumber tile) { return is_slope(shape_of_tile(level_, tile), 1, from, to); });
  }

  // Either each half has a shape of its own, or the left one has that of both, and its neighbour on the sheet
  // is only a picture, as in the article.
  void choose_halves(GroundPart left, GroundPart right, double from, double to) {
    const double middle = (from + to) / 2;
    set_.of(left) = best([&](TileNumber tile) {
      const SheetLayout sheet = level_.sheet(SheetId::tiles).layout();
      const Cell place = sheet.place_of(tile);
      return sheet.contains({place.x + 1, place.y}) && is_slope(shape_of_tile(level_, tile), 2, from, to);
    });
    if (set_.of(left) != 0) {
      set_.of(right) = static_cast<TileNumber>(set_.of(left) + 1);
      return;
    }
    const auto half = [&](double a, double b) {
      return best([&](TileNumber tile) { return is_slope(shape_of_tile(level_, tile), 1, a, b); });
    };
    set_.of(left) = half(from, middle);
    set_.of(right) = half(middle, to);
    if (set_.of(left) == 0 || set_.of(right) == 0) set_.of(left) = set_.of(right) = 0;
  }

  const Level& level_;
  std::vector<TileNumber> tiles_;
  bool takes_opaque_ = false;  // no tile is solid yet, and the pictures tell which are opaque
  AutoTiles set_;
};

}  // namespace

Edit propose_auto_tiles(const Level& level, std::span<const TileNumber> among) {
  const AutoTiles set = proposed_auto_tiles(level, among);
  Edit edit = set_auto_tiles(level, set);
  if (set.empty()) return edit;
  std::vector<bool> is_done(static_cast<std::size_t>(level.tile_count()));
  for (const EdgedPart& edged : kEdgedParts) solidify(level, set.of(edged.part), is_done, edit);
  solidify(level, set.of(GroundPart::inside), is_done, edit);
  return edit;
}

AutoTiles proposed_auto_tiles(const Level& level, std::span<const TileNumber> among) {
  return Proposal(level, among).make();
}

}  // namespace talus
