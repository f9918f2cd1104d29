// What a Session is made of; for session.cpp, session_files.cpp, session_timeline.cpp,
// session_debug.cpp, session_exports.cpp and session_pictures.cpp alone.
#pragma once

#include <variant>

#include <talus/collision/function_ref.h>
#include "lint/lint_cache.h"
#include "session.h"
#include "session/debugger/debugger.h"
#include "session/files/file_reader.h"
#include "session/files/file_stamp.h"
#include "session/files/opened_file.h"
#include "session/run/handmade_runs.h"
#include "session/run/scene_compiler.h"
#include "session/run/simulation.h"

namespace talus {

// What has changed in the level that the simulation has not seen yet.
struct SceneChanges {
  static constexpr std::size_t kMostCells = 1000;  // beyond that the whole level is compiled no slower

  bool whole = false;       // all of the ground may have changed
  bool bodies = false;      // spawns or tuning, which the ground does not see
  std::vector<Cell> cells;  // unless `whole`
  bool empty() const { return !whole && !bodies && cells.empty(); }
  void add(const Change& change) {
    const auto* cell = std::get_if<CellChange>(&change);
    const auto* tuning = std::get_if<TuningChange>(&change);
    if (std::holds_alternative<SpawnsChange>(change) ||
        (tuning != nullptr && is_same_ground(tuning->before, tuning->after))) {
      bodies = true;
      return;
    }
    whole = whole || cell == nullptr || cells.size() >= kMostCells;
    if (cell != nullptr && !whole) cells.push_back(cell->cell);
  }
};

struct Session::Impl {
  // What loses the changes since the last save, and so is asked about first.
  using DiscardingAction =
      std::variant<action::NewLevel, action::OpenFile, action::RecoverLevel, action::Quit>;

  Impl(Level opened, std::string opened_path, std::string unsaved_name, ExportTools tools);

  // One for each action, in the order of actions.h.
  void carry_out(const action::EditLevel& a);
  void carry_out(const action::Undo&);
  void carry_out(const action::Redo&);
  void carry_out(const action::NewLevel& a) { ask_before_discarding(a); }
  void carry_out(const action::OpenFile& a);
  void carry_out(const action::SaveRecording& a);
  void carry_out(const action::SaveFile&) { save(); }
  void carry_out(const action::SaveFileAs& a);
  void carry_out(const action::ExportPng& a);
  void carry_out(const action::SetExportPath& a);
  void carry_out(const action::PreviewExport& a);
  void carry_out(const action::RunExports& a);
  void carry_out(const action::CancelExport&) { exporting.cancel(); }
  void carry_out(const action::OpenPng& a) { open_picture(a.path, {}); }
  void carry_out(const action::SetPngImport& a);
  void carry_out(const action::ApplyPngImport&);
  void carry_out(const action::CancelPngImport&) { png_import.reset(); }
  void carry_out(const action::SetLevelImport& a);
  void carry_out(const action::ApplyLevelImport&);
  void carry_out(const action::CancelLevelImport&) { level_import.reset(); }
  void carry_out(const action::Quit& a) { ask_before_discarding(a); }
  void carry_out(const action::AnswerQuestion& a);
  void carry_out(const action::CancelSaveAs&);
  void carry_out(const action::RecoverLevel& a) { ask_before_discarding(a); }
  void carry_out(const action::CancelReading&) { cancel_reading(); }
  void carry_out(const action::CheckFile&);
  void carry_out(const action::ShowMessage& a) { message = Message{a.text, a.is_error}; }
  void carry_out(const action::DismissMessage&) { message.reset(); }
  void carry_out(const action::Play&) { simulation.set_running(true); }
  void carry_out(const action::Pause&) { simulation.set_running(false); }
  void carry_out(const action::TogglePlay&) { simulation.set_running(!simulation.playback().running); }
  void carry_out(const action::StepFrame&);
  void carry_out(const action::ResetPlay&);
  void carry_out(const action::SetSpeed& a) { simulation.set_speed(a.factor); }
  void carry_out(const action::HoldMouse& a) { simulation.hold_mouse(a, choices.body); }
  void carry_out(const action::HoldKeys& a) { simulation.hold_keys(a); }
  void carry_out(const action::StepBack&) { seek(simulation.timeline().wanted_frame() - 1); }
  void carry_out(const action::SeekStart&) { seek(0); }
  void carry_out(const action::SeekEnd&) { seek(simulation.timeline().last_frame()); }
  void carry_out(const action::SeekFrame& a) { seek(a.frame); }
  void carry_out(const action::SetMark& a);
  void carry_out(const action::RemoveMark& a);
  void carry_out(const action::JumpToMark& a);
  void carry_out(const action::TakeOver&);
  void carry_out(const action::SwitchBranch& a);
  void carry_out(const action::DropBranch& a);
  void drop_branch(int branch);
  void carry_out(const action::CompareBranch& a) { simulation.timeline().compare_with(a.branch); }
  void carry_out(const action::SetInput& a);
  void carry_out(const action::SetMouse& a);
  void carry_out(const action::SetEditRule& a) { simulation.set_rule(a.rule); }
  void carry_out(const action::Rerun& a);
  void carry_out(const action::CancelRerun&) { simulation.timeline().cancel(); }
  void carry_out(const action::SetBreakpoint& a) { debugger.put(a.breakpoint); }
  void carry_out(const action::RemoveBreakpoint& a) { debugger.remove_breakpoint(a.breakpoint); }
  void carry_out(const action::RunToStop& a);
  void carry_out(const action::FindParting& a);
  void carry_out(const action::SetParting& a);
  void carry_out(const action::CancelSearch&) { debugger.cancel_search(); }
  void carry_out(const action::SetWatch& a) { debugger.put(a.index, a.watch); }
  void carry_out(const action::RemoveWatch& a) { debugger.remove_watch(a.index); }
  void carry_out(const action::CompareVariant& a) { debugger.compare_with(a.variant); }
  void carry_out(const action::FindReach&);
  void carry_out(const action::CancelReach&) { reach.cancel(); }
  void carry_out(const action::ShowWay& a);
  void carry_out(const action::SetLintOptions& a);
  void carry_out(const action::SelectBody& a);
  void carry_out(const action::SelectSpawn& a);
  void carry_out(const action::SelectCurve& a) { choices.curve = a.curve; }
  void carry_out(const action::SetCurveKind& a) { choices.curve_kind = a.kind; }
  void carry_out(const action::SelectTiles& a);
  void carry_out(const action::SetStamp& a) { choices.stamp = a.stamp; }
  void carry_out(const action::SetRandomStamp& a) {
    choices.random_stamp = a.on;
    choices.random_seed = a.seed;
  }
  void carry_out(const action::SelectCells& a);
  void carry_out(const action::SetPasted& a) { choices.pasted = a.tiles; }
  void carry_out(const action::SetMapTool& a) {
    choices.map_tool = a.tool;
    choices.pasted.reset();
  }
  void carry_out(const action::SetSpriteTool& a);
  void carry_out(const action::SetBrush& a);
  void carry_out(const action::SelectPixels& a);
  void carry_out(const action::MovePixels& a);
  void carry_out(const action::TurnPixels& a);
  void carry_out(const action::PastePixels& a);
  void carry_out(const action::SetColor& a) {
    (a.secondary ? choices.secondary_color : choices.color) = a.color;
  }
  void carry_out(const action::SetOverlay& a) { choices.overlays.set(a.overlay, a.on); }
  void carry_out(const action::SetFlagOverlay& a) { choices.flag_overlay = a.pattern; }
  void carry_out(const action::SetOverlayPalette& a) { choices.overlay_palette = a.palette; }
  void carry_out(const action::SetGrid& a) { choices.grid = a.on; }
  void carry_out(const action::SetScreenBorders& a) { choices.screen_borders = a.on; }

  void seek(std::int64_t frame);
  void advance(double seconds);
  void play(double seconds);  // until a breakpoint stops it
  void debug();               // goes on with what the debugger has to do
  void note_stop();           // it has stopped at debugger.stop()

  void edit_level(const Edit& wanted, int stroke);  // by whomever
  void note_change(const Edit& edit);               // to be called for each edit done, undone or redone
  // Brings the simulation up to the level, if it is behind; where a large level is compiled for that, later.
  void cut_selection();  // at the edges of a map that may have become smaller
  void refresh_scene();
  void load_player();                                   // with another level
  void take_compiled();                                 // the scene of a large level, when it is done
  void keep_chosen_body(FunctionRef<void()> renumber);  // across a change that may give bodies other ids

  std::string file_name() const;
  std::string file_names() const;
  // Whether the file, with its companion, holds all that is here.
  bool is_stored() const { return history.is_saved() && unstored.empty(); }
  void ask_before_discarding(DiscardingAction discarding);  // asks first if there are unsaved changes
  void ask_about_unstored();
  void go_on_when_stored();
  void answer_about_run(action::Answer answer);
  void ask_about_run(DiscardingAction discarding);  // the same of a run with the user's marks or inputs
  void note_input(FunctionRef<void()> change);      // of the current run, by hand
  void discard_and_do(const DiscardingAction& discarding);
  // Reads beside the window what is not read at once. The level stays as it is until `work`'s answer is
  // called.
  void read_beside(const std::string& file, FileReader::Work work);
  void read_beside(const std::string& file, FileReader::Work work, std::chrono::milliseconds patience);
  void cancel_reading();
  void open(const action::OpenFile& file);
  // A picture is taken into the level that is open, and loses nothing. cart: what to do with a picture that
  // has a cart in it; nothing: it is a picture like others.
  void open_picture(const std::string& picture_path, const std::optional<action::OpenFile>& cart);
  void take_picture(const std::string& picture_path, FormatResult<PngPicture> picture);
  void take_opened(const action::OpenFile& file, OpenedFile opened);
  void open_imported(const std::string& file, LoadedLevel loaded);
  void open_recording(const std::string& file, const Recording& recording, const EndScenes& scenes);
  void read_hard_case();  // of the level as it was opened; shows its answer and plays its input
  void replace_level(Level opened, std::string opened_path, const Format* opened_format,
                     CompanionFile opened_companion = {});
  void recover(const action::RecoverLevel& saved);
  // file: the level as its own file has it. scenes: of the first recording.
  void take_recovered(const action::RecoverLevel& saved, FormatResult<LoadedLevel> file,
                      const EndScenes& scenes);
  void recover_runs(const std::vector<std::shared_ptr<const Recording>>& recordings, const EndScenes& scenes);
  // Notes what the level's file holds now, as what this session knows of it.
  void note_file();
  void take_file_change(FilesChange found);  // by another program; asks or tells what becomes of the level
  void reload();
  void take_reloaded(const FormatResult<LoadedLevel>& loaded);
  bool save();  // false when it failed or a name is needed first
  bool save_to(const std::string& saved_path, const Format& saved_format);
  void continue_pending();

  void export_on_save();
  void export_presets(FunctionRef<bool(std::size_t)> is_wanted, bool on_save);
  void take_exports();  // what the thread has done
  void ask_to_allow(FinishedRun finished);
  void forget_asked_exports();  // of another level
  void answer_to_allow(bool allowed);
  void ask_to_replace(FinishedRun finished);

  Level level;
  std::optional<HardCase> hard_case;
  UndoStack history;
  std::uint64_t revision = 0;
  int last_stroke = 0;  // the highest number of a stroke so far

  std::string name;  // for titles, while there is no file
  std::string path;  // empty: none
  int saves = 0;
  // Of the files as they were read, written or asked about last; none: no file.
  std::optional<LevelStamp> stamp;
  CompanionFile companion;            // that the level was read or written with last
  std::vector<std::string> unstored;  // what the file lacks of the saved level, one phrase each
  const Format* format = nullptr;     // that the file is in; null: none, or an unknown one

  Simulation simulation;
  Debugger debugger;
  bool plays_on = false;        // when the search that is under way finds nothing
  std::string nothing_found;    // what is said then, unless it plays on
  Trails trails, other_trails;  // of the timeline, and of a variant's
  SceneChanges scene_changes;
  SceneCompiler compiler;
  bool is_opening = false;  // the compiler is at the first scene of the level, until which time stands still
  Choices choices;

  std::optional<Message> message;
  std::optional<Question> question;
  std::optional<PngImport> png_import;
  std::optional<LevelImport> level_import;
  // Waits for the question's answer, or for the saving that it led to.
  std::optional<DiscardingAction> pending;
  int branch_to_drop = 0;  // id, waits for the question's answer
  HandmadeRuns handmade_runs;
  bool wants_save_as = false;
  bool wants_save_recording = false;
  bool wants_quit = false;
  int pixel_stroke = 0;  // of the selected pixels' moves, while they float

  void lint_some();   // spends a few ms on what of the level has not been looked at
  void find_reach();  // the same on the search for where a player gets to

  ExportPermissions permissions;
  std::string not_remembered;            // why not what was allowed, until that is told; empty: it is
  std::vector<ExportPreset> declined;    // not allowed when a save asked, which does not ask again
  std::optional<FinishedRun> asked_run;  // waits for the question's answer
  Exporting exporting;
  LintCache lint_cache;
  LintOptions lint_options;
  ReachFinder reach;

  int recoveries = 0;
  std::optional<LevelStamp> changed_from;  // `stamp` as it was before another program changed the file
  bool is_reloading = false;               // what is being read is that file
  FileReader reader;                       // last, as what it finishes is told to all of the above
};

}  // namespace talus
