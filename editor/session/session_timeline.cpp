// Session: going about in what was recorded.
#include <algorithm>
#include <cmath>
#include <utility>

#include "session_impl.h"

namespace talus {

void Session::Impl::seek(std::int64_t frame) {
  refresh_scene();
  player.seek(frame);
}

void Session::Impl::carry_out(const action::JumpToMark& a) {
  const std::vector<Mark>& marks = player.timeline().current().marks;
  const std::int64_t frame = player.timeline().wanted_frame();
  const auto next = std::find_if(marks.begin(), marks.end(), [&](const Mark& m) { return m.frame > frame; });
  if (a.forwards && next != marks.end()) return seek(next->frame);
  const auto before =
      std::find_if(marks.rbegin(), marks.rend(), [&](const Mark& m) { return m.frame < frame; });
  if (!a.forwards && before != marks.rend()) seek(before->frame);
}

void Session::Impl::carry_out(const action::SetMark& a) {
  player.timeline().set_mark(a.frame, a.name);
  handmade_runs.note_marks(player.timeline().current().id, true);
}

void Session::Impl::carry_out(const action::RemoveMark& a) {
  const std::size_t before = player.timeline().current().marks.size();
  player.timeline().remove_mark(a.frame);
  const Branch& branch = player.timeline().current();
  if (branch.marks.size() != before) handmade_runs.note_marks(branch.id, !branch.marks.empty());
}

void Session::Impl::carry_out(const action::TakeOver&) {
  refresh_scene();
  player.timeline().fork();
}

void Session::Impl::carry_out(const action::SwitchBranch& a) {
  refresh_scene();
  keep_chosen_body([&] {
    player.set_running(false);
    player.timeline().switch_to(a.branch);
    player.show();
  });
}

void Session::Impl::carry_out(const action::DropBranch& a) {
  refresh_scene();
  const Branch* branch = player.timeline().find(a.branch);
  if (branch == nullptr || question) return;
  if (branch->last_frame() == 0) return drop_branch(a.branch);
  branch_to_drop = a.branch;
  question = Question{"Drop run " + std::to_string(a.branch) + " with " +
                          std::to_string(branch->last_frame()) + " frames? Nothing brings it back.",
                      Question::Kind::drop_branch};
}

void Session::Impl::drop_branch(int branch) {
  keep_chosen_body([&] {
    if (branch == player.timeline().current().id) player.set_running(false);
    player.timeline().drop(branch);
    handmade_runs.note_gone(branch);
    player.show();
  });
}

void Session::Impl::carry_out(const action::SetInput& a) {
  refresh_scene();
  note_input([&] { player.timeline().set_input(a.first, a.last, a.key, a.on); });
}

void Session::Impl::carry_out(const action::SetMouse& a) {
  if (!std::isfinite(a.position.x) || !std::isfinite(a.position.y)) return;
  refresh_scene();
  note_input([&] { player.timeline().set_mouse(a.first, a.last, a.position); });
}

// What was so before makes no run that is worth keeping.
void Session::Impl::note_input(FunctionRef<void()> change) {
  const auto shown = [this] {
    const Branch& branch = player.timeline().current();
    return std::pair(branch.id, branch.revision);
  };
  const auto before = shown();
  change();
  player.show();
  if (shown() != before) handmade_runs.note_input(shown().first);
}

void Session::Impl::carry_out(const action::Rerun& a) {
  refresh_scene();
  keep_chosen_body([&] {
    player.timeline().begin_series();
    player.timeline().rerun(a.from);
    player.show();
  });
}

// A recording that was read must come out as it was recorded, or its user should know where it does not.
void Session::Impl::advance(double seconds) {
  const bool was_behind = player.timeline().behind();
  reader.finish();
  trails.begin_turn();
  other_trails.begin_turn();
  take_compiled();
  if (!is_opening) play(seconds);
  debug();
  lint_some();
  find_reach();
  if (!question) take_exports();  // which may ask, too
  const Timeline& timeline = player.timeline();
  if (!was_behind || timeline.behind()) return;
  handmade_runs.note_run_again(timeline.current().id);
  if (const auto frame = timeline.unexpected_frame(timeline.current())) {
    message = Message{
        "Frame " + std::to_string(*frame) + " is not as it was recorded, nor may be later ones.", true};
  }
}

}  // namespace talus
