// Traces, and recordings.
#include "sim_run.h"

#include <algorithm>
#include <ostream>

#include "debug/branch_frames.h"
#include "formats/files/atomic_file.h"
#include "formats/native/recording_file.h"
#include "level/lint/lint.h"
#include "output_file.h"
#include "progress_line.h"
#include "sim/timeline.h"
#include "trace.h"
#include "until.h"

namespace talus {
namespace {

constexpr std::int64_t kStepsAtOnce = 256;  // between two comparisons with the recording

std::optional<Recording> load_recording_or_fail(CommandContext& context, const SimOptions& options) {
  context.doing = "reading " + options.file;
  auto recording = [&] {
    ProgressLine line(context.err, "reading " + options.file, is_terminal(context.err));
    return load_recording(options.file, Progress([&](double share) { return line.at(share); }));
  }();
  if (!recording) {
    fail(context, options.file, recording.error().place, recording.error().message);
    return std::nullopt;
  }
  context.doing = "working on " + options.file;
  apply_physics(options.physics, recording->level.tuning);
  warn_of_ignored_ground(context, options.file, recording->level);
  for (RecordedEdit& edit : recording->edits) {
    LevelVersion version = *edit.version;
    apply_physics(options.physics, version.tuning);
    edit.version = std::make_shared<const LevelVersion>(std::move(version));
  }
  return *std::move(recording);
}

// Runs a timeline to a frame; returns false after a reported failure.
bool catch_up(CommandContext& context, const SimOptions& options, Timeline& timeline, std::int64_t frames,
              ProgressLine& line) {
  const auto all = static_cast<double>(std::max<std::int64_t>(frames, 1));
  for (std::int64_t done = 0; done < frames && timeline.behind(); done += kStepsAtOnce) {
    if (!line.at(static_cast<double>(done) / all)) {
      fail(context, options.file, "", "was cancelled");
      return false;
    }
    timeline.catch_up(std::min(kStepsAtOnce, frames - done));
  }
  return true;
}

// Why the trace must not be written to the given place; empty if it may.
std::string trace_problem(const CommandContext& context, const SimOptions& options) {
  if (has_name_of_level(options.trace))
    return "has the name of a level or a recording, but would hold a trace: name another file";
  std::vector<std::string> inputs = context.inputs;
  inputs.insert(inputs.end(), {options.file, options.input});
  return output_problem({options.trace, kTraceBeginning, std::move(inputs)});
}

// "passed 3600 frames", or "failed frame 61: hash .., recorded ..".
void verify(CommandContext& context, const SimOptions& options, Timeline& timeline) {
  const Branch& branch = timeline.current();
  if (branch.expected.size() == 0) {
    context.out << "failed: the recording has no hashes to compare with\n";
    context.status = kExitBad;
    return;
  }
  {
    ProgressLine line(context.err, options.file, is_terminal(context.err));
    for (; timeline.behind() && !timeline.unexpected_frame(branch); timeline.catch_up(kStepsAtOnce)) {
      if (!line.at(timeline.progress())) return fail(context, options.file, "", "was cancelled");
    }
  }
  const auto failed = timeline.unexpected_frame(branch);
  if (!failed) {
    context.out << "passed " << branch.last_frame() << " frames\n";
    return;
  }
  const auto at = static_cast<std::size_t>(*failed);
  context.out << "failed frame " << *failed << ": hash " << hash_text(branch.hashes[at]) << ", recorded "
              << hash_text(branch.expected[at]) << '\n';
  context.status = kExitBad;
}

}  // namespace

void warn_of_ignored_ground(CommandContext& context, const std::string& file, const Level& level) {
  for (const Problem& problem : ignored_ground(level))
    say(context.err, file + ": warning: " + problem.message);
}

TraceFile::TraceFile(CommandContext& context, const SimOptions& options)
    : context_(context), options_(options) {
  if (options.trace.empty()) return;
  if (options.trace == "-") {
    out_ = &context.out;
    return;
  }
  if (const std::string problem = trace_problem(context, options); !problem.empty()) {
    good_ = false;
    fail(context, options.trace, "", problem);
    return;
  }
  auto begun = StagedFile::begin(options.trace, InPlace::write);
  good_ = begun.has_value();
  if (good_)
    file_.emplace(*std::move(begun));
  else
    fail(context, options.trace, "", begun.error().message);
}

void TraceFile::write(const State& state, const StepRecord* record) {
  if (!wanted()) return;
  const std::string line = trace_line(state, record, !options_.no_contacts) + '\n';
  if (out_ != nullptr) *out_ << line;
  if (!file_ || !good_) return;
  constexpr std::size_t kLong = 1 << 16;
  part_ += line;
  if (part_.size() < kLong) return;
  good_ = !fails(file_->add(part_));
  part_.clear();
}

bool TraceFile::fails(const FormatResult<void>& done) {
  if (!done) fail(context_, options_.trace, "", done.error().message);
  return !done;
}

bool TraceFile::finish() {
  if (!good_ || !file_) return good_;
  if (fails(file_->add(part_)) || fails(file_->flush()) || fails(file_->put())) return false;
  if (file_->doubt().empty()) return true;
  fail(context_, options_.trace, "", file_->doubt());
  return false;
}

bool is_recording_file(const std::string& path) {
  const FormatContext context = context_for_file(path);
  if (is_recording("", context)) return true;
  const auto bytes = read_file(path);
  return bytes && is_recording(*bytes, context);
}

void simulate_recording(CommandContext& context, const SimOptions& options) {
  if (!options.input.empty()) return fail(context, options.file, "", "has its own input; leave --input out");
  const std::optional<Recording> recording = load_recording_or_fail(context, options);
  if (!recording) return;
  Timeline timeline(*recording);
  if (options.verify) return verify(context, options, timeline);

  // The line holds back the signals that end the program, and so outlives the trace's unfinished file.
  ProgressLine line(context.err, options.file, is_terminal(context.err) && options.trace != "-");
  TraceFile trace(context, options);
  if (!trace.good()) return;
  const Branch& branch = timeline.current();
  std::int64_t frames = std::min(options.frames, branch.last_frame());
  if (!catch_up(context, options, timeline, frames, line)) return;
  bool goes_on = true;
  const auto is_wanted = [&](double share) { return goes_on = line.at(share); };
  Until until(options.until);
  if (until.wanted()) frames = until.run(BranchFrames(branch), frames, is_wanted);
  if (trace.wanted() && frames > 0) {
    StepRecord record;
    record.only_events = options.no_contacts;
    timeline.walk(branch, 1, frames, &record, [&](const State& state, const StepRecord* written) {
      trace.write(state, written);
      return is_wanted(static_cast<double>(state.frame) / static_cast<double>(frames));
    });
  }
  line.wipe();
  if (!goes_on) return fail(context, options.file, "", "was cancelled");
  if (!trace.finish()) return;
  until.report(context, options.file);
  if (options.hash) context.out << hash_text(state_hash(timeline.state_at(branch, frames))) << '\n';
}

}  // namespace talus
