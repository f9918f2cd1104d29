// The kinds of bodies, one row each: everything that files, exports, solvers and the editor ask of a kind.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <talus/collision/shape.h>
#include <talus/level/flag_roles.h>

namespace talus {

// The order is that of body_kinds().
enum class BodyKind : std::uint8_t { ball, player, crate, disc, marble };

// What moves a body in a step of the exact solver. The other solvers move all kinds alike.
enum class BodyRule : std::uint8_t {
  fall,  // gravity pulls it, and it bounces
  run    // it runs, jumps and stands as the keys say; it has a Gait
};

// What of its box a body is, where bodies meet. Everywhere else it is all of it.
enum class BodyShape : std::uint8_t {
  box,    // all of it
  circle  // a circle as wide as its shorter side, which stands on the middle of its bottom, and rolls
};

// How the canvas draws a body.
enum class BodyLook : std::uint8_t {
  tile,    // as its tile, or as the first tile that is such a body; a disc where there is none
  figure,  // as a box with a face, and the foot that it stands on
  crate,   // as a wooden box
  wheel,   // as a disc that shows how it is turned
  marble   // as a marble of glass, whose eye shows how it is turned
};

inline constexpr double kMassArea = 64;  // px^2, for BodyTraits::mass: the area of a ball of the article

// The properties of a kind.
struct BodyTraits {
  std::string_view word;           // in files, exports, C and on screen: "ball"; a literal, no two are equal
  std::string_view help;           // one sentence: "A ball falls and bounces."
  BodyRule rule = BodyRule::fall;  // what moves it
  bool takes_keys = false;         // whether it does what the keys say; its Gait is part of hashes then
  Vec2 size = {8, 8};              // px, kMinBodySize..kMaxBodySize: of a body for which a file gives no size
  Foot foot = Foot::box;           // what stands on slopes, if nothing is given
  // Of bodies that meet, see BodyPairs; others use none of these four.
  BodyShape shape = BodyShape::box;   // what of it is solid
  double mass = 1;                    // over 0; of kMassArea of it
  double friction = 0;                // 0..: Coulomb's number; of two bodies the geometric mean counts
  std::optional<double> bounce = {};  // 0..1: share of the speed that is left; none: as the tuning says
  TileRole role = TileRole::none;     // tiles with this role are such bodies; none: no tiles are
  BodyLook look = BodyLook::tile;     // how it is drawn
  std::string_view ldtk_identifier;   // of its entity in LDtk: "Ball"
  std::string_view ldtk_color;        // "#RRGGBB"
  std::string_view svg_color;         // of its outline in an SVG, "#rrggbb"
};

// All kinds, by BodyKind.
std::span<const BodyTraits> body_kinds();
// The row of a kind, which must have one (asserted).
const BodyTraits& traits_of(BodyKind kind);
// The size, px, of a new body of a kind among tiles of a size: the kind's, made for tiles of 8x8 px, scaled.
Vec2 new_body_size(BodyKind kind, TileSize tile);
// The mass of a body of a kind and a size, px: over 0.
double mass_of(BodyKind kind, Vec2 size);
// px: the radius of the circle that a body of a kind and a size, px, is where bodies meet; 0 for a box.
double radius_of(BodyKind kind, Vec2 size);
// The kind with this word; nothing if no kind has it.
std::optional<BodyKind> find_body_kind(std::string_view word);
// The kind whose tiles have this role; nothing for roles of the ground.
std::optional<BodyKind> body_kind_of(TileRole role);

}  // namespace talus
