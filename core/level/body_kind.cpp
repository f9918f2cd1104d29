// Looking kinds of bodies up.
#include <talus/level/body_kind.h>

#include <algorithm>
#include <cassert>

namespace talus {
namespace {

// Of the first row for which it holds.
template <class Test>
std::optional<BodyKind> find_kind(Test test) {
  const auto kinds = body_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), test);
  if (found == kinds.end()) return std::nullopt;
  return static_cast<BodyKind>(found - kinds.begin());
}

}  // namespace

const BodyTraits& traits_of(BodyKind kind) {
  assert(static_cast<std::size_t>(kind) < body_kinds().size());
  return body_kinds()[static_cast<std::size_t>(kind)];
}

Vec2 new_body_size(BodyKind kind, TileSize tile) {
  constexpr TileSize kUsual;
  const Vec2 size = traits_of(kind).size;
  return {size.x * tile.width / kUsual.width, size.y * tile.height / kUsual.height};
}

double mass_of(BodyKind kind, Vec2 size) {
  if (const double radius = radius_of(kind, size); radius > 0) size = {2 * radius, 2 * radius};
  return traits_of(kind).mass * (size.x * size.y / kMassArea);
}

double radius_of(BodyKind kind, Vec2 size) {
  return traits_of(kind).shape == BodyShape::circle ? std::min(size.x, size.y) / 2 : 0;
}

std::optional<BodyKind> find_body_kind(std::string_view word) {
  return find_kind([&](const BodyTraits& traits) { return traits.word == word; });
}

std::optional<BodyKind> body_kind_of(TileRole role) {
  if (role == TileRole::none) return std::nullopt;
  return find_kind([&](const BodyTraits& traits) { return traits.role == role; });
}

}  // namespace talus
