// Opens and saves files, with the questions about that.
#include "file_handler.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/ldtk/ldtk_companion.h"
#include "formats/native/recording_file.h"
#include "formats/pictures/png_picture.h"
#include "formats/text/utf8_text.h"

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

// The note on the companion, after another sentence.
std::string with_note(std::string text, const std::string& note) {
  if (note.empty()) return text;
  if (!text.empty()) text += " ";
  text += note + ".";
  return text;
}

// The message about a level of another program's file. can_save: whether saving goes into that file.
std::string import_text(const std::string& file, bool can_save, const std::vector<std::string>& dropped) {
  std::string text =
      can_save ? "Opened " + file + "." : "Made a new level from " + file + "; saving asks for a file name.";
  const char* separator = can_save ? " Saving keeps what Talus does not show: " : " Not in it: ";
  for (const std::string& what : dropped) {
    text.append(separator).append(what);
    separator = "; ";
  }
  return dropped.empty() ? text : text + ".";
}

// The name of a file that was saved with a level: its whole path, if it lies outside of the level's folder.
std::string name_beside(const std::string& level, const std::string& file) {
  const auto folder = real_folder_of(level), place = real_path(file);
  return folder && place && !is_within(*place, *folder) ? printable(*place) : last_name(file);
}

std::string known_extensions() {
  std::vector<std::string_view> all;
  for (const Format& format : formats()) {
    if (format.write && !format.writes_back)
      all.insert(all.end(), format.extensions.begin(), format.extensions.end());
  }
  return joined(all, ".");
}

}  // namespace

FileHandler::FileHandler(const Parts& parts, ExportTools tools, std::string name)
    : open_(parts.open),
      reading_(parts.reading),
      level_(parts.level),
      run_(parts.run),
      debug_(parts.debug),
      messages_(parts.messages),
      reads_(tools.reads),
      mappings_(tools.mappings),
      pictures_(open_, reading_, level_, parts.choices, messages_),
      exports_(open_, level_, messages_, std::move(tools)),
      name_(std::move(name)) {
  open_.format = open_.path.empty() ? nullptr : format_for_file(open_.path);
  open_.permissions.open(open_.path);
  source_.path = open_.path;
  base_ = std::make_shared<const Level>(open_.level);
  note_file();
  reading_.when_given_up([this] { note_reading_given_up(); });
}

template <>
void FileHandler::carry_out(const action::NewLevel& a) {
  ask_before_discarding(a);
}

template <>
void FileHandler::carry_out(const action::OpenTiles& a) {
  const TileSize now = open_.level.map.tile_size();
  reading_.read(a.path, [this, a, now](const Progress&) -> FileReader::Finish {
    auto read = std::make_shared<FormatResult<TileImport>>(
        read_tile_import(a.path, a.adds, a.adds ? now : TileSize{16, 16}));
    return [this, a, read] {
      if (!*read) return messages_.tell_error(to_string(read->error(), a.path));
      tile_import_ = std::move(**read);
    };
  });
}

template <>
void FileHandler::carry_out(const action::ApplyTiles& a) {
  if (!tile_import_ || !problem_of(*tile_import_, a).empty()) return;
  auto level = level_with(*tile_import_, a, open_.level);
  if (!level) return messages_.tell_error(to_string(level.error(), tile_import_->path));
  const TileImport import = *std::exchange(tile_import_, std::nullopt);
  auto made = std::make_shared<const Level>(*std::move(level));
  if (!import.adds) return ask_before_discarding(TakeNewLevel{made, made->tilesets.front().name});
  level_.edit_by_user(replace_by(open_.level, made, "Add tileset " + made->tilesets.back().name));
}

template <>
void FileHandler::carry_out(const action::CancelTiles&) {
  tile_import_.reset();
}

template <>
void FileHandler::carry_out(const action::OpenMaps& a) {
  list_maps(a.paths, true, [this, paths = a.paths] {
    if (!maps_.files().empty()) return ask_before_discarding(action::OpenFile{maps_.files().front()});
    const std::string where = joined(paths, "");
    messages_.tell_error(maps_.is_cut()
                             ? "There is no map among the first " + std::to_string(MapList::kMaxEntries) +
                                   " files in " + where + ": open the folder of a game."
                             : "There is no map in " + where + ".");
  });
}

template <>
void FileHandler::carry_out(const action::OpenNextMap& a) {
  const auto open = [this, a] {
    const std::string next = maps_.beside(a.step);
    if (next.empty()) return messages_.tell("There is no other map to open.");
    ask_before_discarding(action::OpenFile{next});
  };
  if (maps_.opened().empty() || maps_.current()) return open();
  list_maps({std::filesystem::path(maps_.opened()).parent_path().string()}, false, open);
}

template <>
void FileHandler::carry_out(const action::OpenFile& a) {
  std::error_code ignored;
  if (std::filesystem::is_directory(a.path, ignored)) return carry_out(action::OpenMaps{{a.path}});
  if (is_png(read_start_of_file(a.path, kPngStart).value_or("")))
    return pictures_.open(a.path, {.cart = [this, a] { ask_before_discarding(a); },
                                   .tiles = [this, a] { carry_out(action::OpenTiles{a.path}); }});
  ask_before_discarding(a);
}

template <>
void FileHandler::carry_out(const action::RecoverLevel& a) {
  ask_before_discarding(a);
}

template <>
void FileHandler::carry_out(const action::Quit& a) {
  ask_before_discarding(a);
}

template <>
void FileHandler::carry_out(const action::CancelReading&) {
  reading_.cancel();
}

template <>
void FileHandler::carry_out(const action::SaveFile&) {
  save();
}

template <>
void FileHandler::carry_out(const action::SaveFileAs& a) {
  if (open_.format != nullptr && open_.format->keeps_beside && a.path == companion_path(open_.path)) {
    open_.wants_save_as = false;
    if (save()) go_on_when_stored();
    return;
  }
  const Format* chosen = format_for_file(a.path);
  if (chosen == nullptr) {
    return messages_.tell_error("Cannot save " + last_name(a.path) + ": its extension must be one of " +
                                known_extensions() + ".");
  }
  if (a.path == open_.path && asks_about_link([this, a] { carry_out(a); })) return;
  if (!save_to(a.path, *chosen)) return;
  open_.wants_save_as = false;
  go_on_when_stored();
}

void FileHandler::answer_about_changes(action::Answer answer) {
  if (answer == action::Answer::discard) return continue_pending();
  if (answer == action::Answer::save && save()) return go_on_when_stored();
  if (!open_.wants_save_as) pending_.reset();
}

void FileHandler::answer_about_branch(action::Answer answer) {
  if (answer == action::Answer::save) {
    wants_save_recording_ = true;
  } else if (answer == action::Answer::discard) {
    if (const auto branch = run_.handmade_branches().latest()) run_.give_up(*branch);
    continue_pending();
  } else {
    pending_.reset();
  }
}

template <>
void FileHandler::carry_out(const action::CancelSaveAs&) {
  open_.wants_save_as = wants_save_recording_ = false;
  pending_.reset();
}

std::string FileHandler::file_name() const { return open_.path.empty() ? name_ : last_name(open_.path); }

std::string FileHandler::file_names() const {
  return companion_.path.empty() ? file_name() : file_name() + " + " + last_name(companion_.path);
}

void FileHandler::ask_before_discarding(DiscardingAction discarding) {
  reading_.cancel();
  messages_.take_back_question();
  pending_.reset();
  open_.wants_save_as = wants_save_recording_ = false;
  if (is_stored()) return ask_about_branch(std::move(discarding));
  pending_ = std::move(discarding);
  if (open_.history.is_saved()) return ask_about_unstored();
  messages_.ask(Question{"Save the changes to " + file_name() + "?"},
                [this](action::Answer answer) { answer_about_changes(answer); });
}

void FileHandler::ask_about_unstored() {
  messages_.ask(Question{file_name() + " cannot hold all of this level. Not in it: " + joined(unstored_, "") +
                             ".\nA level of Talus, .talus.json, holds everything.",
                         Question::Kind::unstored},
                [this](action::Answer answer) {
                  if (answer != action::Answer::save) return answer_about_changes(answer);
                  open_.wants_save_as = true;  // only another format can hold it
                });
}

// Called after saving.
void FileHandler::go_on_when_stored() {
  if (pending_ && !unstored_.empty()) return ask_about_unstored();
  continue_pending();
}

void FileHandler::continue_pending() {
  if (auto discarding = std::exchange(pending_, std::nullopt)) ask_about_branch(std::move(*discarding));
}

// Shows the branch that would be saved.
void FileHandler::ask_about_branch(DiscardingAction discarding) {
  const auto branch = run_.handmade_branches().latest();
  if (!branch || run_.timeline().find(*branch) == nullptr) return discard_and_do(discarding);
  run_.set_running(false);
  if (run_.timeline().current().id != *branch) run_.switch_to(*branch);
  pending_ = std::move(discarding);
  messages_.ask(Question{"Keep the recording of branch " + std::to_string(*branch) +
                             "?\nIt has marks or inputs of yours, and is not saved in a file yet.",
                         Question::Kind::unsaved_branch},
                [this](action::Answer answer) { answer_about_branch(answer); });
}

void FileHandler::discard_and_do(const DiscardingAction& discarding) {
  if (const auto* file = std::get_if<action::OpenFile>(&discarding)) {
    read_and_open(*file);
  } else if (const auto* saved = std::get_if<action::RecoverLevel>(&discarding)) {
    recover(*saved);
  } else if (const auto* fresh = std::get_if<action::NewLevel>(&discarding)) {
    replace_level(new_level(fresh->tile, fresh->width, fresh->height, fresh->content), {}, nullptr);
    level_.choose_first_tile();
    name_ = kUnnamed;
  } else if (const auto* chosen = std::get_if<TakeImport>(&discarding)) {
    open_import(std::move(*chosen->import));
  } else if (const auto* made = std::get_if<TakeNewLevel>(&discarding)) {
    replace_level(*made->level, {}, nullptr);
    level_.choose_first_tile();
    name_ = made->name;
  } else {
    wants_quit_ = true;
  }
}

void FileHandler::read_and_open(const action::OpenFile& file) {
  if (!file.as_copy) maps_.note_opened(file.path);
  unread_for_.clear();
  const ImportChoices first = with_permissions(file.path, {.mapping = mappings_.find(file.path)});
  reading_.read(file.path, [this, file, first](const Progress& progress) -> FileReader::Finish {
    auto opened = std::make_shared<OpenedFile>(read_for_opening(file.path, !file.as_copy, first, progress));
    return [this, file, opened] { take_opened(file, std::move(*opened)); };
  });
}

void FileHandler::take_opened(const action::OpenFile& file, OpenedFile opened) {
  if (const auto* error = std::get_if<FormatError>(&opened.content))
    return messages_.tell_error(to_string(*error, file.path));
  if (const auto refused = refused_in(opened); is_unasked(file.path, refused)) {
    auto kept = std::make_shared<OpenedFile>(std::move(opened));
    return ask_about_outside(
        file.path, refused, [this, file] { read_and_open(file); },
        [this, file, kept] { take_opened(file, std::move(*kept)); });
  }
  if (auto* import = std::get_if<LevelImport>(&opened.content)) {
    level_import_ = std::move(*import);
    return;
  }
  if (const auto* recording = std::get_if<Recording>(&opened.content))
    return open_recording(file.path, *recording, opened.scenes);
  LoadedLevel& loaded = std::get<LoadedLevel>(opened.content);
  const std::string told = messages_.message() ? messages_.message()->text : "";
  if (file.as_copy) {
    loaded.level.tiled.reset();
    loaded.level.ldtk.reset();
    replace_level(std::move(loaded.level), {}, nullptr);
    const std::string file_name = last_name(file.path);
    name_ = file_name.substr(0, file_name.find('.')) + " (copy)";
  } else if (loaded.format->write == nullptr || loaded.format->writes_back) {
    const std::vector<std::string> dropped = loaded.dropped;
    open_imported(file.path, std::move(loaded));
    note_source(file.path, opened.stamp, {}, dropped);
  } else {
    replace_level(std::move(loaded.level), loaded.path, loaded.format, std::move(loaded.companion));
    if (loaded.path == file.path) note_source(file.path, opened.stamp, {}, {});
    if (!loaded.note.empty()) messages_.tell(with_note("", loaded.note));
  }
  offer_ground(told);
  if (!file.as_copy && (!messages_.message() || messages_.message()->text == told)) tell_place_in_list();
}

void FileHandler::open_imported(const std::string& file, LoadedLevel loaded) {
  const bool can_save = loaded.format->can_save();
  replace_level(std::move(loaded.level), can_save ? loaded.path : file, loaded.format,
                std::move(loaded.companion));
  if (can_save && loaded.dropped.empty() && loaded.note.empty()) return;
  messages_.tell(with_note(import_text(last_name(file), can_save, loaded.dropped), loaded.note));
}

template <>
void FileHandler::carry_out(const action::SetLevelImport& a) {
  if (!level_import_) return;
  const auto choices = with_permissions(level_import_->path, a.choices);
  reading_.read(level_import_->path, [this, a, choices,
                                      path = level_import_->path](const Progress& progress) {
    auto stamp = std::make_shared<std::optional<LevelStamp>>();
    auto plan = std::make_shared<FormatResult<LoadedLevel>>(load_with_stamp(path, choices, progress, *stamp));
    return FileReader::Finish([this, a, plan, stamp] {
      if (!level_import_) return;
      level_import_->stamp = *stamp;
      level_import_->choices = a.choices;
      level_import_->plan = std::move(*plan);
    });
  });
}

template <>
void FileHandler::carry_out(const action::AskLdtkMapping&) {
  if (!open_.level.ldtk || open_.format == nullptr || !open_.format->keeps_beside ||
      reading_.reader().is_busy())
    return;
  level_import_ =
      LevelImport{open_.path, {}, {}, choices_of(open_.level), LoadedLevel{open_.level, open_.format}, true};
}

// What was added to the level stays.
void FileHandler::apply_mapping(const Level& read) {
  Level fresh = *read.ldtk->opened;
  fresh.ldtk = read.ldtk;
  auto moved = move_ldtk_additions(open_.level, fresh, file_name());
  if (!moved) return messages_.tell_error(to_string(moved.error(), open_.path));
  mappings_.keep(open_.path, read.ldtk->mapping);
  level_.edit(replace_by(open_.level, std::make_shared<const Level>(std::move(moved->level)),
                         "Change the LDtk mapping"));
  messages_.tell(
      with_note("Read " + file_name() + " with another mapping. Undo takes that back.", moved->note));
}

template <>
void FileHandler::carry_out(const action::ApplyLevelImport&) {
  if (!level_import_ || !level_import_->plan || reading_.reader().is_busy()) return;
  LevelImport import = *std::exchange(level_import_, std::nullopt);
  if (import.is_mapping) return apply_mapping(import.plan->level);
  if (!is_unasked(import.path, import.plan->refused)) return take_import(std::move(import));
  auto kept = std::make_shared<LevelImport>(std::move(import));
  ask_about_outside(
      kept->path, kept->plan->refused, [this, kept] { read_import_again(kept); },
      [this, kept] { take_import(std::move(*kept)); });
}

void FileHandler::take_import(LevelImport import) {
  ask_before_discarding(TakeImport{std::make_shared<LevelImport>(std::move(import))});
}

void FileHandler::open_import(LevelImport import) {
  const std::vector<std::string> dropped = import.plan->dropped;
  const std::string told = messages_.message() ? messages_.message()->text : "";
  if (import.choices.mapping) mappings_.keep(import.path, *import.choices.mapping);
  open_imported(import.path, *std::move(import.plan));
  note_source(import.path, import.stamp, import.choices, dropped);
  offer_ground(told);
}

// The level becomes that of the recording's end, so that playing goes on as it was recorded.
void FileHandler::open_recording(const std::string& file, const Recording& recording,
                                 const EndScenes& scenes) {
  Level last = recording.level;
  if (!recording.edits.empty()) put_version(*recording.edits.back().version, last);
  replace_level(std::move(last), {}, nullptr);
  name_ = last_name(file);
  run_.load(recording, scenes);
}

void FileHandler::recover(const action::RecoverLevel& saved) {
  const ImportChoices choices = with_permissions(saved.path, saved.choices);
  const auto read = [this, saved, choices](const Progress& progress) {
    auto file = std::make_shared<FormatResult<LoadedLevel>>(tl::unexpected(FormatError{}));
    if (!saved.path.empty()) *file = load_level(saved.path, choices, progress.part(0, 0.5));
    const EndScenes scenes = saved.recordings.empty()
                                 ? EndScenes{}
                                 : compile_ends(*saved.recordings.front(), progress.part(0.5, 1));
    return FileReader::Finish(
        [this, saved, file, scenes] { take_recovered(saved, std::move(*file), scenes); });
  };
  reading_.read(saved.path.empty() ? saved.name : saved.path, read, SceneCompiler::is_large(*saved.level));
}

// The files gave neither level their origin, but where a map of Tiled began is known.
std::pair<Level, std::string> FileHandler::joined_with_file(const action::RecoverLevel& saved) const {
  Level base = *saved.base, mine = *saved.level;
  if (saved.choices.frame) {
    auto origin = std::make_shared<TiledOrigin>();
    origin->frame = *saved.choices.frame;
    base.tiled = mine.tiled = origin;
  }
  MergedLevel merged = merge_levels(base, mine, open_.level, MergeSide::mine);
  if (!merged.apart.empty())
    return {std::move(merged.level),
            "Another program changed the file since, which is not in it, as " + merged.apart + "."};
  if (!merged.conflicts.empty())
    return {std::move(merged.level), "Another program changed the file since. Both changed " +
                                         joined(merged.conflicts, "") + ": they are as you had them."};
  const bool is_mine = merged.level == mine;
  return {std::move(merged.level),
          is_mine ? "" : "It has what another program changed in the file since, too."};
}

void FileHandler::take_recovered(const action::RecoverLevel& saved, FormatResult<LoadedLevel> file,
                                 const EndScenes& scenes) {
  ++recoveries_;
  if (file)
    replace_level(std::move(file->level), saved.path, file->format, std::move(file->companion));
  else
    replace_level(Level(), saved.path, saved.path.empty() ? nullptr : format_for_file(saved.path));
  name_ = saved.name;
  std::shared_ptr<const Level> recovered = saved.level;
  std::string note;
  if (file && saved.base) {
    auto [level, about] = joined_with_file(saved);
    recovered = std::make_shared<const Level>(std::move(level));
    note = about.empty() ? about : " " + about;
  }
  level_.edit(replace_by(open_.level, recovered, "Recover what was not saved"));
  run_.read_hard_case();
  level_.forget_saved();
  if (!saved.recordings.empty()) run_.recover(saved.recordings, scenes);
  messages_.tell("Recovered " + file_name() + ". It is not saved yet; undo goes back to what the file has." +
                 note);
}

template <>
void FileHandler::carry_out(const action::CancelLevelImport&) {
  level_import_.reset();
}

template <>
void FileHandler::carry_out(const action::CheckFile&) {
  if (!stamp_ || messages_.question() || open_.wants_save_as || level_import_ || reading_.reader().is_busy())
    return;
  if (may_have_changed(source_.path, declined_ ? *declined_ : *stamp_)) look_at_files();
}

template <>
void FileHandler::carry_out(const action::SaveRecording& a) {
  const Timeline& timeline = run_.timeline();
  if (timeline.behind())
    return messages_.tell_error("The recording is being run again; save it when that is done.");
  const auto saved = save_recording(timeline.recording(timeline.current(), open_.level), a.path);
  if (!saved) return messages_.tell_error(to_string(saved.error(), a.path));
  run_.note_saved(timeline.current().id);
  messages_.tell("Saved " + last_name(a.path) + ", " + std::to_string(timeline.last_frame()) + " frames.");
  if (std::exchange(wants_save_recording_, false)) continue_pending();
}

void FileHandler::replace_level(Level opened, std::string opened_path, const Format* opened_format,
                                CompanionFile opened_companion) {
  open_.path = std::move(opened_path);
  open_.format = opened_format;
  companion_ = std::move(opened_companion);
  unstored_.clear();
  // Without a file of its own, so that it does not overwrite the one that was read.
  if (open_.format && !open_.format->can_save()) {
    name_ = last_name(open_.path);
    open_.path.clear();
    open_.format = nullptr;
  }
  source_ = Source{open_.path, {}, {}};
  has_given_up_ = is_saving_ = saves_when_read_ = false;
  declined_.reset();
  places_.forget();
  failures_ = 0;
  exports_.forget_level();
  level_.replace(std::move(opened));
  stamp_.reset();
  note_file();
  base_ = std::make_shared<const Level>(open_.level);
  debug_.forget_timeline();
  // An old error no longer holds, but things that a save just before has dropped are still to be reported.
  messages_.dismiss_errors();
}

bool FileHandler::save() {
  if (reading_.reader().is_busy())
    return false;  // another level, or another state of this one, is being read
  if (open_.path.empty() || open_.format == nullptr) {
    open_.wants_save_as = true;
    return false;
  }
  const auto found = [&] { return stamp_ ? level_change(source_.path, *stamp_) : FilesChange(); };
  if (const FilesChange change = found(); change.change == FileChange::content) {
    is_saving_ = true;
    take_file_change(change);
    is_saving_ = false;
    saves_when_read_ = reading_.reader().is_busy();
    if (messages_.question() || saves_when_read_ || found().change == FileChange::content) return false;
  }
  if (asks_about_tileset()) return false;
  const auto go_on = [this] {
    if (save()) go_on_when_stored();
  };
  if (asks_about_link(go_on)) return false;
  return save_to(open_.path, *open_.format);
}

bool FileHandler::save_to(const std::string& saved_path, const Format& saved_format) {
  Level level = open_.level;
  const bool is_into_old = saved_format.writes_back || saved_path == source_.path;
  if (is_into_old && !saves_into_newest(level)) return false;
  FormatResult<SavedLevel> saved = save_level(level, saved_format, saved_path, companion_, base_.get());
  if (!saved) {
    messages_.tell_error(to_string(saved.error(), saved_path));
    return false;
  }
  if (saved_path != source_.path) {
    source_ = Source{saved_path, {}, {}};
    stamp_.reset();
  }
  base_ = std::make_shared<const Level>(std::move(level));
  declined_.reset();
  has_given_up_ = false;
  open_.path = saved_path;
  open_.format = &saved_format;
  companion_ = std::move(saved->companion);
  unstored_ = std::move(saved->dropped);
  if (const std::string place = places_.elsewhere(open_.path); !place.empty())
    places_.allow(open_.path, place);
  note_file(saved->others);
  const auto kept = open_.permissions.save(open_.path, open_.level.exports);
  level_.mark_saved();
  ++saves_;
  messages_.dismiss_errors();  // such as that it could not be saved
  std::string text = "Saved " + file_names();
  for (const std::string& other : saved->others) text += " + " + name_beside(open_.path, other);
  text += ".";
  if (saved_format.keeps_beside) {
    mappings_.forget(open_.path);
    text = "Saved what was added to " + file_name() + ", which LDtk owns, in " + last_name(companion_.path) +
           ".";
  }
  if (!unstored_.empty()) text += " Not stored in this format: " + joined(unstored_, "") + ".";
  text = with_note(std::move(text), saved->note);
  kept ? messages_.tell(text) : messages_.tell_error(text + "\n" + kept.error());
  exports_.export_on_save();
  return true;
}

void FileHandler::apply(const FileAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

}  // namespace talus
