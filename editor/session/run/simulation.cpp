// The simulation of the open level.
#include "simulation.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "sim/case_input.h"

namespace talus {
namespace {

bool holds_anything(const Input& input) {
  return input.mouse_down || input.left || input.right || input.jump;
}

}  // namespace

void Simulation::load(const Level& level) {
  timeline_.emplace(level);
  start();
}

void Simulation::load(const Recording& recording, const EndScenes& scenes) {
  timeline_.emplace(recording, scenes);
  start();
}

void Simulation::start() {
  timeline_->limit_way(1);
  set_running(false);
  playback_.input = {};
  held_.reset();
}

bool Simulation::edit(const Level& edited, const std::vector<Cell>* cells, ScenePtr compiled) {
  const bool reruns = rule_.kind != EditRule::Kind::go_on && timeline_->last_frame() > 0;
  bool has_room = true;
  if (reruns) {
    timeline_->edit_and_rerun(edited, cells, rule_.kind == EditRule::Kind::from_start ? 0 : rule_.frame,
                              std::move(compiled));
  } else {
    has_room = timeline_->edit(edited, cells, std::move(compiled));
  }
  if (timeline_->frame() == 0) playback_.input.grab = 0;  // bodies may have other numbers now
  show();
  return has_room;
}

void Simulation::reset() {
  timeline_->restart();
  playback_.input.grab = 0;
  due_ = 0;
  show();
}

void Simulation::set_running(bool running) {
  playback_.running = running;
  tapped_ = {};
  due_ = 0;
}

void Simulation::set_speed(double factor) {
  playback_.speed = factor >= kMinSpeed ? std::min(factor, kMaxSpeed) : kMinSpeed;
}

void Simulation::hold_mouse(const action::HoldMouse& mouse, int body) {
  Input& input = playback_.input;
  input.mouse = mouse.position;
  const bool was_down = std::exchange(input.mouse_down, mouse.down);
  if (!mouse.down) {
    input.grab = 0;
  } else if (!was_down) {
    input.grab = timeline_->state().find(body) != nullptr ? body : 0;
  }
  show_held();
}

void Simulation::show_held() {
  held_.reset();
  const Input& input = playback_.input;
  const State& state = timeline_->state();
  if (!input.mouse_down || state.grabbed == input.grab || state.find(input.grab) == nullptr) return;
  held_ = state;
  held_->grabbed = input.grab;
}

void Simulation::hold_keys(const action::HoldKeys& keys) {
  Input& input = playback_.input;
  input.left = keys.left;
  input.right = keys.right;
  input.jump = keys.jump;
  if (!playback_.running) return;
  tapped_ = added(
      tapped_, {.mouse = {}, .mouse_down = false, .left = keys.left, .right = keys.right, .jump = keys.jump});
}

void Simulation::step() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const Input live = added(std::exchange(tapped_, {}), playback_.input);
  if (timeline_->in_past() && !holds_anything(live)) {
    timeline_->replay();
  } else {
    timeline_->step(added(case_input(script_, timeline_->frame() + 1), live));
  }
  const std::chrono::duration<double, std::nano> passed = Clock::now() - start;
  step_times_.note(timeline_->frame(), passed.count());
  show_held();
}

void Simulation::seek(std::int64_t frame) {
  set_running(false);
  timeline_->seek(frame);
  show();
}

void Simulation::advance(double seconds, FunctionRef<bool()> may_step, FunctionRef<bool()> stops) {
  assert(seconds >= 0);
  if (timeline_->behind()) return run_again();
  if (timeline_->on_the_way()) return show();
  if (!playback_.running) return;
  due_ = std::min<double>(due_ + seconds * kStepsPerSecond * playback_.speed, kMaxCatchUpSteps);
  const Stopwatch watch;
  for (; due_ >= 1 && playback_.running && watch.seconds() < kPlaySeconds && may_step(); due_ -= 1) {
    step();
    if (stops()) set_running(false);
  }
  if (watch.seconds() >= kPlaySeconds) due_ -= std::floor(due_);  // slow steps make playing slower
}

void Simulation::run_again() {
  const Stopwatch watch;
  while (timeline_->behind() && watch.seconds() < kRerunSeconds) {
    const TimedPiece piece(rerun_share_);
    timeline_->catch_up(rerun_share_.count());
  }
  if (!timeline_->behind()) rerun_share_.begin_again();
  show();
}

void Simulation::show() {
  const Stopwatch watch;
  while (timeline_->on_the_way() && watch.seconds() < kWaySeconds) {
    const TimedPiece piece(way_share_);
    timeline_->go_on(way_share_.count());
  }
  if (!timeline_->on_the_way()) way_share_.begin_again();
  show_held();
}

}  // namespace talus
