// Session: exports of the level's presets, and what is said about them.
#include <filesystem>
#include <utility>

#include "session_impl.h"

namespace talus {
namespace {

constexpr std::size_t kMostNamed = 4;  // files that a question names

std::string label_of(const ExportTask& task) {
  return task.preset.name.empty() ? task.preset.path : task.preset.name;
}

// " Kept main.lua and conf.lua, which are yours by now."
std::string kept_text(const std::vector<ExportOutcome>& outcomes) {
  std::string names, last;
  for (const ExportOutcome& outcome : outcomes) {
    if (!outcome.written) continue;
    for (const PlannedFile& file : outcome.kept) {
      if (!last.empty()) names += (names.empty() ? "" : ", ") + last;
      last = file.name;
    }
  }
  if (last.empty()) return "";
  return " Kept " + names + (names.empty() ? "" : " and ") + last +
         (names.empty() ? ", which is yours by now." : ", which are yours by now.");
}

// "Exported game: 3 files to export/love, map: 1 file to export/cave.tmj."; empty without any.
std::string written_text(const std::vector<ExportOutcome>& outcomes) {
  std::string text, dropped, too_large;
  for (const ExportOutcome& outcome : outcomes) {
    if (!outcome.written) continue;
    const std::size_t count = outcome.files.size();
    text += (text.empty() ? "Exported " : ", ") + label_of(outcome.task) + ": " + std::to_string(count) +
            (count == 1 ? " file to " : " files to ") + outcome.task.preset.path;
    for (const std::string& what : outcome.dropped) dropped += (dropped.empty() ? "" : ", ") + what;
    const std::string problem =
        code_problem(*find_exporter(outcome.task.preset.exporter), outcome.code_bytes);
    if (!problem.empty()) too_large += " Too large, " + label_of(outcome.task) + ": " + problem + ".";
  }
  if (text.empty()) return text;
  return text + "." + kept_text(outcomes) + (dropped.empty() ? "" : " Not held there: " + dropped + ".") +
         too_large;
}

std::string problems_text(const std::vector<ExportOutcome>& outcomes) {
  std::string text;
  for (const ExportOutcome& outcome : outcomes) {
    if (!outcome.problem) continue;
    const FormatError& error = outcome.problem->error;
    text += (text.empty() ? "" : "\n") + std::string("Export of ") + label_of(outcome.task) + ": " +
            (error.place.empty() ? "" : error.place + ": ") + error.message + ".";
  }
  return text;
}

std::string names_of(const std::vector<ExportOutcome>& outcomes) {
  std::size_t count = 0;
  std::string names;
  for (const ExportOutcome& outcome : outcomes) {
    for (const std::string& path : outcome.foreign) {
      if (count++ < kMostNamed) names += "\n  " + path;
    }
  }
  return count > kMostNamed ? names + "\n  and " + std::to_string(count - kMostNamed) + " more" : names;
}

}  // namespace

void Session::Impl::carry_out(const action::PreviewExport& a) {
  if (a.preset < level.exports.size()) exporting.preview(level, revision, export_task(level, a.preset, path));
}

void Session::Impl::carry_out(const action::RunExports& a) {
  ExportRun run{.tasks = {}, .level = Exporting::snapshot(level), .may_replace = {}, .revision = revision};
  for (std::size_t i = 0; i < level.exports.size(); ++i) {
    if (a.preset.value_or(i) == i) run.tasks.push_back(export_task(level, i, path));
  }
  exporting.run(std::move(run));
}

void Session::Impl::export_on_save() {
  std::vector<ExportTask> tasks;
  for (std::size_t i = 0; i < level.exports.size(); ++i) {
    if (level.exports[i].on_save) tasks.push_back(export_task(level, i, path));
  }
  if (!tasks.empty())
    exporting.run({.tasks = std::move(tasks),
                   .level = Exporting::snapshot(level),
                   .may_replace = {},
                   .on_save = true,
                   .revision = revision});
}

void Session::Impl::take_exports() {
  auto finished = exporting.advance();
  if (!finished) return;
  if (finished->asks) return ask_to_replace(*std::move(finished));
  if (finished->cancelled) {
    message = Message{"The export was cancelled: nothing was written.", false};
    return;
  }
  const std::string written = written_text(finished->outcomes);
  std::string problems = problems_text(finished->outcomes);
  if (!finished->record_problem.empty())
    problems += (problems.empty() ? "" : "\n") + finished->record_problem;
  std::string text = problems + (problems.empty() || written.empty() ? "" : "\n") + written;
  // What saving said is still news.
  if (finished->run.on_save && message && !message->is_error) text = message->text + "\n" + text;
  message = Message{std::move(text), !problems.empty()};
}

void Session::Impl::ask_to_replace(FinishedRun finished) {
  run_to_confirm = std::move(finished.run);
  for (const ExportOutcome& outcome : finished.outcomes)
    run_to_confirm->may_replace.insert(outcome.foreign.begin(), outcome.foreign.end());
  question = Question{"These files are not as an export wrote them. Replace them?" +
                          names_of(finished.outcomes) + "\nReplaced, they are gone.",
                      Question::Kind::replace_files};
}

}  // namespace talus
