// ReachFinder: the search for where a player gets to, done a few ms at a time while the editor goes on.
#pragma once

#include <optional>
#include <string>

#include "session/run/work_share.h"
#include "sim/reach.h"

namespace talus {

class ReachFinder {
 public:
  // Begins anew. scene: of the level as it is. origin: of the player to be followed; of no player, or none:
  // the first one. The error is why there is nothing to look for, one sentence.
  std::optional<std::string> start(const Scene& scene, std::optional<BodyOrigin> origin);
  // Goes on for so many seconds of real time, or until it has ended.
  void advance(double seconds);
  void cancel() { running_ = false; }
  void note_change();  // the level is another now: what was found is out of date, and the search ends
  void forget();

  const ReachSearch* found() const { return search_ ? &*search_ : nullptr; }  // null: nothing was looked for
  bool running() const { return running_; }
  bool is_stale() const { return is_stale_; }  // the level was changed since it began
  // Other bodies of the level, which the search leaves out.
  int others() const { return others_; }

 private:
  std::optional<ReachSearch> search_;
  bool running_ = false;
  bool is_stale_ = false;
  int others_ = 0;
  WorkShare share_{64, 0.002};  // states
};

}  // namespace talus
