// Session: one open level with its history, its running simulation and what the user has chosen. The only way
// to change it is apply(); panels see it const.
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
#include "lint/lint.h"
#include "overlay/overlay_id.h"
#include "session/checks/reach_finder.h"
#include "session/choices/choices.h"
#include "session/debugger/debugger.h"
#include "session/editing/open_level.h"
#include "session/files/exporting.h"
#include "session/files/file_reader.h"
#include "session/files/level_import.h"
#include "session/files/png_import.h"
#include "session/messages/message.h"
#include "session/run/playback.h"
#include "session/run/step_times.h"
#include "session/run/trail.h"

namespace talus {

// Whatever plays is recorded (see sim/timeline.h). Playing and stepping at the end of the recording append to
// it. At an earlier frame they show the next recorded ones, and append when they come to the end, unless a
// key or the mouse's button is held: then the user takes over, and a new branch leaves the recording there.
// Taking over, editing under EditRule go_on and resetting leave the old branch as it is, until it is dropped;
// one without any frame is not kept. What is played new is played on the level as it is now; what is recorded
// is shown on the level as it was.
//
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

  // Carries actions out, in order. An edit is fitted to the level as it is by then (see rebase_edit). What
  // the simulation sees of an edit is in the next step: bodies go on from where they are, except that at
  // frame 0 they start anew from the edited level. With a recording, edit_rule() may say otherwise.
  void apply(const Actions& actions);
  template <class A>  // one of Action's alternatives, or an Action
  requires(!std::same_as<A, Actions>) void apply(A action) {
    Actions one;
    one.push_back(std::move(action));
    apply(one);
  }
  // Lets `seconds` (>= 0) of real time pass: makes the steps that are due, at most kMaxCatchUpSteps; after a
  // longer pause the rest is dropped.
  void advance(double seconds);

  const Level& level() const;
  std::uint64_t revision() const;  // grows with every change of the level, undo and opening included
  const UndoStack& history() const;
  const std::string& path() const;               // empty when it has none
  std::string file_name() const;                 // for titles: "demo.talus.json"
  std::string file_names() const;                // with its companion: "game.tic + game.tic.talus.json"
  bool modified() const;                         // differs from what its files hold
  int saves() const;                             // how often a level has been written to its file
  const std::vector<Problem>& problems() const;  // lint of the level as it is
  // The same as far as advance() has come since the last change, and what was known before of the rest: for
  // those who must not wait.
  const std::vector<Problem>& listed_problems() const;
  bool is_linting() const;       // they are not all of the level as it is
  double lint_progress() const;  // how much of the level has been looked at, 0 to 1
  const LintOptions& lint_options() const;
  const std::optional<HardCase>& hard_case() const;  // that the opened level is, whose input is played too

  // Of the shown frame: the one that was played last, unless an earlier one is visited.
  const Scene& scene() const;        // of the level as it was there
  const State& state() const;        // the mouse holds a body in it as soon as its button is down on one
  const StepRecord& record() const;  // of the step that led there; empty at frame 0
  const Playback& playback() const;
  const Timeline& timeline() const;
  const EditRule& edit_rule() const;
  // Where a body was in the frames first..last of a branch, for a trail; see Trails. Until the next call.
  const std::vector<TrailPoint>& trail(const Branch& branch, int body, std::int64_t first,
                                       std::int64_t last) const;
  const Choices& choices() const;
  // The runs with marks or inputs of the user's that no file has, the one that was worked on last at the end.
  // What loses them asks first; they are saved by SaveRecording.
  std::vector<const Branch*> unsaved_runs() const;
  std::uint64_t runs_revision() const;  // grows when the answer may be another one

  // What stops, is watched and is compared; brought up to what is shown by apply() and advance().
  const Debugger& debugger() const;
  // Whether frames are still to be run to for what is shown: on the way to another frame, or of a trail. That
  // goes on with advance() and with the next look.
  bool is_on_the_way() const;
  // From now on trails are whole at the first look: where there is no window that waits for them.
  void take_time();
  // The ground of the shown frame's level, whatever the solver; see Debugger::ground().
  const std::shared_ptr<const Terrain>& ground() const;
  FrameView frame_view() const;              // the shown frame and those before it
  const std::vector<Stage>& stages() const;  // of the chosen body's step to the shown frame
  const State* other_state() const;          // of the other side of a comparison; null: none, or not yet run
  const Frame* other_frame() const;          // the same with its step
  // As trail(), of a body of the other side.
  const std::vector<TrailPoint>& other_trail(int body, std::int64_t first, std::int64_t last) const;
  const StepTimes& step_times() const;
  const ReachFinder& reach() const;                  // where a player of the level gets to
  const Exporting& exporting() const;                // what exports do, and the last preview of one
  ExportTask export_task(std::size_t preset) const;  // index of one of the level's presets
  // Whether it may be written without a question: see ExportPermissions.
  bool allows_export(std::size_t preset) const;
  const FinishedRun* asked_exports() const;  // what question() is about, where it is about exports; or null
  // How far a large level is compiled that was edited or opened, 0..1; until it is, the simulation goes on as
  // it was before. Nothing: it sees the level as it is.
  std::optional<double> compile_progress() const;

  // A file that is to be opened, recovered or read again, while that takes longer than an instant. Until it
  // is there, in advance(), the level is as it was, and edits and saving do nothing.
  std::optional<ReadingProgress> reading() const;
  void finish_reading();   // waits for it, for those without a window to keep going
  int recoveries() const;  // how many RecoverLevel have been carried out to their ends

  const std::optional<Message>& message() const;       // stays until dismissed or replaced
  const std::optional<Question>& question() const;     // waits for AnswerQuestion
  const std::optional<PngImport>& png_import() const;  // waits for ApplyPngImport or CancelPngImport
  // Waits for ApplyLevelImport or CancelLevelImport.
  const std::optional<LevelImport>& level_import() const;
  bool wants_save_as() const;         // waits for SaveFileAs or CancelSaveAs
  bool wants_save_recording() const;  // waits for SaveRecording or CancelSaveAs
  bool wants_quit() const;            // the program should end

  // A number for a stroke that begins now, unlike that of any edit before. Ask once when a drag begins, and
  // give the same number to each of its edits.
  int next_stroke() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace talus
