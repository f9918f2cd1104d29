// WorkGuard: keeps the user's work from being lost. It saves automatically, offers the work after a crash,
// and checks whether other programs change the level's file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "autosave.h"
#include "recovery_dialog.h"
#include "session/files/file_reader.h"

namespace talus {

class WorkGuard {
 public:
  static constexpr double kFileInterval = 0.5;  // s, between two looks at the level's files

  // patience: for the work that was left behind.
  WorkGuard(std::string folder, Patience patience) : autosave_(std::move(folder)), patience_(patience) {}

  // Offers work that was left behind, if there is any: at once, or in a later call of follow() if reading
  // takes long.
  void start(View& view);
  // Call it often; now: s. busy: the user is in the middle of a gesture, so no question may come. Returns
  // true if there is something new to show.
  bool follow(Session& session, View& view, double now, bool busy);
  // The time at which follow() next has something to do, s.
  double due() const;
  void draw(Session& session, Ui& ui);
  void end(const Session& session);   // the program ends normally
  void keep(const Session& session);  // the program ends by an error: saves what should be recovered

 private:
  void look_for_works();
  void offer(View& view);  // shows the dialog for start(), once the work is read
  bool save_by_itself(Session& session, View& view, double now);
  void recover(std::size_t index, Session& session, View& view);
  void finish_recovery(Session& session, View& view);
  void drop(std::size_t index) { works_.erase(works_.begin() + static_cast<std::ptrdiff_t>(index)); }

  Autosave autosave_;
  Patience patience_;
  RecoveryDialog dialog_;
  std::vector<SavedWork> works_;         // offered work
  bool wants_offer_ = false;             // offers it as soon as it is read
  std::optional<SavedWork> recovering_;  // while the file of its level is read
  int recoveries_ = 0;                   // number of recoveries of the session before that
  std::string told_;                     // the last shown problem of the autosave
  bool was_open_ = false;                // whether the dialog was open at the last look
  double next_look_ = 0;                 // s, of the next look at the file
  double polled_ = 0;                    // s, of the last call of follow()
  int looks_ = 0;                        // number of looks at the file so far
  FileReader reader_;                    // fills `works_`, so it is the last member
};

}  // namespace talus
