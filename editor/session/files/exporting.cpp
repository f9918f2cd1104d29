// There is one thread at a time. A job that is given up notices it at its next progress report, and then
// ends.
#include "exporting.h"

#include <algorithm>
#include <utility>

#include "export/preset_clash.h"
#include "formats/last_catch.h"

namespace talus {
namespace {

constexpr double kMaking = 0.9;                           // share of a run's time before it writes
constexpr std::size_t kMaxKept = std::size_t{256} << 20;  // bytes of a preview that are kept for writing

FormatResult<std::string> no_asset(const std::string& name) {
  return tl::unexpected(FormatError{name, "is missing: the program was started without its files"});
}

// kept: own_starters() of the plan.
ExportOutcome outcome_of(const ExportTask& task, const std::string& output, const ExportPlan& plan,
                         const ExportRecord& record, const std::vector<std::size_t>& kept) {
  ExportOutcome outcome{
      .task = task, .output = output, .dropped = plan.content.dropped, .code_bytes = plan.content.code_bytes};
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    const PlannedFile& file = plan.files[i];
    const bool is_kept = std::binary_search(kept.begin(), kept.end(), i);
    (is_kept ? outcome.kept : outcome.files).push_back(file);
    const bool is_known = file.old && record.has(file.path, *file.old);
    if (!is_kept && file.place == PlannedFile::Place::other && !is_known) outcome.foreign.insert(file.path);
  }
  return outcome;
}

}  // namespace

ExportTask task_of_preset(const Level& level, std::size_t preset, const std::string& level_file,
                          const ExportPermissions& permissions) {
  const ExportPreset& exported = level.exports[preset];
  return {exported, level_file, clash_problem(level.exports, preset, level_file),
          permissions.bounds_of(exported)};
}

Exporting::Exporting(ExportTools tools) : tools_(std::move(tools)), record_(tools_.record) {
  if (!tools_.read_asset) tools_.read_asset = no_asset;
}

Exporting::~Exporting() {
  if (job_ && !job_->is_run) job_->wanted = false;
  if (thread_.joinable()) thread_.join();
}

std::shared_ptr<const Level> Exporting::snapshot(const Level& level) {
  auto copy = std::make_shared<Level>(level);
  copy->exports.clear();
  return copy;
}

void Exporting::preview(const Level& level, std::uint64_t revision, ExportTask task) {
  next_preview_ = NextPreview{snapshot(level), revision, std::move(task)};
  cancelled_preview_.reset();
  if (job_ && !job_->is_run && job_->run.tasks.front() != next_preview_->task) job_->wanted = false;
  start_next();
}

bool Exporting::takes_preview(const ExportTask& task) const {
  if (job_ == nullptr) return true;
  return !job_->is_run && job_->wanted && job_->run.tasks.front() != task;
}

void Exporting::run(ExportRun run) {
  if (running() || run.tasks.empty()) return;
  if (job_) job_->wanted = false;  // a preview, or a cancelled run
  next_run_ = std::move(run);
  start_next();
}

void Exporting::cancel() {
  if (next_run_) {
    cancelled_ = FinishedRun{*std::exchange(next_run_, std::nullopt), {}, true};
  } else if (running()) {
    job_->wanted = false;
  } else if (next_preview_) {
    cancelled_preview_.emplace(next_preview_->revision, std::move(next_preview_->task));
    next_preview_.reset();
  } else if (previewing()) {
    job_->wanted = false;
    cancelled_preview_.emplace(job_->run.revision, job_->run.tasks.front());
  }
}

std::optional<FinishedRun> Exporting::advance() {
  std::optional<FinishedRun> finished = std::exchange(cancelled_, std::nullopt);
  if (!finished && job_ && job_->done) {
    thread_.join();
    const auto job = std::exchange(job_, nullptr);
    record_ = job->record;
    if (job->is_run) {
      const bool cancelled = !job->wanted && std::none_of(job->outcomes.begin(), job->outcomes.end(),
                                                          [](const ExportOutcome& o) { return o.written; });
      last_run_ = job->outcomes;
      const auto asks = cancelled ? FinishedRun::Asks::nothing : job->asks;
      if (job->asks == FinishedRun::Asks::nothing) preview_.reset();  // the places have other files now
      finished = FinishedRun{std::move(job->run), std::move(job->outcomes), cancelled, asks,
                             std::move(job->record_problem)};
    } else if (job->wanted) {
      preview_ = ExportPreview{job->run.revision, std::move(job->outcomes.front())};
      made_ = std::move(job->made);
    }
  }
  start_next();
  return finished;
}

std::optional<ExportProgress> Exporting::progress() const {
  if (!running()) return std::nullopt;
  if (!next_run_) return progress_of(*job_);
  return ExportProgress{.name = next_run_->tasks.front().preset.name, .tasks = next_run_->tasks.size()};
}

std::optional<ExportProgress> Exporting::preview_progress() const {
  if (!previewing()) return std::nullopt;
  if (!next_preview_) return progress_of(*job_);
  return ExportProgress{.name = next_preview_->task.preset.name};
}

ExportProgress Exporting::progress_of(const Job& job) {
  const std::size_t tasks = job.run.tasks.size();
  ExportProgress progress{.name = {}, .tasks = tasks};
  progress.task = std::min(job.task.load(), tasks - 1);
  progress.name = job.run.tasks[progress.task].preset.name;
  progress.seconds = std::chrono::duration<double>(Clock::now() - job.start).count();
  progress.files_done = job.files_done;
  progress.files = job.files;
  progress.bytes_done = job.bytes_done;
  progress.bytes = job.bytes;
  double of_task = job.made_share;
  if (job.writing)
    of_task = static_cast<double>(progress.bytes_done) /
              static_cast<double>(std::max<std::size_t>(progress.bytes, 1));
  const double of_all = (static_cast<double>(progress.task) + of_task) / static_cast<double>(tasks);
  const double making = job.is_run ? kMaking : 1;
  progress.share = job.writing ? making + (1 - making) * of_all : making * of_all;
  return progress;
}

bool Exporting::previews(std::uint64_t revision, const ExportTask& task) const {
  if (next_preview_) return next_preview_->revision == revision && next_preview_->task == task;
  if (job_ && !job_->is_run && job_->wanted)
    return job_->run.revision == revision && job_->run.tasks.front() == task;
  if (cancelled_preview_ && *cancelled_preview_ == std::pair(revision, task)) return true;
  return preview_ && preview_->revision == revision && preview_->outcome.task == task;
}

void Exporting::start_next() {
  if (job_ || (!next_run_ && !next_preview_)) return;
  job_ = std::make_unique<Job>();
  if (next_run_) {
    job_->is_run = true;
    job_->run = *std::exchange(next_run_, std::nullopt);
  } else {
    NextPreview next = *std::exchange(next_preview_, std::nullopt);
    job_->run = {.tasks = {std::move(next.task)},
                 .level = std::move(next.level),
                 .may_replace = {},
                 .revision = next.revision};
  }
  job_->read_asset = tools_.read_asset;
  job_->record = record_;
  job_->made = made_;
  thread_ = std::thread([job = job_.get()] {
    try {
      carry_out(*job);
    } catch (...) {
      fail(*job, caught_text());
    }
    job->done = true;
  });
}

void Exporting::carry_out(Job& job) {
  job.record.refresh();
  std::vector<ExportPlan> plans;
  if (!make(job, plans) || !job.is_run) return;
  job.asks = question_of(job);
  if (job.asks != FinishedRun::Asks::nothing) return;
  job.task = 0;
  job.writing = true;
  if (job.wanted) write(job, plans);
}

// Ends the job. Files that are not written yet have this problem.
void Exporting::fail(Job& job, const std::string& problem) {
  for (std::size_t i = job.outcomes.size(); i < job.run.tasks.size(); ++i)
    job.outcomes.push_back({.task = job.run.tasks[i], .output = {}});
  for (ExportOutcome& outcome : job.outcomes) {
    if (!outcome.written && !outcome.problem)
      outcome.problem = {ExportProblem::Field::target, {"", "cannot be made: " + problem}};
  }
}

// Files that will not be written are not asked about.
FinishedRun::Asks Exporting::question_of(const Job& job) {
  auto asks = FinishedRun::Asks::nothing;
  for (std::size_t i = 0; i < job.outcomes.size(); ++i) {
    const ExportOutcome& outcome = job.outcomes[i];
    if (outcome.problem) continue;
    if (job.run.to_allow.contains(i)) return FinishedRun::Asks::to_allow;
    if (!std::includes(job.run.may_replace.begin(), job.run.may_replace.end(), outcome.foreign.begin(),
                       outcome.foreign.end()))
      asks = FinishedRun::Asks::to_replace;
  }
  return asks;
}

// Makes the files, unless a preview did.
tl::expected<ExportPlan, ExportProblem> Exporting::plan_of(Job& job, const ExportTask& task,
                                                           const std::string& output) {
  const auto listener = [&job](double share) {
    job.made_share = share;
    return job.wanted.load();
  };
  const bool is_made = job.made.content && job.made.revision == job.run.revision && job.made.task == task;
  return plan_export(*job.run.level, task.preset.exporter, output, job.read_asset, task.preset.parts,
                     Progress(listener), is_made ? job.made.content.get() : nullptr, task.bounds);
}

// Keeps the files of a preview for a run that may follow, unless they are very large.
void Exporting::keep_made(Job& job, ExportPlan plan) {
  std::size_t bytes = 0;
  for (const PlannedFile& file : plan.files) bytes += file.size;
  job.made = {job.run.revision, job.run.tasks.front(), nullptr};
  if (bytes <= kMaxKept) job.made.content = std::make_shared<const Exported>(std::move(plan.content));
}

// The plans belong to the outcomes without a problem. Returns false if it was given up.
bool Exporting::make(Job& job, std::vector<ExportPlan>& plans) {
  for (std::size_t i = 0; i < job.run.tasks.size() && job.wanted; ++i) {
    job.task = i;
    const ExportTask& task = job.run.tasks[i];
    const auto output = output_of(task.preset, task.level_file);
    const std::string to = output.value_or("");
    job.made_share = 0;
    auto plan = plan_of(job, task, to);
    if (!job.wanted) return false;
    if (!plan) {
      job.outcomes.push_back({.task = task, .output = to, .problem = plan.error()});
      continue;
    }
    const auto kept = own_starters(
        *plan, [&](const PlannedFile& file) { return file.old && job.record.has(file.path, *file.old); });
    job.outcomes.push_back(outcome_of(task, to, *plan, job.record, kept));
    if (job.is_run) leave_out(*plan, kept);
    if (!output)
      job.outcomes.back().problem = output.error();
    else if (!task.clash.empty())
      job.outcomes.back().problem = {ExportProblem::Field::path, {"", task.clash}};
    else if (const PlannedFile* own = own_file_in(*plan, task.level_file))
      job.outcomes.back().problem = {ExportProblem::Field::path,
                                     {"", own->path + " is the level's own file: give another path"}};
    else if (job.is_run)
      plans.push_back(*std::move(plan));
    else
      keep_made(job, *std::move(plan));
  }
  return job.wanted;
}

void Exporting::write(Job& job, const std::vector<ExportPlan>& plans) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < job.outcomes.size() && job.wanted; ++i) {
    ExportOutcome& outcome = job.outcomes[i];
    if (outcome.problem) continue;
    const ExportPlan& plan = plans[next++];
    job.task = i;
    job.bytes = 0;
    for (const PlannedFile& file : plan.files) job.bytes += file.size;
    job.files_done = job.bytes_done = 0;
    job.files = plan.files.size();
    const auto written = write_plan(plan, [&](std::size_t files, std::size_t bytes) {
      job.files_done = files;
      job.bytes_done = bytes;
      return job.wanted.load();
    });
    outcome.written = written.has_value();
    if (!written && job.wanted) outcome.problem = written.error();
    if (!written) continue;
    for (std::size_t f = 0; f < plan.files.size(); ++f)
      job.record.note(plan.files[f].path, content_hash(plan.content.files[f].bytes));
  }
  if (const auto kept = job.record.save(); !kept) job.record_problem = kept.error();
}

}  // namespace talus
