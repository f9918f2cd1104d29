// Timeline: a simulation that can be visited at any frame of its past. It records all that is played: the
// input of each step, the edits of the level, a hash of each frame, and some keyframes. Running a frame again
// gives its state and the record of its step.
//
// A timeline is a set of branches. One of them is current, and one of its frames is shown. Playing or editing
// goes on from the shown frame: at the end of the branch it extends the branch; before the end it makes a new
// one, and the old one stays until it is dropped.
//
// Running again (an edited level from a frame on, or with other input) makes a draft: a branch whose
// remaining input is still to be run, which catch_up() does a little at a time. Running a draft again changes
// it in place, so that a stroke of a hundred edits makes one branch; the branch that the first of them left
// stays as it was, for comparison. A draft is no longer one after a switch to another branch or to itself. A
// draft of an edited level does not serve for other input, nor one of other input for an edited level. Once
// frames were played on a draft, other input makes a new branch; so does the first level edit after
// begin_series(), as frames may be played within a stroke.
//
// Recording never changes a result: solvers step the same states, whether these are kept or not.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/collision/function_ref.h>
#include <talus/level/limits.h>
#include <talus/level/progress.h>
#include "runner.h"

namespace talus {

// A part of a frame's input that can be set: a key of the players, or the mouse button.
enum class InputKey { left, right, jump, mouse };
bool& key_in(Input& input, InputKey key);

// The scenes of the first and the last level of a recording; null: not compiled yet.
struct EndScenes {
  ScenePtr first, last;
};
// Compiles them beforehand, on a thread of its own, as large levels take long. progress: may stop the work;
// then both are null.
EndScenes compile_ends(const Recording& recording, const Progress& progress);

class Timeline {
 public:
  static constexpr std::size_t kKeyframeBytes = std::size_t{96} << 20;

  // keyframe_bytes: limit for the keyframes of all branches together. version_bytes: limit for the edited
  // levels of one branch; a recording may bring more.
  explicit Timeline(const Level& level, std::size_t keyframe_bytes = kKeyframeBytes,
                    std::size_t version_bytes = kMaxVersionBytes);
  // A timeline with one branch whose whole recording is still to be run. Its hashes are the expected ones.
  explicit Timeline(const Recording& recording, const EndScenes& scenes = {},
                    std::size_t keyframe_bytes = kKeyframeBytes);
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  // --- What is shown
  const State& state() const { return cursor_.state(); }
  const StepRecord& record() const { return record_; }     // of the step that led to it; empty at frame 0
  const Scene& scene() const { return *cursor_.scene(); }  // of the level at that frame
  const ScenePtr& shown_scene() const { return cursor_.scene(); }
  std::int64_t frame() const { return state().frame; }
  std::int64_t last_frame() const { return current().last_frame(); }
  bool in_past() const { return frame() < last_frame(); }

  // Shows another frame, clamped to those of the branch. A frame that is still to be run is shown after it
  // was run.
  void seek(std::int64_t frame);
  // Limits the steps that a call may make to show another frame, 1 or more; at first there is no limit. If it
  // needs more, a frame on the way is shown, and go_on() goes on.
  void limit_way(std::int64_t most_steps) { most_way_ = most_steps; }
  bool on_the_way() const { return frame() != std::min(wanted_, current().run_frame()); }
  void go_on(std::int64_t most_steps);                   // 1 or more; does nothing if it is there
  std::int64_t wanted_frame() const { return wanted_; }  // the frame that is shown, or will be
  // Shows the next recorded frame. Returns false, and does nothing, if there is none or it is still to be
  // run.
  bool replay();

  // --- Going on
  // with_record: whether record() is needed for this step; else it is empty until another frame is shown.
  void step(const Input& input, bool with_record = true);
  // The level was edited: playing goes on from here on the edited level. At frame 0 everything starts anew.
  // An edit that the simulation cannot see changes nothing. cells: the only cells that changed; spawns and
  // tuning may have changed, too; null: anything may have. compiled: the level's scene, if it is known.
  // Returns false if the branch's levels would have taken too much memory: then the branch is gone, and
  // another one begins at frame 0 of the edited level.
  bool edit(const Level& level, const std::vector<Cell>* cells = nullptr, ScenePtr compiled = nullptr);
  void restart();  // makes a new branch from frame 0 of the current level, with its bodies
  // The same with a body alone in the current level.
  void restart(const LoneBody& alone);

  // --- Running again; `from` is clamped to the branch
  // Runs again on the edited level, from a frame on; edits recorded after that frame are left out.
  void edit_and_rerun(const Level& level, const std::vector<Cell>* cells, std::int64_t from,
                      ScenePtr compiled = nullptr);
  void rerun(std::int64_t from);  // the same on the current level
  void begin_series();  // a new series of level edits: the next edit leaves what was played as it is
  // Sets whether a key is held in the steps that lead to the frames first..last, clamped to 1..last_frame().
  void set_input(std::int64_t first, std::int64_t last, InputKey key, bool on);
  void set_mouse(std::int64_t first, std::int64_t last,
                 Vec2 position);  // the same for the place of the mouse

  bool behind() const { return current().behind(); }
  double progress() const;                 // of what the current branch has to run, 0..1; 1: nothing is left
  void catch_up(std::int64_t most_steps);  // runs the current branch; does nothing if it is not behind
  void cancel();                           // the current branch ends at the last frame that was run

  // --- Branches, by id
  const std::vector<Branch>& branches() const { return branches_; }
  const Branch* find(int id) const;  // null if there is none
  const Branch& current() const { return *find(current_); }
  // Adds a recording as a branch, shows it, and returns its id. All of it is still to be run; its hashes are
  // the expected ones. The next step or re-run goes on from its last level.
  int add(const Recording& recording);
  int fork();  // leaves the current branch, unless it is empty, at the shown frame; returns the new id
  void switch_to(int id);     // shows the same frame, or the branch's last one; an unknown id changes nothing
  void drop(int id);          // empties the branch if it is the only one
  void compare_with(int id);  // shows the current branch with this one; 0, or an unknown id: with no other
  const Branch* compared() const { return find(current().compared); }
  // The first frame at which the hashes of the current and the compared branch differ, within what both have
  // run; nothing if there is none, or no compared branch.
  std::optional<std::int64_t> parting_frame() const;
  // The first frame of a branch that differs from the recording that it was read from.
  std::optional<std::int64_t> unexpected_frame(const Branch& branch) const;

  // --- Marks of the current branch
  void set_mark(std::int64_t frame, std::string name);  // clamped; renames a mark that is there
  void remove_mark(std::int64_t frame);

  // --- Looking elsewhere, without showing it. frame: the branch must have been run to it (asserted).
  // Goes a little towards a frame. Returns true when it is there: looking at that frame then needs no more
  // steps.
  bool approach(const Branch& branch, std::int64_t frame) const;
  State state_at(const Branch& branch, std::int64_t frame) const;
  StepRecord record_at(const Branch& branch, std::int64_t frame) const;
  // Calls visit for the frames first..last (asserted) in order, until it returns false. It gets the record of
  // the step that led there; null for frame 0, and without a record to fill. It must not look elsewhere.
  using Visit = FunctionRef<bool(const State& state, const StepRecord* record)>;
  void walk(const Branch& branch, std::int64_t first, std::int64_t last, StepRecord* record,
            Visit visit) const;

  // A branch as data, up to the last frame that was run. pictures: a level that gives it all that the physics
  // does not see.
  Recording recording(const Branch& branch, const Level& pictures) const;
  // The same with all of its input. If it is behind, it has the expected hashes, or none.
  Recording whole_recording(const Branch& branch, const Level& pictures) const;

  const ScenePtr& level_scene() const { return scene_; }  // of the current level
  const VersionPtr& level_version() const { return version_; }

  std::size_t keyframe_bytes() const { return keyframes_.bytes(); }
  // With up to a hundred bodies a seek takes at most this number of steps.
  std::int64_t keyframe_stride() const { return keyframes_.stride(); }
  std::int64_t steps_again() const;  // steps made so far to show, look at and re-run recorded frames

 private:
  // scene: of `first`; null: not compiled yet.
  Timeline(VersionPtr first, ScenePtr scene, std::size_t keyframe_bytes,
           std::size_t version_bytes = kMaxVersionBytes);

  Branch& now();                      // the current branch
  Branch& add_branch(Branch branch);  // makes it the current branch
  // In the current branch, which holds its frame 0. last: as EndScenes::last.
  void take(const Recording& recording, const ScenePtr& last = nullptr);
  void fork_at(std::int64_t frame);
  void leave();  // leaves the current branch, and drops it if it is empty
  void forget_positions();
  void show_wanted() { show_wanted(most_way_); }
  void show_wanted(std::int64_t most_steps);

  bool set_level(const Level& level, const std::vector<Cell>* cells, ScenePtr compiled);
  void begin_chapter();
  bool has_room() const;  // whether the current level fits in memory
  void start_over();
  void begin_with(LoneBodyPtr alone);
  Branch& draft(Draft kind, std::int64_t kept);
  void change_inputs(std::int64_t first, std::int64_t last, FunctionRef<void(Input&)> change);
  void renumber_grabs(Branch& branch);
  void run_again_after(Branch& branch, std::int64_t frame);
  void keep(Branch& branch, const State& state, bool is_edit);

  mutable SceneCache scenes_;  // a cache, as are the scouts: neither shows outside
  KeyframeStore keyframes_;
  std::size_t version_bytes_;
  VersionPtr version_;  // of the current level
  ScenePtr scene_;      // its
  std::vector<Branch> branches_;
  int current_ = 0;
  int last_id_ = 0;

  Runner cursor_{scenes_};
  StepRecord record_;
  std::int64_t wanted_ = 0;  // the frame to show as soon as it has been run
  std::int64_t most_way_ = Runner::kAllSteps;
  std::int64_t run_from_ = 0;        // where the re-run of the current branch began
  Runner catching_up_{scenes_};      // at the last frame of the current branch that was run
  mutable Runners scouts_{scenes_};  // look elsewhere
};

}  // namespace talus
