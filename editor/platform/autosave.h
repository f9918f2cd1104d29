// Autosave: writes the level to a file while it has unsaved changes, or branches that the user has worked on,
// so that a crash costs a few seconds at most. Nobody but the user can read these files, as the level may be
// private. It also finds the work of other processes that ended without
// warning.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "session/session.h"

namespace talus {

// What was saved of a level before its program ended, or a file that should hold this.
struct SavedWork {
  std::string file;                    // the file that holds it
  std::string path;                    // the level's own file; empty: it has none
  std::string name;                    // for titles
  std::int64_t time = 0;               // s since 1970, when it was saved
  std::shared_ptr<const Level> level;  // null: the file cannot be read, and `problem` says why
  // Branches with marks or inputs of the user's, never null; the one that was worked on last comes last.
  std::vector<std::shared_ptr<const Recording>> recordings = {};
  // Why recordings with it could not be read, a text each: "key frames: is missing". They are in `file`
  // alone.
  std::vector<std::string> unread_recordings = {};
  // The level as its own file had it, and how that was read; null: it has none, or this is unknown.
  std::shared_ptr<const Level> base = {};
  ImportChoices choices = {};  // for `base`
  std::string problem = {};    // "is damaged: of its level line 3: ..."; empty: it was read
};

// The error says what could not be written, and why: "the file cannot be written: No space left on device". A
// recording that no reader would accept is an error, too, but all else is written.
tl::expected<void, std::string> write_saved_work(const SavedWork& work);
// Reads a file of any size. A recording that cannot be read does not affect the rest. The error is as
// `problem`. progress: may stop the reading, which is an error.
tl::expected<SavedWork, std::string> read_saved_work(const std::string& file, const Progress& progress = {});

class Autosave {
 public:
  // s: unsaved work is in a file within this time, plus the time to write it.
  static constexpr double kDelay = 4.5;

  // folder: created when needed. Processes that share it have files of their own.
  explicit Autosave(std::string folder);
  ~Autosave();  // waits for a write that has begun; files stay
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  // Call it often; now: s. Writes on a thread of its own, and tries again after a failure until it succeeds.
  // Returns problem() when it newly fails.
  std::optional<std::string> follow(const Session& session, double now);
  // Writes at once, and waits for it.
  tl::expected<void, std::string> save_now(const Session& session);
  // Why the last writing failed, in the words of write_saved_work(); nothing: it succeeded.
  const std::optional<std::string>& problem() const { return problem_; }
  bool is_writing() const {
    return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }
  const std::string& folder() const { return folder_; }
  std::string own_file() const { return lock_ >= 0 ? file_ : ""; }  // empty: there is no file
  // The time of the next write; empty while everything is written.
  std::optional<double> due() const;
  void remove();  // call it when there is no work left to keep

  // Returns the work that ended processes have left, the latest first, but not that of running processes.
  // Files that cannot be read stay, and are listed with their problem.
  std::vector<SavedWork> left_behind() const { return left_behind_in(folder_, own_file(), {}); }
  // The same for another thread. own: own_file(). progress: as in read_saved_work(); a stop leaves some out.
  static std::vector<SavedWork> left_behind_in(const std::string& folder, const std::string& own,
                                               const Progress& progress);
  // The size of all files of a folder that left_behind_in() would read; 0 if there are none.
  static std::uintmax_t bytes_in(const std::string& folder);
  // Removes an entry of left_behind(), after this process took it over or the user discarded it. The error is
  // one sentence.
  static tl::expected<void, std::string> discard(const SavedWork& work);
  // The same if part of it could not be read: the file stays under another name, which is returned, and is
  // not offered any more.
  static tl::expected<std::string, std::string> set_aside(const SavedWork& work);

 private:
  std::string folder_, file_;  // file_: that of this process
  int lock_ = -1;              // descriptor
  struct Revision {
    std::uint64_t level = 0, branches = 0;
    friend bool operator==(const Revision&, const Revision&) = default;
  };
  static Revision revision_of(const Session& session) {
    return {session.revision(), session.branches_revision()};
  }

  // The lock shows other processes that this one runs.
  tl::expected<void, std::string> hold_lock();
  void write_when_due(const Session& session, double now);
  void finish_writing();
  void note(const tl::expected<void, std::string>& written, Revision revision);
  SavedWork work_of(const Session& session) const;

  std::optional<Revision> written_revision_;  // nothing: no revision is written
  Revision writing_revision_;                 // of what the thread is writing
  std::optional<double> changed_since_;       // s; since the first unsaved change, or since the last failure
  std::optional<std::string> problem_;
  std::future<tl::expected<void, std::string>> writing_;
};

}  // namespace talus
