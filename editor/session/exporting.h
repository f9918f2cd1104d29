// Exporting: makes and writes exports beside the editor, on a thread.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "export/export_plan.h"
#include "export_record.h"

namespace talus {

// What the program lends to exports.
struct ExportTools {
  ReadAsset read_asset;  // called from another thread; none: exports that need a text end with an error
  std::string record;    // file of the ExportRecord; empty: it lasts as long as the session
};

struct ExportTask {
  ExportPreset preset;
  std::string level_file;  // that its path is counted from; empty: none
  friend bool operator==(const ExportTask&, const ExportTask&) = default;
};

// What an export gave, or would give.
struct ExportOutcome {
  ExportTask task;
  std::string output;  // see output_of(); empty: unknown
  std::vector<PlannedFile> files = {};
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
  std::shared_ptr<const Level> level;  // never null
  std::set<std::string> may_replace;   // paths of foreign files that the user gave up
  bool on_save = false;                // it came by itself, with saving the level
};

struct FinishedRun {
  ExportRun run;
  std::vector<ExportOutcome> outcomes;  // of its tasks, as far as it came
  bool cancelled = false;
  bool asks = false;  // nothing was written: files are foreign that it may not replace
};

struct ExportProgress {
  std::string name;                 // of the preset that it is at
  std::size_t task = 0, tasks = 1;  // number of that, from 0, and of all
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
  // Ends the run: what it has not put in place yet stays as it was.
  void cancel();
  // Takes what is done, and goes on with what waits. A run that has ended is returned once.
  std::optional<FinishedRun> advance();

  bool is_busy() const { return job_ != nullptr || next_run_ || next_preview_ || cancelled_; }
  bool running() const { return next_run_.has_value() || (job_ && job_->is_run && job_->wanted); }
  std::optional<ExportProgress> progress() const;  // of the run that is under way
  const std::optional<ExportPreview>& preview() const { return preview_; }
  // Whether this is what the preview shows, or will show when it is done.
  bool previews(std::uint64_t revision, const ExportTask& task) const;
  const std::vector<ExportOutcome>& last_run() const { return last_run_; }  // empty: there was none

 private:
  struct NextPreview {
    std::shared_ptr<const Level> level;
    std::uint64_t revision = 0;
    ExportTask task;
  };
  // All that a thread works with, so that one that is given up can go on to its end alone.
  struct Job {
    bool is_run = false;
    ExportRun run;               // of a preview: its one task
    std::uint64_t revision = 0;  // of a preview
    ReadAsset read_asset;
    ExportRecord record;
    std::atomic<bool> wanted = true, writing = false, done = false;
    std::atomic<std::size_t> task = 0, files_done = 0, files = 0, bytes_done = 0, bytes = 0;
    // Written before `done`.
    std::vector<ExportOutcome> outcomes;
    bool asks = false;
  };
  void start_next();
  bool give_up_job();
  static void carry_out(Job& job);
  static bool make(Job& job, std::vector<ExportPlan>& plans);
  static void write(Job& job, const std::vector<ExportPlan>& plans);

  ExportTools tools_;
  ExportRecord record_;
  std::shared_ptr<Job> job_;
  std::thread thread_;
  std::weak_ptr<Job> given_up_;  // still making files that nobody wants
  std::optional<FinishedRun> cancelled_;
  std::optional<ExportRun> next_run_;
  std::optional<NextPreview> next_preview_;
  std::optional<ExportPreview> preview_;
  std::vector<ExportOutcome> last_run_;
};

}  // namespace talus
