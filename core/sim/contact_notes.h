// Contacts with the ground, as records tell them.
#pragma once

#include <algorithm>
#include <optional>

#include <talus/collision/cast.h>
#include <talus/sim/record.h>

namespace talus {

// The piece of ground that a contact is with.
template <class Real>
Obstacle obstacle_of(const BasicTerrain<Real>& ground, const Contact<Real>& contact) {
  Obstacle other;
  const Piece<Real>* piece = contact.piece;
  if (piece != nullptr && piece->slope != 0)
    other.role = piece->slope < 0 ? TileRole::up_slope : TileRole::down_slope;
  if (contact.origin < 0) {
    other.curve = -1 - contact.origin;
  } else {
    other.cell = {contact.origin % ground.width(), contact.origin / ground.width()};
  }
  const TileSize tile = ground.tile_size();
  other.box = {ground.x_of(other.cell.x), ground.y_of(other.cell.y), 1.0 * tile.width, 1.0 * tile.height};
  if (piece != nullptr && (contact.origin < 0 || other.role != TileRole::solid)) {
    const double top = std::min(piece->y0, piece->y1), bottom = std::max(piece->y0, piece->y1);
    other.box = {piece->x0, top, static_cast<double>(piece->x1) - piece->x0, bottom - top};
  }
  return other;
}

// How a body of that size met a sloped piece; nothing for what is level or upright. other: of obstacle_of().
template <class Real>
std::optional<SlopeProbe> slope_probe(const Contact<Real>& contact, const Obstacle& other, Vec2 size) {
  const bool sloped = contact.normal.x != 0 && contact.normal.y != 0;
  if (!sloped || contact.piece == nullptr) return std::nullopt;
  const Piece<Real>& piece = *contact.piece;
  const double centre = static_cast<double>(contact.position.x) + size.x / 2;
  return SlopeProbe{
      .slope = other,
      .delta = std::clamp((centre - piece.x0) / (static_cast<double>(piece.x1) - piece.x0), 0.0, 1.0),
      .floor_y = contact.position.y + (contact.facing == Facing::up ? size.y : 0),
      .placed_y = contact.position.y,
      .normal = {contact.normal.x, contact.normal.y},
      .corrected = true};
}

}  // namespace talus
