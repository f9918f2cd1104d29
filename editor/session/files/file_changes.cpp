// Other programs change the files of the level: they are read again, and merged with what was changed here.
#include <algorithm>
#include <memory>
#include <utility>

#include "file_handler.h"
#include "formats/files/atomic_file.h"
#include "formats/files/link_target.h"
#include "formats/files/real_path.h"
#include "formats/text/content_hash.h"
#include "level/merge.h"
#include "level/moved_ground.h"

namespace talus {
namespace {

// How often files that cannot be read are tried before that is reported: another program may be writing them.
constexpr int kReadingTries = 4;
constexpr std::int64_t kLarge = 256 << 10;  // bytes of all files together

std::string sentences(const std::string& text, const std::string& note) {
  return note.empty() ? text : text + (text.empty() ? "" : " ") + note + ".";
}

std::string list_of(const std::vector<std::string>& phrases) {
  std::string text;
  for (std::size_t i = 0; i < phrases.size(); ++i)
    text += (i == 0 ? "" : i + 1 == phrases.size() ? " and " : ", ") + phrases[i];
  return text;
}

// Whether another linked file than before cannot be read.
bool lacks_another_file(const std::vector<std::string>& dropped, const std::vector<std::string>& before) {
  return std::any_of(dropped.begin(), dropped.end(), [&](const std::string& phrase) {
    return phrase.find(", file ") != phrase.npos &&
           std::find(before.begin(), before.end(), phrase) == before.end();
  });
}

}  // namespace

struct FileHandler::Newer {
  std::optional<LevelStamp> stamp = {};  // of the files before they were read
  FormatResult<LoadedLevel> loaded = tl::unexpected(FormatError{});
  bool is_quiet = true;  // whether nobody wrote while they were read
  std::string changed = {};
  // What is merged with the level; not used if nothing was changed here.
  std::shared_ptr<const Level> base = {};
  Level theirs;
};

struct FileHandler::Look {
  FilesChange found = {};
  bool is_known = false;  // whether what has changed was reported or declined
  LevelStamp known;
  std::optional<LevelStamp> declined;
};

// Linked files keep their stamps, but for those that saving writes.
void FileHandler::note_file(const std::vector<std::string>& written) {
  const std::vector<LinkedStamp> linked = stamp_ ? std::move(stamp_->linked) : std::vector<LinkedStamp>();
  stamp_ = source_.path.empty() ? std::nullopt : stamp_of_level(source_.path);
  if (!stamp_) return;
  stamp_->linked = linked;
  std::vector<std::string> pictures;
  for (const Tileset& tileset : open_.level.tilesets)
    if (tileset.link) pictures.push_back(tileset.link->path);
  add_linked(pictures, time_for_stamps(), *stamp_);
  note_places();
  for (LinkedStamp& file : stamp_->linked) {
    const auto is_it = [&](const std::string& path) { return is_same_file(path, file.path); };
    if (std::any_of(written.begin(), written.end(), is_it)) file.stamp = stamp_of_file(file.path);
  }
  if (!open_.level.tiled) return;
  for (LinkedStamp& file : stamp_->linked) {
    for (const TiledOrigin::File& tileset : open_.level.tiled->tilesets) {
      if (file.path == tileset.path) file.stamp = stamp_of_file(file.path);
    }
  }
}

void FileHandler::note_source(const std::string& path, std::optional<LevelStamp> stamp, ImportChoices choices,
                              std::vector<std::string> dropped) {
  source_ = Source{path, std::move(choices), std::move(dropped)};
  stamp_ = std::move(stamp);
  note_places();
}

void FileHandler::note_places() {
  places_.note(files_to_write());
  if (!stamp_) return;
  for (const LinkedStamp& linked : stamp_->linked) places_.note({linked.path});
}

// If another program changed the files, the level here stays as it is, and differs from them.
void FileHandler::note_reading_given_up() {
  saves_when_read_ = false;
  if (!std::exchange(is_reloading_, false)) return;
  has_given_up_ = true;
  level_.forget_saved();
}

// The bytes of files that differ outside are compared, which takes long for large ones.
void FileHandler::look_at_files() {
  is_reloading_ = true;
  const auto compare = [this, file = source_.path, known = *stamp_,
                        declined = declined_](const Progress&) -> FileReader::Finish {
    auto look = std::make_shared<Look>();
    look->known = known;
    look->declined = declined;
    look->is_known = look->declined && level_change(file, *look->declined).change == FileChange::none;
    if (!look->is_known) look->found = level_change(file, look->known);
    if (look->found.change == FileChange::gone) {
      look->is_known = look->found.gone->is_gone();
      look->found.gone->set_gone();
    }
    return [this, look] { take_look(*look); };
  };
  reading_.read(source_.path, compare, bytes_of(*stamp_) > kLarge);
}

void FileHandler::take_look(const Look& look) {
  is_reloading_ = false;
  stamp_ = look.known;
  declined_ = look.is_known ? look.declined : std::nullopt;
  if (look.is_known) return;
  take_file_change(look.found);
}

// Each state of the files is asked about or reported once.
void FileHandler::take_file_change(const FilesChange& found) {
  if (found.change == FileChange::none) return;
  if (found.change == FileChange::content) {
    const bool asks = has_given_up_ || !places_.elsewhere(found.file).empty();
    return asks ? ask_to_read(last_name(found.file), "") : reload();
  }
  const bool is_own = !open_.path.empty() && !is_linked(found.file);
  if (is_own) level_.forget_saved();
  messages_.tell_error(last_name(found.file) + " was removed or renamed by another program." +
                       (is_own ? " Saving writes it again." : ""));
}

bool FileHandler::is_linked(const std::string& file) const {
  for (const LinkedStamp& linked : stamp_->linked) {
    if (linked.path == file) return true;
  }
  return false;
}

// Whether another program changed a tileset that saving would write, although it is not watched: that of a
// level that was recovered or saved under another name. Each state of it is asked about once.
bool FileHandler::asks_about_tileset() {
  for (const auto& [path, content] : companion_.others) {
    const auto bytes = read_file(path);
    if (!stamp_ || !bytes || content_hash(*bytes) == content) continue;
    ask_to_read(last_name(path), "");
    return true;
  }
  return false;
}

std::vector<std::string> FileHandler::files_to_write() const {
  std::vector<std::string> files = {open_.path};
  if (const auto& tiled = open_.level.tiled) {
    for (const TiledOrigin::File& tileset : tiled->tilesets) files.push_back(tileset.path);
  }
  files.insert(files.end(), level_.painted_files().begin(), level_.painted_files().end());
  return files;
}

std::vector<std::pair<std::string, std::string>> FileHandler::new_links() const {
  std::vector<std::pair<std::string, std::string>> links;
  for (const std::string& file : files_to_write())
    if (std::string target = places_.elsewhere(file); !target.empty()) links.emplace_back(file, target);
  return links;
}

bool FileHandler::asks_about_link(const std::function<void()>& go_on) {
  const auto links = new_links();
  if (links.empty()) return false;
  const auto& [file, target] = links.front();
  messages_.ask(Question{last_name(file) + " is a link now, which leads to " + target +
                             (file_number(file) ? "." : ", where no file is.") + "\nWrite " +
                             (file == open_.path ? "the level" : "what was edited of it") + " there?",
                         Question::Kind::replace_files},
                [this, link = links.front(), go_on](action::Answer answer) {
                  if (answer != action::Answer::replace) return pending_.reset();
                  places_.allow(link.first, link.second);
                  go_on();
                });
  return true;
}

// After an undone reading, the level is still saved into its newest files, and not into those before it: they
// hold what Talus does not show, such as the code of a cart. Returns false if they number the level's tiles
// or cells otherwise.
bool FileHandler::saves_into_newest(Level& saved) {
  if (base_->cart) saved.cart = base_->cart;
  if (saved.tiled != base_->tiled && saved.tiled && base_->tiled) {
    if (!(saved.tiled->frame == base_->tiled->frame)) return tell_of_redo();
    saved.tiled = base_->tiled;
  }
  if (saved.ldtk != base_->ldtk && saved.ldtk && base_->ldtk) {
    const std::vector<std::string>&tiles = saved.ldtk->tiles, &newest = base_->ldtk->tiles;
    const bool keeps_numbers =
        tiles.size() <= newest.size() && std::equal(tiles.begin(), tiles.end(), newest.begin());
    const bool keeps_place =
        ground_shift(ground_place(*saved.ldtk->opened), *base_->ldtk->opened) == Cell{0, 0};
    if (saved.ldtk->level != base_->ldtk->level || !keeps_numbers || !keeps_place) return tell_of_redo();
    if (saved.ldtk->mapping == base_->ldtk->mapping) saved.ldtk = base_->ldtk;
  }
  return true;
}

bool FileHandler::tell_of_redo() {
  messages_.tell_error("Cannot save " + file_name() +
                       ": undo went back to before another program gave it other tiles or another place. "
                       "Redo \"Read " +
                       file_name() + " again\", or save the level as .talus.json.");
  return false;
}

// why: that it cannot be read, a sentence, or empty.
void FileHandler::ask_to_read(const std::string& changed, const std::string& why) {
  const auto links = new_links();
  std::string lines;
  const auto add = [&](const std::string& file, const std::string& target) {
    lines += "\n" + last_name(file) + " is a link to " + target + ", where saving writes.";
  };
  for (const auto& [file, target] : links) add(file, target);
  if (const std::string old = link_target(open_.path); !old.empty() && places_.elsewhere(open_.path).empty())
    add(open_.path, old);
  messages_.ask(Question{changed + " was changed by another program." + why + lines +
                             "\nRead it again, or keep what is here? Undo switches between the two.",
                         Question::Kind::changed_outside},
                [this, links](action::Answer answer) {
                  has_given_up_ = false;
                  for (const auto& [file, target] : links) places_.allow(file, target);
                  if (answer == action::Answer::reload) return reload();
                  for (auto& [path, content] : companion_.others) {
                    if (const auto bytes = read_file(path)) content = content_hash(*bytes);
                  }
                  std::vector<std::string> linked;
                  for (const LinkedStamp& file : stamp_->linked) linked.push_back(file.path);
                  const std::int64_t now = time_for_stamps();
                  note_file();
                  if (!stamp_) return;
                  stamp_->linked.clear();
                  add_linked(linked, now, *stamp_);
                });
}

// Whatever it gives is an edit, so that neither version is lost.
void FileHandler::reload() {
  is_reloading_ = true;
  const ImportChoices choices = with_permissions(source_.path, choices_of(open_.level, source_.choices));
  const auto read = [this, file = source_.path, choices, known = *stamp_,
                     is_saving = is_saving_](const Progress& progress) {
    auto newer = std::make_shared<Newer>();
    LevelStamp before = known;
    newer->changed = last_name(level_change(file, before).file);
    newer->loaded = load_with_stamp(file, choices, progress, newer->stamp);
    LevelStamp after = newer->stamp.value_or(LevelStamp());
    newer->is_quiet = newer->stamp && level_change(file, after).change == FileChange::none;
    return FileReader::Finish([this, newer, is_saving] {
      is_saving_ = is_saving;
      take_reloaded(newer);
      is_saving_ = false;
      if (std::exchange(saves_when_read_, false) && !messages_.question()) save();
    });
  };
  reading_.read(source_.path, read, bytes_of(*stamp_) > kLarge);
}

// Whether LDtk has changed cells or bodies that Talus has changed and saved beside the project.
bool FileHandler::is_undecided_in_ldtk(const LoadedLevel& newer) const {
  const bool is_same = base_->ldtk && newer.level.ldtk && base_->ldtk->level == newer.level.ldtk->level;
  return is_same && !newer.companion.path.empty() && !newer.companion.content;
}

// A file that another program is still writing is tried again, without a word.
void FileHandler::take_reloaded(const std::shared_ptr<Newer>& newer) {
  is_reloading_ = false;
  const FormatResult<LoadedLevel>& loaded = newer->loaded;
  if (!newer->is_quiet && ++failures_ < kReadingTries) return;
  const bool is_companion_broken =
      loaded && !companion_.path.empty() && loaded->companion.path.empty() && !loaded->note.empty();
  const bool lacks_more = loaded && lacks_another_file(loaded->dropped, source_.dropped);
  const bool is_bad = !loaded || is_companion_broken;
  if ((is_bad || lacks_more) && ++failures_ < kReadingTries && !is_saving_) return;
  failures_ = 0;
  if (!loaded) return take_unread(*newer, to_string(loaded.error(), source_.path));
  if (is_companion_broken) return take_unread(*newer, loaded->note);
  if (is_unasked(source_.path, loaded->refused)) {
    return ask_about_outside(
        source_.path, loaded->refused, [this] { reload(); }, [this, newer] { take_reloaded(newer); });
  }
  Level& theirs = newer->loaded->level;
  if (const int layer = matching_layer(open_.level, open_.level.layers.chosen, theirs); layer >= 0)
    theirs.choose_layer(layer);
  const bool is_undecided = is_undecided_in_ldtk(*loaded);
  if (is_stored() && !is_undecided) return take_newer(*newer, theirs);
  newer->base = is_undecided ? base_->ldtk->opened : base_;
  newer->theirs = is_undecided ? *theirs.ldtk->opened : theirs;
  newer->theirs.ldtk = theirs.ldtk;
  MergedLevel merged = merge_levels(*newer->base, open_.level, newer->theirs, MergeSide::mine);
  if (merged.conflicts.empty()) return take_newer(*newer, std::move(merged.level));
  ask_about_merge(newer, merged);
}

void FileHandler::take_unread(const Newer& newer, const std::string& why) {
  if (!is_stored() && !open_.path.empty())
    return ask_to_read(newer.changed, "\nIt cannot be read: " + why + ".");
  std::vector<LinkedStamp> linked = newer.stamp ? newer.stamp->linked : std::vector<LinkedStamp>();
  if (linked.empty() && stamp_) linked = stamp_->linked;
  if (newer.stamp) stamp_ = newer.stamp;
  if (stamp_) stamp_->linked = std::move(linked);
  level_.forget_saved();
  messages_.tell_error(newer.loaded
                           ? sentences("Another program changed what goes with " + file_name() +
                                           ", so the level stays as it is here.",
                                       why)
                           : "Another program changed this file, and it cannot be read again: " + why);
}

void FileHandler::ask_about_merge(const std::shared_ptr<Newer>& newer, const MergedLevel& merged) {
  const std::string what =
      merged.apart.empty()
          ? "Both changed " + list_of(merged.conflicts) +
                ", each in another way. Take mine or theirs there? All else that either changed is kept."
          : "It cannot be merged with what was changed here, as " + merged.apart +
                ". Take all of mine or all of theirs?";
  messages_.ask(
      Question{newer->changed + " was changed by another program.\n" + what + " Undo takes it back.",
               Question::Kind::merge},
      [this, newer](action::Answer answer) {
        if (answer != action::Answer::keep && answer != action::Answer::reload) {
          declined_ = newer->stamp;
          return;
        }
        const MergeSide side = answer == action::Answer::keep ? MergeSide::mine : MergeSide::theirs;
        take_newer(*newer, merge_levels(*newer->base, open_.level, newer->theirs, side).level);
      });
}

// The files are what the level is saved into from now on, also where they hold what it does not show.
void FileHandler::take_newer(const Newer& newer, Level level) {
  const LoadedLevel& loaded = *newer.loaded;
  const bool was_changed = !is_stored();
  level_.edit(replace_by(open_.level, std::make_shared<const Level>(std::move(level)),
                         "Read " + file_name() + " again"));
  open_.level.tiled = loaded.level.tiled;
  open_.level.ldtk = loaded.level.ldtk;
  run_.read_hard_case();
  base_ = std::make_shared<const Level>(loaded.level);
  stamp_ = newer.stamp;
  note_places();
  declined_.reset();
  companion_ = loaded.companion;
  source_.dropped = loaded.dropped;
  unstored_.clear();
  if (open_.level == loaded.level && !(was_changed && open_.level.ldtk))  // its mapping may not be saved
    level_.mark_saved();
  else
    level_.forget_saved();
  const std::string changed = source_.path == open_.path ? file_names() : file_name();
  messages_.tell(sentences("Read " + changed + " again, as another program changed it" +
                               (was_changed && !is_stored() ? ", and kept what was changed here" : "") +
                               ". Undo takes that back.",
                           loaded.note));
}

}  // namespace talus
