// Shows frames and goes on from them. timeline_rerun.cpp runs again; timeline_branches.cpp has branches and
// recordings.
#include "timeline.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "frame_hash.h"

namespace talus {

bool& key_in(Input& input, InputKey key) {
  switch (key) {
    case InputKey::left:
      return input.left;
    case InputKey::right:
      return input.right;
    case InputKey::jump:
      return input.jump;
    case InputKey::mouse:
      return input.mouse_down;
  }
  return input.mouse_down;
}

Timeline::Timeline(VersionPtr first, ScenePtr scene, std::size_t keyframe_bytes, std::size_t version_bytes)
    : keyframes_(keyframe_bytes),
      version_bytes_(version_bytes),
      version_(std::move(first)),
      scene_(std::move(scene)) {
  if (scene_ != nullptr)
    scenes_.put(version_, scene_);
  else
    scene_ = scenes_.scene_of(version_);
  add_branch({});
  start_over();
}

Timeline::Timeline(const Level& level, std::size_t keyframe_bytes, std::size_t version_bytes)
    : Timeline(std::make_shared<const LevelVersion>(version_of(level)), nullptr, keyframe_bytes,
               version_bytes) {}

void Timeline::seek(std::int64_t frame) {
  wanted_ = std::clamp<std::int64_t>(frame, 0, last_frame());
  show_wanted();
}

void Timeline::show_wanted(std::int64_t most_steps) {
  const Branch& branch = current();
  cursor_.go_to(branch, std::min(wanted_, branch.run_frame()), &record_, most_steps);
}

void Timeline::go_on(std::int64_t most_steps) {
  if (on_the_way()) show_wanted(most_steps);
}

bool Timeline::replay() {
  if (frame() >= current().run_frame()) return false;
  cursor_.step(current(), &record_);
  wanted_ = frame();
  return true;
}

void Timeline::step(const Input& input, bool with_record) {
  if (in_past()) fork_at(frame());
  Branch& branch = now();
  if (branch.chapters.back().version != version_) begin_chapter();
  record_.clear();
  cursor_.step_by(input, with_record ? &record_ : nullptr);
  branch.inputs.push_back(input);
  branch.played_on = true;
  branch.hashes.push_back(frame_hash(state()));
  keep(branch, state(), false);
  wanted_ = frame();
}

bool Timeline::edit(const Level& level, const std::vector<Cell>* cells, ScenePtr compiled) {
  if (!set_level(level, cells, std::move(compiled))) return true;
  if (in_past()) fork_at(frame());
  if (has_room()) {
    begin_chapter();
    return true;
  }
  const int full = current_;
  restart();
  drop(full);
  return false;
}

bool Timeline::has_room() const {
  const std::vector<Chapter>& chapters = current().chapters;
  std::size_t bytes = frame() == 0 ? 0 : memory_of(*version_, chapters.back().version.get());
  for (const Chapter& chapter : chapters) bytes += chapter.bytes;
  return bytes <= version_bytes_;
}

// Whether the simulation sees a difference. Spawns count though they look the same to it: their order tells
// which body belongs to which after the next edit. So do the size of the map and the number of its layers,
// which later cells refer to.
bool Timeline::set_level(const Level& level, const std::vector<Cell>* cells, ScenePtr compiled) {
  const bool is_known = compiled != nullptr;
  ScenePtr scene = std::move(compiled);
  if (!is_known)
    scene = std::make_shared<const Scene>(cells != nullptr ? recompile_scene(*scene_, level, *cells)
                                                           : compile_scene(level));
  auto version = std::make_shared<const LevelVersion>(cells != nullptr ? version_of(level, *version_, *cells)
                                                                       : version_of(level, version_.get()));
  // A level that was compiled elsewhere is large, and shares nothing that would make the comparison quick.
  const auto size = [](const LevelVersion& v) {
    return std::tuple(v.layers.size(), v.layers.front().rows.size(), v.width);
  };
  if (!is_known && *scene == *scene_ && version->spawns == version_->spawns &&
      size(*version) == size(*version_))
    return false;
  version_ = std::move(version);
  scene_ = std::move(scene);
  scenes_.put(version_, scene_);
  return true;
}

// The current level holds from the shown frame on, which is the last one of the branch. Edits of one frame
// that leave the bodies alone make one chapter: the state after the last edit is the same without the others.
void Timeline::begin_chapter() {
  Branch& branch = now();
  if (frame() == 0) return start_over();
  const bool kept_bodies = cursor_.edit(version_);
  scouts_.forget();
  Chapter& last = branch.chapters.back();
  if (last.first == frame() && last.kept_bodies && *last.version->spawns == *version_->spawns) {
    last = {frame(), version_, kept_bodies, last.bytes + memory_of(*version_, last.version.get())};
  } else {
    branch.chapters.push_back({frame(), version_, kept_bodies, memory_of(*version_, last.version.get())});
  }
  ++branch.revision;
  branch.hashes.set(branch.hashes.size() - 1, frame_hash(state()));
  branch.keyframes.drop_from(frame());
  keep(branch, state(), true);
}

// The current branch then holds only frame 0 of the current level.
void Timeline::start_over() {
  Branch& branch = now();
  branch.chapters = {{0, version_, false}};
  run_again_after(branch, -1);
  show_wanted();
}

void Timeline::keep(Branch& branch, const State& state, bool is_edit) {
  keyframes_.offer(branch.keyframes, state, is_edit);
  for (bool keep_edits = true; keyframes_.over_budget(); keep_edits = false) {
    keyframes_.widen_stride();
    for (Branch& each : branches_) keyframes_.thin(each.keyframes, keep_edits);
    const bool none_left = std::all_of(branches_.begin(), branches_.end(),
                                       [](const Branch& each) { return each.keyframes.size() == 0; });
    if (none_left) return;
  }
}

bool Timeline::approach(const Branch& branch, std::int64_t frame) const {
  return scouts_.nearest(branch, frame).go_to(branch, frame, nullptr, 1);
}

State Timeline::state_at(const Branch& branch, std::int64_t frame) const {
  Runner& scout = scouts_.nearest(branch, frame);
  scout.go_to(branch, frame);
  return scout.state();
}

StepRecord Timeline::record_at(const Branch& branch, std::int64_t frame) const {
  StepRecord record;
  scouts_.nearest(branch, std::max<std::int64_t>(frame - 1, 0)).go_to(branch, frame, &record);
  return record;
}

void Timeline::walk(const Branch& branch, std::int64_t first, std::int64_t last, StepRecord* record,
                    Visit visit) const {
  assert(first >= 0 && first <= last && last <= branch.run_frame());
  const bool steps_there = record != nullptr && first > 0;
  Runner& scout = scouts_.nearest(branch, steps_there ? first - 1 : first);
  scout.go_to(branch, first, record);
  bool goes_on = visit(scout.state(), first > 0 ? record : nullptr);
  while (goes_on && scout.state().frame < last) {
    scout.step(branch, record);
    goes_on = visit(scout.state(), record);
  }
}

std::int64_t Timeline::steps_again() const {
  return cursor_.steps_again() + catching_up_.steps_again() + scouts_.steps_again();
}

}  // namespace talus
