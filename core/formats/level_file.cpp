// Levels in files, with their companions. The companion is written first. If a crash comes between the two,
// the companion's hashes show that the two do not fit, and nothing is lost.
#include <algorithm>
#include <cassert>
#include <filesystem>
#include <iterator>
#include <utility>

#include <talus/formats/format.h>
#include "files/atomic_file.h"
#include "files/keep_aside.h"
#include "files/real_path.h"
#include "last_catch.h"
#include "ldtk/ldtk_companion.h"
#include "native/companion.h"
#include "text/content_hash.h"
#include "tilesets/painted_pictures.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

bool is_ldtk_path(const std::string& path) { return context_for_file(path).extension == "ldtk"; }

void add_doubt(const std::string& path, const StagedFile& staged, std::string& note) {
  if (staged.doubt().empty()) return;
  note += (note.empty() ? "" : ". ") + last_name(path) + " " + staged.doubt();
}

// Says that a file, which is about to be replaced, has other names: they keep the old content. Call it before
// the new file is put.
void add_split(const std::string& path, std::string& note) {
  std::error_code error;
  const auto names = fs::hard_link_count(path, error);
  if (error || names < 2) return;
  note += (note.empty() ? "" : ". ") + last_name(path) +
          " had other names, hard links, which keep what it was before";
}

// What is in the place of a companion.
struct Place {
  bool is_free = true;
  FormatResult<std::string> bytes = std::string();  // an error if it is not a readable file
};

Place look_at(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  if (!fs::exists(status)) return {};
  // A link may lead anywhere, and reading a pipe may wait for ever.
  if (!fs::is_regular_file(status))
    return {false, tl::unexpected(FormatError{"", "is a link, a folder or a device, but must be a file"})};
  return {false, read_file(path)};
}

void add_companion(LoadedLevel& loaded) {
  const std::string path = companion_path(loaded.path);
  const Place place = look_at(path);
  if (place.is_free) return;
  // A level beside a project of LDtk may have been exported to it.
  if (loaded.format->keeps_beside && place.bytes && !is_companion(*place.bytes) &&
      !is_damaged_ldtk_companion(*place.bytes))
    return;
  auto joined = place.bytes ? read_guarded([&] {
    return loaded.format->keeps_beside
               ? join_ldtk_companion(*place.bytes, loaded.level, last_name(loaded.path))
               : join_companion(*place.bytes, loaded.level, *loaded.format, last_name(loaded.path));
  })
                            : FormatResult<JoinedLevel>(tl::unexpected(place.bytes.error()));
  if (!joined) {
    const FormatError& error = joined.error();
    loaded.note = last_name(path) +
                  " is left as it is, and not read: " + (error.place.empty() ? "" : error.place + ": ") +
                  error.message;
    return;
  }
  loaded.level = std::move(joined->level);
  loaded.note = std::move(joined->note);
  loaded.companion.path = path;
  if (joined->is_whole) loaded.companion.content = content_hash(*place.bytes);
}

// How the map of Tiled of that path was numbered when its companion was saved; nothing if that is not known.
std::optional<TiledFrame> known_frame(const std::string& path) {
  const Place place = look_at(companion_path(path));
  return place.is_free || !place.bytes ? std::nullopt : frame_of_companion(*place.bytes);
}

// Reads the level of a companion that was named itself. Errors are about the companion.
FormatResult<LoadedLevel> load_owner(const std::string& owner, std::string_view companion,
                                     ImportChoices choices) {
  const auto failure = [&](const std::string& what) {
    return tl::unexpected(
        FormatError{"", "is the companion that Talus saved with " + last_name(owner) + what});
  };
  std::error_code error;
  if (!fs::exists(owner, error)) return failure(", but that file is not beside it: put both into one folder");
  if (choices.level.empty() && choices.level_number == 0) choices.level = ldtk_memory_of(companion).last;
  auto loaded = load_level(owner, choices);
  if (!loaded) return failure(", which cannot be read: " + to_string(loaded.error(), owner));
  if (loaded->format->holds.empty() && !loaded->format->keeps_beside) return failure(", which is not a cart");
  return loaded;
}

// Why a level cannot be saved beside the files that it names: one of them is in the place of its companion.
// Nothing if it can. path: of the level's file; files: paths.
std::optional<FormatError> problem_of_names(const std::string& path, const std::vector<std::string>& files) {
  const auto beside = real_path(companion_path(path));
  const bool is_named = beside && std::any_of(files.begin(), files.end(), [&](const std::string& file) {
                          const auto place = real_path(file);
                          return place && *place == *beside;
                        });
  if (!is_named) return std::nullopt;
  return FormatError{"", "names " + last_name(*beside) +
                             ", which is the name of its own companion: give that file another name"};
}

// Writes a file that is put in place at once. `note` gets its doubt, if there is one.
FormatResult<void> write_noting(const std::string& path, std::string_view bytes, std::string& note) {
  auto staged = StagedFile::write(path, bytes);
  if (!staged) return tl::unexpected(staged.error());
  add_split(path, note);
  auto put = staged->put();
  if (put) add_doubt(path, *staged, note);
  return put;
}

// Puts a companion and its file in place. If it ends early, it undoes what was done.
class PairWriter {
 public:
  PairWriter(std::string path, Place before) : path_(std::move(path)), before_(std::move(before)) {}
  PairWriter(const PairWriter&) = delete;
  PairWriter& operator=(const PairWriter&) = delete;
  ~PairWriter() {
    std::error_code ignored;
    if (is_done_) return;
    if (is_put_ && is_own_) (void)write_file_atomic(path_, *before_.bytes);
    if (is_put_ && !is_own_) fs::remove(path_, ignored);
    if (!kept_.empty()) fs::rename(kept_, path_, ignored);
  }

  // is_own: the file there may be replaced; otherwise it is kept aside.
  FormatResult<void> put_companion(const std::string& bytes, bool is_own) {
    is_own_ = is_own && !before_.is_free;
    if (!before_.is_free && !is_own) {
      if (const auto made_room = make_room(); !made_room) return made_room;
    }
    if (bytes.empty() || (is_own_ && *before_.bytes == bytes)) return {};
    const auto written = write_noting(path_, bytes, doubt_);
    is_put_ = written.has_value();
    return written;
  }
  void finish(bool removes) {
    is_done_ = true;
    std::error_code ignored;
    if (removes) fs::remove(path_, ignored);
  }
  const std::string& kept() const { return kept_; }
  const std::string& doubt() const { return doubt_; }  // about the companion, in the words of write_noting()

 private:
  FormatResult<void> make_room() {
    auto kept = keep_aside(path_);
    if (!kept) return tl::unexpected(kept.error());
    kept_ = *std::move(kept);
    return {};
  }

  std::string path_;
  Place before_;
  std::string doubt_;
  std::string kept_;  // where the old file is now; empty: it has not been moved
  bool is_own_ = false, is_put_ = false, is_done_ = false;
};

// The other files of a level that change, such as tilesets and pictures: first all are written, then all are
// put in their places. If it ends early, those that were put get their old content again.
class OtherFiles {
 public:
  OtherFiles() = default;
  OtherFiles(const OtherFiles&) = delete;
  OtherFiles& operator=(const OtherFiles&) = delete;
  ~OtherFiles() {
    for (const Entry& entry : entries_) {
      if (entry.is_put && !is_done_) (void)write_file_atomic(entry.file->path, entry.before);
    }
  }

  // files: must live as long as this.
  FormatResult<void> stage(const std::vector<WrittenFile>& files, const CompanionFile& known) {
    for (const WrittenFile& file : files) {
      const std::uint64_t hash = content_hash(file.bytes);
      contents_[file.path] = hash;
      const auto old = known.others.find(file.path);
      if (old != known.others.end() && old->second == hash) continue;
      auto before = read_file(file.path);
      if (!before) return tl::unexpected(named(file, before.error()));
      if (*before == file.bytes) continue;
      auto staged = StagedFile::write(file.path, file.bytes);
      if (!staged) return tl::unexpected(named(file, staged.error()));
      entries_.push_back({&file, *std::move(before), *std::move(staged)});
    }
    return {};
  }
  FormatResult<void> put(std::string& note) {
    for (Entry& entry : entries_) {
      add_split(entry.file->path, note);
      if (const auto put = entry.staged.put(); !put) return tl::unexpected(named(*entry.file, put.error()));
      entry.is_put = true;
      add_doubt(entry.file->path, entry.staged, note);
    }
    return {};
  }
  void finish() { is_done_ = true; }
  std::vector<std::string> written() const {
    std::vector<std::string> paths;
    for (const Entry& entry : entries_) paths.push_back(entry.file->path);
    return paths;
  }
  const std::map<std::string, std::uint64_t>& contents() const { return contents_; }

 private:
  struct Entry {
    const WrittenFile* file;
    std::string before;
    StagedFile staged;
    bool is_put = false;
  };
  static FormatError named(const WrittenFile& file, FormatError error) {
    error.message = last_name(file.path) + ", which is saved with it: " + error.message;
    return error;
  }

  std::vector<Entry> entries_;
  std::map<std::string, std::uint64_t> contents_;
  bool is_done_ = false;
};

// For an error of the companion, whose name the user has not typed.
tl::unexpected<FormatError> companion_error(const std::string& path, FormatError error) {
  error.message = last_name(path) + ", for what it cannot hold: " + error.message;
  return tl::unexpected(std::move(error));
}

// Returns the text of the companion that the written level needs; empty if it needs none.
FormatResult<std::string> needed_companion(const Level& level, const Format& format,
                                           const WrittenLevel& written, const std::string& path) {
  if (written.held)
    return level == *written.held ? FormatResult<std::string>()
                                  : write_companion(level, *written.held, format, last_name(path));
  const auto held = format.read(written.bytes, context_for_file(path));
  if (!held) return tl::unexpected(held.error());
  return write_companion(level, *held, format, last_name(path));
}

FormatResult<SavedLevel> save_pair(const Level& level, const Format& format, const std::string& path,
                                   const WrittenLevel& written, const CompanionFile& known) {
  const std::string beside = companion_path(path);
  std::vector<std::string> names;
  for (const WrittenFile& file : written.others) names.push_back(file.path);
  if (auto problem = problem_of_names(path, names)) return tl::unexpected(*std::move(problem));
  const auto needed = needed_companion(level, format, written, path);
  if (!needed) return companion_error(beside, needed.error());
  const Place before = look_at(beside);
  const bool is_known = before.bytes && known.path == beside && known.content == content_hash(*before.bytes);
  // A file that does not belong to the level cannot be mistaken for its companion. It may stay if no
  // companion is needed.
  const bool stays = needed->empty() && !(before.bytes && is_companion(*before.bytes));
  auto staged = StagedFile::write(path, written.bytes);
  if (!staged) return tl::unexpected(staged.error());
  OtherFiles others;
  if (const auto all = others.stage(written.others, known); !all) return tl::unexpected(all.error());
  PairWriter pair(beside, before);
  if (!stays || before.is_free) {
    const auto put = pair.put_companion(*needed, is_known || (before.bytes && *before.bytes == *needed));
    if (!put) return companion_error(beside, put.error());
  }
  std::string note = pair.doubt();
  if (const auto put = others.put(note); !put) return tl::unexpected(put.error());
  add_split(path, note);
  if (const auto put = staged->put(); !put) return tl::unexpected(put.error());
  others.finish();
  pair.finish(needed->empty() && is_known);
  SavedLevel saved{written.dropped, others.written(), {}, std::move(note)};
  add_doubt(path, *staged, saved.note);
  if (!needed->empty()) saved.companion = {beside, content_hash(*needed), {}};
  saved.companion.others = others.contents();
  if (!pair.kept().empty())
    saved.note += (saved.note.empty() ? "" : ". ") + last_name(beside) +
                  " held something else, which is kept as " + last_name(pair.kept());
  return saved;
}

// Writes only the companion.
FormatResult<SavedLevel> save_beside(const Level& level, const std::string& path, const CompanionFile& known,
                                     const std::vector<WrittenFile>& pictures) {
  if (!level.ldtk) return tl::unexpected(FormatError{"", "is LDtk's: save the level under another name"});
  const std::string beside = companion_path(path);
  const Place before = look_at(beside);
  if (!before.bytes) return companion_error(beside, before.bytes.error());
  // What is painted into its pictures is no addition.
  const Level additions = without_painted_tiles(level, *level.ldtk->opened);
  const bool is_damaged = !before.is_free && is_damaged_ldtk_companion(*before.bytes);
  const auto written =
      write_ldtk_companion(additions, is_damaged ? "" : std::string_view(*before.bytes), last_name(path));
  if (!written) {
    FormatError error = written.error();
    error.message =
        last_name(beside) + (error.place.empty() ? " " : ", " + error.place + ", ") + error.message;
    error.place.clear();  // which is not one of the project
    return tl::unexpected(std::move(error));
  }
  OtherFiles others;
  if (const auto all = others.stage(pictures, known); !all) return tl::unexpected(all.error());
  PairWriter pair(beside, before);
  // What was not read of it is kept aside.
  const bool is_read = known.path == beside
                           ? known.content.has_value()
                           : ldtk_tiles_of_companion(*before.bytes, level.ldtk->level).empty();
  const bool is_own = is_read && !is_damaged;
  if (const auto put = pair.put_companion(*written, is_own); !put)
    return companion_error(beside, put.error());
  std::string note = pair.doubt();
  if (const auto put = others.put(note); !put) return tl::unexpected(put.error());
  others.finish();
  pair.finish(false);
  SavedLevel saved{.others = others.written(), .companion = {beside, content_hash(*written)}, .note = note};
  saved.companion.others = others.contents();
  if (!pair.kept().empty())
    saved.note += (saved.note.empty() ? "" : ". ") + std::string("What was there before is kept as ") +
                  last_name(pair.kept());
  return saved;
}

// The pictures that were painted, if saving keeps the level's ties to them.
FormatResult<std::vector<WrittenFile>> pictures_to_write(const Level& level, const Format& format,
                                                         const Level* before) {
  const bool is_tied = format.keeps_beside || format.writes_back || (!level.tiled && !level.ldtk);
  const Level* const known = before != nullptr ? before
                             : level.tiled     ? level.tiled->opened.get()
                             : level.ldtk      ? level.ldtk->opened.get()
                                               : nullptr;
  if (!is_tied || known == nullptr) return std::vector<WrittenFile>();
  return painted_pictures(level, *known);
}

// "cave.ldtk" gives "cave"; empty for others.
std::string without_ldtk(const std::string& path) {
  constexpr std::string_view kEnding = ".ldtk";
  return is_ldtk_path(path) ? path.substr(0, path.size() - kEnding.size()) : std::string();
}

}  // namespace

std::string companion_path(const std::string& file) {
  std::error_code error;
  fs::path target(file);
  if (fs::is_symlink(fs::symlink_status(target, error))) target = fs::weakly_canonical(target, error);
  const std::string real = error ? file : target.string(), bare = without_ldtk(real);
  return (bare.empty() ? real : bare) + std::string(kCompanionEnding);
}

std::string companion_place_problem(const std::string& path) {
  const std::string owner = owner_of_companion(path);
  std::error_code error;
  if (is_ldtk_path(owner) && level_path(path) == owner)
    return "is what Talus adds to " + last_name(owner) + " beside it: choose another name";
  const Format* format = owner.empty() ? nullptr : format_for_file(owner);
  if (format == nullptr || format->holds.empty() || !fs::exists(owner, error)) return "";
  return "is the name of the companion of " + last_name(owner) + " beside it: choose another name";
}

std::string level_path(const std::string& path) {
  const std::string owner = owner_of_companion(path);
  std::error_code error;
  if (owner.empty() || !fs::exists(owner, error)) return path;
  const Place place = look_at(path);
  return place.bytes && is_companion(*place.bytes) ? owner : path;
}

FormatResult<LoadedLevel> load_level(const std::string& path, const ImportChoices& choices,
                                     const Progress& progress) {
  constexpr double kReading = 0.1;  // share of the time
  const auto bytes = read_file(path, std::nullopt, progress.part(0, kReading));
  if (!bytes) return tl::unexpected(bytes.error());
  if (const std::string owner = owner_of_companion(path); !owner.empty() && is_companion(*bytes))
    return load_owner(owner, *bytes, choices);
  FormatContext context = context_for_file(path);
  context.choices = choices;
  if (!choices.frame) context.choices.frame = known_frame(path);
  const Place beside = is_ldtk_path(path) ? look_at(companion_path(path)) : Place();
  if (!beside.is_free && beside.bytes && is_companion(*beside.bytes)) context.companion = *beside.bytes;
  context.progress = progress.part(kReading, 1);
  auto loaded = read_level(*bytes, context);
  if (!loaded) return loaded;
  loaded->path = path;
  if (!loaded->format->holds.empty() || loaded->format->keeps_beside) {
    if (auto problem = problem_of_names(path, loaded->linked)) return tl::unexpected(*std::move(problem));
    add_companion(*loaded);
  }
  if (loaded->level.tiled) {
    for (const TiledOrigin::File& tileset : loaded->level.tiled->tilesets)
      loaded->companion.others[tileset.path] = content_hash(tileset.bytes);
  }
  return loaded;
}

FormatResult<SavedLevel> save_level(const Level& level, const Format& format, const std::string& path,
                                    const CompanionFile& known, const Level* before) {
  assert(format.can_save() && "the format is read alone");
  auto pictures = pictures_to_write(level, format, before);
  if (!pictures) return tl::unexpected(pictures.error());
  if (format.keeps_beside) return save_beside(level, path, known, *pictures);
  auto written = format.write(level, context_for_file(path));
  if (!written) return tl::unexpected(written.error());
  std::move(pictures->begin(), pictures->end(), std::back_inserter(written->others));
  if (!format.holds.empty()) return save_pair(level, format, path, *written, known);
  if (std::string problem = companion_place_problem(path); !problem.empty())
    return tl::unexpected(FormatError{"", std::move(problem)});
  SavedLevel saved{.dropped = std::move(written->dropped)};
  auto staged = StagedFile::write(path, written->bytes);
  if (!staged) return tl::unexpected(staged.error());
  OtherFiles others;
  if (const auto all = others.stage(written->others, known); !all) return tl::unexpected(all.error());
  if (const auto put = others.put(saved.note); !put) return tl::unexpected(put.error());
  add_split(path, saved.note);
  if (const auto put = staged->put(); !put) return tl::unexpected(put.error());
  others.finish();
  add_doubt(path, *staged, saved.note);
  saved.others = others.written();
  saved.companion.others = others.contents();
  return saved;
}

}  // namespace talus
