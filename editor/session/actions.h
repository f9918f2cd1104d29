// Actions: everything that a user can do to a session, as values. Panels emit them; Session::apply carries
// them out. Tests and the command palette speak the same language.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "debug/stop_search.h"
#include "edit/edit.h"
#include "edit/map_tools.h"
#include "edit/sprite_tools.h"
#include "overlay/overlay_id.h"
#include "sim/timeline.h"
#include "variant_run.h"
#include "watches.h"

namespace talus {

// The tools of the map, in the order of their keys 1 to 9; 1, 2 and 4 as in TIC-80.
enum class MapTool { stamp, pan, rectangle, fill, erase, pick, body, slope, segment };
// The tools of the sprite canvas, in the order of their keys 1, 2 and 4, as in TIC-80.
enum class SpriteTool { pencil, pick, fill };

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
struct OpenFile {
  std::string path;
  bool as_copy = false;  // without a path, so that saving asks for one: for levels that come with the program
};
// A recording and its level; asks as OpenFile does, which does the same when its file is a recording.
struct OpenRecording {
  std::string path;
};
struct SaveRecording {  // of the current branch; not while it is run again
  std::string path;
};
struct SaveFile {};  // to its own path and format; without a name: see Session::wants_save_as()
struct SaveFileAs {
  std::string path;  // the format by its extension; with an unknown one nothing is saved
};
struct Quit {};
enum class Answer { save, discard, cancel };
struct AnswerQuestion {  // to Session::question()
  Answer answer = Answer::cancel;
};
struct CancelSaveAs {};
struct ShowMessage {  // for what panels and the platform find out
  std::string text;
  bool is_error = false;
};
struct DismissMessage {};

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
struct DropBranch {  // the one shown too; of the last one, what it holds
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

// --- what is chosen and shown
struct SelectBody {
  int id = 0;  // 0, or the id of no body: none
};
struct SelectSpawn {  // the body of a spawn of the level
  int spawn = 0;      // its index; of none: no body
};
struct SelectTiles {  // on the sheet: what the canvas and the flags show, and, of tiles, the stamp
  SpriteArea area;
};
struct SetStamp {
  Stamp stamp;
};
struct SetMapTool {
  MapTool tool;
};
struct SetSpriteTool {
  SpriteTool tool;
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
  std::optional<int> flag;  // 0..7 tints the map where that flag is set; nothing: no tint
};
struct SetGrid {
  bool on = true;
};
struct SetScreenBorders {
  bool on = true;
};

}  // namespace action

using Action =
    std::variant<action::EditLevel, action::Undo, action::Redo, action::NewLevel, action::OpenFile,
                 action::OpenRecording, action::SaveRecording, action::SaveFile, action::SaveFileAs,
                 action::Quit, action::AnswerQuestion, action::CancelSaveAs, action::ShowMessage,
                 action::DismissMessage, action::Play, action::Pause, action::TogglePlay, action::StepFrame,
                 action::ResetPlay, action::SetSpeed, action::HoldMouse, action::HoldKeys, action::StepBack,
                 action::SeekStart, action::SeekEnd, action::SeekFrame, action::SetMark, action::RemoveMark,
                 action::JumpToMark, action::TakeOver, action::SwitchBranch, action::DropBranch,
                 action::CompareBranch, action::SetInput, action::SetEditRule, action::Rerun,
                 action::CancelRerun, action::SetBreakpoint, action::RemoveBreakpoint, action::RunToStop,
                 action::FindParting, action::CancelSearch, action::SetWatch, action::RemoveWatch,
                 action::CompareVariant, action::SelectBody, action::SelectSpawn, action::SelectTiles,
                 action::SetStamp, action::SetMapTool, action::SetSpriteTool, action::SetColor,
                 action::SetOverlay, action::SetFlagOverlay, action::SetGrid, action::SetScreenBorders>;
using Actions = std::vector<Action>;

}  // namespace talus
