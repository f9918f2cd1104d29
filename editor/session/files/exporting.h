// Exporting: makes and writes exports beside the editor, on a thread.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "export/export_plan.h"
#include "export_permissions.h"
#include "export_record.h"

namespace talus {

// What the program lends to exports.
struct ExportTools {
  ReadAsset read_asset;     // called from another thread; none: exports that need a text end with an error
  std::string record = {};  // file of the ExportRecord; empty: it lasts as long as the session
  std::string permissions = {};  // file of the ExportPermissions; empty: the same
};

struct ExportTask {
  ExportPreset preset;
  std::string level_file;  // that its path is counted from; empty: none
  std::string clash = {};  // see clash_problem(); then it is not written
  ExportBounds bounds = {};
  friend bool operator==(const ExportTask&, const ExportTask&) = default;
};

// Of one of the level's presets.
ExportTask task_of_preset(const Level& level, std::size_t preset, const std::string& level_file,
                          const ExportPermissions& permissions);

// What an export gave, or would give.
struct ExportOutcome {
  ExportTask task;
  std::string output;  // see output_of(); empty: unknown
  std::vector<PlannedFile> files = {};
  std::vector<PlannedFile> kept = {};  // starters that stay as they are: see own_starters()
  // Those of the files that something else is in the place of than what an export wrote there.
  std::set<std::string> foreign = {};     // paths
  std::vector<std::string> dropped = {};  // as in Exported
  std::optional<std::size_t> code_bytes = {};
  std::optional<ExportProblem> problem = {};
  bool written = false;
};

struct ExportPreview {
  std::uint64_t revision = 0;  // of the level that it is of
  ExportOutcome outcome;
};

struct ExportRun {
  std::vector<ExportTask> tasks;
  std::shared_ptr<const Level> level;   // never null
  std::set<std::string> may_replace;    // paths of foreign files that the user gave up
  std::set<std::size_t> to_allow = {};  // of the tasks, those of presets that the user has not allowed yet
  bool on_save = false;                 // it came by itself, with saving the level
  std::uint64_t revision = 0;           // of the level
};

struct FinishedRun {
  ExportRun run;
  std::vector<ExportOutcome> outcomes;  // of its tasks, as far as it came
  bool cancelled = false;
  // What has to be asked before anything is written: whether presets are allowed, or whether foreign files
  // may be replaced.
  enum class Asks { nothing, to_allow, to_replace };
  Asks asks = Asks::nothing;
  std::string record_problem = {};  // of ExportRecord::save(); empty: none
};

// Of a run, which makes the files of all its tasks and then writes them, or of a preview.
struct ExportProgress {
  std::string name;                 // of the preset that it is at
  std::size_t task = 0, tasks = 1;  // number of that, from 0, and of all
  double share = 0;                 // of all that is done, 0..1
  double seconds = 0;               // since it began
  // Of that task, how many of how many; no files: they are being made.
  std::size_t files_done = 0, files = 0;
  std::size_t bytes_done = 0, bytes = 0;
};

class Exporting {
 public:
  explicit Exporting(ExportTools tools);
  ~Exporting();  // waits for a run to end
  Exporting(const Exporting&) = delete;
  Exporting& operator=(const Exporting&) = delete;

  // A level as exports get it: without its presets, which are no part of what is exported.
  static std::shared_ptr<const Level> snapshot(const Level& level);
  // Looks at what a task would write; once, in place of the preview before.
  void preview(const Level& level, std::uint64_t revision, ExportTask task);
  // Whether a preview would begin at once: of the same task, the one before has to end first, so that a level
  // that is being painted on is not copied in vain.
  bool takes_preview(const ExportTask& task) const;
  // Writes all tasks that have no problem, or nothing where one of them asks. Goes before a preview. While
  // another run is under way nothing happens: see running().
  void run(ExportRun run);
  // Ends the run: what it has not put in place yet stays as it was. Without a run, ends the preview.
  void cancel();
  // Takes what is done, and goes on with what waits. A run that has ended is returned once.
  std::optional<FinishedRun> advance();

  bool is_busy() const { return job_ != nullptr || next_run_ || next_preview_ || cancelled_; }
  bool running() const { return next_run_.has_value() || (job_ && job_->is_run && job_->wanted); }
  bool previewing() const { return next_preview_.has_value() || (job_ && !job_->is_run && job_->wanted); }
  std::optional<ExportProgress> progress() const;  // of the run that is under way
  std::optional<ExportProgress> preview_progress() const;
  const std::optional<ExportPreview>& preview() const { return preview_; }
  // Whether this is what the preview shows, will show when it is done, or would if it had not been cancelled.
  bool previews(std::uint64_t revision, const ExportTask& task) const;
  bool preview_cancelled() const {
    return cancelled_preview_.has_value();
  }                                                                         // the last one that was asked for
  const std::vector<ExportOutcome>& last_run() const { return last_run_; }  // empty: there was none

 private:
  struct NextPreview {
    std::shared_ptr<const Level> level;
    std::uint64_t revision = 0;
    ExportTask task;
  };
  // What a level's preview has made, to be written.
  struct Made {
    std::uint64_t revision = 0;
    ExportTask task;
    std::shared_ptr<const Exported> content;  // null: it was not kept
  };
  using Clock = std::chrono::steady_clock;
  // What the thread works with.
  struct Job {
    bool is_run = false;
    ExportRun run;  // of a preview: its one task
    ReadAsset read_asset;
    ExportRecord record;
    Clock::time_point start = Clock::now();
    std::atomic<bool> wanted = true, writing = false, done = false;
    std::atomic<double> made_share = 0;  // of the task that it is at
    std::atomic<std::size_t> task = 0, files_done = 0, files = 0, bytes_done = 0, bytes = 0;
    Made made;  // by an earlier preview; when it is done, what this one made
    // Written before `done`.
    std::vector<ExportOutcome> outcomes;
    FinishedRun::Asks asks = FinishedRun::Asks::nothing;
    std::string record_problem;
  };
  void start_next();
  static ExportProgress progress_of(const Job& job);
  static void carry_out(Job& job);
  static void fail(Job& job, const std::string& problem);
  static tl::expected<ExportPlan, ExportProblem> plan_of(Job& job, const ExportTask& task,
                                                         const std::string& output);
  static void keep_made(Job& job, ExportPlan plan);
  static FinishedRun::Asks question_of(const Job& job);
  static bool make(Job& job, std::vector<ExportPlan>& plans);
  static void write(Job& job, const std::vector<ExportPlan>& plans);

  ExportTools tools_;
  ExportRecord record_;
  std::unique_ptr<Job> job_;
  std::thread thread_;
  std::optional<FinishedRun> cancelled_;
  std::optional<ExportRun> next_run_;
  std::optional<NextPreview> next_preview_;
  std::optional<ExportPreview> preview_;
  std::optional<std::pair<std::uint64_t, ExportTask>> cancelled_preview_;  // of this level's revision
  Made made_;
  std::vector<ExportOutcome> last_run_;
};

}  // namespace talus
