// Decides what happens when.
#include "work_guard.h"

#include <algorithm>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace talus {
namespace {

constexpr std::uintmax_t kSmall = 1 << 20;  // bytes; so much work is offered at once
constexpr double kPollInterval = 0.05;      // s, while it is read
// Number of checks of the file after which it searches again for work that was left behind.
constexpr int kSecondOffer = 3;

// Sets the file aside, and says where it is.
std::string message_of_unread(const SavedWork& work) {
  const auto kept = Autosave::set_aside(work);
  if (!kept) return kept.error();
  const std::size_t count = work.unread_recordings.size();
  return "Recovered without " + (count == 1 ? "a recording" : std::to_string(count) + " recordings") +
         ", which cannot be read: " + work.unread_recordings.front() + ". What was saved is kept as " +
         *kept + ".";
}

}  // namespace

void WorkGuard::start(View& view) {
  look_for_works();
  wants_offer_ = true;
  offer(view);
}

void WorkGuard::look_for_works() {
  works_.clear();
  const auto read = [this, folder = autosave_.folder(),
                     own = autosave_.own_file()](const Progress& progress) {
    auto found = std::make_shared<std::vector<SavedWork>>(Autosave::left_behind_in(folder, own, progress));
    return FileReader::Finish([this, found] { works_ = std::move(*found); });
  };
  reader_.start("unsaved work", read,
                Autosave::bytes_in(autosave_.folder()) <= kSmall ? patience_.small : patience_.large);
}

void WorkGuard::offer(View& view) {
  if (reader_.is_busy() || !std::exchange(wants_offer_, false)) return;
  view.window.recovery_open = was_open_ = !works_.empty();
}

// A message says when a problem begins and ends; between them the status bar shows it.
bool WorkGuard::save_by_itself(Session& session, View& view, double now) {
  if (autosave_.follow(session, now)) {
    told_ = "Unsaved work cannot be saved automatically: " + *autosave_.problem() +
            ". It is tried again until it succeeds; the folder is " + autosave_.folder() + ".";
    session.apply(action::ShowMessage{told_, true});
  }
  const std::string problem = autosave_.problem().value_or("");
  const bool changed = std::exchange(view.window.autosave_problem, problem) != problem;
  if (changed && problem.empty() && session.message() && session.message()->text == told_)
    session.apply(session.modified()
                      ? Action(action::ShowMessage{"Unsaved work is saved automatically again.", false})
                      : Action(action::DismissMessage{}));
  return changed;
}

bool WorkGuard::follow(Session& session, View& view, double now, bool busy) {
  if (recovering_ && !session.reading()) finish_recovery(session, view);
  polled_ = now;
  const bool was_read = reader_.finish();
  offer(view);
  const bool changed = save_by_itself(session, view, now) || was_read;
  if (now < next_look_) return changed;
  next_look_ = now + kFileInterval;
  if (busy) return changed;
  // A process that was killed just before this one started may not have ended yet.
  const bool was_open = view.window.recovery_open;
  if (++looks_ == kSecondOffer && !was_open && works_.empty() && !reader_.is_busy()) start(view);
  const auto shown = [&] {
    return std::tuple(session.revision(), session.modified(),
                      session.message() ? session.message()->text : "", session.question().has_value());
  };
  const auto before = shown();
  session.apply(action::CheckFile{});
  return changed || before != shown() || view.window.recovery_open != was_open;
}

double WorkGuard::due() const {
  if (reader_.is_busy()) return polled_ + kPollInterval;
  return autosave_.due() ? std::min(next_look_, *autosave_.due()) : next_look_;
}

void WorkGuard::draw(Session& session, Ui& ui) {
  const bool open = ui.view.window.recovery_open;
  if (open && !was_open_) {
    wants_offer_ = false;
    look_for_works();
  }
  was_open_ = open;
  const auto answer = dialog_.draw(works_, reader_.is_busy(), session, ui);
  if (!answer) return;
  if (answer->choice == RecoveryDialog::Choice::recover) {
    recover(answer->index, session, ui.view);
  } else {
    if (const auto gone = Autosave::discard(works_[answer->index]); !gone)
      session.apply(action::ShowMessage{gone.error(), true});
    drop(answer->index);
    if (works_.empty()) ui.view.window.recovery_open = false;
  }
}

void WorkGuard::recover(std::size_t index, Session& session, View& view) {
  recovering_ = works_[index];
  recoveries_ = session.recoveries();
  drop(index);
  view.window.recovery_open = false;
  session.apply(action::RecoverLevel{recovering_->level, recovering_->path, recovering_->name,
                                     recovering_->recordings, recovering_->base, recovering_->choices});
  if (!session.reading()) finish_recovery(session, view);
}

// The old file is removed once the level is in this process's own file; if reading was cancelled, it stays.
void WorkGuard::finish_recovery(Session& session, View& view) {
  const SavedWork work = *std::exchange(recovering_, std::nullopt);
  if (session.recoveries() == recoveries_) return;
  const auto saved = autosave_.save_now(session);
  view.window.autosave_problem = autosave_.problem().value_or("");
  if (!saved)
    session.apply(action::ShowMessage{
        "Recovered, but not saved automatically again: " + saved.error() + ". " + work.file + " stays.",
        true});
  else if (!work.unread_recordings.empty())
    session.apply(action::ShowMessage{message_of_unread(work), true});
  else if (const auto gone = Autosave::discard(work); !gone)
    session.apply(action::ShowMessage{gone.error(), true});
}

void WorkGuard::keep(const Session& session) {
  if (session.modified() || !session.unsaved_branches().empty()) (void)autosave_.save_now(session);
}

void WorkGuard::end(const Session& session) {
  if (session.wants_quit()) autosave_.remove();
}

}  // namespace talus
