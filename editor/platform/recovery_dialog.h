// The dialog that offers what was saved automatically before a crash.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "autosave.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// What the dialog says about a work below its name, a text a line.
std::vector<std::string> about_work(const SavedWork& work);

class RecoveryDialog {
 public:
  enum class Choice { recover, discard };
  struct Answer {
    std::size_t index = 0;  // of the entry
    Choice choice = Choice::recover;
  };
  // Draws the dialog while ui.view.window.recovery_open. `reading`: the offered work is still being read.
  // While the open level has unsaved changes, or a branch that the user has worked on, nothing may replace
  // it.
  std::optional<Answer> draw(std::span<const SavedWork> works, bool reading, const Session& session, Ui& ui);

 private:
  std::optional<Answer> draw_work(std::size_t index, const SavedWork& work, bool unsaved, Ui& ui);
  bool draw_discard(std::size_t index, Ui& ui);
  std::size_t chosen_ = 0;                  // the entry that had the keys last: the letters are for it
  std::optional<std::size_t> asked_about_;  // the entry that a second click discards
};

}  // namespace talus
