// The dialog that offers what was saved by itself before a crash.
#pragma once

#include <optional>
#include <span>

#include "autosave.h"
#include "panels/ui/ui.h"

namespace talus {

class RecoveryDialog {
 public:
  enum class Choice { recover, discard };
  struct Answer {
    std::size_t index = 0;  // of the work
    Choice choice = Choice::recover;
  };
  // Draws it while ui.view.program.recovery_open. `reading`: what is to be offered is still read. `unsaved`:
  // the open level has unsaved changes, or a run that the user has worked on, so that nothing can take its
  // place.
  std::optional<Answer> draw(std::span<const SavedWork> works, bool reading, bool unsaved, Ui& ui);

 private:
  std::optional<Answer> draw_work(std::size_t index, const SavedWork& work, bool unsaved, Ui& ui);
  bool draw_discard(std::size_t index, Ui& ui);
  std::size_t chosen_ = 0;                  // the work that had the keys last: the letters are for it
  std::optional<std::size_t> asked_about_;  // the work that a second click throws away
};

}  // namespace talus
