// WorkGuard: keeps what the user made from being lost: saves it by itself, offers it after a crash, and looks
// whether other programs change the level's file.
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
  static constexpr double kFileInterval = 1;  // s, between two looks at the level's file

  explicit WorkGuard(std::string folder) : autosave_(std::move(folder)) {}

  // Offers what was left behind, if there is any: at once, or by a later call of follow() where it takes long
  // to read.
  void start(View& view);
  // To be called often; now: s. busy: the user is in the middle of a gesture, so that no question may come.
  // True when there is something new to show.
  bool follow(Session& session, View& view, double now, bool busy);
  // When follow() has something to do next, s.
  double due() const;
  void draw(Session& session, Ui& ui);
  void end(const Session& session);   // the program ends as it should
  void keep(const Session& session);  // it ends by an error: saves what is to be recovered

 private:
  void look_for_works();
  void offer(View& view);  // what start() wanted, once it is read
  bool save_by_itself(Session& session, View& view, double now);
  void recover(std::size_t index, Session& session, View& view);
  void finish_recovery(Session& session, View& view);
  void drop(std::size_t index) { works_.erase(works_.begin() + static_cast<std::ptrdiff_t>(index)); }

  Autosave autosave_;
  RecoveryDialog dialog_;
  std::vector<SavedWork> works_;         // offered
  bool wants_offer_ = false;             // as soon as they are read
  std::optional<SavedWork> recovering_;  // while its level's file is read
  int recoveries_ = 0;                   // of the session, before that
  std::string told_;                     // about the autosave's problem
  bool was_open_ = false;                // the dialog, when last looked at
  double next_look_ = 0;                 // s, at the file
  double polled_ = 0;                    // s, when follow() was called last
  int looks_ = 0;                        // at it so far
  FileReader reader_;                    // of `works_`, to which it tells what it has read: the last member
};

}  // namespace talus
