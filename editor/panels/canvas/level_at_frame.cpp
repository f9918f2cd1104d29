// Compares a version of the level with the session's.
#include "level_at_frame.h"

#include <algorithm>
#include <utility>

namespace talus {
namespace {

// Whether the maps have layers for the same purposes.
bool same_kinds(const TileLayers& a, const TileLayers& b) {
  const auto same = [](const TileLayer& x, const TileLayer& y) { return x.is_ground == y.is_ground; };
  return std::equal(a.list.begin(), a.list.end(), b.list.begin(), b.list.end(), same);
}

std::vector<Cell> cells_changed(const Level& a, const Level& b) {
  if (a.map.width() != b.map.width() || a.map.height() != b.map.height() ||
      a.layers.count() != b.layers.count())
    return {};
  const auto width = static_cast<std::size_t>(a.map.width());
  std::vector<bool> is_changed;  // by cell; empty: none is
  for (int layer = 0; layer < a.layers.count(); ++layer) {
    const MapCells &then = a.cells_of(layer), &now = b.cells_of(layer);
    if (then == now) continue;
    is_changed.resize(now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
      if (then[i] != now[i]) is_changed[i] = true;
  }
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < is_changed.size(); ++i)
    if (is_changed[i]) cells.push_back({static_cast<int>(i % width), static_cast<int>(i / width)});
  return cells;
}

// What is not of the ground stays as it is now, as pictures do.
void keep_looks(const TileLayers& now, TileLayers& then) {
  if (!same_kinds(now, then)) return;
  for (std::size_t i = 0; i < now.list.size(); ++i) {
    auto cells = std::move(then.list[i].cells);
    then.list[i] = now.list[i];
    then.list[i].cells = std::move(cells);
  }
}

// Lists what differs between two levels with the same pictures; empty if nothing does.
std::string differences_of(const Level& a, const Level& b, std::size_t cells) {
  std::string text;
  const auto add = [&](bool differs, const std::string& what) {
    if (differs) text += (text.empty() ? "" : ", ") + what;
  };
  const bool same_size = a.map.width() == b.map.width() && a.map.height() == b.map.height();
  add(!same_size, "the map's size");
  add(!same_kinds(a.layers, b.layers), "layers");
  add(cells > 0, std::to_string(cells) + (cells == 1 ? " cell" : " cells"));
  add(a.sheet(SheetId::tiles).flags != b.sheet(SheetId::tiles).flags || !(a.roles == b.roles), "flags");
  add(a.tile_shapes != b.tile_shapes || a.flag_shapes != b.flag_shapes, "shapes");
  add(a.curves != b.curves, "curves");
  add(a.objects != b.objects, "objects");
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
  keep_looks(now.layers, level_.layers);
  changed_ = cells_changed(level_, now);
  const std::string what = differences_of(level_, now, changed_.size());
  is_other_ = !what.empty();
  if (is_other_) ++number_;
  caption_ = "Level as it was at this frame (other: " + what + "); edits go to the newest";
}

}  // namespace talus
