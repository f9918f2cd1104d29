// Exporting: a thread makes and writes exports while the editor goes on.
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
#include "file_reader.h"

namespace talus {

// What the program provides for exports.
struct ExportTools {
  ReadAsset read_asset;     // called from another thread; empty: exports that need a text end with an error
  std::string record = {};  // file of the ExportRecord; empty: it lasts as long as the session
  std::string permissions = {};  // file of the ExportPermissions; empty: they last as long as the session
  std::string reads = {};        // file of the ReadPermissions; the same
  std::string mappings = {};     // file of the UnsavedMappings; the same
  Patience patience = {};        // when files are opened
};

struct ExportTask {
  ExportPreset preset;
  std::string level_file;  // its path is relative to this file; empty: none
  std::string clash = {};  // see clash_problem(); if set, the preset is not written
  ExportBounds bounds = {};
  friend bool operator==(const ExportTask&, const ExportTask&) = default;
};

// For one of the level's presets.
ExportTask task_of_preset(const Level& level, std::size_t preset, const std::string& level_file,
                          const ExportPermissions& permissions);

// What action::ExportGame exports.
inline ExportPreset preset_of_game(const std::string& folder) {
  return {.name = "the game", .exporter = "love", .path = folder, .extra = ""};
}

// The result of an export, or of a preview.
struct ExportOutcome {
  ExportTask task;
  std::string output;  // see output_of(); empty: not known
  std::vector<PlannedFile> files = {};
  std::vector<PlannedFile> kept = {};  // starters that stay as they are: see own_starters()
  // Files whose places hold something that was not exported.
  std::set<std::string> foreign = {};     // paths
  std::vector<std::string> dropped = {};  // as in Exported
  std::optional<std::size_t> code_bytes = {};
  std::optional<ExportProblem> problem = {};
  bool written = false;
};

struct ExportPreview {
  std::uint64_t revision = 0;  // revision of its level
  ExportOutcome outcome;
};

struct ExportRun {
  std::vector<ExportTask> tasks;
  std::shared_ptr<const Level> level;   // never null
  std::set<std::string> may_replace;    // paths of foreign files that the user gave up
  std::set<std::size_t> to_allow = {};  // tasks of presets that the user has not allowed yet
  bool on_save = false;                 // it was started by saving the level
  std::uint64_t revision = 0;           // of the level
};

struct FinishedRun {
  ExportRun run;
  std::vector<ExportOutcome> outcomes;  // of its tasks, up to the last one that was done
  bool cancelled = false;
  // The question before anything is written: whether presets are allowed, or whether foreign files may be
  // replaced.
  enum class Asks { nothing, to_allow, to_replace };
  Asks asks = Asks::nothing;
  std::string record_problem = {};  // of ExportRecord::save(); empty: no problem
};

// For a run, which makes the files of all its tasks and then writes them, or for a preview.
struct ExportProgress {
  std::string name;                 // of the current preset
  std::size_t task = 0, tasks = 1;  // index of the current task, and number of tasks
  double share = 0;                 // of all work, 0..1
  double seconds = 0;               // since it began
  // Of the current task, how many of how many files; without files: they are being made.
  std::size_t files_done = 0, files = 0;
  std::size_t bytes_done = 0, bytes = 0;
};

class Exporting {
 public:
  explicit Exporting(ExportTools tools);
  ~Exporting();  // waits for a run to end
  Exporting(const Exporting&) = delete;
  Exporting& operator=(const Exporting&) = delete;

  // A level for exports: without its presets, which are not exported.
  static std::shared_ptr<const Level> snapshot(const Level& level);
  // Looks once at what a task would write; replaces the preview before.
  void preview(const Level& level, std::uint64_t revision, ExportTask task);
  // Whether a preview would begin at once. A preview of the same task has to end first, so that a level that
  // is being painted on is not copied in vain.
  bool takes_preview(const ExportTask& task) const;
  // Writes all tasks that have no problem, or nothing if one of them asks. Goes before a preview. Does
  // nothing while another run is going on: see running().
  void run(ExportRun run);
  // Ends the run: places that it has not written yet stay as they were. Without a run, ends the preview.
  void cancel();
  // Takes finished work, and goes on with what waits. A run that has ended is returned once.
  std::optional<FinishedRun> advance();

  bool is_busy() const { return job_ != nullptr || next_run_ || next_preview_ || cancelled_; }
  bool running() const { return next_run_.has_value() || (job_ && job_->is_run && job_->wanted); }
  bool previewing() const { return next_preview_.has_value() || (job_ && !job_->is_run && job_->wanted); }
  std::optional<ExportProgress> progress() const;  // of the current run
  std::optional<ExportProgress> preview_progress() const;
  const std::optional<ExportPreview>& preview() const { return preview_; }
  // Whether the preview shows this, will show it when it is done, or would if it had not been cancelled.
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
  // The files of a level's preview, for writing.
  struct Made {
    std::uint64_t revision = 0;
    ExportTask task;
    std::shared_ptr<const Exported> content;  // null: they were not kept
  };
  using Clock = std::chrono::steady_clock;
  // The data of the thread.
  struct Job {
    bool is_run = false;
    ExportRun run;  // for a preview: its one task
    ReadAsset read_asset;
    ExportRecord record;
    Clock::time_point start = Clock::now();
    std::atomic<bool> wanted = true, writing = false, done = false;
    std::atomic<double> made_share = 0;  // share of the current task
    std::atomic<std::size_t> task = 0, files_done = 0, files = 0, bytes_done = 0, bytes = 0;
    Made made;  // the files of an earlier preview; when it is done, those that this one made
    // Written before `done`:
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
  std::optional<std::pair<std::uint64_t, ExportTask>> cancelled_preview_;  // for this revision of the level
  Made made_;
  std::vector<ExportOutcome> last_run_;
};

}  // namespace talus
