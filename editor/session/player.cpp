// The simulation of the open level.
#include "player.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "level/followed_spawn.h"
#include "sim/case_input.h"

namespace talus {

void Player::load(const Level& level) {
  compile(compile_scene(level));
  spawns_ = level.spawns;
  set_running(false);
  playback_.input = {};
  reset();
}

void Player::recompile(const Level& edited) { go_on_in(compile_scene(edited)); }

void Player::recompile(const Level& edited, std::span<const Cell> changed) {
  go_on_in(recompile_scene(*scene_, edited, changed));
}

void Player::follow_spawns(const std::vector<Spawn>& edited) {
  if (edited == spawns_) return;
  std::erase_if(state_.bodies, [&](Body& body) {
    if (body.origin.spawn < 0) return false;
    const auto now = followed_spawn(spawns_, edited, body.origin.spawn);
    body.origin.spawn = now.value_or(-1);
    return !now;
  });
  spawns_ = edited;
}

void Player::go_on_in(Scene scene) {
  if (scene == *scene_) return;
  compile(std::move(scene));
  state_ = state_.frame == 0 ? initial_state(*scene_) : carry_over(state_, *scene_);
}

void Player::reset() {
  state_ = initial_state(*scene_);
  record_.clear();
  due_ = 0;
}

void Player::set_running(bool running) {
  playback_.running = running;
  tapped_ = {};
  due_ = 0;
}

void Player::set_speed(double factor) {
  playback_.speed = factor >= kMinSpeed ? std::min(factor, kMaxSpeed) : kMinSpeed;
}

void Player::hold_mouse(const action::HoldMouse& mouse, int body) {
  playback_.input.mouse = mouse.position;
  const bool was_down = std::exchange(playback_.input.mouse_down, mouse.down);
  if (mouse.down && !was_down && state_.find(body) != nullptr) {
    state_.grabbed = body;
    held_since_ = state_.frame;
  }
  const bool not_moved_yet = state_.frame == held_since_;
  if (!mouse.down && was_down && not_moved_yet) state_.grabbed = 0;  // nothing to throw it with
}

void Player::hold_keys(const action::HoldKeys& keys) {
  Input& input = playback_.input;
  input.left = keys.left;
  input.right = keys.right;
  input.jump = keys.jump;
  if (!playback_.running) return;
  tapped_ = added(
      tapped_, {.mouse = {}, .mouse_down = false, .left = keys.left, .right = keys.right, .jump = keys.jump});
}

void Player::step() {
  if (solver_ == nullptr) solver_ = make_solver(scene_);
  const Input live = added(std::exchange(tapped_, {}), playback_.input);
  solver_->step(state_, added(case_input(script_, state_.frame + 1), live), &record_);
}

void Player::advance(double seconds) {
  assert(seconds >= 0);
  if (!playback_.running) return;
  due_ = std::min<double>(due_ + seconds * kStepsPerSecond * playback_.speed, Session::kMaxCatchUpSteps);
  for (; due_ >= 1; due_ -= 1) step();
}

void Player::compile(Scene scene) {
  scene_ = std::make_shared<const Scene>(std::move(scene));
  solver_.reset();
}

}  // namespace talus
