// Timeline: branches, marks and recordings.
#include <algorithm>
#include <utility>

#include "case_input.h"
#include "timeline.h"

namespace talus {
namespace {

RecordedInput recorded(const Input& input, std::int64_t frame) {
  RecordedInput entry;
  entry.frame = frame;
  entry.mouse = input.mouse;
  entry.mouse_down = input.mouse_down;
  entry.left = input.left;
  entry.right = input.right;
  entry.jump = input.jump;
  entry.grab = input.grab;
  return entry;
}

std::vector<std::uint64_t> list_of(const SharedLog<std::uint64_t>& hashes) {
  std::vector<std::uint64_t> list;
  list.reserve(hashes.size());
  for (std::size_t i = 0; i < hashes.size(); ++i) list.push_back(hashes[i]);
  return list;
}

Recording unhashed_recording(const Branch& branch, const Level& pictures, std::int64_t frames) {
  Recording recording;
  recording.level = pictures;
  put_version(*branch.chapters.front().version, recording.level);
  if (branch.alone != nullptr) recording.alone = *branch.alone;
  recording.frames = frames;
  for (std::int64_t frame = 1; frame <= frames; ++frame) {
    const Input& input = branch.input(frame);
    if (input != (frame == 1 ? Input() : branch.input(frame - 1)))
      recording.input.push_back(recorded(input, frame));
  }
  for (std::size_t i = 1; i < branch.chapters.size(); ++i) {
    const Chapter& chapter = branch.chapters[i];
    if (chapter.first <= frames) recording.edits.push_back({chapter.first, chapter.version});
  }
  for (const Mark& mark : branch.marks) {
    if (mark.frame <= frames) recording.marks.push_back(mark);
  }
  return recording;
}

}  // namespace

EndScenes compile_ends(const Recording& recording, const Progress& progress) {
  const auto compiled = [](const Level& level, const Progress& part) -> ScenePtr {
    auto scene = compile_scene(level, [&](double share) { return part.at(share); });
    return scene ? std::make_shared<const Scene>(*std::move(scene)) : nullptr;
  };
  const ScenePtr first = compiled(recording.level, progress.part(0, 0.5));
  if (first == nullptr || !progress.at(0.5)) return {};
  if (recording.edits.empty()) return {first, first};
  Level edited = recording.level;
  put_version(*recording.edits.back().version, edited);
  const ScenePtr last = compiled(edited, progress.part(0.5, 1));
  return last != nullptr ? EndScenes{first, last} : EndScenes{};
}

Timeline::Timeline(const Recording& recording, const EndScenes& scenes, std::size_t keyframe_bytes)
    : Timeline(std::make_shared<const LevelVersion>(version_of(recording.level)), scenes.first,
               keyframe_bytes) {
  take(recording, scenes.last);
}

int Timeline::add(const Recording& recording) {
  leave();
  version_ = std::make_shared<const LevelVersion>(version_of(recording.level));
  scene_ = scenes_.scene_of(version_);
  add_branch({});
  start_over();
  take(recording);
  return current_;
}

void Timeline::take(const Recording& recording, const ScenePtr& last) {
  if (recording.alone) begin_with(std::make_shared<const LoneBody>(*recording.alone));
  Branch& branch = now();
  for (const RecordedEdit& edit : recording.edits)
    branch.chapters.push_back({edit.frame, edit.version, false});
  version_ = branch.chapters.back().version;
  if (last != nullptr) scenes_.put(version_, last);
  scene_ = scenes_.scene_of(version_);
  auto next = recording.input.begin();
  Input input;
  for (std::int64_t frame = 1; frame <= recording.frames; ++frame) {
    if (next != recording.input.end() && next->frame == frame) input = input_of(*next++);
    branch.inputs.push_back(input);
  }
  for (const std::uint64_t hash : recording.hashes) branch.expected.push_back(hash);
  branch.marks = recording.marks;
}

Recording Timeline::recording(const Branch& branch, const Level& pictures) const {
  Recording recording = unhashed_recording(branch, pictures, branch.run_frame());
  recording.hashes = list_of(branch.hashes);
  return recording;
}

Recording Timeline::whole_recording(const Branch& branch, const Level& pictures) const {
  if (!branch.behind()) return recording(branch, pictures);
  Recording recording = unhashed_recording(branch, pictures, branch.last_frame());
  if (branch.expected.size() == branch.inputs.size() + 1) recording.hashes = list_of(branch.expected);
  return recording;
}

const Branch* Timeline::find(int id) const {
  const auto found =
      std::find_if(branches_.begin(), branches_.end(), [&](const Branch& branch) { return branch.id == id; });
  return found == branches_.end() ? nullptr : &*found;
}

Branch& Timeline::now() {
  return *std::find_if(branches_.begin(), branches_.end(),
                       [this](const Branch& branch) { return branch.id == current_; });
}

Branch& Timeline::add_branch(Branch branch) {
  branch.id = ++last_id_;
  current_ = branch.id;
  branches_.push_back(std::move(branch));
  return branches_.back();
}

int Timeline::fork() {
  if (last_frame() > 0) fork_at(frame());
  return current_;
}

// The copy shares everything up to the frame. The rest stays with the old branch.
void Timeline::fork_at(std::int64_t frame) {
  Branch branch = current();
  branch.parent = current_;
  branch.fork = frame;
  branch.draft = Draft::none;
  branch.played_on = false;
  branch.compared = 0;
  branch.inputs.cut(static_cast<std::size_t>(frame));
  branch.hashes.cut(static_cast<std::size_t>(frame + 1));
  branch.expected.cut(0);
  branch.keyframes.drop_from(frame + 1);
  std::erase_if(branch.chapters, [&](const Chapter& chapter) { return chapter.first > frame; });
  std::erase_if(branch.marks, [&](const Mark& mark) { return mark.frame > frame; });
  leave();
  add_branch(std::move(branch));
  if (this->frame() <= frame) {
    cursor_.change_branch(current_);
  } else {
    cursor_.forget();
  }
  wanted_ = std::min(frame, this->frame());
}

void Timeline::restart() {
  if (last_frame() > 0) fork_at(0);
  begin_with(nullptr);
}

void Timeline::restart(const LoneBody& alone) {
  if (last_frame() > 0) fork_at(0);
  begin_with(std::make_shared<const LoneBody>(alone));
}

// The current branch begins anew, with the bodies of the level or with one alone.
void Timeline::begin_with(LoneBodyPtr alone) {
  now().alone = std::move(alone);
  wanted_ = 0;
  start_over();
}

void Timeline::leave() {
  Branch& branch = now();
  branch.draft = Draft::none;
  if (branch.last_frame() == 0 && branch.marks.empty() && branches_.size() > 1)
    std::erase_if(branches_, [this](const Branch& each) { return each.id == current_; });
}

void Timeline::switch_to(int id) {
  if (find(id) == nullptr) return;
  if (id != current_) leave();
  current_ = id;
  now().draft = Draft::none;
  run_from_ = current().run_frame();
  seek(wanted_);
}

void Timeline::drop(int id) {
  if (find(id) == nullptr) return;
  if (branches_.size() == 1) {
    branches_.clear();
    add_branch({});
    wanted_ = 0;
    return start_over();
  }
  const Branch dropped = *find(id);
  std::erase_if(branches_, [&](const Branch& branch) { return branch.id == id; });
  for (Branch& branch : branches_) {
    if (branch.compared == id) branch.compared = 0;
  }
  if (id != current_) return;
  const int next = find(dropped.compared) != nullptr ? dropped.compared : dropped.parent;
  current_ = find(next) != nullptr ? next : branches_.back().id;
  switch_to(current_);
}

void Timeline::compare_with(int id) { now().compared = id != current_ && find(id) != nullptr ? id : 0; }

std::optional<std::int64_t> Timeline::parting_frame() const {
  const Branch* other = compared();
  if (other == nullptr) return std::nullopt;
  return current().hashes.first_difference(other->hashes);
}

std::optional<std::int64_t> Timeline::unexpected_frame(const Branch& branch) const {
  return branch.hashes.first_difference(branch.expected);
}

void Timeline::set_mark(std::int64_t frame, std::string name) {
  std::vector<Mark>& marks = now().marks;
  frame = std::clamp<std::int64_t>(frame, 0, last_frame());
  const auto at = std::lower_bound(marks.begin(), marks.end(), frame,
                                   [](const Mark& mark, std::int64_t f) { return mark.frame < f; });
  if (at != marks.end() && at->frame == frame) {
    at->name = std::move(name);
  } else {
    marks.insert(at, {frame, std::move(name)});
  }
}

void Timeline::remove_mark(std::int64_t frame) {
  std::erase_if(now().marks, [&](const Mark& mark) { return mark.frame == frame; });
}

void Timeline::forget_positions() {
  cursor_.forget();
  catching_up_.forget();
  scouts_.forget();
}

}  // namespace talus
