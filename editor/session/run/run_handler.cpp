// Plays, moves in the recording, and follows edits.
#include "run_handler.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <talus/level/limits.h>
#include "formats/native/hard_case_file.h"
#include "level/followed_spawn.h"
#include "level/ground_cells.h"
#include "level/object_ground.h"

namespace talus {

RunHandler::RunHandler(const OpenLevel& open, ChoiceHandler& choices, MessageHandler& messages)
    : open_(open), choices_(choices), messages_(messages), simulation_(open.level) {}

// --- Playing

template <>
void RunHandler::carry_out(const action::Play&) {
  simulation_.set_running(true);
}

template <>
void RunHandler::carry_out(const action::Pause&) {
  simulation_.set_running(false);
}

template <>
void RunHandler::carry_out(const action::TogglePlay&) {
  simulation_.set_running(!simulation_.playback().running);
}

template <>
void RunHandler::carry_out(const action::StepFrame&) {
  simulation_.set_running(false);
  refresh_scene();
  if (!is_opening_) simulation_.step();
}

template <>
void RunHandler::carry_out(const action::ResetPlay&) {
  refresh_scene();
  keep_chosen_body([&] { simulation_.reset(); });
}

template <>
void RunHandler::carry_out(const action::SetSpeed& a) {
  simulation_.set_speed(a.factor);
}

template <>
void RunHandler::carry_out(const action::HoldMouse& a) {
  simulation_.hold_mouse(a, choices_.choices().body);
}

template <>
void RunHandler::carry_out(const action::HoldKeys& a) {
  simulation_.hold_keys(a);
}

template <>
void RunHandler::carry_out(const action::SelectBody& a) {
  refresh_scene();
  choices_.choose_body(simulation_.state().find(a.id) != nullptr ? a.id : 0);
}

template <>
void RunHandler::carry_out(const action::SelectSpawn& a) {
  refresh_scene();
  choices_.choose_body(0);
  for (const Body& body : simulation_.state().bodies) {
    if (a.spawn >= 0 && body.origin.spawn == a.spawn) choices_.choose_body(body.id);
  }
}

// --- The timeline

template <>
void RunHandler::carry_out(const action::StepBack&) {
  seek(timeline().wanted_frame() - 1);
}

template <>
void RunHandler::carry_out(const action::SeekStart&) {
  seek(0);
}

template <>
void RunHandler::carry_out(const action::SeekEnd&) {
  seek(timeline().last_frame());
}

template <>
void RunHandler::carry_out(const action::SeekFrame& a) {
  seek(a.frame);
}

void RunHandler::seek(std::int64_t frame) {
  refresh_scene();
  simulation_.seek(frame);
}

template <>
void RunHandler::carry_out(const action::SetMark& a) {
  simulation_.timeline().set_mark(a.frame, a.name);
  handmade_branches_.note_marks(timeline().current().id, true);
}

template <>
void RunHandler::carry_out(const action::RemoveMark& a) {
  const std::size_t before = timeline().current().marks.size();
  simulation_.timeline().remove_mark(a.frame);
  const Branch& branch = timeline().current();
  if (branch.marks.size() != before) handmade_branches_.note_marks(branch.id, !branch.marks.empty());
}

template <>
void RunHandler::carry_out(const action::JumpToMark& a) {
  const std::vector<Mark>& marks = timeline().current().marks;
  const std::int64_t frame = timeline().wanted_frame();
  const auto next = std::find_if(marks.begin(), marks.end(), [&](const Mark& m) { return m.frame > frame; });
  if (a.forwards && next != marks.end()) return seek(next->frame);
  const auto before =
      std::find_if(marks.rbegin(), marks.rend(), [&](const Mark& m) { return m.frame < frame; });
  if (!a.forwards && before != marks.rend()) seek(before->frame);
}

template <>
void RunHandler::carry_out(const action::TakeOver&) {
  refresh_scene();
  simulation_.timeline().fork();
}

template <>
void RunHandler::carry_out(const action::SwitchBranch& a) {
  switch_to(a.branch);
}

void RunHandler::switch_to(int branch) {
  refresh_scene();
  keep_chosen_body([&] {
    simulation_.set_running(false);
    simulation_.timeline().switch_to(branch);
    simulation_.show();
  });
}

template <>
void RunHandler::carry_out(const action::DropBranch& a) {
  refresh_scene();
  const Branch* branch = timeline().find(a.branch);
  if (branch == nullptr || messages_.question()) return;
  if (branch->last_frame() == 0) return drop_branch(a.branch);
  messages_.ask(Question{"Drop branch " + std::to_string(a.branch) + " with " +
                             std::to_string(branch->last_frame()) + " frames? This cannot be undone.",
                         Question::Kind::drop_branch},
                [this, branch = a.branch](action::Answer answer) {
                  if (answer == action::Answer::discard) drop_branch(branch);
                });
}

void RunHandler::drop_branch(int branch) {
  keep_chosen_body([&] {
    if (branch == timeline().current().id) simulation_.set_running(false);
    simulation_.timeline().drop(branch);
    handmade_branches_.note_gone(branch);
    simulation_.show();
  });
}

template <>
void RunHandler::carry_out(const action::CompareBranch& a) {
  simulation_.timeline().compare_with(a.branch);
}

template <>
void RunHandler::carry_out(const action::SetInput& a) {
  refresh_scene();
  note_input([&] { simulation_.timeline().set_input(a.first, a.last, a.key, a.on); });
}

template <>
void RunHandler::carry_out(const action::SetMouse& a) {
  if (!std::isfinite(a.position.x) || !std::isfinite(a.position.y)) return;
  refresh_scene();
  note_input([&] { simulation_.timeline().set_mouse(a.first, a.last, a.position); });
}

// Notes that an input was set by hand, unless it has changed nothing in the branch.
void RunHandler::note_input(FunctionRef<void()> change) {
  const auto shown = [this] {
    const Branch& branch = timeline().current();
    return std::pair(branch.id, branch.revision);
  };
  const auto before = shown();
  change();
  simulation_.show();
  if (shown() != before) handmade_branches_.note_input(shown().first);
}

template <>
void RunHandler::carry_out(const action::SetEditRule& a) {
  simulation_.set_rule(a.rule);
}

template <>
void RunHandler::carry_out(const action::Rerun& a) {
  refresh_scene();
  keep_chosen_body([&] {
    simulation_.timeline().begin_series();
    simulation_.timeline().rerun(a.from);
    simulation_.show();
  });
}

template <>
void RunHandler::carry_out(const action::CancelRerun&) {
  simulation_.timeline().cancel();
}

void RunHandler::apply(const RunAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

void RunHandler::play_new(const std::vector<Input>& inputs) {
  keep_chosen_body([&] {
    simulation_.set_running(false);
    simulation_.reset();
    make_steps(inputs);
  });
}

void RunHandler::make_steps(const std::vector<Input>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i)
    simulation_.timeline().step(inputs[i], i + 1 == inputs.size());
  simulation_.show();
}

void RunHandler::play_alone(const LoneBody& body, const std::vector<Input>& inputs, const std::string& mark) {
  Timeline& timeline = simulation_.timeline();
  simulation_.set_running(false);
  timeline.restart(body);
  make_steps(inputs);
  timeline.set_mark(timeline.last_frame(), mark);
  const auto kept = handmade_branches_.all();
  const Branch* const before = timeline.find(alone_);
  const bool is_used = before == nullptr || alone_ == timeline.current().id || before->marks.size() != 1 ||
                       before->marks.front().frame != before->last_frame() ||
                       std::find(kept.begin(), kept.end(), alone_) != kept.end();
  if (!is_used) timeline.drop(alone_);
  alone_ = timeline.current().id;
  choices_.choose_body(timeline.state().bodies.front().id);
}

void RunHandler::advance(double seconds, FunctionRef<bool()> may_step, FunctionRef<bool()> stops) {
  simulation_.advance(seconds, may_step, stops);
}

// A recording that was read must give the recorded frames; if it does not, the user should know where.
void RunHandler::note_rerun_ended() {
  handmade_branches_.note_rerun(timeline().current().id);
  if (const auto frame = timeline().unexpected_frame(timeline().current()))
    messages_.tell_error("Frame " + std::to_string(*frame) +
                         " differs from the recording; later frames may differ, too.");
}

// --- The level

void RunHandler::note_edit(const Edit& edit) {
  for (const Change& change : edit.changes) scene_changes_.add(open_.level, change);
}

void RunHandler::refresh_scene() {
  if (scene_changes_.empty() || (compiler_.is_busy() && !scene_changes_.whole)) return;
  const SceneChanges changes = std::exchange(scene_changes_, {});
  const bool takes_long = changes.whole || !can_change(*timeline().level_scene(), changes.cells);
  if (takes_long && SceneCompiler::is_large(open_.level)) return compiler_.start(open_.level);
  leave_compiler();
  ++scenes_;
  bool has_room = true;
  keep_chosen_body(
      [&] { has_room = simulation_.edit(open_.level, changes.whole ? nullptr : &changes.cells); });
  if (!has_room) {
    messages_.tell("A new branch begins, as the one before has edits of the level that take more than " +
                   std::to_string(kMaxVersionBytes >> 20) + " MiB.");
  }
}

// Whether a scene gets these cells of the level without being compiled as a whole. It cannot get new stacks
// of tiles in layers of ground.
bool RunHandler::can_change(const Scene& scene, std::span<const Cell> cells) const {
  if (cells.empty()) return true;
  const TileMap& map = open_.level.map;
  const auto is_of_map = [&](const auto& ground) {
    return ground == nullptr || (ground->width() == map.width() && ground->height() == map.height());
  };
  if (!is_of_map(scene.ground) || !is_of_map(scene.single_ground)) return false;  // as it was opened
  if (has_object_ground(open_.level)) return false;
  return std::all_of(cells.begin(), cells.end(),
                     [&](Cell cell) { return ground_number(open_.level, scene.stacks, cell).has_value(); });
}

void RunHandler::leave_compiler() {
  compiler_.cancel();
  is_opening_ = false;
}

// A large level is opened with its bodies alone; the compiled scene brings the map.
void RunHandler::load_simulation() {
  compiler_.cancel();
  is_opening_ = SceneCompiler::is_large(open_.level);
  if (!is_opening_) return simulation_.load(open_.level);
  Level bare;
  bare.map = TileMap(1, 1, open_.level.map.tile_size());
  bare.spawns = open_.level.spawns;
  bare.tuning = open_.level.tuning;
  simulation_.load(bare);
  compiler_.start(open_.level);
}

void RunHandler::take_compiled() {
  const auto compiled = compiler_.take();
  if (!compiled) return;
  is_opening_ = false;
  if (!compiled->scene) return messages_.tell_error("The level cannot be played: " + compiled->problem + ".");
  ++scenes_;
  keep_chosen_body([&] { simulation_.edit(*compiled->level, nullptr, compiled->scene); });
  refresh_scene();
}

std::optional<double> RunHandler::compile_progress() const {
  return compiler_.is_busy() ? std::optional(compiler_.progress()) : std::nullopt;
}

void RunHandler::load_level() {
  read_hard_case();
  load_simulation();
  handmade_branches_.clear();
  alone_ = 0;
  trails_ = other_trails_ = {};
  scene_changes_ = {};
}

void RunHandler::read_hard_case() {
  hard_case_ = hard_case_of(open_.level).value_or(std::nullopt);
  simulation_.set_script(hard_case_ ? hard_case_->input : std::vector<CaseInput>());
  if (hard_case_) choices_.show_overlay(overlay::answer, true);
}

void RunHandler::load(const Recording& recording, const EndScenes& scenes) {
  leave_compiler();
  alone_ = 0;
  simulation_.load(recording, scenes);
}

void RunHandler::recover(const std::vector<std::shared_ptr<const Recording>>& recordings,
                         const EndScenes& scenes) {
  load(*recordings.front(), scenes);
  handmade_branches_.note_input(timeline().current().id);
  for (std::size_t i = 1; i < recordings.size(); ++i)
    handmade_branches_.note_input(simulation_.timeline().add(*recordings[i]));
  scene_changes_ = {};
  scene_changes_.whole = true;
}

void RunHandler::keep_chosen_body(FunctionRef<void()> renumber) {
  const auto spawns = [this] {
    const Branch& branch = timeline().current();
    return branch.chapters[branch.chapter_at(timeline().frame())].version->spawns;
  };
  const Body* chosen = simulation_.state().find(choices_.choices().body);
  choices_.choose_body(0);
  if (chosen == nullptr) return renumber();
  BodyOrigin origin = chosen->origin;
  const auto before = spawns();
  renumber();
  if (origin.spawn >= 0) {
    const auto now = followed_spawn(*before, *spawns(), origin.spawn);
    if (!now) return;
    origin.spawn = *now;
  }
  for (const Body& body : simulation_.state().bodies) {
    if (body.origin == origin) choices_.choose_body(body.id);
  }
}

}  // namespace talus
