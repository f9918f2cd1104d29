// Session: editing, playing and choosing. Files are in session_files.cpp, the past is in
// session_timeline.cpp.
#include "session.h"

#include <algorithm>
#include <cassert>
#include <type_traits>
#include <utility>

#include <talus/level/limits.h>
#include "edit/stamp.h"
#include "level/followed_spawn.h"
#include "session_impl.h"

namespace talus {
namespace {

// Whether tiles with these flags are the same to the simulation.
bool same_physics(const Level& level, std::uint8_t flags_a, std::uint8_t flags_b) {
  return role_of(flags_a, level.roles) == role_of(flags_b, level.roles) &&
         shape_of_flags(level, flags_a) == shape_of_flags(level, flags_b);
}

// Whether the simulation can see a change. Painting pixels or one plain tile over another must not cost a
// compilation.
bool changes_scene(const Level& level, const Change& change) {
  return std::visit(
      [&](const auto& c) {
        using T = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<T, CellChange>) {
          return level.tile_shapes[c.before] != level.tile_shapes[c.after] ||
                 !same_physics(level, level.tile_flags(c.before), level.tile_flags(c.after));
        } else if constexpr (std::is_same_v<T, FlagsChange>) {
          return c.sheet == SheetId::tiles && !same_physics(level, c.before, c.after);
        } else {
          return !(std::is_same_v<T, PixelChange> || std::is_same_v<T, ColorChange> ||
                   std::is_same_v<T, FlagNameChange> || std::is_same_v<T, FlagFieldsChange> ||
                   std::is_same_v<T, BrushesChange> || std::is_same_v<T, AutoTilesChange> ||
                   std::is_same_v<T, ExportsChange>);
        }
      },
      change);
}

}  // namespace

Session::Impl::Impl(Level opened, std::string opened_path, std::string unsaved_name, ExportTools tools)
    : level(std::move(opened)),
      name(std::move(unsaved_name)),
      path(std::move(opened_path)),
      format(path.empty() ? nullptr : format_for_file(path)),
      simulation(level),
      permissions(tools.permissions),
      exporting(std::move(tools)) {
  permissions.open(path);
  note_file();
  read_hard_case();
}

void Session::Impl::carry_out(const action::EditLevel& a) {
  if (reader.is_busy()) return;
  for (const Change& change : a.edit.changes) {
    if (const auto* presets = std::get_if<ExportsChange>(&change))
      permissions.note_edit(presets->before, presets->after);
  }
  edit_level(a.edit, a.stroke);
}

void Session::Impl::edit_level(const Edit& wanted, int stroke) {
  if (stroke == 0 || stroke > last_stroke) simulation.timeline().begin_series();
  last_stroke = std::max(last_stroke, stroke);
  Edit edit = wanted;
  rebase_edit(level, edit);
  if (const auto problem = problem_after(level, edit)) {
    message = Message{edit.label + ": not done, as the level then " + *problem + ".", true};
    return;
  }
  if (edit.selection) choices.selection = edit.selection->after;
  if (edit.empty()) return;
  note_change(edit);
  history.push(level, std::move(edit), stroke);
  cut_selection();
}

void Session::Impl::carry_out(const action::Undo&) {
  if (!history.can_undo() || reader.is_busy()) return;
  simulation.timeline().begin_series();
  history.undo(level);
  const Edit& edit = history.edits()[history.position()];
  if (edit.selection) choices.selection = edit.selection->before;
  note_change(edit);
  cut_selection();
  choices.pixels.check(level, choices.area);
}

void Session::Impl::carry_out(const action::Redo&) {
  if (!history.can_redo() || reader.is_busy()) return;
  simulation.timeline().begin_series();
  history.redo(level);
  const Edit& edit = history.edits()[history.position() - 1];
  if (edit.selection) choices.selection = edit.selection->after;
  note_change(edit);
  cut_selection();
  choices.pixels.check(level, choices.area);
}

void Session::Impl::carry_out(const action::StepFrame&) {
  simulation.set_running(false);
  refresh_scene();
  if (!is_opening) simulation.step();
}

void Session::Impl::carry_out(const action::ResetPlay&) {
  refresh_scene();
  keep_chosen_body([&] { simulation.reset(); });
}

void Session::Impl::carry_out(const action::SelectBody& a) {
  refresh_scene();
  choices.body = simulation.state().find(a.id) != nullptr ? a.id : 0;
}

void Session::Impl::carry_out(const action::SelectSpawn& a) {
  refresh_scene();
  choices.body = 0;
  for (const Body& body : simulation.state().bodies) {
    if (a.spawn >= 0 && body.origin.spawn == a.spawn) choices.body = body.id;
  }
}

void Session::Impl::carry_out(const action::SelectTiles& a) {
  if (!(a.area == choices.area)) choices.pixels.drop();
  choices.area = a.area;
  if (a.area.sheet == SheetId::tiles) choices.stamp = stamp_of_sheet(a.area.tiles);
}

void Session::Impl::carry_out(const action::SelectCells& a) {
  choices.selection = a.cells;
  cut_selection();
}

void Session::Impl::cut_selection() {
  if (choices.selection)
    choices.selection = shared(*choices.selection, {0, 0, level.map.width(), level.map.height()});
}

void Session::Impl::note_change(const Edit& edit) {
  ++revision;
  for (const Change& change : edit.changes) {
    if (changes_scene(level, change)) scene_changes.add(change);
    if (const auto* cell = std::get_if<CellChange>(&change)) {
      lint_cache.note_cell(cell->cell);
    } else if (std::holds_alternative<MapChange>(change)) {
      lint_cache.note_map();
    } else {
      lint_cache.note_rest();
    }
  }
}

void Session::Impl::refresh_scene() {
  if (scene_changes.empty() || (compiler.is_busy() && !scene_changes.whole)) return;
  const SceneChanges changes = std::exchange(scene_changes, {});
  if (changes.whole && SceneCompiler::is_large(level)) return compiler.start(level);
  compiler.cancel();
  is_opening = false;
  reach.note_change();
  bool has_room = true;
  keep_chosen_body([&] { has_room = simulation.edit(level, changes.whole ? nullptr : &changes.cells); });
  if (!has_room) {
    message = Message{"The run begins anew, as its edits of the level took more than " +
                          std::to_string(kMaxVersionBytes >> 20) + " MiB.",
                      false};
  }
}

// A large level is opened with nothing on its map, which the compiled scene brings.
void Session::Impl::load_player() {
  compiler.cancel();
  is_opening = SceneCompiler::is_large(level);
  if (!is_opening) return simulation.load(level);
  Level bare = level;
  std::fill(bare.map.cells().begin(), bare.map.cells().end(), std::uint8_t{0});
  simulation.load(bare);
  compiler.start(level);
}

void Session::Impl::take_compiled() {
  const auto compiled = compiler.take();
  if (!compiled) return;
  is_opening = false;
  if (!compiled->scene) {
    message = Message{"The level cannot be played: " + compiled->problem + ".", true};
    return;
  }
  reach.note_change();
  keep_chosen_body([&] { simulation.edit(*compiled->level, nullptr, compiled->scene); });
  refresh_scene();
}

void Session::Impl::keep_chosen_body(FunctionRef<void()> renumber) {
  const auto spawns = [this] {
    const Branch& branch = simulation.timeline().current();
    return branch.chapters[branch.chapter_at(simulation.timeline().frame())].version->spawns;
  };
  const Body* chosen = simulation.state().find(choices.body);
  choices.body = 0;
  if (chosen == nullptr) return renumber();
  BodyOrigin origin = chosen->origin;
  const auto before = spawns();
  renumber();
  if (origin.spawn >= 0) {
    const auto now = followed_spawn(*before, *spawns(), origin.spawn);
    if (!now) return;
    origin.spawn = *now;
  }
  for (const Body& body : simulation.state().bodies) {
    if (body.origin == origin) choices.body = body.id;
  }
}

Session::Session(Level level, std::string path, std::string name, ExportTools tools)
    : impl_(std::make_unique<Impl>(std::move(level), std::move(path), std::move(name), std::move(tools))) {
  impl_->debugger.follow(timeline(), this->level());
}
Session::~Session() = default;

void Session::apply(const Actions& actions) {
  for (const Action& action : actions) std::visit([this](const auto& a) { impl_->carry_out(a); }, action);
  impl_->refresh_scene();
  impl_->debugger.follow(timeline(), level());
}

void Session::advance(double seconds) { impl_->advance(seconds); }

const Level& Session::level() const { return impl_->level; }
std::uint64_t Session::revision() const { return impl_->revision; }
const UndoStack& Session::history() const { return impl_->history; }
const std::string& Session::path() const { return impl_->path; }
std::string Session::file_name() const { return impl_->file_name(); }
std::string Session::file_names() const { return impl_->file_names(); }
bool Session::modified() const { return !impl_->is_stored(); }
int Session::saves() const { return impl_->saves; }

const std::optional<HardCase>& Session::hard_case() const { return impl_->hard_case; }
const Scene& Session::scene() const { return timeline().scene(); }
void Session::take_time() {
  impl_->trails.take_time();
  impl_->other_trails.take_time();
}

const State& Session::state() const { return impl_->simulation.state(); }
const StepRecord& Session::record() const { return timeline().record(); }
const Playback& Session::playback() const { return impl_->simulation.playback(); }
const Timeline& Session::timeline() const { return impl_->simulation.timeline(); }
const EditRule& Session::edit_rule() const { return impl_->simulation.rule(); }
const std::vector<TrailPoint>& Session::trail(const Branch& branch, int body, std::int64_t first,
                                              std::int64_t last) const {
  return impl_->trails.trail(timeline(), branch, body, first, last);
}
const Choices& Session::choices() const { return impl_->choices; }
const Debugger& Session::debugger() const { return impl_->debugger; }
bool Session::is_on_the_way() const {
  return timeline().on_the_way() || impl_->trails.is_behind() || impl_->other_trails.is_behind();
}
FrameView Session::frame_view() const { return impl_->debugger.view(timeline()); }
const std::shared_ptr<const Terrain>& Session::ground() const { return impl_->debugger.ground(timeline()); }
const std::vector<Stage>& Session::stages() const {
  return impl_->debugger.stages(timeline(), impl_->choices.body);
}
const State* Session::other_state() const { return impl_->debugger.other_state(timeline()); }
const Frame* Session::other_frame() const { return impl_->debugger.other_frame(timeline()); }
const std::vector<TrailPoint>& Session::other_trail(int body, std::int64_t first, std::int64_t last) const {
  static const std::vector<TrailPoint> kNone;
  const SideBySide& side = impl_->debugger.side_by_side();
  const Branch* branch = side.branch(timeline());
  if (branch == nullptr) return kNone;
  if (side.variant() == nullptr) return trail(*branch, body, first, last);
  return impl_->other_trails.trail(*side.variant()->timeline(), *branch, body, first, last);
}
const StepTimes& Session::step_times() const { return impl_->simulation.step_times(); }
const std::optional<Message>& Session::message() const { return impl_->message; }
const std::optional<Question>& Session::question() const { return impl_->question; }
const Exporting& Session::exporting() const { return impl_->exporting; }
ExportTask Session::export_task(std::size_t preset) const {
  return task_of_preset(level(), preset, path(), impl_->permissions);
}
bool Session::allows_export(std::size_t preset) const {
  return impl_->permissions.allows(level().exports[preset]);
}
const FinishedRun* Session::asked_exports() const { return impl_->asked_run ? &*impl_->asked_run : nullptr; }
std::optional<ReadingProgress> Session::reading() const { return impl_->reader.progress(); }
void Session::finish_reading() { impl_->reader.wait(); }
int Session::recoveries() const { return impl_->recoveries; }
std::optional<double> Session::compile_progress() const {
  return impl_->compiler.is_busy() ? std::optional(impl_->compiler.progress()) : std::nullopt;
}
const std::optional<PngImport>& Session::png_import() const { return impl_->png_import; }
const std::optional<LevelImport>& Session::level_import() const { return impl_->level_import; }
std::vector<const Branch*> Session::unsaved_runs() const {
  std::vector<const Branch*> runs;
  for (int id : impl_->handmade_runs.all()) {
    if (const Branch* run = timeline().find(id)) runs.push_back(run);
  }
  return runs;
}
std::uint64_t Session::runs_revision() const { return impl_->handmade_runs.revision(); }
bool Session::wants_save_as() const { return impl_->wants_save_as; }
bool Session::wants_save_recording() const { return impl_->wants_save_recording; }
bool Session::wants_quit() const { return impl_->wants_quit; }
int Session::next_stroke() const { return impl_->last_stroke + 1; }

}  // namespace talus
