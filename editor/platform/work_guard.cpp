// What is to be done when.
#include "work_guard.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace talus {
namespace {

constexpr int kSecondOffer = 3;  // looks at the file, after which it looks again for what was left behind

}  // namespace

void WorkGuard::start(View& view) {
  works_ = autosave_.left_behind();
  view.program.recovery_open = was_open_ = !works_.empty();
}

bool WorkGuard::follow(Session& session, View& view, double now, bool busy) {
  const auto error = autosave_.follow(session, now);
  if (error) session.apply(action::ShowMessage{*error, true});
  if (now < next_look_) return error.has_value();
  next_look_ = now + kFileInterval;
  if (busy) return error.has_value();
  // A process that was killed just before this one started may have been ending still.
  const bool was_open = view.program.recovery_open;
  if (++looks_ == kSecondOffer && !was_open && works_.empty()) start(view);
  const auto shown = [&] {
    return std::tuple(session.revision(), session.modified(),
                      session.message() ? session.message()->text : "", session.question().has_value());
  };
  const auto before = shown();
  session.apply(action::CheckFile{});
  return error || before != shown() || view.program.recovery_open != was_open;
}

double WorkGuard::due() const {
  return autosave_.due() ? std::min(next_look_, *autosave_.due()) : next_look_;
}

void WorkGuard::draw(Session& session, Ui& ui) {
  const bool open = ui.view.program.recovery_open;
  if (open && !was_open_) works_ = autosave_.left_behind();
  was_open_ = open;
  const auto answer = dialog_.draw(works_, session.modified() || !session.unsaved_runs().empty(), ui);
  if (!answer) return;
  if (answer->choice == RecoveryDialog::Choice::recover) {
    recover(answer->index, session, ui.view);
  } else {
    Autosave::discard(works_[answer->index]);
    drop(answer->index);
    if (works_.empty()) ui.view.program.recovery_open = false;
  }
}

// The old file goes once the level is in this process's own.
void WorkGuard::recover(std::size_t index, Session& session, View& view) {
  const SavedWork work = works_[index];
  session.apply(action::RecoverLevel{work.level, work.path, work.name, work.recordings});
  drop(index);
  view.program.recovery_open = false;
  if (const auto saved = autosave_.save_now(session))
    Autosave::discard(work);
  else
    session.apply(action::ShowMessage{saved.error(), true});
}

void WorkGuard::keep(const Session& session) {
  if (session.modified() || !session.unsaved_runs().empty()) (void)autosave_.save_now(session);
}

void WorkGuard::end(const Session& session) {
  if (session.wants_quit()) autosave_.remove();
}

}  // namespace talus
