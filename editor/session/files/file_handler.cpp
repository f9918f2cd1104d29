// Session: opening and saving, and the questions that they lead to.
#include <chrono>
#include <filesystem>
#include <memory>
#include <utility>

#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/last_catch.h"
#include "formats/native/companion.h"
#include "formats/native/hard_case_file.h"
#include "formats/native/recording_file.h"
#include "formats/pictures/png_picture.h"
#include "session/session_impl.h"

namespace talus {
namespace {

template <class Strings>
std::string joined(const Strings& strings, std::string_view before_each) {
  std::string text;
  for (const auto& string : strings) {
    if (!text.empty()) text += ", ";
    text.append(before_each).append(string);
  }
  return text;
}

// What is told of the companion, behind another sentence.
std::string with_note(std::string text, const std::string& note) {
  if (note.empty()) return text;
  if (!text.empty()) text += " ";
  text += note + ".";
  return text;
}

// What is told of a level whose file cannot be saved.
std::string import_text(const std::string& file, const std::vector<std::string>& dropped) {
  std::string text = "Made a new level of " + file + "; saving asks for a file of its own.";
  const char* separator = " Not in it: ";
  for (const std::string& what : dropped) {
    text.append(separator).append(what);
    separator = "; ";
  }
  return dropped.empty() ? text : text + ".";
}

std::string known_extensions() {
  std::vector<std::string_view> all;
  for (const Format& format : formats()) {
    if (format.write) all.insert(all.end(), format.extensions.begin(), format.extensions.end());
  }
  return joined(all, ".");
}

// How long to wait for what is read: what is small is there at once, and of what is large the window goes on.
constexpr std::chrono::milliseconds kPatience{2000}, kPatienceForLarge{100};

std::chrono::milliseconds patience_for(const std::string& path) {
  constexpr std::uintmax_t kSmall = 256 << 10;  // bytes
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error || size <= kSmall ? kPatience : kPatienceForLarge;
}

}  // namespace

void Session::Impl::carry_out(const action::OpenFile& a) {
  if (is_png(read_start_of_file(a.path, kPngStart).value_or(""))) return open_picture(a.path, a);
  ask_before_discarding(a);
}

void Session::Impl::carry_out(const action::SaveFileAs& a) {
  const Format* chosen = format_for_file(a.path);
  if (chosen == nullptr) {
    message = Message{
        "Cannot save " + last_name(a.path) + ": its extension is none of " + known_extensions() + ".", true};
    return;
  }
  if (!save_to(a.path, *chosen)) return;
  wants_save_as = false;
  go_on_when_stored();
}

void Session::Impl::carry_out(const action::AnswerQuestion& a) {
  if (!question) return;
  const Question::Kind kind = question->kind;
  question.reset();
  if (kind == Question::Kind::changed_outside) {
    if (a.answer == action::Answer::reload) reload();
    return;
  }
  if (kind == Question::Kind::allow_exports) return answer_to_allow(a.answer == action::Answer::allow);
  if (kind == Question::Kind::replace_files) {
    auto asked = std::exchange(asked_run, std::nullopt);
    if (asked && a.answer == action::Answer::replace) exporting.run(std::move(asked->run));
    return;
  }
  if (kind == Question::Kind::drop_branch) {
    if (a.answer == action::Answer::discard) drop_branch(branch_to_drop);
    return;
  }
  if (kind == Question::Kind::unsaved_run) return answer_about_run(a.answer);
  if (kind == Question::Kind::unstored && a.answer == action::Answer::save) {
    wants_save_as = true;  // only another format can hold it
    return;
  }
  if (a.answer == action::Answer::discard) return continue_pending();
  if (a.answer == action::Answer::save && save()) return go_on_when_stored();
  if (!wants_save_as) pending.reset();
}

void Session::Impl::answer_about_run(action::Answer answer) {
  if (answer == action::Answer::save) {
    wants_save_recording = true;
  } else if (answer == action::Answer::discard) {
    if (const auto run = handmade_runs.latest()) handmade_runs.note_gone(*run);
    continue_pending();
  } else {
    pending.reset();
  }
}

void Session::Impl::carry_out(const action::CancelSaveAs&) {
  wants_save_as = wants_save_recording = false;
  pending.reset();
}

std::string Session::Impl::file_name() const { return path.empty() ? name : last_name(path); }

std::string Session::Impl::file_names() const {
  return companion.path.empty() ? file_name() : file_name() + " + " + last_name(companion.path);
}

void Session::Impl::ask_before_discarding(DiscardingAction discarding) {
  cancel_reading();
  question.reset();
  pending.reset();
  wants_save_as = wants_save_recording = false;
  if (is_stored()) return ask_about_run(std::move(discarding));
  pending = std::move(discarding);
  if (history.is_saved()) return ask_about_unstored();
  question = Question{"Save the changes to " + file_name() + "?"};
}

void Session::Impl::ask_about_unstored() {
  question = Question{file_name() + " cannot hold all of this level. Not in it: " + joined(unstored, "") +
                          ".\nA level of Talus, .talus.json, holds everything.",
                      Question::Kind::unstored};
}

// After saving.
void Session::Impl::go_on_when_stored() {
  if (pending && !unstored.empty()) return ask_about_unstored();
  continue_pending();
}

void Session::Impl::continue_pending() {
  if (auto discarding = std::exchange(pending, std::nullopt)) ask_about_run(std::move(*discarding));
}

// The run is shown, as it is what would be saved.
void Session::Impl::ask_about_run(DiscardingAction discarding) {
  const auto run = handmade_runs.latest();
  if (!run || simulation.timeline().find(*run) == nullptr) return discard_and_do(discarding);
  simulation.set_running(false);
  if (simulation.timeline().current().id != *run) carry_out(action::SwitchBranch{*run});
  pending = std::move(discarding);
  question = Question{"Keep the recording of run " + std::to_string(*run) +
                          "?\nIt has marks or inputs of yours, and is in no file yet.",
                      Question::Kind::unsaved_run};
}

void Session::Impl::discard_and_do(const DiscardingAction& discarding) {
  if (const auto* file = std::get_if<action::OpenFile>(&discarding)) {
    open(*file);
  } else if (const auto* saved = std::get_if<action::RecoverLevel>(&discarding)) {
    recover(*saved);
  } else if (std::holds_alternative<action::NewLevel>(discarding)) {
    replace_level(Level(), {}, nullptr);
    name = kUnnamed;
  } else {
    wants_quit = true;
  }
}

void Session::Impl::read_beside(const std::string& file, FileReader::Work work) {
  read_beside(file, std::move(work), patience_for(file));
}

void Session::Impl::read_beside(const std::string& file, FileReader::Work work,
                                std::chrono::milliseconds patience) {
  const auto guarded = [this, file, work = std::move(work)](const Progress& progress) {
    try {
      return work(progress);
    } catch (...) {
      return FileReader::Finish([this, file, problem = "cannot be read: " + caught_text()] {
        cancel_reading();
        message = Message{to_string(FormatError{"", problem}, file), true};
      });
    }
  };
  reader.start(last_name(file), guarded, patience);
}

// Of a file that another program changed, what is here stays as it is, and differs from the file.
void Session::Impl::cancel_reading() {
  reader.cancel();
  if (!std::exchange(is_reloading, false)) return;
  stamp = changed_from;
  history.forget_saved();
}

void Session::Impl::open(const action::OpenFile& file) {
  read_beside(file.path, [this, file](const Progress& progress) -> FileReader::Finish {
    auto opened = std::make_shared<OpenedFile>(read_for_opening(file.path, !file.as_copy, progress));
    return [this, file, opened] { take_opened(file, std::move(*opened)); };
  });
}

void Session::Impl::take_opened(const action::OpenFile& file, OpenedFile opened) {
  if (const auto* error = std::get_if<FormatError>(&opened.content)) {
    message = Message{to_string(*error, file.path), true};
    return;
  }
  if (auto* import = std::get_if<LevelImport>(&opened.content)) {
    level_import = std::move(*import);
    return;
  }
  if (const auto* recording = std::get_if<Recording>(&opened.content))
    return open_recording(file.path, *recording, opened.scenes);
  LoadedLevel& loaded = std::get<LoadedLevel>(opened.content);
  if (file.as_copy) {
    replace_level(std::move(loaded.level), {}, nullptr);
    const std::string file_name = last_name(file.path);
    name = file_name.substr(0, file_name.find('.')) + " (copy)";
  } else if (loaded.format->write == nullptr) {
    open_imported(file.path, std::move(loaded));
  } else {
    replace_level(std::move(loaded.level), loaded.path, loaded.format, std::move(loaded.companion));
    if (stamp && loaded.path == file.path) stamp = opened.stamp;
    if (!loaded.note.empty()) message = Message{with_note("", loaded.note), false};
  }
}

// A file that cannot be written again.
void Session::Impl::open_imported(const std::string& file, LoadedLevel loaded) {
  replace_level(std::move(loaded.level), file, loaded.format);
  message = Message{with_note(import_text(last_name(file), loaded.dropped), loaded.note), false};
}

void Session::Impl::carry_out(const action::SetLevelImport& a) {
  if (!level_import) return;
  read_beside(level_import->path, [this, a, path = level_import->path](const Progress& progress) {
    auto plan = std::make_shared<FormatResult<LoadedLevel>>(load_level(path, a.choices, progress));
    return FileReader::Finish([this, a, plan] {
      if (!level_import) return;
      level_import->choices = a.choices;
      level_import->plan = std::move(*plan);
    });
  });
}

void Session::Impl::carry_out(const action::ApplyLevelImport&) {
  if (!level_import || !level_import->plan || reader.is_busy()) return;
  LevelImport import = *std::exchange(level_import, std::nullopt);
  open_imported(import.path, *std::move(import.plan));
}

// The level becomes what it was at the recording's end, so that playing goes on from there as it was played.
void Session::Impl::open_recording(const std::string& file, const Recording& recording,
                                   const EndScenes& scenes) {
  Level last = recording.level;
  if (!recording.edits.empty()) put_version(*recording.edits.back().version, last);
  replace_level(std::move(last), {}, nullptr);
  name = last_name(file);
  compiler.cancel();
  is_opening = false;
  simulation.load(recording, scenes);
}

void Session::Impl::recover(const action::RecoverLevel& saved) {
  const auto read = [this, saved](const Progress& progress) {
    auto file = std::make_shared<FormatResult<LoadedLevel>>(tl::unexpected(FormatError{}));
    if (!saved.path.empty()) *file = load_level(saved.path, {}, progress.part(0, 0.5));
    const EndScenes scenes = saved.recordings.empty()
                                 ? EndScenes{}
                                 : compile_ends(*saved.recordings.front(), progress.part(0.5, 1));
    return FileReader::Finish(
        [this, saved, file, scenes] { take_recovered(saved, std::move(*file), scenes); });
  };
  read_beside(saved.path.empty() ? saved.name : saved.path, read,
              SceneCompiler::is_large(*saved.level) ? kPatienceForLarge : patience_for(saved.path));
}

void Session::Impl::take_recovered(const action::RecoverLevel& saved, FormatResult<LoadedLevel> file,
                                   const EndScenes& scenes) {
  ++recoveries;
  if (file)
    replace_level(std::move(file->level), saved.path, file->format, std::move(file->companion));
  else
    replace_level(Level(), saved.path, saved.path.empty() ? nullptr : format_for_file(saved.path));
  name = saved.name;
  edit_level(replace_by(level, saved.level, "Recover what was not saved"), 0);
  read_hard_case();
  history.forget_saved();
  if (!saved.recordings.empty()) recover_runs(saved.recordings, scenes);
  message = Message{
      "Recovered " + file_name() + ". It is not saved yet; undo goes back to what the file has.", false};
}

// On the level as it is by now, which differs from the recordings' last ones where pixels were drawn later.
void Session::Impl::recover_runs(const std::vector<std::shared_ptr<const Recording>>& recordings,
                                 const EndScenes& scenes) {
  compiler.cancel();
  is_opening = false;
  simulation.load(*recordings.front(), scenes);
  handmade_runs.note_input(simulation.timeline().current().id);
  for (std::size_t i = 1; i < recordings.size(); ++i)
    handmade_runs.note_input(simulation.timeline().add(*recordings[i]));
  scene_changes = {};
  scene_changes.whole = true;
}

void Session::Impl::carry_out(const action::CheckFile&) {
  if (stamp && !question && !wants_save_as && !level_import && !reader.is_busy())
    take_file_change(level_change(path, *stamp));
}

void Session::Impl::note_file() { stamp = path.empty() ? std::nullopt : stamp_of_level(path); }

// Each state of the file is asked or told about once.
void Session::Impl::take_file_change(FilesChange found) {
  const std::string changed = found.of_companion ? last_name(companion_path(path)) : file_name();
  FileStamp* gone = found.of_companion && stamp->companion ? &*stamp->companion : &stamp->file;
  if (found.change == FileChange::none || (found.change == FileChange::gone && gone->is_gone())) return;
  if (found.change == FileChange::gone) {
    gone->set_gone();
    history.forget_saved();
    message = Message{changed + " was removed or renamed by another program. Saving writes it anew.", true};
    return;
  }
  changed_from = stamp;
  note_file();
  if (is_stored()) return reload();
  question = Question{changed +
                          " was changed by another program.\n"
                          "Read it again, or keep what is here? Undo goes back from the one to the other.",
                      Question::Kind::changed_outside};
}

// As an edit, so that nothing is lost whichever was right.
void Session::Impl::reload() {
  is_reloading = true;
  note_file();  // first: what is written from now on is another change
  read_beside(path, [this, file = path](const Progress& progress) {
    auto loaded = std::make_shared<FormatResult<LoadedLevel>>(load_level(file, {}, progress));
    return FileReader::Finish([this, loaded] { take_reloaded(*loaded); });
  });
}

void Session::Impl::take_reloaded(const FormatResult<LoadedLevel>& loaded) {
  is_reloading = false;
  if (!loaded) {
    history.forget_saved();
    message = Message{
        "Another program changed this file, and it cannot be read again: " + to_string(loaded.error(), path),
        true};
    return;
  }
  const bool is_companion_broken =
      !companion.path.empty() && loaded->companion.path.empty() && !loaded->note.empty();
  if (is_companion_broken) {
    history.forget_saved();
    message = Message{with_note("Another program changed what goes with " + file_name() +
                                    ", so the level stays as it is here.",
                                loaded->note),
                      true};
    return;
  }
  edit_level(
      replace_by(level, std::make_shared<const Level>(loaded->level), "Read " + file_name() + " again"), 0);
  read_hard_case();
  history.mark_saved();
  companion = loaded->companion;
  unstored.clear();
  message = Message{
      with_note("Read " + file_names() + " again, as another program changed it. Undo takes that back.",
                loaded->note),
      false};
}

void Session::Impl::carry_out(const action::SaveRecording& a) {
  const Timeline& timeline = simulation.timeline();
  if (timeline.behind()) {
    message = Message{"The recording is being run again; save it when that is done.", true};
    return;
  }
  const auto saved = save_recording(timeline.recording(timeline.current(), level), a.path);
  if (saved) handmade_runs.note_saved(timeline.current().id);
  message =
      saved
          ? Message{"Saved " + last_name(a.path) + ", " + std::to_string(timeline.last_frame()) + " frames.",
                    false}
          : Message{to_string(saved.error(), a.path), true};
  if (saved && std::exchange(wants_save_recording, false)) continue_pending();
}

void Session::Impl::replace_level(Level opened, std::string opened_path, const Format* opened_format,
                                  CompanionFile opened_companion) {
  level = std::move(opened);
  path = std::move(opened_path);
  format = opened_format;
  companion = std::move(opened_companion);
  unstored.clear();
  if (format && !format->write) {  // without a file of its own, it cannot be written over what was read
    name = last_name(path);
    path.clear();
    format = nullptr;
  }
  note_file();
  permissions.open(path);
  declined.clear();
  forget_asked_exports();
  choices.overlays.set(OverlayId::answer, false);
  read_hard_case();
  history.clear();
  ++revision;
  load_player();
  handmade_runs.clear();
  lint_cache.note_map();
  reach.forget();
  trails = other_trails = {};
  debugger.forget_run();
  scene_changes = {};
  choices.body = 0;
  choices.selection.reset();
  choices.pixels.drop();
  // An old error no longer holds, but what a saving on the way here dropped is still news.
  if (message && message->is_error) message.reset();
}

void Session::Impl::read_hard_case() {
  hard_case = hard_case_of(level).value_or(std::nullopt);
  simulation.set_script(hard_case ? hard_case->input : std::vector<CaseInput>());
  if (hard_case) choices.overlays.set(OverlayId::answer, true);
}

bool Session::Impl::save() {
  if (reader.is_busy()) return false;  // another level, or another state of this one, is on its way
  if (path.empty() || format == nullptr) {
    wants_save_as = true;
    return false;
  }
  if (const auto found = stamp ? level_change(path, *stamp) : FilesChange();
      found.change == FileChange::content) {
    take_file_change(found);
    return false;
  }
  return save_to(path, *format);
}

bool Session::Impl::save_to(const std::string& saved_path, const Format& saved_format) {
  FormatResult<SavedLevel> saved = save_level(level, saved_format, saved_path, companion);
  if (!saved) {
    message = Message{to_string(saved.error(), saved_path), true};
    return false;
  }
  path = saved_path;
  format = &saved_format;
  companion = std::move(saved->companion);
  unstored = std::move(saved->dropped);
  note_file();
  const auto kept = permissions.save(path, level.exports);
  history.mark_saved();
  ++saves;
  std::string text = "Saved " + file_names() + ".";
  if (!unstored.empty()) text += " Not stored in this format: " + joined(unstored, "") + ".";
  text = with_note(std::move(text), saved->note);
  message = Message{kept ? text : text + "\n" + kept.error(), !kept};
  export_on_save();
  return true;
}

}  // namespace talus
