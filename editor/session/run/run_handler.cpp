// Session: going about in what was recorded.
#include <algorithm>
#include <cmath>
#include <utility>

#include "session/session_impl.h"

namespace talus {

void Session::Impl::seek(std::int64_t frame) {
  refresh_scene();
  simulation.seek(frame);
}

void Session::Impl::carry_out(const action::JumpToMark& a) {
  const std::vector<Mark>& marks = simulation.timeline().current().marks;
  const std::int64_t frame = simulation.timeline().wanted_frame();
  const auto next = std::find_if(marks.begin(), marks.end(), [&](const Mark& m) { return m.frame > frame; });
  if (a.forwards && next != marks.end()) return seek(next->frame);
  const auto before =
      std::find_if(marks.rbegin(), marks.rend(), [&](const Mark& m) { return m.frame < frame; });
  if (!a.forwards && before != marks.rend()) seek(before->frame);
}

void Session::Impl::carry_out(const action::SetMark& a) {
  simulation.timeline().set_mark(a.frame, a.name);
  handmade_runs.note_marks(simulation.timeline().current().id, true);
}

void Session::Impl::carry_out(const action::RemoveMark& a) {
  const std::size_t before = simulation.timeline().current().marks.size();
  simulation.timeline().remove_mark(a.frame);
  const Branch& branch = simulation.timeline().current();
  if (branch.marks.size() != before) handmade_runs.note_marks(branch.id, !branch.marks.empty());
}

void Session::Impl::carry_out(const action::TakeOver&) {
  refresh_scene();
  simulation.timeline().fork();
}

void Session::Impl::carry_out(const action::SwitchBranch& a) {
  refresh_scene();
  keep_chosen_body([&] {
    simulation.set_running(false);
    simulation.timeline().switch_to(a.branch);
    simulation.show();
  });
}

void Session::Impl::carry_out(const action::DropBranch& a) {
  refresh_scene();
  const Branch* branch = simulation.timeline().find(a.branch);
  if (branch == nullptr || question) return;
  if (branch->last_frame() == 0) return drop_branch(a.branch);
  branch_to_drop = a.branch;
  question = Question{"Drop run " + std::to_string(a.branch) + " with " +
                          std::to_string(branch->last_frame()) + " frames? Nothing brings it back.",
                      Question::Kind::drop_branch};
}

void Session::Impl::drop_branch(int branch) {
  keep_chosen_body([&] {
    if (branch == simulation.timeline().current().id) simulation.set_running(false);
    simulation.timeline().drop(branch);
    handmade_runs.note_gone(branch);
    simulation.show();
  });
}

void Session::Impl::carry_out(const action::SetInput& a) {
  refresh_scene();
  note_input([&] { simulation.timeline().set_input(a.first, a.last, a.key, a.on); });
}

void Session::Impl::carry_out(const action::SetMouse& a) {
  if (!std::isfinite(a.position.x) || !std::isfinite(a.position.y)) return;
  refresh_scene();
  note_input([&] { simulation.timeline().set_mouse(a.first, a.last, a.position); });
}

// What was so before makes no run that is worth keeping.
void Session::Impl::note_input(FunctionRef<void()> change) {
  const auto shown = [this] {
    const Branch& branch = simulation.timeline().current();
    return std::pair(branch.id, branch.revision);
  };
  const auto before = shown();
  change();
  simulation.show();
  if (shown() != before) handmade_runs.note_input(shown().first);
}

void Session::Impl::carry_out(const action::Rerun& a) {
  refresh_scene();
  keep_chosen_body([&] {
    simulation.timeline().begin_series();
    simulation.timeline().rerun(a.from);
    simulation.show();
  });
}

// A recording that was read must come out as it was recorded, or its user should know where it does not.
void Session::Impl::advance(double seconds) {
  const bool was_behind = simulation.timeline().behind();
  reader.finish();
  trails.begin_turn();
  other_trails.begin_turn();
  take_compiled();
  if (!is_opening) play(seconds);
  debug();
  lint_some();
  find_reach();
  if (!question) take_exports();  // which may ask, too
  const Timeline& timeline = simulation.timeline();
  if (!was_behind || timeline.behind()) return;
  handmade_runs.note_run_again(timeline.current().id);
  if (const auto frame = timeline.unexpected_frame(timeline.current())) {
    message = Message{
        "Frame " + std::to_string(*frame) + " is not as it was recorded, nor may be later ones.", true};
  }
}

}  // namespace talus
