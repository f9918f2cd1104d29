// Finds mirrored tiles.
#include "map_mirror.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <utility>

#include <talus/collision/shape_forms.h>
#include "cell_painter.h"
#include "stamp.h"

namespace talus {
namespace {

using Kind = TileShape::Kind;
constexpr int kNoGround = -1;

// What a tile is to the simulation, for every solver.
struct Physics {
  TileShape shape;
  TileRole role = TileRole::none;
  friend bool operator==(const Physics&, const Physics&) = default;
};

Physics physics_of(const Level& level, TileNumber tile) {
  Physics physics{shape_of_tile(level, tile), role_of(level.tile_flags(tile), level.roles)};
  // These fields mean nothing for a full tile, or for no shape.
  if (physics.shape.kind == Kind::none) physics.shape = {};
  if (physics.shape.kind == Kind::solid)
    physics.shape = {
        .kind = Kind::solid, .one_way = physics.shape.one_way, .conveyor = physics.shape.conveyor};
  return physics;
}

// The mirror image; nothing if there is none: a full tile is one-way only from above.
std::optional<Physics> mirrored(Physics physics, MirrorAxis axis, TileSize tile) {
  TileShape& shape = physics.shape;
  if (axis == MirrorAxis::horizontal) {
    shape = talus::mirrored(shape, tile, ShapeMirror::left_right);
    if (physics.role == TileRole::up_slope)
      physics.role = TileRole::down_slope;
    else if (physics.role == TileRole::down_slope)
      physics.role = TileRole::up_slope;
    return physics;
  }
  if (shape.kind == Kind::solid && shape.one_way) return std::nullopt;
  shape = talus::mirrored(shape, tile, ShapeMirror::up_down);
  return physics;
}

TileImage mirrored(const TileImage& image, MirrorAxis axis) {
  TileImage result;
  for (int y = 0; y < kCartTileSize; ++y) {
    for (int x = 0; x < kCartTileSize; ++x) {
      const int from_x = axis == MirrorAxis::horizontal ? kCartTileSize - 1 - x : x;
      const int from_y = axis == MirrorAxis::vertical ? kCartTileSize - 1 - y : y;
      result[static_cast<std::size_t>(y * kCartTileSize + x)] =
          image[static_cast<std::size_t>(from_y * kCartTileSize + from_x)];
    }
  }
  return result;
}

class Mirrorer {
 public:
  Mirrorer(const Level& level, CellRect cells, MirrorAxis axis)
      : level_(level),
        cells_(cells),
        axis_(axis),
        can_turn_(level.cart == nullptr),
        result_(stamp_of_map(level, cells)) {
    for (int tile = 0; tile < level.tile_count(); ++tile)
      physics_.push_back(physics_of(level, static_cast<TileNumber>(tile)));
  }

  MirroredCells run() {
    for (int y = 0; y < cells_.h; ++y) {
      for (int x = 0; x < cells_.w; ++x) {
        if (!taken_by_slope(x, y)) mirror_from(x, y);
      }
    }
    CellPainter painter(level_.map);
    for (int y = 0; y < cells_.h; ++y) {
      for (int x = 0; x < cells_.w; ++x) painter.paint({cells_.x + x, cells_.y + y}, result_.at(x, y));
    }
    mirrored_.edit =
        painter.finish(axis_ == MirrorAxis::horizontal ? "Mirror tiles" : "Mirror tiles up and down");
    return std::move(mirrored_);
  }

 private:
  MapCell cell_at(int x, int y) const { return level_.map.at({cells_.x + x, cells_.y + y}); }
  TileNumber tile_at(int x, int y) const { return cell_at(x, y).tile; }
  // A turned tile is mirrored by itself, whatever it is, and so is one in true colour: other tiles of a
  // picture look otherwise.
  bool turns_itself(int x, int y) const {
    const MapCell cell = cell_at(x, y);
    const bool is_in_true_color =
        level_.sheet(SheetId::tiles).picture != nullptr || level_.large_tiles.contains(cell.tile);
    return cell.turn != TileTurn::none || (can_turn_ && is_in_true_color);
  }
  const Physics& physics_at(int x, int y) const {
    static const Physics kNone;
    return turns_itself(x, y) ? kNone : physics_[tile_at(x, y)];
  }
  const TileImage& image(TileNumber tile) const { return level_.sheet(SheetId::tiles).images[tile]; }

  // Number of cells that the slope at x, y spans; 1 if it would leave the selection or meet the cell of
  // another slope.
  int span_at(int x, int y) const {
    const TileShape& shape = physics_at(x, y).shape;
    if (axis_ == MirrorAxis::vertical || shape.kind == Kind::none || x + shape.tiles > cells_.w) return 1;
    for (int i = 1; i < shape.tiles; ++i)
      if (physics_at(x + i, y) != Physics() || turns_itself(x + i, y)) return 1;
    return shape.tiles;
  }
  bool taken_by_slope(int x, int y) const {
    for (int from = std::max(0, x - kMaxShapeTiles + 1); from < x; ++from)
      if (from + span_at(from, y) > x) return true;
    return false;
  }
  void put(int x, int y, MapCell cell) {
    result_.tiles[static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.w) +
                  static_cast<std::size_t>(x)] = cell;
  }

  // Mirrors the cell at x, y, and the cells that a slope there spans. The slope belongs to its leftmost cell
  // before and after; each image goes to the other side on its own.
  void mirror_from(int x, int y) {
    const int span = span_at(x, y);
    const bool is_cut = axis_ == MirrorAxis::horizontal && span < physics_at(x, y).shape.tiles;
    const int to_x = axis_ == MirrorAxis::horizontal ? cells_.w - x - span : x;
    const int to_y = axis_ == MirrorAxis::vertical ? cells_.h - 1 - y : y;
    if (turns_itself(x, y)) return put(to_x, to_y, turned_over(cell_at(x, y)));
    std::array<MapCell, kMaxShapeTiles> tiles{};
    int art = 0;
    for (int i = 0; i < span; ++i) {
      const TileNumber looks = tile_at(x + span - 1 - i, y);
      const auto found = partner_of(i == 0 ? tile_at(x, y) : kNoGround, looks);
      if (!found || is_cut) return keep(x, y, to_x, to_y, span);
      const bool is_drawn_so = image(*found) == mirrored(image(looks), axis_);
      const bool turns = can_turn_ && *found == looks && !is_drawn_so;
      tiles[static_cast<std::size_t>(i)] = turns ? turned_over(looks) : MapCell(*found);
      art += turns || is_drawn_so ? 0 : 1;
    }
    for (int i = 0; i < span; ++i) put(to_x + i, to_y, tiles[static_cast<std::size_t>(i)]);
    mirrored_.unmirrored_art += art;
  }

  MapCell turned_over(MapCell cell) const {
    if (cell.tile == 0) return cell;
    const bool is_horizontal = axis_ == MirrorAxis::horizontal;
    return {cell.tile, after_turn(cell.turn, is_horizontal ? TileTurn::left_right : TileTurn::up_down)};
  }

  // Without a mirror image on the sheet.
  void keep(int x, int y, int to_x, int to_y, int span) {
    for (int i = 0; i < span; ++i) {
      const int from = can_turn_ ? span - 1 - i : i;
      const MapCell cell = cell_at(x + from, y);
      put(to_x + i, to_y, can_turn_ ? turned_over(cell) : cell);
    }
    if (!can_turn_) ++mirrored_.without_partner;
  }

  // The tile that is the mirror image of `ground` to the simulation (or of kNoGround) and looks most like
  // that of `looks`. Each pair is looked for only once.
  std::optional<TileNumber> partner_of(int ground, TileNumber looks) {
    const auto [found, is_new] = partners_.try_emplace({ground, looks});
    if (is_new) {
      const auto wanted = ground == kNoGround ? Physics()
                                              : mirrored(physics_[static_cast<std::size_t>(ground)], axis_,
                                                         level_.map.tile_size());
      if (wanted) found->second = find_partner(*wanted, looks);
    }
    return found->second;
  }

  std::optional<TileNumber> find_partner(const Physics& wanted, TileNumber looks) const {
    const TileImage target = mirrored(image(looks), axis_);
    const bool stays = physics_[looks] == wanted;
    const FlagSet flags = level_.tile_flags(looks);
    std::optional<TileNumber> best = stays ? std::optional(looks) : std::nullopt;
    int best_score = stays ? score(looks, target, flags) : -1;
    for (int i = 0; i < level_.tile_count(); ++i) {
      const auto tile = static_cast<TileNumber>(i);
      if (physics_[tile] != wanted) continue;
      if (stays && (image(tile) != target || level_.tile_flags(tile) != flags)) continue;
      const int tile_score = score(tile, target, flags);
      if (tile_score > best_score) {
        best = tile;
        best_score = tile_score;
      }
    }
    return best;
  }

  // Equal pixels count first, then equal flags.
  int score(TileNumber tile, const TileImage& target, FlagSet flags) const {
    int alike = 0;
    for (std::size_t i = 0; i < target.size(); ++i) alike += image(tile)[i] == target[i] ? 1 : 0;
    const int flags_alike = kMaxFlags - std::popcount(level_.tile_flags(tile) ^ flags);
    return alike * (kMaxFlags + 1) + flags_alike;
  }

  const Level& level_;
  CellRect cells_;
  MirrorAxis axis_;
  bool can_turn_;
  Stamp result_;
  std::vector<Physics> physics_;  // by tile
  std::map<std::pair<int, TileNumber>, std::optional<TileNumber>> partners_;
  MirroredCells mirrored_;
};

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

MirroredCells mirror_cells(const Level& level, CellRect cells, MirrorAxis axis) {
  const auto part = shared(cells, {0, 0, level.map.width(), level.map.height()});
  if (!part) return {};
  return Mirrorer(level, *part, axis).run();
}

std::string text_of_missing(const MirroredCells& mirrored) {
  std::string text;
  if (mirrored.without_partner > 0) {
    text = counted(mirrored.without_partner, "piece of ground is", "pieces of ground are") +
           " as before: the sheet has no mirror image, or the selection cuts through";
  }
  if (mirrored.unmirrored_art > 0) {
    text += (text.empty() ? "" : "; ") +
            counted(mirrored.unmirrored_art, "tile is not drawn mirrored", "tiles are not drawn mirrored") +
            ", as the sheet has no such picture";
  }
  return text.empty() ? text : text + ".";
}

}  // namespace talus
