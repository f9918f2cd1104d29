// Copyright (c) 2026 the Talus authors. MIT license, see LICENSE-talus.txt.
#include "bodies.h"

#include <talus/sim/body_act.h>

#include <algorithm>
#include <cmath>

namespace game {

using talus::Body;
using talus::Rect;
using talus::Rgb;
using talus::Vec2;

namespace {

constexpr Rgb kLight{244, 244, 244}, kBlue{65, 166, 246}, kDark{11, 12, 20};
constexpr Rgb kBoard{160, 112, 60}, kFrame{92, 61, 32};                       // of crates
constexpr Rgb kTyre{41, 54, 111};                                             // of discs
constexpr Rgb kRim{37, 113, 121}, kGlass{115, 239, 247}, kEye{239, 125, 87};  // of marbles

// The bar below is what it stands on: all of its bottom side, or the middle of it.
void draw_figure(Painter& painter, const Body& body) {
  const auto [x, y, w, h] = body.box;
  painter.rectangle(body.box, kBlue);
  for (const double eye : {0.3, 0.6})
    painter.rectangle({x + w * eye, y + h * 0.2, w * 0.12, h * 0.25}, kDark);
  const double inset = body.foot == talus::Foot::centre ? w * 0.38 : 0, foot = h * 0.15;
  painter.rectangle({x + inset, y + h - foot, w - 2 * inset, foot}, kLight);
}

// Boards in a frame, with one across.
void draw_crate(Painter& painter, const Rect& box) {
  const double bar = std::min(box.w, box.h) * 0.14;
  painter.rectangle(box, kFrame);
  painter.rectangle({box.x + bar, box.y + bar, box.w - 2 * bar, box.h - 2 * bar}, kBoard);
  const Vec2 across[] = {{box.x, box.bottom() - bar}, {box.x, box.bottom()}, {box.x + bar, box.bottom()},
                         {box.right(), box.y + bar},  {box.right(), box.y},  {box.right() - bar, box.y}};
  painter.polygon(across, kFrame);
}

// A circle that stands on the middle of a box's bottom.
struct Circle {
  double radius;
  Vec2 middle;
  explicit Circle(const Rect& box)
      : radius(std::min(box.w, box.h) / 2), middle{box.x + box.w / 2, box.bottom() - radius} {}
};

// A disc with a spoke that shows how it is turned.
void draw_wheel(Painter& painter, const Body& body) {
  const auto [radius, middle] = Circle(body.box);
  const double rim = radius * 0.2;
  const Vec2 way = Vec2{std::cos(body.turn), std::sin(body.turn)} * (radius - rim);
  painter.disc(middle, radius, kTyre);
  painter.disc(middle, radius - rim, kBlue);
  painter.line(middle - way, middle + way, rim, kLight);
  painter.disc(middle + way * 0.6, rim, kLight);
}

// A ball of glass. Its eye turns with it, its gleam does not.
void draw_marble(Painter& painter, const Body& body) {
  const auto [radius, middle] = Circle(body.box);
  painter.disc(middle, radius, kRim);
  painter.disc(middle, radius * 0.85, kGlass);
  painter.ellipse(middle, {radius * 0.65, radius * 0.25}, body.turn, kEye);
  painter.disc(middle - Vec2{radius * 0.35, radius * 0.4}, radius * 0.18, kLight);
}

}  // namespace

Bodies::Bodies(const talus::Level& level)
    : level_(level),
      tiles_(sheet_of(level, talus::SheetId::tiles)),
      sprites_(sheet_of(level, talus::SheetId::sprites)) {
  for (int tile = level.tile_count() - 1; tile >= 0; --tile)
    if (talus::is_ball_tile(level, static_cast<talus::TileNumber>(tile))) first_ball_ = tile;
}

void Bodies::draw(Painter& painter, const talus::State& state, double time) {
  for (const Body& body : state.bodies) {
    if (draw_picture(painter, body, state.frame)) continue;
    switch (talus::traits_of(body.kind).look) {
      case talus::BodyLook::tile:
        draw_tile(painter, body, time);
        break;
      case talus::BodyLook::figure:
        draw_figure(painter, body);
        break;
      case talus::BodyLook::crate:
        draw_crate(painter, body.box);
        break;
      case talus::BodyLook::wheel:
        draw_wheel(painter, body);
        break;
      case talus::BodyLook::marble:
        draw_marble(painter, body);
        break;
    }
  }
}

// The frame stands on the bottom of the box, in its middle.
bool Bodies::draw_picture(Painter& painter, const Body& body, std::int64_t frame) {
  if (body.origin.spawn < 0) return false;
  const talus::BodyPicture& its = level_.spawns[static_cast<std::size_t>(body.origin.spawn)].picture;
  const Sheet& sheet = its.sheet == talus::SheetId::sprites ? sprites_ : tiles_;
  const talus::BodyPicture picture = talus::on_sheet(its, sheet.layout);
  if (picture.empty()) return false;
  bool& looks_left = looks_left_[body.id];
  if (body.velocity.x != 0) looks_left = body.velocity.x < 0;
  talus::PicturePart part =
      sheet.part(talus::frame_tile(picture, talus::act_of(body), frame), picture.columns, picture.rows);
  part.mirrors_x = looks_left;
  const talus::TileSize tile = level_.map.tile_size();
  const Vec2 size{1.0 * picture.columns * tile.width, 1.0 * picture.rows * tile.height};
  const Vec2 corner{body.box.x + (body.box.w - size.x) / 2, body.box.bottom() - size.y};
  painter.draw(talus::placed(part, corner, size), {}, {});
  return true;
}

void Bodies::draw_tile(Painter& painter, const Body& body, double time) const {
  const auto [x, y, w, h] = body.box;
  const int tile = tile_of(body);
  if (tile < 0) return painter.disc({x + w / 2, y + h / 2}, w / 2, kLight);
  const auto* animation = talus::find_animation(level_.animations, static_cast<talus::TileNumber>(tile));
  const int shown = animation == nullptr ? tile : talus::tile_shown_at(*animation, time);
  painter.draw(talus::placed(tiles_.part(shown), {x, y}, {w, h}), {}, {});
}

int Bodies::tile_of(const Body& body) const {
  if (body.origin.spawn >= 0) return first_ball_;
  const auto at =
      static_cast<std::size_t>(body.origin.cell.y) * static_cast<std::size_t>(level_.map.width()) +
      static_cast<std::size_t>(body.origin.cell.x);
  for (int layer = level_.layers.count() - 1; layer >= 0; --layer) {
    const talus::TileNumber tile = level_.cells_of(layer).tiles()[at];
    const bool is_ground = level_.layers.list[static_cast<std::size_t>(layer)].is_ground;
    if (is_ground && talus::is_ball_tile(level_, tile)) return tile;
  }
  return first_ball_;
}

}  // namespace game
