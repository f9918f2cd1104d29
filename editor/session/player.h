// Player: the simulation of the open level. Compiles it, steps it in real time and records each step.
#pragma once

#include <memory>
#include <span>

#include "session.h"

namespace talus {

class Player {
 public:
  explicit Player(const Level& level) { load(level); }

  void load(const Level& level);        // another level: stopped, at frame 0
  void recompile(const Level& edited);  // the same level, edited: the state goes on, see Session::apply
  void recompile(const Level& edited,
                 std::span<const Cell> changed);  // edited in these cells of the map alone
  // Bodies keep to their spawns, wherever those are now in the list; those of spawns that are gone go too. To
  // be called before recompile().
  void follow_spawns(const std::vector<Spawn>& edited);
  void reset();  // frame 0 of the compiled level; keeps running if it ran

  // What is held in each frame besides what the user holds; stays until set again.
  void set_script(std::vector<CaseInput> script) { script_ = std::move(script); }

  void set_running(bool running);
  void set_speed(double factor);  // clamped; NaN gives kMinSpeed
  // Input for the steps to come. Where the button goes down on a ball, `body` is its id (0: none): it is held
  // from then on, though the mouse may be elsewhere by the next step.
  void hold_mouse(const action::HoldMouse& mouse, int body);
  // A key that is held and let go between two steps of a running simulation counts in the next one.
  void hold_keys(const action::HoldKeys& keys);

  void step();
  void advance(double seconds);  // see Session::advance

  const Scene& scene() const { return *scene_; }
  const State& state() const { return state_; }
  const StepRecord& record() const { return record_; }
  const Playback& playback() const { return playback_; }

 private:
  void compile(Scene scene);
  void go_on_in(Scene scene);

  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<Solver> solver_;  // null until a step needs it: painting while paused must not pay for it
  State state_;
  std::vector<Spawn> spawns_;  // that the origins of the bodies are numbers of
  StepRecord record_;
  Playback playback_;
  std::vector<CaseInput> script_;  // by frame
  Input tapped_;                   // keys held at any time since the last step; of a running simulation alone
  std::int64_t held_since_ = 0;    // frame in which the button went down
  double due_ = 0;  // steps that real time asks for and that are not made yet, below 1 after advance()
};

}  // namespace talus
