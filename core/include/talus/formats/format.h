// The list of file formats, and reading and writing a level in any of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include <talus/level/level.h>
#include <talus/level/progress.h>

namespace talus {

// What is wrong with a file, and where.
struct FormatError {
  std::string place;    // "byte 12", "line 4"; empty when the whole file is meant
  std::string message;  // one sentence without the place
  // Of a file that ImportChoices would make readable: the command line that makes them, as a sentence. Empty:
  // none would.
  std::string remedy = {};
};

// An error of what lies at a place, whose own place is counted from there.
FormatError error_within(const std::string& place, FormatError error);

// "FILE:PLACE: error: MESSAGE: REMEDY", without what is empty: one line, see printable_line (utf8_text.h),
// however long the names are that the file has.
std::string to_string(const FormatError& error, std::string_view file);

// A value, or what is wrong.
template <class T>
using FormatResult = tl::expected<T, FormatError>;

// An error on the line of a text that holds the byte at `offset`.
tl::unexpected<FormatError> error_at_line(std::string_view text, std::size_t offset, std::string message);

// What is returned where a Progress says that the work ends.
tl::unexpected<FormatError> was_cancelled();

// A written level, and what is lost of it: what neither the format nor a companion (see companion.h) can
// hold.
struct WrittenLevel {
  std::string bytes;                 // the whole file
  std::vector<std::string> dropped;  // one phrase each: "the BINARY chunk of bank 0"; empty: nothing is lost
};

// What to take of a file of another program that holds more than a level can.
struct ImportChoices {
  // Of several layers of tiles, the name of the one; or, of none with that name, its number, from 1. Empty:
  // there must be only one.
  std::string layer = {};
  int layer_number = 0;     // the same by number alone, which goes before the name; 0: by name
  bool used_tiles = false;  // only the tiles that the map shows, numbered anew, also of several tilesets
  friend bool operator==(const ImportChoices&, const ImportChoices&) = default;
};

// What a reader or writer may need to know besides the content.
struct FormatContext {
  std::string extension;       // of the file's name, lower case, without the dot; may be empty
  std::string folder = {};     // where files lie that the content names; empty: they are not looked for
  ImportChoices choices = {};  // for readers of formats that are read alone
  std::vector<std::string>* dropped = nullptr;  // gets a phrase for each thing that a reader could not keep
  std::vector<std::string>* linked = nullptr;   // gets the path of each file that the content names
  Progress progress = {};  // told how much a reader has read; where it says so, reading ends as an error
};

// One row for each format of files.
struct Format {
  std::string_view id;                           // "tic", as in `talus export --to tic`
  std::string_view label;                        // "TIC-80 cartridge"
  std::span<const std::string_view> extensions;  // without the dot; the first is the usual one
  bool (*accepts)(std::string_view bytes, const FormatContext&);  // could this be such a file?
  // The level of a file, or what is wrong with it; all bytes of the file.
  FormatResult<Level> (*read)(std::string_view bytes, const FormatContext&);
  // Null: the format is read alone. What is opened from it has no file yet, so that saving asks for one.
  FormatResult<WrittenLevel> (*write)(const Level&, const FormatContext&);
  // The members of a native level (see native.h) that such a file holds; what it lacks of them and all others
  // go into its companion. Empty: it has no companion.
  std::span<const std::string_view> holds = {};
};

// Every format, in the order in which content is tried. To add one, add its row here.
std::span<const Format> formats();
const Format* find_format(std::string_view id);  // null when there is none
// The format that a file of this name is written in; null when none is written under its extension.
const Format* format_for_file(const std::string& path);
// The extension and the folder of a path, for a reader; the file need not exist.
FormatContext context_for_file(const std::string& path);

// The companion of a level's file, as it was read or written with the level.
struct CompanionFile {
  std::string path = {};                      // empty: there was none
  std::optional<std::uint64_t> content = {};  // content_hash of its bytes; none: not all of it was understood
};

// What load_level() and read_level() give.
struct LoadedLevel {
  Level level;                            // the whole of it
  const Format* format = nullptr;         // never null
  std::vector<std::string> dropped = {};  // what a level cannot hold of what was read, one phrase each
  std::vector<std::string> linked = {};   // paths of the files that it names, such as a map's tilesets
  std::string path = {};         // of the file; where its companion was named, of the one that it belongs to
  CompanionFile companion = {};  // to be given to save_level()
  std::string note = {};  // what is to be told of the companion, a sentence without full stop; empty: nothing
};

// What save_level() gives.
struct SavedLevel {
  std::vector<std::string> dropped = {};  // as WrittenLevel has it
  CompanionFile companion = {};           // to be given to the next save_level()
  std::string note = {};                  // as LoadedLevel has it
};

// Reads bytes in whichever format accepts them, told by content, then by extension. An error when none does.
FormatResult<LoadedLevel> read_level(std::string_view bytes, const FormatContext& context);
// The file that holds the level of a path: of a companion, the one that it belongs to; else the path itself.
std::string level_path(const std::string& path);
// Reads a file as read_level() does, with its companion, if it has one; a file that cannot be one is left
// alone, and the note says so. choices: what to take of a file that holds more than a level. progress: see
// FormatContext.
FormatResult<LoadedLevel> load_level(const std::string& path, const ImportChoices& choices = {},
                                     const Progress& progress = {});
// Writes atomically (see atomic_file.h), with a companion where the format cannot hold everything. The format
// must have a writer. known: the companion that the level came with. It is replaced, and removed where there
// is no more need for it; any other file in its place is kept under another name, and the note says so. After
// an error both files are as they were.
FormatResult<SavedLevel> save_level(const Level& level, const Format& format, const std::string& path,
                                    const CompanionFile& known = {});

}  // namespace talus
