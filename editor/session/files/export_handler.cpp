// Exports the level's presets, and reports on that.
#include "export_handler.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "edit/export_presets.h"
#include "formats/text/utf8_text.h"

namespace talus {
namespace {

constexpr std::size_t kMaxNamed = 4;  // files that a question names

// For a line of a message, whatever the name in the level's file is.
std::string label_of(const ExportPreset& preset) {
  constexpr std::size_t kMaxShown = 100;  // bytes
  return printable(shortened(preset.name.empty() ? preset.path : preset.name, kMaxShown));
}

// " Kept main.lua and conf.lua, which are yours now."
std::string kept_text(const std::vector<ExportOutcome>& outcomes) {
  std::string names, last;
  for (const ExportOutcome& outcome : outcomes) {
    if (!outcome.written) continue;
    for (const PlannedFile& file : outcome.kept) {
      if (!last.empty()) names += (names.empty() ? "" : ", ") + last;
      last = printable(file.name);
    }
  }
  if (last.empty()) return "";
  return " Kept " + names + (names.empty() ? "" : " and ") + last +
         (names.empty() ? ", which is yours now." : ", which are yours now.");
}

std::string not_allowed_text(const std::string& names) {
  return "Not exported, as you have not allowed it: " + names + ". File > Export shows what it would write.";
}

// "Exported game: 3 files to export/love, map: 1 file to export/cave.tmj."; empty if there are none.
std::string written_text(const std::vector<ExportOutcome>& outcomes) {
  std::string text, dropped, too_large;
  for (const ExportOutcome& outcome : outcomes) {
    if (!outcome.written) continue;
    const std::size_t count = outcome.files.size();
    text += (text.empty() ? "Exported " : ", ") + label_of(outcome.task.preset) + ": " +
            std::to_string(count) + (count == 1 ? " file to " : " files to ") +
            printable(outcome.task.preset.path);
    for (const std::string& what : outcome.dropped)
      dropped += (dropped.empty() ? "" : ", ") + printable(what);
    const std::string problem =
        code_problem(*find_exporter(outcome.task.preset.exporter), outcome.code_bytes);
    if (!problem.empty()) too_large += " Too large, " + label_of(outcome.task.preset) + ": " + problem + ".";
  }
  if (text.empty()) return text;
  return text + "." + kept_text(outcomes) + (dropped.empty() ? "" : " Not in the export: " + dropped + ".") +
         too_large;
}

// The path of what was written last, empty if nothing was.
std::string last_place(const std::vector<ExportOutcome>& outcomes) {
  const auto last = std::find_if(outcomes.rbegin(), outcomes.rend(),
                                 [](const ExportOutcome& outcome) { return outcome.written; });
  return last == outcomes.rend() ? std::string() : last->output;
}

std::string problems_text(const std::vector<ExportOutcome>& outcomes) {
  std::string text;
  for (const ExportOutcome& outcome : outcomes) {
    if (!outcome.problem) continue;
    const FormatError& error = outcome.problem->error;
    text += (text.empty() ? "" : "\n") + std::string("Export of ") + label_of(outcome.task.preset) + ": " +
            printable((error.place.empty() ? "" : error.place + ": ") + error.message) + ".";
  }
  return text;
}

// Whether one of the exports to allow writes the code of the level's cart.
bool any_brings_code(const ExportRun& run) {
  return std::any_of(run.to_allow.begin(), run.to_allow.end(), [&](std::size_t task) {
    return brings_code(*run.level, run.tasks[task].preset.exporter);
  });
}

std::string names_of(const std::vector<ExportOutcome>& outcomes) {
  std::size_t count = 0;
  std::string names;
  for (const ExportOutcome& outcome : outcomes) {
    for (const std::string& path : outcome.foreign) {
      if (count++ < kMaxNamed) names += "\n  " + printable(path);
    }
  }
  return count > kMaxNamed ? names + "\n  and " + std::to_string(count - kMaxNamed) + " more" : names;
}

}  // namespace

template <>
void ExportHandler::carry_out(const action::SetExportPath& a) {
  const std::vector<ExportPreset>& presets = open_.level.exports;
  if (a.preset >= presets.size()) return;
  ExportPreset moved = presets[a.preset];
  moved.path = a.path;
  if (moved != presets[a.preset])
    level_.edit_by_user(set_export(open_.level, a.preset, std::move(moved), "Change export path"));
  open_.permissions.allow_place(presets[a.preset]);
}

template <>
void ExportHandler::carry_out(const action::PreviewExport& a) {
  if (a.preset < open_.level.exports.size()) exporting_.preview(open_.level, open_.revision, task(a.preset));
}

template <>
void ExportHandler::carry_out(const action::RunExports& a) {
  const std::vector<ExportPreset>& presets = open_.level.exports;
  const auto is_wanted = [&](std::size_t i) { return a.preset.value_or(i) == i; };
  bool is_beside_level = false;
  for (std::size_t i = 0; i < presets.size(); ++i)
    is_beside_level |= is_wanted(i) && std::filesystem::path(presets[i].path).is_relative();
  if (open_.path.empty() && is_beside_level) {
    waits_for_file_ = a;
    open_.wants_save_as = true;
    return;
  }
  export_presets(is_wanted, false);
}

template <>
void ExportHandler::carry_out(const action::ExportGame& a) {
  exporting_.run({.tasks = {{preset_of_game(a.folder), open_.path}},
                  .level = Exporting::snapshot(open_.level),
                  .may_replace = {},
                  .revision = open_.revision});
}

template <>
void ExportHandler::carry_out(const action::CancelExport&) {
  exporting_.cancel();
}

void ExportHandler::apply(const ExportAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

ExportTask ExportHandler::task(std::size_t preset) const {
  return task_of_preset(open_.level, preset, open_.path, open_.permissions);
}

void ExportHandler::export_on_save() {
  std::string not_allowed;
  const auto is_wanted = [&](std::size_t i) {
    const ExportPreset& preset = open_.level.exports[i];
    const bool was_declined = std::find(declined_.begin(), declined_.end(), preset) != declined_.end();
    const bool is_declined = was_declined && !open_.permissions.allows(preset);
    if (preset.on_save && is_declined) not_allowed += (not_allowed.empty() ? "" : ", ") + label_of(preset);
    return preset.on_save && !is_declined;
  };
  export_presets(is_wanted, true);
  if (!not_allowed.empty()) messages_.add(not_allowed_text(not_allowed));
}

void ExportHandler::export_presets(FunctionRef<bool(std::size_t)> is_wanted, bool on_save) {
  ExportRun run{
      .tasks = {}, .level = nullptr, .may_replace = {}, .on_save = on_save, .revision = open_.revision};
  for (std::size_t i = 0; i < open_.level.exports.size(); ++i) {
    if (!is_wanted(i)) continue;
    if (!open_.permissions.allows(open_.level.exports[i])) run.to_allow.insert(run.tasks.size());
    run.tasks.push_back(task(i));
  }
  if (run.tasks.empty()) return;
  run.level = Exporting::snapshot(open_.level);
  exporting_.run(std::move(run));
}

// If the user has not given the level a file, nothing is exported.
void ExportHandler::go_on_with_file() {
  if (!waits_for_file_ || open_.wants_save_as) return;
  const action::RunExports wanted = *std::exchange(waits_for_file_, std::nullopt);
  if (!open_.path.empty()) carry_out(wanted);
}

void ExportHandler::take_exports() {
  go_on_with_file();
  auto finished = exporting_.advance();
  if (!finished) return;
  if (finished->asks == FinishedRun::Asks::to_allow) return ask_to_allow(*std::move(finished));
  if (finished->asks == FinishedRun::Asks::to_replace) return ask_to_replace(*std::move(finished));
  if (finished->cancelled) return messages_.tell("The export was cancelled: nothing was written.");
  tell_of(*finished);
}

void ExportHandler::tell_of(const FinishedRun& finished) {
  const std::string written = written_text(finished.outcomes);
  std::string problems = problems_text(finished.outcomes);
  for (const std::string& problem : {finished.record_problem, std::exchange(not_remembered_, "")}) {
    if (!problem.empty()) problems += (problems.empty() ? "" : "\n") + problem;
  }
  std::string text = problems + (problems.empty() || written.empty() ? "" : "\n") + written;
  // The result of saving is still news.
  const std::optional<Message>& message = messages_.message();
  const bool adds = finished.run.on_save && message;
  const bool is_error = !problems.empty() || (adds && message->is_error);
  if (adds) text = message->text + "\n" + text;
  is_error ? messages_.tell_error(std::move(text))
           : messages_.tell(std::move(text), last_place(finished.outcomes));
}

// If the level was left meanwhile, nothing is written.
void ExportHandler::ask_to_allow(FinishedRun finished) {
  if (finished.run.tasks.front().level_file != open_.path) return;
  std::string text =
      "These exports came with the level's file. Nothing of them is written until you allow it.";
  if (any_brings_code(finished.run))
    text += "\nThe TIC-80 carts among them bring the level's own code, which TIC-80 runs when you open them.";
  asked_run_ = std::move(finished);
  messages_.ask(Question{std::move(text), Question::Kind::allow_exports},
                [this](action::Answer answer) { answer_to_allow(answer == action::Answer::allow); });
}

// Only what was shown is allowed. If it is not, the run goes on with the presets that are allowed already.
void ExportHandler::answer_to_allow(bool allowed) {
  auto asked = std::exchange(asked_run_, std::nullopt);
  if (!asked) return;
  ExportRun& run = asked->run;
  std::vector<ExportPreset> shown;
  std::string names;
  for (auto at = run.to_allow.begin(); at != run.to_allow.end();) {
    const bool was_shown = !asked->outcomes[*at].problem;
    if (was_shown) {
      shown.push_back(run.tasks[*at].preset);
      names += (names.empty() ? "" : ", ") + label_of(shown.back());
    }
    at = was_shown && allowed ? run.to_allow.erase(at) : std::next(at);
  }
  if (allowed) {
    if (const auto kept = open_.permissions.allow(shown); !kept) not_remembered_ = kept.error();
  } else {
    messages_.tell(not_allowed_text(names));
    declined_.insert(declined_.end(), shown.begin(), shown.end());
    for (auto at = run.to_allow.rbegin(); at != run.to_allow.rend(); ++at)
      run.tasks.erase(run.tasks.begin() + static_cast<std::ptrdiff_t>(*at));
    run.to_allow.clear();
  }
  exporting_.run(std::move(run));
}

void ExportHandler::forget_level() {
  open_.permissions.open(open_.path);
  declined_.clear();
  waits_for_file_.reset();
  if (asked_run_) messages_.take_back_question();
  asked_run_.reset();
}

void ExportHandler::ask_to_replace(FinishedRun finished) {
  const std::string names = names_of(finished.outcomes);
  for (const ExportOutcome& outcome : finished.outcomes)
    finished.run.may_replace.insert(outcome.foreign.begin(), outcome.foreign.end());
  asked_run_ = std::move(finished);
  messages_.ask(Question{"These files are not exports, or were changed since. Replace them?" + names +
                             "\nThis cannot be undone.",
                         Question::Kind::replace_files},
                [this](action::Answer answer) {
                  auto asked = std::exchange(asked_run_, std::nullopt);
                  if (asked && answer == action::Answer::replace) exporting_.run(std::move(asked->run));
                });
}

}  // namespace talus
