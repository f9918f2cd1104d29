// Timeline: runs recorded input again.
#include <algorithm>
#include <utility>

#include "frame_hash.h"
#include "timeline.h"

namespace talus {

void Timeline::edit_and_rerun(const Level& level, const std::vector<Cell>* cells, std::int64_t from,
                              ScenePtr compiled) {
  if (set_level(level, cells, std::move(compiled))) rerun(from);
}

void Timeline::rerun(std::int64_t from) {
  from = std::clamp<std::int64_t>(from, 0, last_frame());
  if (last_frame() == 0) return start_over();
  Branch& branch = draft(Draft::level, from);
  if (from == 0 && branch.alone == nullptr) renumber_grabs(branch);
  std::erase_if(branch.chapters, [&](const Chapter& chapter) { return chapter.first >= from; });
  branch.chapters.push_back({from, version_, false});
  run_again_after(branch, from - 1);
  show_wanted();
}

void Timeline::set_input(std::int64_t first, std::int64_t last, InputKey key, bool on) {
  change_inputs(first, last, [=](Input& input) { key_in(input, key) = on; });
}

void Timeline::set_mouse(std::int64_t first, std::int64_t last, Vec2 position) {
  change_inputs(first, last, [=](Input& input) { input.mouse = position; });
}

void Timeline::change_inputs(std::int64_t first, std::int64_t last, FunctionRef<void(Input&)> change) {
  first = std::max<std::int64_t>(first, 1);
  last = std::min(last, last_frame());
  const auto changed = [&](std::int64_t frame) {
    Input input = current().input(frame);
    change(input);
    return input;
  };
  while (first <= last && changed(first) == current().input(first)) ++first;
  if (first > last) return;
  Branch& branch = draft(Draft::input, first - 1);
  for (std::int64_t frame = first; frame <= last; ++frame)
    branch.inputs.set(static_cast<std::size_t>(frame - 1), changed(frame));
  run_again_after(branch, first - 1);
  show_wanted();
}

// The bodies of the current level may have other numbers: the mouse must hold the same body as before.
void Timeline::renumber_grabs(Branch& branch) {
  const VersionPtr before = branch.chapters.front().version;
  State old = initial_state(*scenes_.scene_of(before));
  old.frame = 1;  // so that its bodies keep their numbers
  const State carried = edited_state(std::move(old), *before, *version_, *scene_);
  const State now = initial_state(*scene_);
  const auto number_now = [&](int number) {
    const Body* body = carried.find(number);
    if (body == nullptr) return 0;
    const auto same = std::find_if(now.bodies.begin(), now.bodies.end(),
                                   [&](const Body& b) { return b.origin == body->origin; });
    return same == now.bodies.end() ? 0 : same->id;
  };
  for (std::size_t i = 0; i < branch.inputs.size(); ++i) {
    Input input = branch.inputs[i];
    if (input.grab == 0) continue;
    input.grab = number_now(input.grab);
    if (input != branch.inputs[i]) branch.inputs.set(i, input);
  }
}

void Timeline::begin_series() {
  if (current().played_on) now().draft = Draft::none;
}

// The current branch if it is such a draft; else a new draft of it. kept: the last frame that stays as it
// was.
Branch& Timeline::draft(Draft kind, std::int64_t kept) {
  const bool is_lost = kind == Draft::input && current().played_on;
  if (current().draft != kind || is_lost) {
    const int compared = current_;
    const std::int64_t wanted = wanted_;
    fork_at(last_frame());
    wanted_ = wanted;
    now().draft = kind;
    now().compared = compared;
  }
  Branch& branch = now();
  branch.fork = std::min(branch.fork, kept);
  return branch;
}

// Marks what comes after a frame as still to be run; after -1, everything.
void Timeline::run_again_after(Branch& branch, std::int64_t frame) {
  frame = std::min(frame, branch.run_frame());
  ++branch.revision;
  branch.hashes.cut(static_cast<std::size_t>(frame + 1));
  branch.keyframes.drop_from(frame + 1);
  branch.expected.cut(0);
  forget_positions();
  run_from_ = std::max<std::int64_t>(frame, 0);
  if (frame >= 0) return;
  const ScenePtr scene = scenes_.scene_of(branch.chapters.front().version, branch.alone);
  branch.hashes.push_back(frame_hash(start_state(*scene, branch.alone.get())));
}

double Timeline::progress() const {
  const Branch& branch = current();
  if (!branch.behind()) return 1;
  const auto all = static_cast<double>(branch.last_frame() - run_from_);
  return static_cast<double>(branch.run_frame() - run_from_) / all;
}

void Timeline::catch_up(std::int64_t most_steps) {
  Branch& branch = now();
  if (!branch.behind() || most_steps <= 0) return;
  catching_up_.go_to(branch, branch.run_frame());
  for (std::int64_t i = 0; i < most_steps && branch.behind(); ++i) {
    catching_up_.step(branch);
    const State& state = catching_up_.state();
    branch.hashes.push_back(frame_hash(state));
    keep(branch, state, branch.chapters[branch.chapter_at(state.frame)].first == state.frame);
  }
  if (frame() < wanted_) show_wanted();
}

void Timeline::cancel() {
  Branch& branch = now();
  if (!branch.behind()) return;
  const std::int64_t last = branch.run_frame();
  branch.inputs.cut(static_cast<std::size_t>(last));
  std::erase_if(branch.chapters, [&](const Chapter& chapter) { return chapter.first > last; });
  std::erase_if(branch.marks, [&](const Mark& mark) { return mark.frame > last; });
  seek(wanted_);
}

}  // namespace talus
