// Compares a version of the level with the session's.
#include "level_at_frame.h"

namespace talus {
namespace {

std::vector<Cell> cells_changed(const TileMap& a, const TileMap& b) {
  std::vector<Cell> cells;
  if (a.width() != b.width() || a.height() != b.height() || a == b) return cells;
  for (Cell cell; cell.y < a.height(); ++cell.y) {
    for (cell.x = 0; cell.x < a.width(); ++cell.x) {
      if (a.at(cell) != b.at(cell)) cells.push_back(cell);
    }
  }
  return cells;
}

// Lists what differs between two levels with the same pictures; empty if nothing does.
std::string differences_of(const Level& a, const Level& b, std::size_t cells) {
  std::string text;
  const auto add = [&](bool differs, const std::string& what) {
    if (differs) text += (text.empty() ? "" : ", ") + what;
  };
  const bool same_size = a.map.width() == b.map.width() && a.map.height() == b.map.height();
  add(!same_size, "the map's size");
  add(cells > 0, std::to_string(cells) + (cells == 1 ? " cell" : " cells"));
  add(a.sheet(SheetId::tiles).flags != b.sheet(SheetId::tiles).flags || !(a.roles == b.roles), "flags");
  add(a.tile_shapes != b.tile_shapes || a.flag_shapes != b.flag_shapes, "shapes");
  add(a.curves != b.curves, "curves");
  add(a.spawns != b.spawns, "starts");
  add(!(a.tuning == b.tuning), "tuning");
  return text;
}

}  // namespace

void LevelAtFrame::show(const Session& session, const Branch& branch, std::int64_t frame) {
  const VersionPtr& version = branch.version_at(frame);
  if (version == session.timeline().level_version()) {
    is_other_ = false;
    version_.reset();
    return;
  }
  if (version == version_ && revision_ == session.revision()) return;
  version_ = version;
  revision_ = session.revision();
  take(session);
}

void LevelAtFrame::take(const Session& session) {
  const Level& now = session.level();
  level_ = now;
  put_version(*version_, level_);
  changed_ = cells_changed(level_.map, now.map);
  const std::string what = differences_of(level_, now, changed_.size());
  is_other_ = !what.empty();
  if (is_other_) ++number_;
  caption_ = "Level as it was at this frame (other: " + what + "); edits go to the newest";
}

}  // namespace talus
