// ReachFinder: finds where a player gets to, a few ms at a time while the editor goes on.
#pragma once

#include <optional>
#include <string>

#include "session/run/work_share.h"
#include "sim/reach.h"

namespace talus {

class ReachFinder {
 public:
  // Starts again. scene: of the current level. origin: of the player to follow; if no player has it, the
  // first player is followed. Returns an error in one sentence if there is nothing to search.
  std::optional<std::string> start(const Scene& scene, std::optional<BodyOrigin> origin);
  // Searches for so many seconds of processor time, or until the search has ended.
  void advance(double seconds);
  void cancel() { running_ = false; }
  void note_change();  // the level has changed: the result is out of date, and the search ends
  void forget();

  const ReachSearch* found() const { return search_ ? &*search_ : nullptr; }  // null: there was no search
  bool running() const { return running_; }
  bool is_stale() const { return is_stale_; }  // whether the level has changed since the search began
  // Number of other bodies in the level, which the search leaves out.
  int others() const { return others_; }

 private:
  std::optional<ReachSearch> search_;
  bool running_ = false;
  bool is_stale_ = false;
  int others_ = 0;
  WorkShare share_{64, 0.002};  // states
};

}  // namespace talus
