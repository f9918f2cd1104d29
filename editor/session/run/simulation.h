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

  void load(const Level& level);  // another level: stopped, at frame 0, with nothing recorded
  // The same with a recording, which is still to be run.
  void load(const Recording& recording, const EndScenes& scenes);
  // The same level, edited; see Timeline::edit, also for what is returned. What follows the rule says.
  bool edit(const Level& edited, const std::vector<Cell>* cells, ScenePtr compiled = nullptr);
  void set_rule(const EditRule& rule) { rule_ = rule; }
  void reset();  // a new run from frame 0; keeps running if it ran

  // What is held in each frame besides what the user holds; stays until set again.
  void set_script(std::vector<CaseInput> script) { script_ = std::move(script); }

  void set_running(bool running);
  void set_speed(double factor);  // clamped; NaN gives kMinSpeed
  // Input for the steps to come. Where the button goes down on a ball, `body` is its id (0: none): it is held
  // from the next step on, though the mouse may be elsewhere by then.
  void hold_mouse(const action::HoldMouse& mouse, int body);
  // A key that is held and let go between two steps of a running simulation counts in the next one.
  void hold_keys(const action::HoldKeys& keys);

  void step();                    // see Session
  void seek(std::int64_t frame);  // pauses
  // See Session::advance. may_step() is asked before each step; false puts it off. stops() is asked after it;
  // true pauses.
  void advance(double seconds, FunctionRef<bool()> may_step, FunctionRef<bool()> stops);

  // For what neither time nor the input is needed for; show() afterwards.
  Timeline& timeline() { return *timeline_; }
  const Timeline& timeline() const { return *timeline_; }
  // Spends up to its share of time on the way to the frame that the timeline is to show; advance() goes on.
  void show();

  const State& state() const { return held_ ? *held_ : timeline_->state(); }
  const Playback& playback() const { return playback_; }
  const EditRule& rule() const { return rule_; }
  const StepTimes& step_times() const { return step_times_; }

 private:
  // Of real time, that a call spends on a re-run, on the way to another frame, and on playing; one step may
  // take longer.
  static constexpr double kRerunSeconds = 0.008, kWaySeconds = 0.03, kPlaySeconds = 0.1;

  void start();
  void run_again();
  void show_held();

  std::optional<Timeline> timeline_;  // always there
  std::optional<State> held_;  // the state shown, if the mouse holds a body that the next step will take
  EditRule rule_;
  Playback playback_;
  std::vector<CaseInput> script_;  // by frame
  Input tapped_;                   // keys held at any time since the last step; of a running simulation alone
  StepTimes step_times_;
  double due_ = 0;  // steps that real time asks for and that are not made yet, below 1 after advance()
  WorkShare rerun_share_{16, 0.002}, way_share_{64, 0.004};  // frames
};

}  // namespace talus
