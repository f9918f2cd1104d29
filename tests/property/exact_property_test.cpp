// Properties of casting boxes against random ground. A reference that shares no code with the core judges
// them: no contact is missed, none is invented, and times and places are exact within bounds that are stated
// where they are checked. TALUS_PROPERTY_MOVES: the number of moves for each property, at least kMoves.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include <talus/collision/cast.h>
#include "collision/cast_rounding.h"
#include "random_ground.h"
#include "tries.h"

namespace talus::exact_property_test {

using reference::Exact;
using reference::ExactBox;
using reference::ExactGround;
using reference::ExactHit;
using reference::Wide;
using reference::WideBox;
using reference::WideCurve;

constexpr double kMoves = 2000;
constexpr int kSeeds = 100;          // tries of rapidcheck for each property
constexpr int kMovesOnAGround = 20;  // then another ground is made
constexpr Wide kNever = 2;           // a time: not during the motion

int grounds_of_a_seed() {
  return static_cast<int>(tries("TALUS_PROPERTY_MOVES", kMoves) / (kSeeds * kMovesOnAGround));
}

// ---- Moves ----

struct Move {
  Rect box;
  Vec2 motion;
};

void showValue(const Move& m, std::ostream& out) {
  char text[200];
  std::snprintf(text, sizeof text, "box {%.17g, %.17g, %.17g, %.17g} motion {%.17g, %.17g}", m.box.x, m.box.y,
                m.box.w, m.box.h, m.motion.x, m.motion.y);
  out << text;
}

// The distance between neighbouring doubles at the largest coordinate of the move.
double ulp_of(const Move& m) {
  double most = 0;
  for (const double t : {0.0, 1.0}) {
    const double x = m.box.x + t * m.motion.x, y = m.box.y + t * m.motion.y;
    most = std::max({most, std::abs(x), std::abs(x + m.box.w), std::abs(y), std::abs(y + m.box.h)});
  }
  return std::nextafter(most, std::numeric_limits<double>::infinity()) - most;
}

// Numbers on a grid of 1/parts hit sides and corners exactly. Other numbers hardly ever do.
Move random_move(Dice& dice, const RandomGround& ground, const ExactGround& exact, double parts) {
  const double width = ground.right(), height = ground.bottom();
  Move m;
  m.box.w = dice.one_in(3) ? 8 : dice.step(0.25, 20, parts);
  m.box.h = dice.one_in(3) ? 8 : dice.step(0.25, 20, parts);
  for (int tries = 0; tries < 10; ++tries) {  // mostly outside the ground
    m.box.x = dice.step(-8, width, parts);
    m.box.y = dice.step(-8, height, parts);
    if (!exact.meets({m.box.x, m.box.y, m.box.w, m.box.h})) break;
  }
  const double lengths[] = {4, 40, 40, 40, 40, 4096, 1e6, 40};
  const double length = lengths[dice.up_to(7)];
  m.motion = {dice.step(-length, length, parts), dice.step(-length, length, parts)};
  if (dice.one_in(6)) m.motion.x = 0;
  if (dice.one_in(6)) m.motion.y = 0;
  if (dice.one_in(6)) m.motion.y = dice.one_in(2) ? m.motion.x : -m.motion.x;
  if (dice.one_in(3)) {  // like a body at rest
    const auto floor = exact.floor_below(ExactBox{m.box.x, m.box.y, m.box.w, m.box.h});
    if (floor) m.box.y = floor->get_d() - m.box.h;
  }
  return m;
}

double random_grid(Dice& dice) { return std::array{4.0, 4.0, 256.0, 1e10}[dice.up_to(3)]; }

// ---- The truth ----

// The answer of the reference: the time of impact, and the times of slightly smaller and larger boxes. A cast
// is right if it is the answer for some box in between.
struct Truth {
  Wide t = kNever, smaller = kNever, larger = kNever;
  bool is_told = true;  // false if the last bit decides whether the box comes in from the open side
};

Truth truth_of(const ExactGround& ground, const Move& m, double by) {
  const ExactBox box{m.box.x, m.box.y, m.box.w, m.box.h};
  const Exact dx = m.motion.x, dy = m.motion.y, eps = by;
  const ExactHit hit = ground.cast(box, dx, dy, eps), smaller = ground.cast(box.grown(-eps), dx, dy),
                 larger = ground.cast(box.grown(eps), dx, dy, 3 * eps);
  return {reference::wide(hit.t), reference::wide(smaller.t), reference::wide(larger.t),
          !hit.passed_a_line && !smaller.passed_a_line && !larger.passed_a_line &&
              !ground.meets(box.grown(-eps))};
}

Truth truth_of(const std::vector<WideCurve>& curves, const Move& m, double by) {
  const WideBox box{m.box.x, m.box.y, m.box.w, m.box.h};
  const Wide dx = m.motion.x, dy = m.motion.y, eps = by;
  Truth truth;
  for (const WideCurve& curve : curves) {
    WideCurve both = curve;
    both.stops = WideCurve::Stops::everywhere;
    const auto larger = cast(curve, box.grown(eps), dx, dy, 3 * eps);
    truth.t = std::min(truth.t, cast(curve, box, dx, dy, eps).value_or(kNever));
    truth.smaller = std::min(truth.smaller, cast(curve, box.grown(-eps), dx, dy, 0).value_or(kNever));
    truth.larger = std::min(truth.larger, larger.value_or(kNever));
    truth.is_told = truth.is_told && !meets(curve, box.grown(-eps)) &&
                    cast(both, box.grown(eps), dx, dy, 3 * eps) == larger;
  }
  return truth;
}

// Curves have approximate heights, and the box may be off by that error too.
struct Scene {
  RandomGround ground;
  Terrain terrain;
  ExactGround exact;
  std::vector<WideCurve> curves;
  explicit Scene(RandomGround random)
      : ground(std::move(random)), terrain(ground.compile()), exact(ground.exact()), curves(ground.wide()) {}

  double allowance(const Move& m) const {
    return 1.25 * rounding_slack(Cast<double>{m.box, m.motion}) + (curves.empty() ? 0 : 1e-12);
  }
  Truth truth(const Move& m) const {
    const Truth a = truth_of(exact, m, allowance(m)), b = truth_of(curves, m, allowance(m));
    return {std::min(a.t, b.t), std::min(a.smaller, b.smaller), std::min(a.larger, b.larger),
            a.is_told && b.is_told};
  }
  Contact<double> cast(const Move& m) const { return cast_box(terrain, Cast<double>{m.box, m.motion}); }
  const Scene& mirrored() const {
    if (!mirrored_) mirrored_ = std::make_shared<const Scene>(ground.mirrored());
    return *mirrored_;
  }

 private:
  mutable std::shared_ptr<const Scene> mirrored_;  // made when it is asked for
};

// ---- What is wrong with a cast ----

// The length of the motion divided by its part against the surface: a rounding across the surface moves the
// contact by as many times its size along the motion.
double stretch_of(const Move& m, Vec2 normal) {
  return std::hypot(m.motion.x, m.motion.y) / std::abs(dot(m.motion, normal));
}
// The effect of a rounding of x and y on the y of the contact.
double steepness(const Contact<double>& hit) {
  constexpr double kMax = 1e9;  // the vertical end of an arc bends away before the effect is larger
  const bool wall = hit.facing == Facing::left || hit.facing == Facing::right;
  return wall || hit.on_end ? 1 : std::min(kMax, 1 + std::abs(hit.normal.x / hit.normal.y));
}

const char* wrong_time(const Contact<double>& hit, const Truth& truth) {
  constexpr Wide kRounding = 4e-16L;  // of t itself
  if (!hit) return truth.smaller < 1 ? "misses" : nullptr;
  if (truth.larger > 1) return "hits nothing";
  if (hit.t < truth.larger - kRounding) return "is early";
  return truth.smaller <= 1 && hit.t > truth.smaller + kRounding ? "is late" : nullptr;
}

// Judges the place. A contact with a line on the way may be one unit in the last place from where the exact
// time puts the box, however flatly the two cross, and half a unit more for the corner from which its y
// follows. A contact at the start, or with a curve, may be at most `bound` px off at right angles to the
// surface, and correspondingly more along it and along the motion.
const char* wrong_place(const Contact<double>& hit, const Truth& truth, const Move& m, double bound,
                        double allowance) {
  // A box that grazes a corner may hit or miss it. Where it goes after a miss is not judged here.
  const Wide band = (truth.smaller - truth.larger) * std::hypot(m.motion.x, m.motion.y);
  if (!hit || truth.t > 1 || band > 8 * allowance * stretch_of(m, hit.normal)) return nullptr;
  const Wide x = m.box.x + truth.t * m.motion.x, y = m.box.y + truth.t * m.motion.y;
  const auto off_x = static_cast<double>(std::abs(x - hit.position.x));
  const auto off_y = static_cast<double>(std::abs(y - hit.position.y));
  const bool crosses_a_line = hit.t > 0 && (hit.piece == nullptr || hit.piece->stretch == 0);
  const double most_x = crosses_a_line ? ulp_of(m) : bound * stretch_of(m, hit.normal);
  const double most_y = (crosses_a_line ? 1.5 * most_x : most_x) * steepness(hit);
  return off_x <= most_x && off_y <= most_y ? nullptr : "is in the wrong place";
}

// The box stands on the ground that it hit, so it may be in other ground by as much as its place is rounded.
const char* wrong_depth(const Contact<double>& hit, const ExactGround& ground, const Move& m, double slack) {
  const ExactBox box{m.box.x, m.box.y, m.box.w, m.box.h};
  const ExactBox end{hit ? Exact(hit.position.x) : Exact(box.x + m.motion.x),
                     hit ? Exact(hit.position.y) : Exact(box.y + m.motion.y), box.w, box.h};
  return ground.depth(end) <= (hit ? 3 * ulp_of(m) * steepness(hit) : slack) ? nullptr : "ends in the ground";
}

template <class Check>
void for_random_moves(std::uint64_t seed, GroundKinds kinds, bool exact_grid, Check check) {
  Dice dice(seed);
  for (int i = grounds_of_a_seed(); i > 0; --i) {
    const Scene scene(random_ground(dice, 4 + dice.up_to(8), 4 + dice.up_to(8), kinds));
    for (int k = 0; k < kMovesOnAGround; ++k) {
      const double parts = exact_grid ? 16 : random_grid(dice);
      const Move move = random_move(dice, scene.ground, scene.exact, parts);
      const Truth truth = scene.truth(move);
      if (truth.is_told) check(dice, scene, move, truth);
    }
  }
}

void expect_right(const Scene& scene, const Move& move, const Truth& truth, double bound) {
  const Contact<double> hit = scene.cast(move);
  const char* wrong = wrong_time(hit, truth);
  if (wrong == nullptr) wrong = wrong_place(hit, truth, move, bound, scene.allowance(move));
  if (wrong == nullptr) wrong = wrong_depth(hit, scene.exact, move, scene.allowance(move));
  if (wrong != nullptr) RC_LOG() << rc::toString(move) << " " << wrong;
  RC_ASSERT(std::string(wrong == nullptr ? "" : wrong).empty());
}

// ---- Properties ----

// A move that the reference cannot judge shows nothing, so most moves must be judged.
TEST(ExactProperty, MostMovesAreJudged) {
  const auto percent = [](GroundKinds kinds) {
    constexpr int kGrounds = 50;
    int judged = 0;
    for (std::uint64_t seed = 1; seed <= kGrounds; ++seed) {
      Dice dice(seed);
      const Scene scene(random_ground(dice, 4 + dice.up_to(8), 4 + dice.up_to(8), kinds));
      for (int k = 0; k < kMovesOnAGround; ++k)
        judged += scene.truth(random_move(dice, scene.ground, scene.exact, random_grid(dice))).is_told;
    }
    return judged * 100 / (kGrounds * kMovesOnAGround);
  };
  EXPECT_GE(percent({}), 90);
  EXPECT_GE(percent({.one_way = true, .segments = true}), 70);
  EXPECT_GE(percent({.polygons = true}), 80);
  EXPECT_GE(percent({.one_way = true, .polygons = true}), 70);
  EXPECT_GE(percent({.curves = true}), 70);
  EXPECT_GE(percent({.one_way = true, .segments = true, .curves = true}), 70);
}

// Straight ground: at most 3 units in the last place of the largest coordinate.
RC_GTEST_PROP(ExactProperty, CastsAgainstTilesAreRight, (std::uint64_t seed)) {
  for_random_moves(seed, {}, false, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_right(scene, move, truth, 3 * ulp_of(move));
  });
}

RC_GTEST_PROP(ExactProperty, CastsAgainstLinesAreRight, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .segments = true};
  for_random_moves(seed, kinds, false, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_right(scene, move, truth, 3 * ulp_of(move));
  });
}

RC_GTEST_PROP(ExactProperty, CastsAgainstPolygonsAreRight, (std::uint64_t seed)) {
  const GroundKinds kinds{.polygons = true};
  for_random_moves(seed, kinds, false, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_right(scene, move, truth, 3 * ulp_of(move));
  });
}

RC_GTEST_PROP(ExactProperty, CastsAgainstOneWayPolygonsAreRight, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .segments = true, .polygons = true};
  for_random_moves(seed, kinds, false, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_right(scene, move, truth, 3 * ulp_of(move));
  });
}

// Curves: 1e-12 px more.
RC_GTEST_PROP(ExactProperty, CastsAgainstCurvesAreRight, (std::uint64_t seed)) {
  const GroundKinds kinds{.curves = true};
  for_random_moves(seed, kinds, false, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_right(scene, move, truth, 3 * ulp_of(move) + 1e-12);
  });
}

// A move of this seed meets an arc just above the straight end of its steepest part.
TEST(ExactProperty, CastsBesideTheSteepEndOfAnArcAreRight) {
  const GroundKinds kinds{.curves = true};
  for_random_moves(507099, kinds, false, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    const char* wrong = wrong_time(scene.cast(move), truth);
    EXPECT_EQ(wrong, nullptr) << rc::toString(move) << " " << wrong;
  });
}

// What cast_box() relies on: straight down it does not look for what stops the middle of a box by itself.
RC_GTEST_PROP(ExactProperty, StraightDownTheMiddleAloneMeetsNothingSooner, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .segments = true, .curves = true, .polygons = true};
  Dice dice(seed);
  for (int i = grounds_of_a_seed(); i > 0; --i) {
    const Scene scene(random_ground(dice, 4 + dice.up_to(8), 4 + dice.up_to(8), kinds));
    for (int k = 0; k < kMovesOnAGround; ++k) {
      Move move = random_move(dice, scene.ground, scene.exact, random_grid(dice));
      move.motion = {0, std::abs(move.motion.y)};
      const Rect middle{move.box.x + move.box.w / 2, move.box.y, 0, move.box.h};
      const Contact<double> alone = cast_box(scene.terrain, Cast<double>{middle, move.motion});
      const Contact<double> whole =
          cast_box(scene.terrain, Cast<double>{move.box, move.motion, Foot::centre});
      const double slack = 4 * rounding_slack(Cast<double>{move.box, move.motion}) * steepness(alone);
      const bool is_sooner = alone && !(whole && (whole.t - alone.t) * move.motion.y <= slack);
      if (is_sooner) RC_LOG() << rc::toString(move);
      RC_ASSERT(!is_sooner);
    }
  }
}

// ---- The same elsewhere ----

Facing mirrored(Facing facing) {
  return facing == Facing::left ? Facing::right : facing == Facing::right ? Facing::left : facing;
}

// All coordinates are on a grid that both sides of the map share. Times, sides and the normals of straight
// ground are equal to the last bit; so is y on level floors and x at walls. Other places are sums that are
// rounded on different grids to the left and right of a power of two.
void expect_mirrored(const Scene& scene, const Move& move, const Truth& truth, bool straight) {
  const double width = scene.ground.right();
  const Scene& other = scene.mirrored();
  const Move turned{{width - move.box.x - move.box.w, move.box.y, move.box.w, move.box.h},
                    {-move.motion.x, move.motion.y}};
  const Contact<double> a = scene.cast(move), b = other.cast(turned);
  if (straight) {
    RC_ASSERT(a.t == b.t);
    RC_ASSERT(a.normal.x == -b.normal.x && a.normal.y == b.normal.y);
    RC_ASSERT(!a || a.facing == mirrored(b.facing));
  }
  const char* wrong = wrong_time(b, truth);
  if (wrong != nullptr) RC_LOG() << rc::toString(move) << " mirrored " << wrong;
  RC_ASSERT(std::string(wrong == nullptr ? "" : wrong).empty());
  const bool wall = a && (a.facing == Facing::left || a.facing == Facing::right);
  if (straight && wall) RC_ASSERT(a.position.x == width - b.position.x - move.box.w);
  if (straight && a && a.normal.x == 0) RC_ASSERT(a.position.y == b.position.y);
}

RC_GTEST_PROP(ExactProperty, MirroredStraightGroundGivesTheMirroredContact, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .segments = true};
  for_random_moves(seed, kinds, true, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_mirrored(scene, move, truth, true);
  });
}

RC_GTEST_PROP(ExactProperty, MirroredPolygonsGiveTheMirroredContact, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .polygons = true};
  for_random_moves(seed, kinds, true, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_mirrored(scene, move, truth, true);
  });
}

RC_GTEST_PROP(ExactProperty, MirroredCurvesGiveTheMirroredContact, (std::uint64_t seed)) {
  const GroundKinds kinds{.curves = true};
  for_random_moves(seed, kinds, true, [](Dice&, const Scene& scene, const Move& move, const Truth& truth) {
    expect_mirrored(scene, move, truth, false);
  });
}

// Up to 2^20 px from the origin in x or y, a cast obeys the same bound as near it: 3 units in the last place
// of the largest coordinate (there 7e-10 px), and 1e-12 px more with curves.
RC_GTEST_PROP(ExactProperty, MovedGroundGivesTheMovedContact, (std::uint64_t seed)) {
  Dice dice(seed);
  for (int i = grounds_of_a_seed(); i > 0; --i) {
    const GroundKinds kinds{.one_way = true, .segments = true, .curves = dice.one_in(2)};
    const Scene near(random_ground(dice, 4 + dice.up_to(8), 4 + dice.up_to(8), kinds));
    const bool to_the_right = dice.one_in(2);
    const TileSize tile = near.ground.tile;
    const int cells = 1 + (1 << dice.up_to(20)) / (to_the_right ? tile.width : tile.height);
    const Cell by{to_the_right ? cells : dice.up_to(2), to_the_right ? dice.up_to(2) : cells};
    const Scene far(near.ground.moved(by.x, by.y));
    for (int k = 0; k < kMovesOnAGround; ++k) {
      const Move move = random_move(dice, near.ground, near.exact, 256);
      Move moved = move;
      moved.box.x += by.x * tile.width, moved.box.y += by.y * tile.height;
      const Truth truth = far.truth(moved);
      if (!truth.is_told) continue;
      expect_right(far, moved, truth, 3 * ulp_of(moved) + (kinds.curves ? 1e-12 : 0));
    }
  }
}

// The order of the curves affects only which of two simultaneous contacts is reported.
RC_GTEST_PROP(ExactProperty, PermutedCurvesGiveTheSameContact, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .segments = true, .curves = true};
  Dice dice(seed);
  for (int i = grounds_of_a_seed(); i > 0; --i) {
    const Scene scene(random_ground(dice, 4 + dice.up_to(8), 4 + dice.up_to(8), kinds));
    RandomGround shuffled = scene.ground;
    dice.shuffle(shuffled.curves);
    const Scene other(std::move(shuffled));
    for (int k = 0; k < kMovesOnAGround; ++k) {
      const Move move = random_move(dice, scene.ground, scene.exact, random_grid(dice));
      const Contact<double> a = scene.cast(move), b = other.cast(move);
      RC_ASSERT(a.t == b.t && a.position == b.position && a.normal == b.normal && a.facing == b.facing);
    }
  }
}

// A box that fell straight down stays at its place to the last bit, in whole and in half steps. Between a
// steep line and a floor it is put on one of them first and on the other next; the two places differ by the
// rounding of a place on the steep line.
RC_GTEST_PROP(ExactProperty, ABoxAtRestStays, (std::uint64_t seed)) {
  const GroundKinds kinds{.one_way = true, .segments = true, .curves = true};
  for_random_moves(seed, kinds, false, [](Dice& dice, const Scene& scene, Move move, const Truth&) {
    move.motion.x = 0;
    const Contact<double> landed = scene.cast(move);
    if (!landed || landed.facing != Facing::up) return;
    move.box.x = landed.position.x, move.box.y = landed.position.y;
    move.motion = {0, 1};
    const Contact<double> settled = scene.cast(move);
    RC_ASSERT(settled.t == 0 && settled.position.x == move.box.x);
    RC_ASSERT(std::abs(settled.position.y - move.box.y) <= 3 * ulp_of(move) * steepness(landed));
    move.box.y = settled.position.y;
    const double fall = dice.in(0.001, 8);
    for (const double step : {fall, fall / 2, fall / 2}) {
      move.motion = {0, step};
      const Contact<double> rest = scene.cast(move);
      if (rest.t != 0) RC_LOG() << rc::toString(move) << " does not rest";
      RC_ASSERT(rest.t == 0);
      RC_ASSERT(rest.position == move.box.position());
    }
  });
}

}  // namespace talus::exact_property_test
