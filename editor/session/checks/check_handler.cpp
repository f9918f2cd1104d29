// Session: what is likely wrong in the level, and where a player of it gets to.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "session/session_impl.h"

namespace talus {
namespace {

constexpr double kLintSeconds = 0.003;   // of real time that a call of advance() spends
constexpr double kReachSeconds = 0.006;  // the same

}  // namespace

void Session::Impl::carry_out(const action::SetLintOptions& a) {
  lint_options.seam = a.options.seam >= 0 ? std::min(a.options.seam, kMaxSeam) : 0;
  lint_cache.note_rest();
}

void Session::Impl::lint_some() {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::chrono::duration<double> most(kLintSeconds);
  lint_cache.advance(level, lint_options, [&] { return Clock::now() - start < most; });
}

void Session::Impl::carry_out(const action::FindReach&) {
  refresh_scene();
  if (compiler.is_busy()) {
    message = Message{"The level is still being compiled: look again when that is done.", true};
    return;
  }
  const Body* chosen = simulation.state().find(choices.body);
  const auto origin = chosen != nullptr ? std::optional(chosen->origin) : std::nullopt;
  if (const auto problem = reach.start(*simulation.timeline().level_scene(), origin)) {
    message = Message{*problem, true};
    return;
  }
  choices.overlays.set(OverlayId::reach, true);
}

void Session::Impl::carry_out(const action::ShowWay& a) {
  if (reach.found() == nullptr || reach.is_stale()) return;
  const std::vector<Input> way = reach.found()->way_to(a.cell);
  if (way.empty()) return;
  keep_chosen_body([&] {
    simulation.set_running(false);
    simulation.reset();
    for (std::size_t i = 0; i < way.size(); ++i) simulation.timeline().step(way[i], i + 1 == way.size());
    simulation.show();
  });
}

void Session::Impl::find_reach() { reach.advance(kReachSeconds); }

const std::vector<Problem>& Session::problems() const {
  impl_->lint_cache.finish(impl_->level, impl_->lint_options);
  return impl_->lint_cache.problems();
}

const std::vector<Problem>& Session::listed_problems() const { return impl_->lint_cache.problems(); }
bool Session::is_linting() const { return !impl_->lint_cache.is_done(); }
double Session::lint_progress() const { return impl_->lint_cache.progress(); }
const LintOptions& Session::lint_options() const { return impl_->lint_options; }
const ReachFinder& Session::reach() const { return impl_->reach; }

}  // namespace talus
