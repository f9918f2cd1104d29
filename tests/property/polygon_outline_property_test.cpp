// Properties of the outline of polygons and groups: it bounds exactly what is inside of any of them, and has
// no pieces within the ground.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "collision/ground_queries.h"
#include "random_polygons.h"

namespace talus::polygon_outline_property_test {

constexpr int kPlaces = 60;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_ground(const RandomGround& ground, double x, double y) {
  for (int row = 0; row < ground.height; ++row) {
    for (int column = 0; column < ground.width; ++column) {
      const TileShape& shape =
          ground.shapes[ground.cells[static_cast<std::size_t>(row) * ground.width + column]];
      if (is_inside(shape, ground.tile, x - column * ground.tile.width, y - row * ground.tile.height))
        return true;
    }
  }
  return false;
}

// Calls use(piece) for each piece of the cell, and for each open side of a full tile.
template <class Use>
void for_pieces(const Terrain& terrain, Cell c, Use use) {
  if (terrain.is_detailed(c)) {
    for (const Piece<double>& piece : terrain.pieces_in(c)) use(piece);
    return;
  }
  if (!terrain.is_solid(c)) return;
  const double x0 = terrain.x_of(c.x), x1 = terrain.x_of(c.x + 1), y0 = terrain.y_of(c.y),
               y1 = terrain.y_of(c.y + 1);
  const auto side = [&](Cell beside, Facing facing, Vec2 a, Vec2 b) {
    if (!terrain.is_solid(beside))
      use(Piece<double>{
          .x0 = a.x, .y0 = a.y, .x1 = b.x, .y1 = b.y, .base_x = a.x, .base_y = a.y, .facing = facing});
  };
  side({c.x, c.y - 1}, Facing::up, {x0, y0}, {x1, y0});
  side({c.x, c.y + 1}, Facing::down, {x0, y1}, {x1, y1});
  side({c.x - 1, c.y}, Facing::left, {x0, y0}, {x0, y1});
  side({c.x + 1, c.y}, Facing::right, {x1, y0}, {x1, y1});
}

// Whether a place is within the ground with all around it. Where lines cross, a piece may reach 1/256 px into
// the ground, as its end is rounded.
bool is_within(const RandomGround& ground, double x, double y, double aside_x, double aside_y) {
  return is_ground(ground, x - aside_x, y - aside_y) && is_ground(ground, x + aside_x, y + aside_y);
}

constexpr double kAside = 1e-7;  // px, times the slope of a line

bool is_within(const RandomGround& ground, const Piece<double>& piece, double x) {
  return is_within(ground, x, piece.y_at(x, {}), 0, kAside * (1 + std::abs(piece.slope)));
}

// What the outline says of a place: the first piece below it is a ceiling inside of the ground, a floor
// outside.
bool is_above_a_ceiling(const RandomGround& ground, const Terrain& terrain, double x, double y) {
  const int column = static_cast<int>(x / terrain.tile_size().width);
  double nearest = kInfinity;
  bool inside = false;
  for (int row = 0; row < terrain.height(); ++row) {
    for_pieces(terrain, {column, row}, [&](const Piece<double>& piece) {
      if (piece.is_wall() || piece.one_way || !(piece.x0 <= x && x <= piece.x1)) return;
      const double at = piece.y_at(x, {});
      if (at < terrain.y_of(row) || at > terrain.y_of(row + 1) || at <= y || at >= nearest) return;
      if (is_within(ground, piece, x)) return;
      nearest = at;
      inside = piece.facing == Facing::down;
    });
  }
  return inside;
}

// The same to the right, with walls.
bool is_left_of_a_right_side(const RandomGround& ground, const Terrain& terrain, double x, double y) {
  const int row = static_cast<int>(y / terrain.tile_size().height);
  double nearest = kInfinity;
  bool inside = false;
  const auto offer = [&](double at, bool right) {
    if (at > x && at < nearest && !is_within(ground, at, y, kAside, 0)) nearest = at, inside = right;
  };
  for (int column = 0; column < terrain.width(); ++column) {
    for_pieces(terrain, {column, row}, [&](const Piece<double>& piece) {
      if (piece.one_way || !(std::min(piece.y0, piece.y1) <= y && y <= std::max(piece.y0, piece.y1))) return;
      if (piece.is_wall()) return offer(piece.x0, piece.facing == Facing::right);
      if (piece.y0 == piece.y1) return;
      offer(piece.x0 + (piece.x1 - piece.x0) * (y - piece.y0) / (piece.y1 - piece.y0),
            (piece.facing == Facing::up) != piece.rises_to_the_right());
    });
  }
  return inside;
}

RandomGround polygons(Dice& dice, bool one_way) {
  return random_ground(dice, 3 + dice.up_to(4), 3 + dice.up_to(4), {.one_way = one_way, .polygons = true});
}

RC_GTEST_PROP(PolygonOutline, BoundsTheUnionOfAllShapes, (std::uint64_t seed)) {
  Dice dice(seed);
  for (int grounds = 0; grounds < 4; ++grounds) {
    const RandomGround ground = polygons(dice, dice.one_in(2));
    const Terrain terrain = ground.compile();
    for (int i = 0; i < kPlaces; ++i) {
      const double x = dice.in(0, ground.right()), y = dice.in(0, ground.bottom());
      const bool expected = is_ground(ground, x, y);
      if (is_above_a_ceiling(ground, terrain, x, y) != expected ||
          is_left_of_a_right_side(ground, terrain, x, y) != expected)
        RC_LOG() << "at " << x << ", " << y << (expected ? " is ground" : " is no ground");
      RC_ASSERT(is_above_a_ceiling(ground, terrain, x, y) == expected);
      RC_ASSERT(is_left_of_a_right_side(ground, terrain, x, y) == expected);
    }
  }
}

RC_GTEST_PROP(PolygonOutline, HasNoPiecesWithinTheGround, (std::uint64_t seed)) {
  Dice dice(seed);
  const RandomGround ground = polygons(dice, dice.one_in(2));
  const Terrain terrain = ground.compile();
  constexpr double kStep = 2.0 / 256;
  const auto runs_within = [&](const Piece<double>& piece, double x, double step) {
    for (int i = 1; i <= 16; ++i) {
      const double beside = x + step * i / 16, y = piece.y_at(beside, {});
      if (beside <= piece.x0 || beside >= piece.x1 || !is_within(ground, piece, beside)) return false;
      if (static_cast<int>(y / ground.tile.height) !=
          static_cast<int>(piece.y_at(x, {}) / ground.tile.height))
        return false;
    }
    return true;
  };
  for (Cell c; c.y < ground.height; ++c.y) {
    for (c.x = 0; c.x < ground.width; ++c.x) {
      for_pieces(terrain, c, [&](const Piece<double>& piece) {
        const auto is_here = [&](double x) {
          const double y = piece.y_at(x, {});
          return piece.x0 < x && x < piece.x1 && y > terrain.y_of(c.y) && y < terrain.y_of(c.y + 1);
        };
        for (int i = 0; i < 5; ++i) {
          const double share = dice.in(0.01, 0.99);
          if (piece.is_wall()) {
            const double y = piece.y0 + (piece.y1 - piece.y0) * share;
            RC_ASSERT(piece.y0 == piece.y1 ||
                      is_ground(ground, piece.x0 - kAside, y) != is_ground(ground, piece.x0 + kAside, y));
            continue;
          }
          const double x = piece.x0 + (piece.x1 - piece.x0) * share;
          if (!is_here(x) || !is_within(ground, piece, x)) continue;
          for (const double step : {-kStep, kStep}) {
            const bool is_long = runs_within(piece, x, step);
            if (is_long) RC_LOG() << "a piece at " << x << " in cell " << c.x << ", " << c.y;
            RC_ASSERT(!is_long);
          }
        }
      });
    }
  }
}

// A box on a steep line may count as outside by 1/256 px.
RC_GTEST_PROP(PolygonOutline, BoxesOverlapWhatTheyAreIn, (std::uint64_t seed)) {
  Dice dice(seed);
  const RandomGround ground = polygons(dice, dice.one_in(2));
  const Terrain terrain = ground.compile();
  const reference::ExactGround exact = ground.exact();
  for (int i = 0; i < kPlaces; ++i) {
    const double side = dice.one_in(2) ? 8 : 1;
    const Rect box{dice.in(0, ground.right()), dice.in(0, ground.bottom()), dice.in(0.1, side),
                   dice.in(0.1, side)};
    const reference::ExactBox same{box.x, box.y, box.w, box.h};
    const bool overlaps = overlaps_ground(terrain, box);
    RC_ASSERT(!overlaps || exact.meets(same));
    RC_ASSERT(overlaps || exact.depth(same) <= 2.0 / 256);
  }
}

}  // namespace talus::polygon_outline_property_test
