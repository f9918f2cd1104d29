// Simulation: plays the timeline of the open level in real time, with the input that the user holds.
#pragma once

#include <optional>

#include <talus/collision/function_ref.h>
#include "playback.h"
#include "run_actions.h"
#include "step_times.h"
#include "work_share.h"

namespace talus {

class Simulation {
 public:
  explicit Simulation(const Level& level) { load(level); }

  void load(const Level& level);  // opens another level: paused, at frame 0, with nothing recorded
  // The same with a recording, which is still to be run.
  void load(const Recording& recording, const EndScenes& scenes);
  // The same level was edited; see Timeline::edit, also for the result. The rule says what follows.
  bool edit(const Level& edited, const std::vector<Cell>* cells, ScenePtr compiled = nullptr);
  void set_rule(const EditRule& rule) { rule_ = rule; }
  void reset();  // a new branch from frame 0; keeps running if it ran

  // Input in each frame besides the user's; stays until it is set again.
  void set_script(std::vector<CaseInput> script) { script_ = std::move(script); }

  void set_running(bool running);
  void set_speed(double factor);  // clamped; NaN gives kMinSpeed
  // Input for the next steps. If the button goes down on a ball, `body` is its id (0: no body): it is held
  // from the next step on, even if the mouse is elsewhere by then.
  void hold_mouse(const action::HoldMouse& mouse, int body);
  // A key that is pressed and released between two steps of a running simulation counts in the next step.
  void hold_keys(const action::HoldKeys& keys);

  void step();                    // see Session
  void seek(std::int64_t frame);  // pauses
  // See Session::advance. may_step() is called before each step; false postpones it. stops() is called after
  // it; true pauses.
  void advance(double seconds, FunctionRef<bool()> may_step, FunctionRef<bool()> stops);

  // For changes that need neither time nor input; call show() afterwards.
  Timeline& timeline() { return *timeline_; }
  const Timeline& timeline() const { return *timeline_; }
  // Spends up to its share of time on the way to the frame that the timeline should show; advance() goes on.
  void show();

  const State& state() const { return held_ ? *held_ : timeline_->state(); }
  const Playback& playback() const { return playback_; }
  const EditRule& rule() const { return rule_; }
  const StepTimes& step_times() const { return step_times_; }

 private:
  // Processor time for a re-run, for the way to another frame, and for playing, in one call; a single step
  // may take longer.
  static constexpr double kRerunSeconds = 0.008, kWaySeconds = 0.03, kPlaySeconds = 0.1;

  void start();
  void run_again();
  void show_held();

  std::optional<Timeline> timeline_;  // always set
  std::optional<State> held_;  // the shown state, if the mouse holds a body that the next step will grab
  EditRule rule_;
  Playback playback_;
  std::vector<CaseInput> script_;  // by frame
  Input tapped_;                   // keys pressed at any time since the last step; only while running
  StepTimes step_times_;
  double due_ = 0;  // steps that are due but not made yet; below 1 after advance()
  WorkShare rerun_share_{16, 0.002}, way_share_{64, 0.004};  // frames
};

}  // namespace talus
