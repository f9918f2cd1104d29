// Making the files of a huge level may take a minute, and exporters know no way to stop: what is cancelled
// meanwhile is left to itself, at most one at a time. What writes is waited for.
#include "exporting.h"

#include <algorithm>
#include <utility>

namespace talus {
namespace {

FormatResult<std::string> no_asset(const std::string& name) {
  return tl::unexpected(FormatError{name, "is missing: the program was started without its files"});
}

ExportOutcome outcome_of(const ExportTask& task, const std::string& output, const ExportPlan& plan,
                         const ExportRecord& record) {
  ExportOutcome outcome{.task = task,
                        .output = output,
                        .files = plan.files,
                        .dropped = plan.content.dropped,
                        .code_bytes = plan.content.code_bytes};
  for (const PlannedFile& file : plan.files) {
    const bool is_known = file.old && record.has(file.path, *file.old);
    if (file.place == PlannedFile::Place::other && !is_known) outcome.foreign.insert(file.path);
  }
  return outcome;
}

}  // namespace

Exporting::Exporting(ExportTools tools) : tools_(std::move(tools)), record_(tools_.record) {
  if (!tools_.read_asset) tools_.read_asset = no_asset;
}

Exporting::~Exporting() {
  if (job_ && !job_->is_run) give_up_job();
  if (thread_.joinable()) thread_.join();
}

// False: it has to be waited for, as it writes, or as another one was given up already.
bool Exporting::give_up_job() {
  job_->wanted = false;
  if (job_->writing || !given_up_.expired()) return false;
  given_up_ = job_;
  job_.reset();
  thread_.detach();
  return true;
}

std::shared_ptr<const Level> Exporting::snapshot(const Level& level) {
  auto copy = std::make_shared<Level>(level);
  copy->exports.clear();
  return copy;
}

void Exporting::preview(const Level& level, std::uint64_t revision, ExportTask task) {
  next_preview_ = NextPreview{snapshot(level), revision, std::move(task)};
  if (job_ && !job_->is_run && job_->run.tasks.front() != next_preview_->task) give_up_job();
  start_next();
}

bool Exporting::takes_preview(const ExportTask& task) const {
  if (job_ == nullptr) return true;
  return !job_->is_run && job_->run.tasks.front() != task && given_up_.expired();
}

void Exporting::run(ExportRun run) {
  if (running() || run.tasks.empty()) return;
  if (job_) give_up_job();  // a preview, or a run that was cancelled
  next_run_ = std::move(run);
  start_next();
}

void Exporting::cancel() {
  if (!running()) return;
  if (next_run_)
    cancelled_ = FinishedRun{*std::exchange(next_run_, std::nullopt), {}, true, false};
  else if (ExportRun run = job_->run; give_up_job())
    cancelled_ = FinishedRun{std::move(run), {}, true, false};
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
      if (!job->asks) preview_.reset();  // what is at the places is something else now
      finished =
          FinishedRun{std::move(job->run), std::move(job->outcomes), cancelled, job->asks && !cancelled};
    } else if (job->wanted) {
      preview_ = ExportPreview{job->revision, std::move(job->outcomes.front())};
    }
  }
  start_next();
  return finished;
}

std::optional<ExportProgress> Exporting::progress() const {
  if (!running()) return std::nullopt;
  const ExportRun& run = next_run_ ? *next_run_ : job_->run;
  ExportProgress progress{.name = run.tasks.front().preset.name, .tasks = run.tasks.size()};
  if (next_run_) return progress;
  progress.task = std::min(job_->task.load(), run.tasks.size() - 1);
  progress.name = run.tasks[progress.task].preset.name;
  progress.files_done = job_->files_done;
  progress.files = job_->files;
  progress.bytes_done = job_->bytes_done;
  progress.bytes = job_->bytes;
  return progress;
}

bool Exporting::previews(std::uint64_t revision, const ExportTask& task) const {
  if (next_preview_) return next_preview_->revision == revision && next_preview_->task == task;
  if (job_ && !job_->is_run && job_->wanted)
    return job_->revision == revision && job_->run.tasks.front() == task;
  return preview_ && preview_->revision == revision && preview_->outcome.task == task;
}

void Exporting::start_next() {
  if (job_ || (!next_run_ && !next_preview_)) return;
  job_ = std::make_shared<Job>();
  if (next_run_) {
    job_->is_run = true;
    job_->run = *std::exchange(next_run_, std::nullopt);
  } else {
    NextPreview next = *std::exchange(next_preview_, std::nullopt);
    job_->revision = next.revision;
    job_->run = {.tasks = {std::move(next.task)}, .level = std::move(next.level), .may_replace = {}};
  }
  job_->read_asset = tools_.read_asset;
  job_->record = record_;
  thread_ = std::thread([job = job_] {
    carry_out(*job);
    job->done = true;
  });
}

void Exporting::carry_out(Job& job) {
  std::vector<ExportPlan> plans;
  if (!make(job, plans) || !job.is_run) return;
  for (const ExportOutcome& outcome : job.outcomes) {
    job.asks = job.asks || !std::includes(job.run.may_replace.begin(), job.run.may_replace.end(),
                                          outcome.foreign.begin(), outcome.foreign.end());
  }
  if (job.asks) return;
  job.writing = true;  // before it looks whether it is wanted: from here on it is waited for
  if (job.wanted) write(job, plans);
}

// The plans are those of the outcomes without a problem. False: it was given up.
bool Exporting::make(Job& job, std::vector<ExportPlan>& plans) {
  for (std::size_t i = 0; i < job.run.tasks.size() && job.wanted; ++i) {
    job.task = i;
    const ExportTask& task = job.run.tasks[i];
    const auto output = output_of(task.preset, task.level_file);
    const std::string to = output.value_or("");
    auto plan = plan_export(*job.run.level, task.preset.exporter, to, job.read_asset);
    if (!plan) {
      job.outcomes.push_back({.task = task, .output = to, .problem = plan.error()});
      continue;
    }
    job.outcomes.push_back(outcome_of(task, to, *plan, job.record));
    if (!output)
      job.outcomes.back().problem = output.error();
    else
      plans.push_back(*std::move(plan));
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
  job.record.save();
}

}  // namespace talus
