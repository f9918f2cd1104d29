// Draws one body at a time onto a canvas.
#include "body_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/ui/theme.h"

namespace talus {
namespace {

int first_ball_tile(const Level& level) {
  for (int tile = 0; tile < level.tile_count(); ++tile)
    if (is_ball_tile(level, static_cast<TileNumber>(tile))) return tile;
  return -1;
}

void draw_figure(ImDrawList& list, ImVec2 from, ImVec2 to, Foot foot, int alpha) {
  const float w = to.x - from.x, h = to.y - from.y;
  const ImU32 dark = theme::color(theme::kDark, alpha);
  list.AddRectFilled(from, to, theme::color(theme::kAccent, alpha));
  list.AddRect(from, to, dark);
  for (const float x : {0.3f, 0.6f})
    list.AddRectFilled({from.x + w * x, from.y + h * 0.2f}, {from.x + w * (x + 0.12f), from.y + h * 0.45f},
                       dark);
  const float inset = foot == Foot::centre ? w * 0.38f : 0;
  list.AddRectFilled({from.x + inset, to.y - std::max(1.0f, h * 0.15f)}, {to.x - inset, to.y},
                     theme::color(theme::kText, alpha));
}

// Boards in a frame, with one across.
void draw_crate(ImDrawList& list, ImVec2 from, ImVec2 to, int alpha) {
  constexpr std::uint32_t kBoard = 0xa0703c, kFrame = 0x5c3d20;
  const float w = to.x - from.x, h = to.y - from.y, bar = std::max(1.0f, std::min(w, h) * 0.14f);
  const ImU32 frame = theme::color(kFrame, alpha);
  list.AddRectFilled(from, to, theme::color(kBoard, alpha));
  list.AddLine({from.x + bar, to.y - bar}, {to.x - bar, from.y + bar}, frame, bar);
  list.AddRect({from.x + bar / 2, from.y + bar / 2}, {to.x - bar / 2, to.y - bar / 2}, frame, 0, 0, bar);
}

// A disc that stands on the middle of the box's bottom, with a spoke that shows how it is turned.
void draw_wheel(ImDrawList& list, ImVec2 from, ImVec2 to, double turn, int alpha) {
  constexpr std::uint32_t kTyre = 0x29366f, kWheel = 0x41a6f6;
  const float radius = std::min(to.x - from.x, to.y - from.y) / 2, rim = std::max(1.0f, radius * 0.2f);
  const ImVec2 middle{(from.x + to.x) / 2, to.y - radius};
  list.AddCircleFilled(middle, radius, theme::color(kTyre, alpha));
  list.AddCircleFilled(middle, radius - rim, theme::color(kWheel, alpha));
  const float length = radius - rim;
  const ImVec2 way{length * static_cast<float>(std::cos(turn)), length * static_cast<float>(std::sin(turn))};
  const ImU32 light = theme::color(theme::kText, alpha);
  list.AddLine({middle.x - way.x, middle.y - way.y}, {middle.x + way.x, middle.y + way.y}, light, rim);
  list.AddCircleFilled({middle.x + way.x * 0.6f, middle.y + way.y * 0.6f}, rim, light);
}

void draw_ellipse(ImDrawList& list, ImVec2 middle, ImVec2 radii, double turn, ImU32 color) {
  constexpr int kPoints = 32;
  const auto cosine = static_cast<float>(std::cos(turn)), sine = static_cast<float>(std::sin(turn));
  for (int i = 0; i < kPoints; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / kPoints;
    const float x = radii.x * std::cos(angle), y = radii.y * std::sin(angle);
    list.PathLineTo({middle.x + x * cosine - y * sine, middle.y + x * sine + y * cosine});
  }
  list.PathFillConvex(color);
}

// A ball of glass that stands on the middle of the box's bottom. Its eye turns with it, its gleam does not.
void draw_marble(ImDrawList& list, ImVec2 from, ImVec2 to, double turn, int alpha) {
  constexpr std::uint32_t kRim = 0x257179, kGlass = 0x73eff7, kEye = 0xef7d57;
  const float radius = std::min(to.x - from.x, to.y - from.y) / 2, rim = std::max(1.0f, radius * 0.15f);
  const ImVec2 middle{(from.x + to.x) / 2, to.y - radius};
  list.AddCircleFilled(middle, radius, theme::color(kRim, alpha));
  list.AddCircleFilled(middle, radius - rim, theme::color(kGlass, alpha));
  draw_ellipse(list, middle, {radius * 0.65f, radius * 0.25f}, turn, theme::color(kEye, alpha));
  list.AddCircleFilled({middle.x - radius * 0.35f, middle.y - radius * 0.4f}, radius * 0.18f,
                       theme::color(theme::kText, alpha));
}

}  // namespace

const BodyPicture* picture_of_body(const Level& level, const Body& body) {
  const int spawn = body.origin.spawn;
  if (spawn < 0 || spawn >= static_cast<int>(level.spawns.size())) return nullptr;
  const BodyPicture& picture = level.spawns[static_cast<std::size_t>(spawn)].picture;
  return picture.empty() ? nullptr : &picture;
}

Rect place_of_picture(const BodyPicture& picture, const Rect& box, TileSize tile) {
  const double w = picture.columns * tile.width, h = picture.rows * tile.height;
  return {box.x + (box.w - w) / 2, box.bottom() - h, w, h};
}

bool draw_own_look(ImDrawList& list, const Body& body, ImVec2 from, ImVec2 to, int alpha) {
  switch (traits_of(body.kind).look) {
    case BodyLook::tile:
      return false;
    case BodyLook::figure:
      draw_figure(list, from, to, body.foot, alpha);
      return true;
    case BodyLook::crate:
      draw_crate(list, from, to, alpha);
      return true;
    case BodyLook::wheel:
      draw_wheel(list, from, to, body.turn, alpha);
      return true;
    case BodyLook::marble:
      draw_marble(list, from, to, body.turn, alpha);
      return true;
  }
  return false;
}

BodyDrawing::BodyDrawing(const Level& level, std::int64_t step)
    : level_(level), step_(step), layers_(ground_layers(level)), first_ball_(first_ball_tile(level)) {}

int BodyDrawing::tile_of(const Body& body) const {
  if (body.origin.spawn >= 0 || !level_.map.contains(body.origin.cell)) return first_ball_;
  const auto at = static_cast<std::size_t>(body.origin.cell.y) * level_.map.width() + body.origin.cell.x;
  for (auto cells = layers_.rbegin(); cells != layers_.rend(); ++cells)
    if (const TileNumber tile = (*cells)->tiles()[at]; is_ball_tile(level_, tile)) return tile;
  return first_ball_;
}

std::optional<CellRect> BodyDrawing::frame_of(const Body& body) const {
  const BodyPicture* its = picture_of_body(level_, body);
  if (its == nullptr) return std::nullopt;
  const SheetLayout layout = level_.sheet(its->sheet).layout();
  const BodyPicture picture = on_sheet(*its, layout);
  if (picture.empty()) return std::nullopt;
  const Cell at = layout.place_of(frame_tile(picture, act_of(body), step_));
  return CellRect{at.x, at.y, picture.columns, picture.rows};
}

void BodyDrawing::draw(ImDrawList& list, const Body& body, bool looks_left, const CanvasView& view,
                       const Ui& ui, int alpha) const {
  if (const auto frame = frame_of(body)) {
    const BodyPicture& picture = *picture_of_body(level_, body);
    const Rect place = place_of_picture(picture, body.box, level_.map.tile_size());
    UvRect uv = ui.uv_of(picture.sheet, *frame);
    if (looks_left) std::swap(uv.from.x, uv.to.x);
    return list.AddImage(ui.clear_sheet(picture.sheet), view.to_screen({place.x, place.y}),
                         view.to_screen({place.right(), place.bottom()}), uv.from, uv.to,
                         IM_COL32(255, 255, 255, alpha));
  }
  const ImVec2 from = view.to_screen({body.box.x, body.box.y});
  const ImVec2 to = view.to_screen({body.box.right(), body.box.bottom()});
  if (draw_own_look(list, body, from, to, alpha)) return;
  int tile = tile_of(body);
  if (tile >= 0) {
    if (const auto* animation = find_animation(level_.animations, static_cast<TileNumber>(tile)))
      tile = tile_shown_at(*animation, static_cast<double>(step_) * kMsPerFrame);
    const UvRect uv = ui.uv_of(tile);
    list.AddImage(ui.clear_sheet(SheetId::tiles), from, to, uv.from, uv.to, IM_COL32(255, 255, 255, alpha));
  } else {
    list.AddCircleFilled({(from.x + to.x) / 2, (from.y + to.y) / 2}, (to.x - from.x) / 2,
                         theme::color(theme::kText, alpha));
  }
}

}  // namespace talus
