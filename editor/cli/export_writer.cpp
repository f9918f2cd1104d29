// Checks what is in each place before it writes anything.
#include "export_writer.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <ostream>

#include "formats/files/atomic_file.h"
#include "output_file.h"
#include "platform/asset_path.h"
#include "platform/user_folder.h"
#include "progress_line.h"
#include "session/files/export_record.h"

namespace talus {
namespace {

namespace fs = std::filesystem;
using Place = PlannedFile::Place;

constexpr double kMakingShare = 0.9;  // share of the time; writing the files takes the rest

FormatResult<std::string> read_asset(const std::string& name) { return read_file(asset_path(name)); }

void warn_of_losses(CommandContext& context, const Exporter& exporter, const Exported& exported,
                    const std::string& output) {
  for (const std::string& what : exported.dropped)
    say(context.err, output + ": warning: not stored in this format: " + what);
  if (const std::string problem = code_problem(exporter, exported.code_bytes); !problem.empty())
    say(context.err, output + ": warning: " + problem);
}

void fail_with(CommandContext& context, const ExportOrder& order, const ExportProblem& problem) {
  FormatError error = problem.error;
  if (problem.is_outside) error.message += ": to write there, use --allow-outside";
  if (error.message.starts_with(order.output + " ")) error.message.erase(0, order.output.size() + 1);
  if (problem.field == ExportProblem::Field::target)
    fail(context, order.input, "preset \"" + order.preset + "\"", error.message);
  else
    fail(context, problem.field == ExportProblem::Field::path ? order.output : order.input, error.place,
         error.message);
}

void print_export(CommandContext& context, const Exporter& exporter, const ExportOrder& order,
                  ProgressLine& line) {
  const ReadAsset read = read_asset;
  const Progress progress([&](double share) { return line.at(share); });
  const auto exported = exporter.make({order.level, order.output, read, order.parts, progress});
  line.wipe();
  if (!exported) return fail(context, order.input, exported.error().place, exported.error().message);
  context.out << exported->files.front().bytes;
  warn_of_losses(context, exporter, *exported, order.output);
}

// Whether a file begins like such an export, which says so. A file that Talus reads could be the user's own
// work.
bool begins_as_an_export(const ExportPlan& plan, std::string_view bytes) {
  const auto first_line = [](std::string_view text) { return text.substr(0, text.find('\n')); };
  const std::string_view line = first_line(bytes);
  return find_format(plan.exporter->id) == nullptr && line.find("Talus") != line.npos &&
         line == first_line(plan.content.files.front().bytes);
}

// Whether the files are those of an export that the record does not know: all of them are there, and the main
// file is Talus's own. Links do not count in a place that the level names.
bool is_earlier_export(const ExportOrder& order, const ExportPlan& plan, const ExportRecord& record) {
  std::error_code ignored;
  for (const PlannedFile& file : plan.files) {
    if (file.place == Place::empty || record.knows(file.path)) return false;
    if (order.is_of_level && fs::is_symlink(file.path, ignored)) return false;
  }
  if (plan.exporter->is_folder()) return true;
  const auto named = read_file(plan.output);
  if (named && order.is_of_level) return begins_as_an_export(plan, *named);
  return named && (named->find("talus") != std::string::npos || named->find("Talus") != std::string::npos);
}

// Why a file must not be written, one sentence without its full stop; empty if it may.
std::string problem_of_file(const CommandContext& context, const ExportOrder& order, const ExportPlan& plan,
                            std::size_t index, const ExportRecord& record, bool may_replace) {
  const PlannedFile& file = plan.files[index];
  const ExportedFile& content = plan.content.files[index];
  const bool was_typed = content.name.empty() && !order.is_of_level;
  if (was_typed) return output_problem({file.path, content.bytes, context.inputs, /*may_be_unknown=*/true});
  if (is_one_of(context.inputs, file.path))
    return "is an input of this command, which the export would overwrite: name another place";
  if (file.place != Place::other || content.is_starter || may_replace ||
      (file.old && record.has(file.path, *file.old)))
    return "";
  return record.knows(file.path)
             ? "was changed since it was exported: move it away, or replace it with --force"
             : "exists, and is not an export: move it away, or replace it with --force";
}

// Reports the files that are in the way. Returns true if there are any.
bool finds_foreign_files(CommandContext& context, const ExportOrder& order, const ExportPlan& plan,
                         const ExportRecord& record) {
  const bool may_replace = order.rules.force || is_earlier_export(order, plan, record);
  bool found = false;
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    const std::string problem = problem_of_file(context, order, plan, i, record, may_replace);
    if (problem.empty()) continue;
    fail(context, plan.files[i].path, "", problem);
    found = true;
  }
  return found;
}

ExportBounds bounds_of(const ExportOrder& order) {
  const Exporter* exporter = find_exporter(order.exporter);
  if (exporter == nullptr) return {};
  if (order.rules.allow_outside) return {.folder = {}, .takes_pipe = !order.is_of_level};
  return order.is_of_level ? bounds_of_level(order.input)
                           : bounds_of_output(order.output, exporter->is_folder());
}

// Leaves out the starters that are the user's own. Returns their paths.
std::vector<std::string> keep_own_starters(ExportPlan& plan, const ExportRecord& record) {
  const auto own = own_starters(
      plan, [&](const PlannedFile& file) { return file.old && record.has(file.path, *file.old); });
  std::vector<std::string> paths;
  paths.reserve(own.size());
  for (const std::size_t i : own) paths.push_back(plan.files[i].path);
  leave_out(plan, own);
  return paths;
}

tl::expected<void, ExportProblem> write_files(const ExportPlan& plan, bool makes_folder,
                                              const Progress& progress) {
  std::size_t all = 0;
  for (const PlannedFile& file : plan.files) all += file.size;
  const auto tell = [&](std::size_t, std::size_t bytes) { return progress.at(bytes, all); };
  if (makes_folder) return write_plan(plan, tell);
  const auto written = write_exported(*plan.exporter, plan.content, plan.output, tell, plan.bounds);
  if (!written) return tl::unexpected(ExportProblem{ExportProblem::Field::path, written.error()});
  return {};
}

}  // namespace

void carry_out(CommandContext& context, const ExportOrder& order) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  ProgressLine line(context.err, order.output, is_terminal(context.err));
  const Progress progress([&](double share) { return line.at(share); });
  if (const Exporter* exporter = find_exporter(order.exporter)) {
    if (const std::string problem = name_problem(*exporter, order.output); !problem.empty())
      return fail(context, order.output, "", problem);
    if (order.output == "-") return print_export(context, *exporter, order, line);
  }
  auto plan = plan_export(order.level, order.exporter, order.output, read_asset, order.parts,
                          progress.part(0, kMakingShare), nullptr, bounds_of(order));
  line.wipe();
  if (!plan) return fail_with(context, order, plan.error());
  ExportRecord record(state_folder() + "/exports");
  if (finds_foreign_files(context, order, *plan, record)) return;
  std::vector<std::string> kept;
  if (!order.rules.fresh) kept = keep_own_starters(*plan, record);
  const auto written = write_files(*plan, order.tells, progress.part(kMakingShare, 1));
  line.wipe();
  if (!written) return fail_with(context, order, written.error());
  for (std::size_t i = 0; i < plan->files.size(); ++i)
    record.note(plan->files[i].path, content_hash(plan->content.files[i].bytes));
  if (const auto kept_record = record.save(); !kept_record)
    say(context.err, order.output + ": warning: " + kept_record.error());
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
  if (order.tells) {
    say(context.out, summary_of(*plan) + ", " + std::to_string(time.count()) + " ms");
    context.out.flush();
  }
  for (const std::string& path : kept)
    say(context.err, path + ": note: kept, as this file is yours now; --fresh writes it anew");
  warn_of_losses(context, *plan->exporter, plan->content, order.output);
}

}  // namespace talus
