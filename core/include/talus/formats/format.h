// The list of file formats, and reading and writing a level in any of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
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
  std::string place;    // "byte 12", "line 4"; empty for the whole file
  std::string message;  // one sentence without the place
  // If other ImportChoices would make the file readable: a sentence with the command line for them. Empty:
  // they would not.
  std::string remedy = {};
};

// An error about what lies at a place; its own place is relative to that.
FormatError error_within(const std::string& place, FormatError error);

// "FILE:PLACE: error: MESSAGE: REMEDY", without empty parts. One line without control characters, however
// long the names in the file are.
std::string to_string(const FormatError& error, std::string_view file);

// A value, or what is wrong.
template <class T>
using FormatResult = tl::expected<T, FormatError>;

// An error on the line of a text that holds the byte at `offset`.
tl::unexpected<FormatError> error_at_line(std::string_view text, std::size_t offset, std::string message);

// The result when a Progress stops the work.
tl::unexpected<FormatError> was_cancelled();

// Another file that is written with a level, such as a tileset of its map.
struct WrittenFile {
  std::string path;   // of the file, which exists
  std::string bytes;  // the whole file
};

// A written level, and what is lost: what neither the format nor a companion can hold. A companion is a file
// beside the level's, NAME.talus.json, with what the format of the level's file cannot hold.
struct WrittenLevel {
  std::string bytes;                 // the whole file
  std::vector<std::string> dropped;  // one phrase each: "the BINARY chunk of bank 0"; empty: nothing was lost
  std::shared_ptr<const Level> held = {};  // the level that the bytes alone give; null: reading them tells
  std::vector<WrittenFile> others = {};    // other files that belong to it, also those that did not change
};

// What to take from a file of another program that holds more than a level can.
struct ImportChoices {
  // The only tile layer to take, by name; if none has that name, by its number, from 1. Empty: all of them.
  // Of a project of LDtk, the IntGrid whose values are the ground; empty: that with the most.
  std::string layer = {};
  int layer_number = 0;  // the same only by number, which goes before the name; 0: by name
  // The level to take of a project that has several, by name, or by WORLD/NAME in one with worlds, or by its
  // iid; if none has that name, by its number, from 1. Empty: the project must have only one.
  std::string level = {};
  int level_number = 0;  // the same only by number, which goes before the name; 0: by name
  // Takes only the tiles that the map shows, with new numbers, also from several tilesets.
  bool used_tiles = false;
  // Of a map of Tiled that was read before: how it was numbered then, so that it is numbered so again.
  std::optional<TiledFrame> frame = {};
  // Of a project of LDtk, what its things stand for; nothing: as its companion says, or else as their names
  // say.
  std::optional<LdtkMapping> mapping = {};
  // Of a level of a project that was read before: LdtkOrigin::tiles, so that tiles keep their numbers; empty:
  // as its companion says.
  std::vector<std::string> ldtk_tiles = {};
  // Absolute paths of folders without links. Files that the content names are read in them, as in the folder
  // of the file itself and below it; those elsewhere are not. "/": they are read everywhere.
  std::vector<std::string> outside = {};
  friend bool operator==(const ImportChoices&, const ImportChoices&) = default;
};

// What a reader or writer may need to know besides the content.
struct FormatContext {
  std::string extension;            // of the file's name, lower case, without the dot; may be empty
  std::string folder = {};          // folder of the files that the content names; empty: they are not read
  ImportChoices choices = {};       // for readers of formats that Talus only reads
  std::string_view companion = {};  // text of the companion beside the file; empty: there is none
  std::vector<std::string>* dropped = nullptr;  // gets a phrase for each thing that a reader could not keep
  std::vector<std::string>* linked = nullptr;   // gets the path of each file that the content names
  // Gets the name of each file that the content names, and that was not read for where it lies: see
  // ImportChoices::outside.
  std::vector<std::string>* refused = nullptr;
  // Gets the name of each file that the content names, and that could not be read: also of the refused ones.
  std::vector<std::string>* missing = nullptr;
  Progress progress = {};  // receives how much a reader has read; may stop the reading, which is an error
};

// One row for each format of files.
struct Format {
  std::string_view id;                           // "tic", as in `talus export --to tic`
  std::string_view label;                        // "TIC-80 cartridge"
  std::span<const std::string_view> extensions;  // without the dot; the first is the usual one
  bool (*accepts)(std::string_view bytes, const FormatContext&);  // whether this could be such a file
  // Returns the level of a file, or what is wrong with it. bytes: the whole file.
  FormatResult<Level> (*read)(std::string_view bytes, const FormatContext&);
  // Null: Talus only reads the format. A level opened from it has no file yet, so saving asks for one.
  FormatResult<WrittenLevel> (*write)(const Level&, const FormatContext&);
  // The keys of a native level (docs/formats.md) that such a file holds. Keys that it lacks, and all
  // others, go into its companion. Empty: it has no companion.
  std::span<const std::string_view> holds = {};
  bool writes_back = false;  // whether it writes only levels that came from such a file, into that one
  // Whether another program owns such files: they are never written, and saving a level that came from one
  // writes its companion alone.
  bool keeps_beside = false;
  // The members of ImportChoices by which a part of such a file is chosen; the reader ignores the others.
  std::span<const std::string_view> choices = {};
  // Whether save_level() takes it.
  bool can_save() const { return write != nullptr || keeps_beside; }
};

// Every format, in the order in which content is tried.
std::span<const Format> formats();
const Format* find_format(std::string_view id);  // null if there is none
// The format in which a file of this name is written; null if no format with its extension is written.
const Format* format_for_file(const std::string& path);
// The extension and the folder of a path, for a reader; the file need not exist.
FormatContext context_for_file(const std::string& path);

// The companion of a level's file, when it was read or written with the level.
struct CompanionFile {
  std::string path = {};  // empty: there was none
  // content_hash of its bytes; nothing: not all of it was understood.
  std::optional<std::uint64_t> content = {};
  // content_hash of the other files that the level is saved into, by their paths, when they were read or
  // written. They are the files of a map's tilesets, and pictures that were painted. A file that is not here
  // has the level's own bytes of it.
  std::map<std::string, std::uint64_t> others = {};
};

// The result of load_level() and read_level().
struct LoadedLevel {
  Level level;                            // the whole of it
  const Format* format = nullptr;         // never null
  std::vector<std::string> dropped = {};  // what a level cannot hold, one phrase each
  std::vector<std::string> linked = {};   // paths of the files that it names, such as a map's tilesets
  std::vector<std::string> refused = {};  // as in FormatContext, each name once
  std::vector<std::string> missing = {};  // as in FormatContext, each name once
  std::string path = {};  // path of the file; if its companion was named, path of the file that it belongs to
  CompanionFile companion = {};  // pass it to save_level()
  std::string note = {};         // a note on the companion, a sentence without full stop; empty: no note
};

// The result of save_level().
struct SavedLevel {
  std::vector<std::string> dropped = {};  // as in WrittenLevel
  std::vector<std::string> others = {};   // paths of the other files that were written, such as tilesets
  CompanionFile companion = {};           // pass it to the next save_level()
  std::string note = {};                  // as in LoadedLevel
};

// Reads bytes in the first format that accepts them, by content, then by extension. An error if no format
// accepts them.
FormatResult<LoadedLevel> read_level(std::string_view bytes, const FormatContext& context);
// The file with the level of a path: for a companion, the file that it belongs to; else the path itself.
std::string level_path(const std::string& path);
// Reads a file as read_level() does, with its companion, if it has one. A file that cannot be a companion is
// left alone, and the note says so. choices: what to take from a file that holds more than a level. progress:
// see FormatContext.
FormatResult<LoadedLevel> load_level(const std::string& path, const ImportChoices& choices = {},
                                     const Progress& progress = {});
// Writes the whole file or nothing of it, with a companion if the format cannot hold everything. The format
// must be one that can_save(). known: the companion that the level came with. That one is replaced, and
// removed if it is no longer needed. Any other file in its place is kept under another name, and the note
// says so. Files of tilesets into which a map of Tiled is saved are written with it, if they change, and so
// are the pictures of tiles that were painted and come from files, as PNGs. before: the level as its files
// had it when they were last read or written; null: as it was opened in Tiled's or LDtk's files, and of other
// levels no pictures are written. After an error all files are as they were.
FormatResult<SavedLevel> save_level(const Level& level, const Format& format, const std::string& path,
                                    const CompanionFile& known = {}, const Level* before = nullptr);

}  // namespace talus
