// Session: one open level with its history, its running simulation and the user's choices. Only apply()
// changes it; panels see it const.
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <talus/formats/format.h>
#include <talus/sim/solver.h>
#include "actions.h"
#include "edit/undo_stack.h"
#include "level/hard_case.h"
#include "level/lint/lint.h"
#include "overlay/overlay_table.h"
#include "session/checks/reach_finder.h"
#include "session/choices/choices.h"
#include "session/debugger/debugger.h"
#include "session/editing/open_level.h"
#include "session/files/exporting.h"
#include "session/files/file_reader.h"
#include "session/files/level_import.h"
#include "session/files/map_list.h"
#include "session/files/png_import.h"
#include "session/files/tile_import.h"
#include "session/messages/message.h"
#include "session/run/playback.h"
#include "session/run/step_times.h"
#include "session/run/trail.h"

namespace talus {

class Prover;

// The session records whatever plays (see sim/timeline.h). At the end of the recording, playing and stepping
// append to it. At an earlier frame they show the next recorded frames, and append when they come to the end.
// If a key or the mouse button is held at an earlier frame, the user takes over: a new branch leaves the
// recording there. Taking over, editing under EditRule go_on and resetting keep the old branch until it is
// dropped, unless it has no frames. New frames are played on the current level; recorded ones are shown on
// the level of their time.
// While the recorded input is run again, in advance(), a few ms each time, time stands still. The shown frame
// is shown again as soon as it has been run.
class Session {
 public:
  // path: the file that the level was read from, in the format of its extension; empty: none. name: for
  // titles, while there is no file. tools: for exports.
  explicit Session(Level level = Level(), std::string path = {}, std::string name = kUnnamed,
                   ExportTools tools = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Carries actions out, in order. An edit is fitted to the current level (see rebase_edit). The simulation
  // sees the edit in the next step: bodies go on from where they are, except that at frame 0 they start anew
  // from the edited level. With a recording, edit_rule() may say otherwise.
  void apply(const Actions& actions);
  template <class A>  // one of Action's alternatives, or an Action
  requires(!std::same_as<A, Actions>) void apply(A action) {
    Actions one;
    one.push_back(std::move(action));
    apply(one);
  }
  // Lets `seconds` (>= 0) of real time pass: makes the due steps, at most kMaxCatchUpSteps; after a longer
  // pause the rest is dropped.
  void advance(double seconds);

  const Level& level() const;
  std::uint64_t revision() const;  // grows with every change of the level, also by undo and opening
  const SheetChanges& sheet_changes() const;
  const UndoStack& history() const;
  const std::string& path() const;  // empty when it has none
  std::string file_name() const;    // for titles: "demo.talus.json"
  std::string file_names() const;   // with its companion: "game.tic + game.tic.talus.json"
  bool modified() const;            // whether the level differs from its files
  // The level as its file had it when it was last read or written, never null, and how to read it so again.
  const std::shared_ptr<const Level>& stored_level() const;
  ImportChoices stored_choices() const;
  int saves() const;                             // how often a level has been written to its file
  const std::vector<Problem>& problems() const;  // lint of the current level
  // The same, as far as advance() has checked since the last change, with the old problems of the rest: for
  // callers that must not wait.
  const std::vector<Problem>& listed_problems() const;
  bool is_linting() const;       // whether they are not all of the current level's
  double lint_progress() const;  // the checked share of the level, 0 to 1
  const LintOptions& lint_options() const;
  // What the problems are of: the level, or the ground of its layers.
  const Level& linted_level() const;
  const std::optional<HardCase>& hard_case() const;  // of the opened level, whose input is played, too

  // About the shown frame: the last played one, unless an earlier one is visited.
  const Scene& scene() const;        // of the level at that frame
  const State& state() const;        // the mouse holds a body in it as soon as its button is down on one
  const StepRecord& record() const;  // of the step that led to it; empty at frame 0
  const Playback& playback() const;
  const Timeline& timeline() const;
  const EditRule& edit_rule() const;
  // Where a body was in the frames first..last of a branch, for a trail; see Trails. Valid until the next
  // call.
  const std::vector<TrailPoint>& trail(const Branch& branch, int body, std::int64_t first,
                                       std::int64_t last) const;
  const Choices& choices() const;
  // The branches with marks or inputs of the user's that no file has, the last changed one at the end.
  // Actions that lose them ask first. SaveRecording saves them.
  std::vector<const Branch*> unsaved_branches() const;
  std::uint64_t branches_revision() const;  // grows when the result may be another one

  // The debugger; apply() and advance() bring it up to what is shown.
  const Debugger& debugger() const;
  // Whether frames are still to be run for the shown picture: on the way to another frame, or for a trail.
  // advance(), and the next call, go on with that.
  bool is_on_the_way() const;
  // From now on the first call returns complete trails: for callers without a window.
  void take_time();
  // The ground of the shown frame's level, whatever the solver; see Debugger::ground().
  const std::shared_ptr<const Terrain>& ground() const;
  FrameView frame_view() const;              // the shown frame and those before it
  const std::vector<Stage>& stages() const;  // of the chosen body's step to the shown frame
  // Of the other side of a comparison; null: there is none, or it is not run yet.
  const State* other_state() const;
  const Frame* other_frame() const;  // the same with its step
  // As trail(), for a body of the other side.
  const std::vector<TrailPoint>& other_trail(int body, std::int64_t first, std::int64_t last) const;
  const StepTimes& step_times() const;
  const ReachFinder& reach() const;                  // where a player of the level gets to
  const Prover& prover() const;                      // whether bodies move over the level as its ground says
  const Exporting& exporting() const;                // what exports do, and the last preview of one
  ExportTask export_task(std::size_t preset) const;  // index of one of the level's presets
  // Whether it may be written without a question: see ExportPermissions.
  bool allows_export(std::size_t preset) const;
  const FinishedRun* asked_exports() const;  // what question() is about, if it is about exports; else null
  // How much of a large level that was edited or opened is compiled, 0..1; until it is, the simulation goes
  // on as before. Nothing: the simulation is up to date.
  std::optional<double> compile_progress() const;

  // A file that is being opened, recovered or read again, if that takes longer than an instant. Until it is
  // there, in advance(), the level stays as it was, and edits and saving do nothing.
  std::optional<ReadingProgress> reading() const;
  void finish_reading();   // waits for it; for callers without a window
  int recoveries() const;  // number of RecoverLevel actions that are finished

  const std::optional<Message>& message() const;  // stays until dismissed or replaced
  // Errors and offers that were replaced before they were dismissed, the oldest first.
  const std::vector<Message>& earlier_messages() const;
  const std::optional<Question>& question() const;     // waits for AnswerQuestion
  const std::optional<PngImport>& png_import() const;  // waits for ApplyPngImport or CancelPngImport
  // Waits for ApplyLevelImport or CancelLevelImport.
  const std::optional<LevelImport>& level_import() const;
  // A picture of tiles that waits for ApplyTiles or CancelTiles.
  const std::optional<TileImport>& tile_import() const;
  const MapList& maps() const;        // those to go through by OpenNextMap
  bool wants_save_as() const;         // waits for SaveFileAs or CancelSaveAs
  bool wants_save_recording() const;  // waits for SaveRecording or CancelSaveAs
  bool wants_quit() const;            // the program should end

  // Returns a number for a stroke that begins now, which no edit has yet. Call it once when a drag begins,
  // and use the number for each of its edits.
  int next_stroke() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talus
