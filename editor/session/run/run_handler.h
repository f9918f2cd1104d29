// RunHandler: runs the open level: plays it, moves along its branches, and keeps them up to date with edits.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <talus/collision/function_ref.h>
#include "handmade_branches.h"
#include "level/hard_case.h"
#include "run_actions.h"
#include "scene_changes.h"
#include "scene_compiler.h"
#include "session/choices/choice_handler.h"
#include "session/messages/message_handler.h"
#include "simulation.h"
#include "trail.h"

namespace talus {

class RunHandler {
 public:
  RunHandler(const OpenLevel& open, ChoiceHandler& choices, MessageHandler& messages);

  void apply(const RunAction& action);

  const Simulation& simulation() const { return simulation_; }
  const Timeline& timeline() const { return simulation_.timeline(); }
  const HandmadeBranches& handmade_branches() const { return handmade_branches_; }
  const std::optional<HardCase>& hard_case() const { return hard_case_; }
  // Of the timeline, and of the variant.
  Trails& trails() { return trails_; }
  Trails& other_trails() { return other_trails_; }

  // --- Edits of the level
  void begin_series() { simulation_.timeline().begin_series(); }  // of edits
  void note_edit(const Edit& edit);  // call it for each edit that is done or undone
  // Updates the simulation if the level has changed. A large level is compiled first, so that takes effect
  // later.
  void refresh_scene();
  void take_compiled();                            // takes the scene of a large level when it is done
  int scenes() const { return scenes_; }           // grows when the level has another scene
  bool is_opening() const { return is_opening_; }  // time stands still until the level's first scene
  std::optional<double> compile_progress() const;  // 0..1; nothing: the simulation is up to date
  void load_level();                               // another one is open
  void read_hard_case();  // of the level as it was opened; shows its answer and plays its input
  // The level is the last one of the recording.
  void load(const Recording& recording, const EndScenes& scenes);
  // On the current level, which differs from the recordings' last ones if pixels were drawn later. None is
  // null. scenes: of the first one.
  void recover(const std::vector<std::shared_ptr<const Recording>>& recordings, const EndScenes& scenes);

  // --- For other actions
  void advance(double seconds, FunctionRef<bool()> may_step, FunctionRef<bool()> stops);  // as Simulation
  void note_rerun_ended();
  void set_running(bool running) { simulation_.set_running(running); }
  void show_frame(std::int64_t frame) { simulation_.seek(frame); }  // of the current scene
  void switch_to(int branch);
  void play_new(const std::vector<Input>& inputs);  // as a new branch, which ends there, paused
  // Plays a body alone as a new branch, which ends there, paused, with a mark of that name. Chooses the body.
  // The last such branch goes, unless the user went on with it.
  void play_alone(const LoneBody& body, const std::vector<Input>& inputs, const std::string& mark);
  void note_saved(int branch) { handmade_branches_.note_saved(branch); }
  void give_up(int branch) { handmade_branches_.note_gone(branch); }  // it is not worth keeping any more

 private:
  // For each action of RunAction, in run_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void seek(std::int64_t frame);
  void drop_branch(int branch);
  void note_input(FunctionRef<void()> change);          // of the current branch, by hand
  void keep_chosen_body(FunctionRef<void()> renumber);  // across a change that may give bodies other ids
  void load_simulation();
  void leave_compiler();  // the timeline brings a scene of its own
  void make_steps(const std::vector<Input>& inputs);
  bool can_change(const Scene& scene, std::span<const Cell> cells) const;

  const OpenLevel& open_;
  ChoiceHandler& choices_;
  MessageHandler& messages_;
  Simulation simulation_;
  Trails trails_, other_trails_;
  SceneChanges scene_changes_;
  SceneCompiler compiler_;
  bool is_opening_ = false;  // the compiler works on the first scene of the level
  int scenes_ = 0;
  int alone_ = 0;  // id of the last branch of play_alone()
  std::optional<HardCase> hard_case_;
  HandmadeBranches handmade_branches_;
};

}  // namespace talus
