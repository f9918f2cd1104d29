// Actions: everything that a user can do to a session, as values. Panels emit them; Session::apply carries
// them out. Tests and the command palette speak the same language.
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "debug/stop_search.h"
#include "edit/curve_tools.h"
#include "edit/edit.h"
#include "edit/pixel_selection.h"
#include "edit/sprite_area.h"
#include "edit/sprite_shapes.h"
#include "edit/stamp.h"
#include "lint/lint.h"
#include "overlay/overlay_id.h"
#include "session/debugger/watches.h"
#include "session/files/png_import.h"
#include "session/run/variant_run.h"
#include "sim/timeline.h"

namespace talus {

// The tools of the map: those of the keys 1 to 9 and 0 in their order, 1 to 4 as in TIC-80; then those that
// have letters.
enum class MapTool {
  stamp,
  pan,
  select,
  fill,
  line,
  rectangle,
  ellipse,
  slope,
  segment,
  body,
  erase,
  pick,
  ground,
  flag,
  curve
};
// The tools of the sprite canvas; the first four in the order of their keys 1 to 4, as in TIC-80.
enum class SpriteTool { pencil, pick, select, fill, line, rectangle, ellipse };

// What an edit does while there is a recording. Whatever it says, an edit without one starts anew.
struct EditRule {
  enum class Kind {
    go_on,       // the shown frame goes on on the edited level
    from_start,  // the recorded input is run again on it from frame 0
    from_frame   // the same from `frame`, clamped to the recording
  };
  Kind kind = Kind::go_on;
  std::int64_t frame = 0;
  friend bool operator==(const EditRule&, const EditRule&) = default;
};

namespace action {

// --- the level
struct EditLevel {  // an edit made by a tool; a stroke > 0 merges with the entry of the same stroke before it
  Edit edit;
  int stroke = 0;
};
struct Undo {};
struct Redo {};

// --- files. What would lose unsaved changes is asked about first: see Session::question().
struct NewLevel {};
// A level, or a recording with its level; a PNG without a cart in it as OpenPng. Where there is something to
// choose of it first: see Session::level_import(). What takes long is read beside the editor: see
// Session::reading().
struct OpenFile {
  std::string path;
  bool as_copy = false;  // without a path, so that saving asks for one: for levels that come with the program
};
struct SaveRecording {  // of the current branch; not while it is run again
  std::string path;
};
struct SaveFile {};  // to its own path and format; without a name: see Session::wants_save_as()
struct SaveFileAs {
  std::string path;  // the format by its extension; with an unknown one nothing is saved
};
struct ExportPng {
  PngPart part = PngPart::tiles;
  std::string path;
};
// The path of a preset, as the user has typed or chosen it: it may leave the folder of the level. Of no such
// preset: nothing happens.
struct SetExportPath {
  std::size_t preset = 0;  // index
  std::string path;        // as ExportPreset::path; the one that it has already is chosen by that
};
// Looks at what a preset of the level would write: see Session::exporting(). Of none: nothing happens.
struct PreviewExport {
  std::size_t preset = 0;  // index
};
// Exports presets of the level as it is now, in the background; a message tells what came of it. While that
// goes on, nothing happens. Presets that the user has not allowed, and files that no export wrote, are asked
// about first: see Session::question().
struct RunExports {
  std::optional<std::size_t> preset = {};  // index; nothing: all
};
struct CancelExport {};
struct OpenPng {  // to be taken into the level: see Session::png_import()
  std::string path;
};
struct SetPngImport {
  PngImportOptions options;
};
struct ApplyPngImport {};  // while its plan is an error, nothing happens
struct CancelPngImport {};
struct SetLevelImport {
  ImportChoices choices;
};
struct ApplyLevelImport {};  // while it cannot be read so, nothing happens
struct CancelLevelImport {};
struct Quit {};
// To "unsaved changes": save, discard or cancel. To "the file was changed": reload or keep. To "drop this
// run": discard or cancel. To "replace these files": replace or cancel. To "keep the recording", and to "the
// file cannot hold all of this level": save (as), discard or cancel. To "these exports came with the file":
// allow or cancel.
enum class Answer { save, discard, cancel, reload, keep, replace, allow };
struct AnswerQuestion {  // to Session::question()
  Answer answer = Answer::cancel;
};
struct CancelSaveAs {};
// A level that was saved by itself before the program was killed: its file is opened, if it has one, and the
// level comes as a change of it that can be undone. Asks as OpenFile does.
struct RecoverLevel {
  std::shared_ptr<const Level> level;  // never null
  std::string path;                    // empty: none
  std::string name;                    // for titles, without a path
  // Of the runs that were saved with it, none null; the last one is shown.
  std::vector<std::shared_ptr<const Recording>> recordings = {};
};
// Looks whether another program has changed the level's file; see Session::question().
struct CheckFile {};
struct ShowMessage {  // for what panels and the platform find out
  std::string text;
  bool is_error = false;
};
struct DismissMessage {};
struct CancelReading {};  // of what Session::reading() tells; the level stays as it is

// --- play
struct Play {};
struct Pause {};
struct TogglePlay {};
struct StepFrame {};  // pauses and makes one step, or shows the next recorded frame: see Session
struct ResetPlay {};  // a new run from frame 0 of the level as it is now; keeps running if it ran
struct SetSpeed {
  double factor = 1;  // kMinSpeed to kMaxSpeed; clamped
};
struct HoldMouse {  // the mouse over the play view, in level pixels; drags the chosen ball while down
  Vec2 position;
  bool down = false;
};
struct HoldKeys {  // the keys of the players, as they are held from now on
  bool left = false, right = false, jump = false;
};

// --- the timeline (see sim/timeline.h). What shows another frame pauses.
struct StepBack {};   // the frame before
struct SeekStart {};  // frame 0
struct SeekEnd {};    // the last frame recorded
struct SeekFrame {
  std::int64_t frame = 0;  // clamped to those recorded
};
struct SetMark {           // at a frame; renames the one that is there
  std::int64_t frame = 0;  // clamped
  std::string name;
};
struct RemoveMark {
  std::int64_t frame = 0;  // without a mark nothing happens
};
struct JumpToMark {
  bool forwards = true;  // to the next one or the one before; without one nothing happens
};
struct TakeOver {};  // leaves the recording at the shown frame: what is played next goes on from there
struct SwitchBranch {
  int branch = 0;  // id, here and below; of none: nothing happens
};
// The one shown too; of the last one, what it holds. Asks first, unless there is nothing in it: see
// Session::question().
struct DropBranch {
  int branch = 0;
};
struct CompareBranch {  // shows it with the current one
  int branch = 0;       // 0: none
};
// Presses or lets go a key in the steps to the frames first..last and runs what follows again. Clamped.
struct SetInput {
  std::int64_t first = 1, last = 1;
  InputKey key = InputKey::left;
  bool on = true;
};
struct SetMouse {  // where the mouse is in those steps, in the same way
  std::int64_t first = 1, last = 1;
  Vec2 position;  // px, in the level; finite
};
struct SetEditRule {
  EditRule rule;
};
struct Rerun {            // the recorded input on the level as it is now
  std::int64_t from = 0;  // frame; clamped
};
struct CancelRerun {};  // the branch ends where it has been run to

// --- the debugger
struct SetBreakpoint {  // in the place of the one with its id; id 0: a new one
  Breakpoint breakpoint;
};
struct RemoveBreakpoint {
  int breakpoint = 0;  // id
};
// Pauses, and shows the next frame at which a breakpoint stops, or the one before. Where nothing recorded
// stops, forwards goes on playing.
struct RunToStop {
  SearchDirection direction = SearchDirection::forwards;
};
struct FindParting {     // shows the first frame in which a body is apart from the same one on the other side
  double threshold = 0;  // px, finite and >= 0: by more than this
};
struct SetParting {      // how far bodies are from their other selves when the sides have parted
  double threshold = 0;  // px; a negative one gives 0, what is no number changes nothing
};
struct CancelSearch {};
struct SetWatch {  // in the place of the one with this index; a larger one: a new one
  std::size_t index = 0;
  WatchText watch;
};
struct RemoveWatch {
  std::size_t index = 0;
};
struct CompareVariant {            // runs the same input through it, beside what is shown
  std::optional<Variant> variant;  // nothing: no longer
};

// --- where players get to (see session/reach_finder.h)
struct FindReach {};    // of the level as it is now; what was found before is forgotten
struct CancelReach {};  // keeps what has been found
struct ShowWay {        // plays the way to a reached cell as a new branch; to another one nothing happens
  Cell cell;
};

// --- what is chosen and shown
struct SetLintOptions {
  LintOptions options;  // clamped
};
struct SelectBody {
  int id = 0;  // 0, or the id of no body: none
};
struct SelectSpawn {  // the body of a spawn of the level
  int spawn = 0;      // its index; of none: no body
};
struct SelectCurve {
  int curve = -1;  // its index in the level; of none: none
};
struct SetCurveKind {  // what the curve tool draws
  CurveKind kind = CurveKind::segment;
};
struct SelectTiles {  // on the sheet: what the canvas and the flags show, and, of tiles, the stamp
  SpriteArea area;
};
struct SetStamp {
  Stamp stamp;
};
struct SetRandomStamp {  // each painted cell takes a tile of the stamp at random
  bool on = true;
  std::uint32_t seed = 1;  // of what is painted from now on
};
struct SelectCells {  // on the map; cut at its edge, and wholly outside, or nothing: no selection
  std::optional<CellRect> cells;
};
struct SetPasted {  // tiles that hang at the mouse until a click puts them on the map; nothing: none any more
  std::optional<Stamp> tiles;
};
struct SetMapTool {  // lets go what hangs at the mouse
  MapTool tool;
};
struct SetSpriteTool {
  SpriteTool tool;
};
struct SetBrush {  // of the tools that draw pixels
  int size = 1;    // px, 1..kMaxBrush; clamped
};
struct SelectPixels {            // in the canvas, until another tool or canvas is chosen
  std::optional<CellRect> rect;  // px of the canvas, clamped to it; nothing: none
};
// The selected pixels are lifted from the canvas: the right button's colour stays behind, and they float
// until something else changes the canvas. All moves in a row are one undo. Without a selection nothing
// happens.
struct MovePixels {
  Cell by;  // px
};
struct TurnPixels {  // the selected ones, in the same way, or all of the canvas, which rotates if it is
                     // square
  PixelTurn turn = PixelTurn::flip_horizontal;
};
struct PastePixels {  // they are selected, and float
  PixelBlock block;   // 1 px or more in each direction
  Cell at;            // px of the canvas; one px stays inside
};
struct SetColor {
  int color = 0;           // 0..15
  bool secondary = false;  // false: the left button's colour; true: the right button's
};
struct SetOverlay {
  OverlayId overlay;
  bool on = true;
};
struct SetFlagOverlay {
  // Tints the map and the sheet where tiles match it; it is what is painted and looked for. Nothing: no tint.
  std::optional<FlagPattern> pattern;
};
struct SetOverlayPalette {
  OverlayPalette palette;
};
struct SetGrid {
  bool on = true;
};
struct SetScreenBorders {
  bool on = true;
};

}  // namespace action

using Action = std::variant<
    action::EditLevel, action::Undo, action::Redo, action::NewLevel, action::OpenFile, action::SaveRecording,
    action::SaveFile, action::SaveFileAs, action::ExportPng, action::SetExportPath, action::PreviewExport,
    action::RunExports, action::CancelExport, action::OpenPng, action::SetPngImport, action::ApplyPngImport,
    action::CancelPngImport, action::SetLevelImport, action::ApplyLevelImport, action::CancelLevelImport,
    action::Quit, action::AnswerQuestion, action::CancelSaveAs, action::RecoverLevel, action::CheckFile,
    action::ShowMessage, action::DismissMessage, action::CancelReading, action::Play, action::Pause,
    action::TogglePlay, action::StepFrame, action::ResetPlay, action::SetSpeed, action::HoldMouse,
    action::HoldKeys, action::StepBack, action::SeekStart, action::SeekEnd, action::SeekFrame,
    action::SetMark, action::RemoveMark, action::JumpToMark, action::TakeOver, action::SwitchBranch,
    action::DropBranch, action::CompareBranch, action::SetInput, action::SetMouse, action::SetEditRule,
    action::Rerun, action::CancelRerun, action::SetBreakpoint, action::RemoveBreakpoint, action::RunToStop,
    action::FindParting, action::SetParting, action::CancelSearch, action::SetWatch, action::RemoveWatch,
    action::CompareVariant, action::SelectBody, action::SelectSpawn, action::SelectCurve,
    action::SetCurveKind, action::SelectTiles, action::SetStamp, action::SetRandomStamp, action::SelectCells,
    action::SetPasted, action::SetMapTool, action::SetSpriteTool, action::SetBrush, action::SelectPixels,
    action::MovePixels, action::TurnPixels, action::PastePixels, action::SetColor, action::SetOverlay,
    action::SetFlagOverlay, action::SetOverlayPalette, action::FindReach, action::CancelReach,
    action::ShowWay, action::SetLintOptions, action::SetGrid, action::SetScreenBorders>;

// What was done since it was last looked at, in order.
class Actions {
 public:
  Actions();
  Actions(std::initializer_list<Action> actions);
  Actions(const Actions& other);
  Actions(Actions&& other) noexcept;
  Actions& operator=(const Actions& other);
  Actions& operator=(Actions&& other) noexcept;
  ~Actions();

  // A: one of the alternatives of Action. Compiled in actions.cpp for each of them, as are the members above:
  // in every panel they would be most of the time that it takes to compile.
  template <class A>
  void push_back(A action);

  bool empty() const { return begin() == end(); }
  const Action* begin() const;
  const Action* end() const;

 private:
  std::vector<Action> list_;
};

}  // namespace talus
