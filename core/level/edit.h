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
#include "cell_rect.h"
#include "tile_look.h"

namespace talus {

// Each change holds the old and the new value, so that it can be undone. The level must hold `before` when
// the change is applied (asserted).
struct CellChange {
  Cell cell;
  MapCell before, after;
};
struct PixelChange {
  SheetId sheet;
  int tile;   // of the sheet
  int pixel;  // 0..63, row by row
  std::uint8_t before, after;
};
struct TileLookChange {  // of a sheet in true colour
  SheetId sheet;
  int tile;  // of the sheet
  TileLook before, after;
};
struct FlagsChange {
  SheetId sheet;
  int tile;
  FlagSet before, after;
};
struct ColorChange {
  int color;  // 0..15
  Rgb before, after;
};
struct BackgroundChange {
  std::optional<Rgba> before, after;
};
struct FlagNameChange {
  int flag;  // 0..31
  std::string before, after;
};
struct FlagFieldsChange {
  std::vector<FlagField> before, after;
};
struct RolesChange {
  FlagRoles before, after;
};
struct TileShapeChange {
  int tile;  // of the level
  TileShape before, after;
};
struct TileNotesChange {
  TileNotes before, after;
};
struct TileAnimationsChange {
  TileAnimations before, after;
};
struct FlagShapeChange {
  int flag;  // 0..31
  TileShape before, after;
};
struct CurvesChange {
  std::vector<LevelCurve> before, after;
};
struct ObjectsChange {
  std::vector<ObjectLayer> before, after;
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
// A copy of a whole level instead of a value in a change, so that other changes stay small.
class LevelCopy {
 public:
  LevelCopy(const Level& level) : level_(std::make_shared<const Level>(level)) {}
  explicit LevelCopy(std::shared_ptr<const Level> level) : level_(std::move(level)) {}  // never null
  operator const Level&() const { return *level_; }

 private:
  std::shared_ptr<const Level> level_;
};
struct TilesetsChange {  // their tiles stay as they are
  std::vector<Tileset> before, after;
};
struct LayersChange {  // the layers without the cells of the chosen one, which is the same in both
  TileLayers before, after;
};
struct LevelChange {  // the whole level, which was read again from its file
  LevelCopy before, after;
};
struct MapChange {  // the whole map: its size has changed, or too many cells to list
  TileMap before, after;
};

using AnyChange = std::variant<CellChange, PixelChange, TileLookChange, FlagsChange, ColorChange,
                               BackgroundChange, FlagNameChange, FlagFieldsChange, RolesChange,
                               TileShapeChange, FlagShapeChange, CurvesChange, ObjectsChange, TuningChange,
                               SpawnsChange, BrushesChange, AutoTilesChange, ExportsChange, TileNotesChange,
                               TileAnimationsChange, TilesetsChange, LayersChange, LevelChange, MapChange>;
// Copied, moved and destroyed in edit.cpp, so that the many files with edits need not compile that.
struct Change : AnyChange {
  using AnyChange::AnyChange;
  Change(const Change&);
  Change(Change&&) noexcept;
  Change& operator=(const Change&);
  Change& operator=(Change&&) noexcept;
  ~Change();
};

// The change of the selection of cells on the map, so that undo restores that, too.
struct SelectionChange {
  std::optional<CellRect> before, after;
  // How the tiles in `after` came there: moved from `before`, or put over other tiles. While this is the last
  // change they can be moved again, and the tiles that they covered come back. `stays`: neither.
  enum class Tiles { stays, moved, put } tiles = Tiles::stays;
};

struct Edit {
  std::string label;            // for the Edit menu and the history: "Paint tiles"
  std::vector<Change> changes;  // at most one for each place; applied first to last, undone last to first
  std::optional<SelectionChange> selection = {};
  int layer = 0;  // the chosen one, whose cells it changes; see rebase_edit
  bool empty() const { return changes.empty(); }
};

// Replaces the whole level by `other`, which is never null. Empty if it is the same.
Edit replace_by(const Level& level, std::shared_ptr<const Level> other, std::string label);

// Says which limit the edited level would exceed: "has 70000 bodies, but a level holds at most 65536";
// nothing if it keeps all.
std::optional<std::string> problem_after(const Level& level, const Edit& edit);
// The memory that an edit takes, in bytes.
std::size_t memory_of(const Edit& edit);

// Applying and reverting choose the layer of the edit.
void apply_edit(Level& level, const Edit& edit);
void revert_edit(Level& level, const Edit& edit);
// Adapts an edit to a level that has changed since the tool saw it: each `before` becomes what the level
// holds now, and its layer the chosen one. Changes whose place is gone, or that have no effect any more, are
// dropped.
void rebase_edit(const Level& level, Edit& edit);
// The chosen layer after an edit is applied.
int layer_after(const Edit& edit);
// Appends `next`. Keeps one change for each place and for the selection, with its first `before` and last
// `after`. Changes that end where they began are dropped. Both must be of the same layer (asserted), which is
// layer_after(edit).
void merge_edit(Edit& edit, const Edit& next);

// merge_edit for a stroke of many edits. It knows where each place's change is, so a merge takes time only by
// the length of `next`.
class EditMerger {
 public:
  EditMerger() = default;
  explicit EditMerger(const Edit& edit);
  // `edit` must be the one that the merger was made with, and nobody else may change it.
  void merge(Edit& edit, const Edit& next);

 private:
  void merge_change(Edit& edit, const Change& next);
  void fold_cells_into_map(Edit& edit, const MapChange& next);
  void remove(Edit& edit, std::size_t index);

  std::unordered_map<std::uint64_t, std::size_t> index_of_place_;  // into Edit::changes
};

}  // namespace talus
