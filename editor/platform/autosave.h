// Autosave: writes the level away while it has unsaved changes, or runs that the user has worked on, so that
// a crash costs a few seconds at most, and finds what programs that ended without warning have left.
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

// What was saved of a level before the program that edited it ended, or a file that should hold such.
struct SavedWork {
  std::string file;                    // that holds it
  std::string path;                    // the level's own file; empty: none
  std::string name;                    // for titles
  std::int64_t time = 0;               // s since 1970, when it was saved
  std::shared_ptr<const Level> level;  // null: the file cannot be read, and `problem` tells why
  // Of the runs with marks or inputs of the user's, none null, the one that was worked on last at the end.
  std::vector<std::shared_ptr<const Recording>> recordings = {};
  std::string problem = {};  // "is damaged: of its level line 3: ..."; empty: it was read
};

// The error tells what of it and why: "the file cannot be written: No space left on device".
tl::expected<void, std::string> write_saved_work(const SavedWork& work);
// Of any size. The error is that of `problem`. progress: it ends early, with an error, where that says so.
tl::expected<SavedWork, std::string> read_saved_work(const std::string& file, const Progress& progress = {});

class Autosave {
 public:
  // Unsaved work is in a file within this time, s, and a moment for writing it.
  static constexpr double kDelay = 4.5;

  // folder: made when it is needed. Another process with the same one keeps files of its own.
  explicit Autosave(std::string folder);
  ~Autosave();  // waits for what is being written; what there is stays
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  // To be called often; now: s. Writes on a thread of its own, and again after a failure until it succeeds.
  // Returns problem() where there was none before.
  std::optional<std::string> follow(const Session& session, double now);
  // The same at once, waiting for it.
  tl::expected<void, std::string> save_now(const Session& session);
  // Why the last writing failed, as write_saved_work() tells it; nothing: it did not.
  const std::optional<std::string>& problem() const { return problem_; }
  bool is_writing() const {
    return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }
  const std::string& folder() const { return folder_; }
  std::string own_file() const { return lock_ >= 0 ? file_ : ""; }  // empty: there is none
  // When the next writing is due; nothing while all is written.
  std::optional<double> due() const;
  void remove();  // nothing is worth keeping any more

  // What ended processes have left, the latest first; of a running process nothing. What cannot be read is
  // left alone, and listed with its problem.
  std::vector<SavedWork> left_behind() const { return left_behind_in(folder_, own_file(), {}); }
  // The same for another thread. own: own_file(). progress: as read_saved_work(); some are left out then.
  static std::vector<SavedWork> left_behind_in(const std::string& folder, const std::string& own,
                                               const Progress& progress);
  // Of all files of a folder that left_behind_in() would look at; 0 where there are none.
  static std::uintmax_t bytes_in(const std::string& folder);
  // Of what left_behind() gave: it was taken over by this process, or is wanted no more. The error is one
  // sentence.
  static tl::expected<void, std::string> discard(const SavedWork& work);

 private:
  std::string folder_, file_;  // file_: of this process
  int lock_ = -1;              // descriptor
  struct Revision {
    std::uint64_t level = 0, runs = 0;
    friend bool operator==(const Revision&, const Revision&) = default;
  };
  static Revision revision_of(const Session& session) {
    return {session.revision(), session.runs_revision()};
  }

  // That tells others that this process runs.
  tl::expected<void, std::string> hold_lock();
  void write_when_due(const Session& session, double now);
  void finish_writing();
  void note(const tl::expected<void, std::string>& written, Revision revision);
  SavedWork work_of(const Session& session) const;

  std::optional<Revision> written_revision_;  // nothing: none is
  Revision writing_revision_;                 // of what the thread writes
  std::optional<double> changed_since_;       // s; or since the last writing failed
  std::optional<std::string> problem_;
  std::future<tl::expected<void, std::string>> writing_;
};

}  // namespace talus
