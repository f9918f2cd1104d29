// Session: a handler for the actions of each domain, in the order in which they need one another.
#include "session.h"

#include <utility>
#include <variant>

#include "session/checks/check_handler.h"
#include "session/choices/choice_handler.h"
#include "session/debugger/debug_handler.h"
#include "session/editing/level_handler.h"
#include "session/files/file_handler.h"
#include "session/files/file_reading.h"
#include "session/messages/message_handler.h"
#include "session/run/run_handler.h"

namespace talus {

struct Session::Impl {
  Impl(Level opened, std::string opened_path, std::string unsaved_name, ExportTools tools)
      : open(std::move(opened), std::move(opened_path), tools.permissions),
        reading(messages, tools.patience),
        files({open, reading, level, run, debug, choices, messages}, std::move(tools),
              std::move(unsaved_name)) {
    choices.forget_level();  // the first level is a new one, too
    run.read_hard_case();
    debug.follow();
  }

  void apply(const Action& action) {
    std::visit([this](const auto& of_domain) { apply_in_domain(of_domain); }, action);
  }
  void advance(double seconds);

  OpenLevel open;
  MessageHandler messages;
  FileReading reading;
  ChoiceHandler choices{open};
  RunHandler run{open, choices, messages};
  CheckHandler checks{open, run, choices, messages};
  DebugHandler debug{open, run, choices, messages};
  LevelHandler level{open, reading.reader(), run, checks, choices, messages};
  FileHandler files;

 private:
  void apply_in_domain(const LevelAction& a) { level.apply(a); }
  void apply_in_domain(const ChoiceAction& a) { choices.apply(a); }
  void apply_in_domain(const RunAction& a) { run.apply(a); }
  void apply_in_domain(const DebugAction& a) { debug.apply(a); }
  void apply_in_domain(const CheckAction& a) { checks.apply(a); }
  void apply_in_domain(const FileAction& a) { files.apply(a); }
  void apply_in_domain(const PictureAction& a) { files.pictures().apply(a); }
  void apply_in_domain(const ExportAction& a) { files.exports().apply(a); }
  void apply_in_domain(const MessageAction& a) { messages.apply(a); }
};

void Session::Impl::advance(double seconds) {
  const bool was_behind = run.timeline().behind();
  reading.finish();
  run.trails().begin_turn();
  run.other_trails().begin_turn();
  run.take_compiled();
  if (!run.is_opening()) debug.play(seconds);
  debug.advance();
  checks.advance();
  if (!messages.question()) files.exports().take_exports();  // which may ask, too
  if (was_behind && !run.timeline().behind()) run.note_rerun_ended();
}

Session::Session(Level level, std::string path, std::string name, ExportTools tools)
    : impl_(std::make_unique<Impl>(std::move(level), std::move(path), std::move(name), std::move(tools))) {}
Session::~Session() = default;

void Session::apply(const Actions& actions) {
  for (const Action& action : actions) impl_->apply(action);
  impl_->run.refresh_scene();
  impl_->checks.follow_scene();
  impl_->debug.follow();
}

void Session::advance(double seconds) { impl_->advance(seconds); }

const Level& Session::level() const { return impl_->open.level; }
std::uint64_t Session::revision() const { return impl_->open.revision; }
const SheetChanges& Session::sheet_changes() const { return impl_->open.sheet_changes; }
const UndoStack& Session::history() const { return impl_->open.history; }
const std::string& Session::path() const { return impl_->open.path; }
std::string Session::file_name() const { return impl_->files.file_name(); }
std::string Session::file_names() const { return impl_->files.file_names(); }
bool Session::modified() const { return !impl_->files.is_stored(); }
const std::shared_ptr<const Level>& Session::stored_level() const { return impl_->files.stored_level(); }
ImportChoices Session::stored_choices() const { return impl_->files.stored_choices(); }
int Session::saves() const { return impl_->files.saves(); }

const std::vector<Problem>& Session::problems() const { return impl_->checks.problems(); }
const std::vector<Problem>& Session::listed_problems() const { return impl_->checks.lint_cache().problems(); }
bool Session::is_linting() const { return !impl_->checks.lint_cache().is_done(); }
double Session::lint_progress() const { return impl_->checks.lint_cache().progress(); }
const Level& Session::linted_level() const { return impl_->checks.linted(); }
const LintOptions& Session::lint_options() const { return impl_->checks.lint_options(); }
const ReachFinder& Session::reach() const { return impl_->checks.reach(); }
const Prover& Session::prover() const { return impl_->checks.prover(); }
const std::optional<HardCase>& Session::hard_case() const { return impl_->run.hard_case(); }
const Scene& Session::scene() const { return timeline().scene(); }
void Session::take_time() {
  impl_->run.trails().take_time();
  impl_->run.other_trails().take_time();
}

const State& Session::state() const { return impl_->run.simulation().state(); }
const StepRecord& Session::record() const { return timeline().record(); }
const Playback& Session::playback() const { return impl_->run.simulation().playback(); }
const Timeline& Session::timeline() const { return impl_->run.simulation().timeline(); }
const EditRule& Session::edit_rule() const { return impl_->run.simulation().rule(); }
const std::vector<TrailPoint>& Session::trail(const Branch& branch, int body, std::int64_t first,
                                              std::int64_t last) const {
  return impl_->run.trails().trail(timeline(), branch, body, first, last);
}
const Choices& Session::choices() const { return impl_->choices.choices(); }
const Debugger& Session::debugger() const { return impl_->debug.debugger(); }
bool Session::is_on_the_way() const {
  return timeline().on_the_way() || impl_->run.trails().is_behind() || impl_->run.other_trails().is_behind();
}
FrameView Session::frame_view() const { return impl_->debug.debugger().view(timeline()); }
const std::shared_ptr<const Terrain>& Session::ground() const {
  return impl_->debug.debugger().ground(timeline());
}
const std::vector<Stage>& Session::stages() const {
  return impl_->debug.debugger().stages(timeline(), impl_->choices.choices().body);
}
const State* Session::other_state() const { return impl_->debug.debugger().other_state(timeline()); }
const Frame* Session::other_frame() const { return impl_->debug.debugger().other_frame(timeline()); }
const std::vector<TrailPoint>& Session::other_trail(int body, std::int64_t first, std::int64_t last) const {
  static const std::vector<TrailPoint> kNone;
  const SideBySide& side = impl_->debug.debugger().side_by_side();
  const Branch* branch = side.branch(timeline());
  if (branch == nullptr) return kNone;
  if (side.variant() == nullptr) return trail(*branch, body, first, last);
  return impl_->run.other_trails().trail(*side.variant()->timeline(), *branch, body, first, last);
}
const StepTimes& Session::step_times() const { return impl_->run.simulation().step_times(); }
const std::optional<Message>& Session::message() const { return impl_->messages.message(); }
const std::vector<Message>& Session::earlier_messages() const { return impl_->messages.earlier(); }
const std::optional<Question>& Session::question() const { return impl_->messages.question(); }
const Exporting& Session::exporting() const { return impl_->files.exports().exporting(); }
ExportTask Session::export_task(std::size_t preset) const { return impl_->files.exports().task(preset); }
bool Session::allows_export(std::size_t preset) const {
  return impl_->open.permissions.allows(level().exports[preset]);
}
const FinishedRun* Session::asked_exports() const { return impl_->files.exports().asked(); }
std::optional<ReadingProgress> Session::reading() const { return impl_->reading.reader().progress(); }
void Session::finish_reading() { impl_->reading.wait(); }
int Session::recoveries() const { return impl_->files.recoveries(); }
std::optional<double> Session::compile_progress() const { return impl_->run.compile_progress(); }
const std::optional<PngImport>& Session::png_import() const { return impl_->files.pictures().png_import(); }
const std::optional<TileImport>& Session::tile_import() const { return impl_->files.tile_import(); }
const MapList& Session::maps() const { return impl_->files.maps(); }
const std::optional<LevelImport>& Session::level_import() const { return impl_->files.level_import(); }
std::vector<const Branch*> Session::unsaved_branches() const {
  std::vector<const Branch*> branches;
  for (int id : impl_->run.handmade_branches().all()) {
    if (const Branch* branch = timeline().find(id)) branches.push_back(branch);
  }
  return branches;
}
std::uint64_t Session::branches_revision() const { return impl_->run.handmade_branches().revision(); }
bool Session::wants_save_as() const { return impl_->files.wants_save_as(); }
bool Session::wants_save_recording() const { return impl_->files.wants_save_recording(); }
bool Session::wants_quit() const { return impl_->files.wants_quit(); }
int Session::next_stroke() const { return impl_->open.last_stroke + 1; }

}  // namespace talus
