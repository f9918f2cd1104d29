// Edit: a reversible change of a level. Tools make edits from a level and a gesture; the session applies,
// merges, undoes and redoes them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include <talus/level/level.h>
#include "level/cell_rect.h"

namespace talus {

// Each change knows what was there and what comes, so that it can be taken back. `before` must be what the
// level holds when the change is applied (asserted).
struct CellChange {
  Cell cell;
  std::uint8_t before, after;
};
struct PixelChange {
  SheetId sheet;
  int tile;   // 0..255
  int pixel;  // 0..63, row by row
  std::uint8_t before, after;
};
struct FlagsChange {
  SheetId sheet;
  int tile;
  std::uint8_t before, after;
};
struct ColorChange {
  int color;  // 0..15
  Rgb before, after;
};
struct FlagNameChange {
  int flag;  // 0..7
  std::string before, after;
};
struct FlagFieldsChange {
  std::vector<FlagField> before, after;
};
struct RolesChange {
  FlagRoles before, after;
};
struct TileShapeChange {
  int tile;  // 0..255
  TileShape before, after;
};
struct FlagShapeChange {
  int flag;  // 0..7
  TileShape before, after;
};
struct CurvesChange {
  std::vector<LevelCurve> before, after;
};
struct TuningChange {
  Tuning before, after;
};
struct SpawnsChange {
  std::vector<Spawn> before, after;
};
struct BrushesChange {
  std::vector<Brush> before, after;
};
struct AutoTilesChange {
  AutoTiles before, after;
};
struct ExportsChange {
  std::vector<ExportPreset> before, after;
};
// A whole level that stands in for its value in a change, so that other changes stay small.
class LevelCopy {
 public:
  LevelCopy(const Level& level) : level_(std::make_shared<const Level>(level)) {}
  explicit LevelCopy(std::shared_ptr<const Level> level) : level_(std::move(level)) {}  // never null
  operator const Level&() const { return *level_; }

 private:
  std::shared_ptr<const Level> level_;
};
struct LevelChange {  // all of it, by a file that was read again
  LevelCopy before, after;
};
struct MapChange {  // the whole map: its size, or too many cells to list
  TileMap before, after;
};

using Change =
    std::variant<CellChange, PixelChange, FlagsChange, ColorChange, FlagNameChange, FlagFieldsChange,
                 RolesChange, TileShapeChange, FlagShapeChange, CurvesChange, TuningChange, SpawnsChange,
                 BrushesChange, AutoTilesChange, ExportsChange, LevelChange, MapChange>;

// What an edit does to the selection of cells on the map, so that undo takes that back too.
struct SelectionChange {
  std::optional<CellRect> before, after;
  // How the tiles in `after` came there: moved from `before`, or put over what was there. While they are the
  // last change, they can be moved on, and what they covered comes back. `stays`: none of these.
  enum class Tiles { stays, moved, put } tiles = Tiles::stays;
};

struct Edit {
  std::string label;            // for the Edit menu and the history: "Paint tiles"
  std::vector<Change> changes;  // at most one for each place; applied first to last, undone last to first
  std::optional<SelectionChange> selection = {};
  bool empty() const { return changes.empty(); }
};

// The whole level becomes `other`, which is never null; empty when it is the same.
Edit replace_by(const Level& level, std::shared_ptr<const Level> other, std::string label);

// What the edited level would have more of than a level may: "has 70000 bodies, and a level holds up to
// 65536".
std::optional<std::string> problem_after(const Level& level, const Edit& edit);
// The memory that an edit takes, in bytes.
std::size_t memory_of(const Edit& edit);

void apply_edit(Level& level, const Edit& edit);
void revert_edit(Level& level, const Edit& edit);
// Fits an edit to a level that has changed since the tool saw it: each `before` becomes what the level holds.
// Changes that lost their place, or change nothing any more, vanish.
void rebase_edit(const Level& level, Edit& edit);
// Appends `next`, keeping one change for each place, and for the selection: its first `before` and last
// `after`. Changes that end where they began vanish.
void merge_edit(Edit& edit, const Edit& next);

// merge_edit for a stroke of many edits: it knows where each place's change is, so that a merge takes time by
// the length of `next` alone.
class EditMerger {
 public:
  EditMerger() = default;
  explicit EditMerger(const Edit& edit);
  // `edit` must be the one that the merger was made with, changed by it alone.
  void merge(Edit& edit, const Edit& next);

 private:
  void merge_change(Edit& edit, const Change& next);
  void fold_cells_into_map(Edit& edit, const MapChange& next);
  void remove(Edit& edit, std::size_t index);

  std::unordered_map<std::uint64_t, std::size_t> index_of_place_;  // into Edit::changes
};

}  // namespace talus
