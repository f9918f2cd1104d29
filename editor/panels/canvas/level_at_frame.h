// LevelAtFrame: the level as it was at a frame, for views of a recording: its bodies move over the level of
// that time, not over what was painted since.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "session/session.h"

namespace talus {

class LevelAtFrame {
 public:
  // Looks up a frame of a branch. Costs nothing while that frame has the current level. Otherwise a copy of
  // the level is kept until a frame with another version is looked up, or the level is edited.
  void show(const Session& session, const Branch& branch, std::int64_t frame);

  // The rest is about the frame that was looked up last. Whether its level differs from the session's.
  bool is_other() const { return is_other_; }
  // The level to draw: the copy, or the session's.
  const Level& level(const Session& session) const { return is_other_ ? level_ : session.level(); }
  std::uint64_t number() const { return number_; }  // of the copy: grows when the copy changes
  // Cells with another tile than now, row by row; empty if the maps differ in size.
  const std::vector<Cell>& changed() const { return changed_; }
  // "Level as it was at this frame (other: 3 cells, tuning); edits go to the newest".
  const std::string& caption() const { return caption_; }

 private:
  void take(const Session& session);

  VersionPtr version_;          // null: no frame was looked up
  std::uint64_t revision_ = 0;  // of the session's level that the version was compared with
  bool is_other_ = false;
  std::uint64_t number_ = 0;
  Level level_;
  std::vector<Cell> changed_;
  std::string caption_;
};

}  // namespace talus
