// Timeline: a simulation that can be visited at any frame of its past. Whatever is played is recorded: the
// input of each step, the edits of the level, a hash of each frame, and a keyframe here and there; every
// state and every record of a step follows from these by running it again.
//
// A timeline is a set of branches. One of them is the current one, and one of its frames is shown. What is
// played or edited goes on from the shown frame: at the end of the branch it is appended; earlier, it makes a
// new branch, and the old one stays until it is dropped.
//
// Running again (an edited level from a frame on, or with other input) makes a draft: a branch with the rest
// of its input still to be run, which catch_up() does, a little at a time. Running a draft again changes it
// in place, so that a stroke of a hundred edits makes one branch; the branch that the first of them left
// stays as it was, to be compared with. A draft ends being one when another branch, or itself, is switched
// to. A draft of an edited level is none for other input, nor one of other input for an edited level. Frames
// that were played on a draft are nobody's draft: other input makes a new branch then, and so does the first
// level edit after begin_series(), within whose strokes frames may be played.
//
// Recording never changes a result: solvers step the same states, whether anything is kept of them or not.
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

// What can be set in the input of a frame: a key of the players, or the mouse's button.
enum class InputKey { left, right, jump, mouse };
bool& key_in(Input& input, InputKey key);

// The scenes of the first and the last level of a recording; null: still to be compiled.
struct EndScenes {
  ScenePtr first, last;
};
// Compiles them beforehand, on a thread of its own, as those of large levels take long. progress: both are
// null where it says so.
EndScenes compile_ends(const Recording& recording, const Progress& progress);

class Timeline {
 public:
  static constexpr std::size_t kKeyframeBytes = std::size_t{96} << 20;

  // keyframe_bytes: the most that the keyframes of all branches take together. version_bytes: the most that
  // the levels of one branch take, as its level is edited; a recording may bring more.
  explicit Timeline(const Level& level, std::size_t keyframe_bytes = kKeyframeBytes,
                    std::size_t version_bytes = kMaxVersionBytes);
  // A timeline of one branch, behind by the whole recording. Its hashes are what is expected.
  explicit Timeline(const Recording& recording, const EndScenes& scenes = {},
                    std::size_t keyframe_bytes = kKeyframeBytes);
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  // --- What is shown
  const State& state() const { return cursor_.state(); }
  const StepRecord& record() const { return record_; }     // of the step that led there; empty at frame 0
  const Scene& scene() const { return *cursor_.scene(); }  // of the level as it was there
  const ScenePtr& shown_scene() const { return cursor_.scene(); }
  std::int64_t frame() const { return state().frame; }
  std::int64_t last_frame() const { return current().last_frame(); }
  bool in_past() const { return frame() < last_frame(); }

  // Shows another frame, clamped to those of the branch; one that is still to be run is shown once it is.
  void seek(std::int64_t frame);
  // How many steps a call makes at most to show another frame, 1 or more; at first there is no limit. Where
  // it takes more, a frame of the way there is shown, and go_on() goes on.
  void limit_way(std::int64_t most_steps) { most_way_ = most_steps; }
  bool on_the_way() const { return frame() != std::min(wanted_, current().run_frame()); }
  void go_on(std::int64_t most_steps);                   // 1 or more; does nothing when it is there
  std::int64_t wanted_frame() const { return wanted_; }  // that is shown, or on the way to which it is
  // Shows the next recorded frame; false, and nothing happens, when there is none or it is still to be run.
  bool replay();

  // --- Going on
  // with_record: whether record() is wanted of the step; else it is empty until another frame is shown.
  void step(const Input& input, bool with_record = true);
  // The level was edited, in these cells of the map alone if they are given: it goes on from here on the
  // edited one. At frame 0 everything starts anew from it. What the simulation cannot see changes nothing.
  // cells: besides them, spawns and tuning may have changed. compiled: the level's scene, if it is known.
  // False: the branch's levels would have taken too much memory, so that it is gone, and another one begins
  // at frame 0 of the edited level.
  bool edit(const Level& level, const std::vector<Cell>* cells = nullptr, ScenePtr compiled = nullptr);
  void restart();  // a new branch that begins at frame 0 of the level as it is now

  // --- Running again; `from` is clamped to the branch
  // On the edited level, from a frame on; the edits recorded after that frame are left out.
  void edit_and_rerun(const Level& level, const std::vector<Cell>* cells, std::int64_t from,
                      ScenePtr compiled = nullptr);
  void rerun(std::int64_t from);  // the same on the level as it is now
  void begin_series();            // of level edits; the next one leaves what was played as it is
  // With a key held or not in the steps that lead to the frames first..last, clamped to 1..last_frame().
  void set_input(std::int64_t first, std::int64_t last, InputKey key, bool on);
  void set_mouse(std::int64_t first, std::int64_t last, Vec2 position);  // the same with the mouse's place

  bool behind() const { return current().behind(); }
  double progress() const;                 // of what the current branch has to run, 0..1; 1: nothing
  void catch_up(std::int64_t most_steps);  // of the current branch; does nothing when it is not behind
  void cancel();                           // the current branch ends where it has been run to

  // --- Branches, by id
  const std::vector<Branch>& branches() const { return branches_; }
  const Branch* find(int id) const;  // null: there is none
  const Branch& current() const { return *find(current_); }
  // A branch of its own, shown now and behind by the whole recording, whose hashes are what is expected. What
  // is stepped or run again next goes on from its last level. The new id.
  int add(const Recording& recording);
  int fork();                 // leaves the current branch, unless it is empty, at the shown frame; the new id
  void switch_to(int id);     // shows the same frame, or its last; of no branch: nothing happens
  void drop(int id);          // of the last branch only what it holds
  void compare_with(int id);  // the current branch is shown with this one; 0, or no other branch: with none
  const Branch* compared() const { return find(current().compared); }
  // The first frame of the current and the compared branch whose hashes differ, as far as both have been run;
  // nothing: none, or there is no such branch.
  std::optional<std::int64_t> parting_frame() const;
  // The first frame of a branch that is not as the recording says from which it was read.
  std::optional<std::int64_t> unexpected_frame(const Branch& branch) const;

  // --- Marks of the current branch
  void set_mark(std::int64_t frame, std::string name);  // clamped; renames the one that is there
  void remove_mark(std::int64_t frame);

  // --- Looking elsewhere, without showing it. frame: that the branch has been run to (asserted).
  // Goes a step towards a frame. True: it is there, and what looks at that frame alone makes no steps more.
  bool approach(const Branch& branch, std::int64_t frame) const;
  State state_at(const Branch& branch, std::int64_t frame) const;
  StepRecord record_at(const Branch& branch, std::int64_t frame) const;
  // Calls visit for the frames first..last (asserted) in order, until it returns false. record: of the step
  // that led there, null for frame 0 and where `with_records` is false. visit must not look elsewhere itself.
  using Visit = FunctionRef<bool(const State& state, const StepRecord* record)>;
  void walk(const Branch& branch, std::int64_t first, std::int64_t last, bool with_records,
            Visit visit) const;

  // A branch as data, up to the frame it has been run to. pictures: a level that gives it all that the
  // physics does not see.
  Recording recording(const Branch& branch, const Level& pictures) const;
  // The same with all of its input: while it is behind with the hashes that are expected of it, or none.
  Recording whole_recording(const Branch& branch, const Level& pictures) const;

  const ScenePtr& level_scene() const { return scene_; }  // of the level as it is now
  const VersionPtr& level_version() const { return version_; }

  std::size_t keyframe_bytes() const { return keyframes_.bytes(); }
  // With up to a hundred bodies a seek takes no more steps than this.
  std::int64_t keyframe_stride() const { return keyframes_.stride(); }
  std::int64_t steps_again() const;  // made so far to show, look at and run again what was recorded

 private:
  // scene: of `first`; null: still to be compiled.
  Timeline(VersionPtr first, ScenePtr scene, std::size_t keyframe_bytes,
           std::size_t version_bytes = kMaxVersionBytes);

  Branch& now();                      // the current one
  Branch& add_branch(Branch branch);  // makes it the current one
  // In the current branch, which holds its frame 0. last: as EndScenes::last.
  void take(const Recording& recording, const ScenePtr& last = nullptr);
  void fork_at(std::int64_t frame);
  void leave();  // the current branch, which nobody misses if it is empty
  void forget_positions();
  void show_wanted() { show_wanted(most_way_); }
  void show_wanted(std::int64_t most_steps);

  bool set_level(const Level& level, const std::vector<Cell>* cells, ScenePtr compiled);
  void begin_chapter();
  bool has_room() const;  // for the level as it is now
  void start_over();
  Branch& draft(Draft kind, std::int64_t kept);
  void change_inputs(std::int64_t first, std::int64_t last, FunctionRef<void(Input&)> change);
  void renumber_grabs(Branch& branch);
  void run_again_after(Branch& branch, std::int64_t frame);
  void keep(Branch& branch, const State& state, bool is_edit);

  mutable SceneCache scenes_;  // a cache, as are the scouts: none shows
  KeyframeStore keyframes_;
  std::size_t version_bytes_;
  VersionPtr version_;  // of the level as it is now
  ScenePtr scene_;      // its
  std::vector<Branch> branches_;
  int current_ = 0;
  int last_id_ = 0;

  Runner cursor_{scenes_};
  StepRecord record_;
  std::int64_t wanted_ = 0;  // the frame to be shown as soon as it has been run
  std::int64_t most_way_ = Runner::kAllSteps;
  std::int64_t run_from_ = 0;        // where the current branch was begun to be run again
  Runner catching_up_{scenes_};      // at the end of what has been run of the current branch
  mutable Runners scouts_{scenes_};  // look elsewhere
};

}  // namespace talus
