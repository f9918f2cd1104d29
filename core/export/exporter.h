// Exporters: what games and other programs read. Each is a file of this folder that declares itself in
// export_targets.h and has a row in exporter.cpp; `talus export` and the export window list them all.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include <talus/level/progress.h>
#include "export_bounds.h"

namespace talus {

struct ExportedFile {
  // Of an exporter of folders: in that folder, with '/' before the names of its own folders. Else empty for
  // the file that was named, and of further ones the name beside it.
  std::string name;
  std::string bytes;
  // A start for the user's own code: where another one is already, that is kept. See own_starters().
  bool is_starter = false;
  // Written only where a file is already, which would mean something else now: an empty companion of a cart.
  bool only_replaces = false;
};

struct Exported {
  std::vector<ExportedFile> files;   // at least one
  std::vector<std::string> dropped;  // what could not be held, one phrase each as in WrittenLevel::dropped
  // Of code that TIC-80 is to run: how much of its kMostTicCode bytes the exporter's part of it takes.
  std::optional<std::size_t> code_bytes = {};
};

// Of the named file alone. Its bytes are moved, which those of a list in braces are not.
Exported exported_file(std::string bytes, std::vector<std::string> dropped = {});

inline constexpr std::size_t kMostTicCode = 65'536;  // bytes of code that TIC-80's free version holds

// The text of one of the files that come with the program, such as "runtime/base.lua".
using ReadAsset = std::function<FormatResult<std::string>(const std::string& name)>;

struct ExportRequest {
  const Level& level;
  // Of the file or folder that is named, without the folders it is in: "cave.tmj". "-": standard output.
  std::string name;
  const ReadAsset& read_asset;
  std::string_view parts = {};  // of those that take parts, besides what the level uses: see lua_parts.h
  Progress progress = {};       // told how much of it is made, and asked whether to go on

  std::string stem() const;  // of the name, up to its first dot: "cave"; of "-" and without a name: "level"
  std::string sheet_name() const;  // of a picture of the tiles beside the file: "cave-tiles.png"
};

struct Exporter {
  std::string_view id;     // "love", as in `talus export --to love`
  std::string_view label;  // "game for LÖVE 11"
  // That the file's name may have, without the dot; the first is the usual one. Empty: a folder is named.
  std::span<const std::string_view> extensions;
  // For make(), which is to be called: what it gives after the progress was stopped is good for nothing.
  FormatResult<Exported> (*write)(const ExportRequest& request);
  std::string_view purpose = {};  // one sentence on what it is for and what is in it; may be empty
  bool takes_parts = false;       // it writes Lua's runtime, which is of parts
  // What its usual name has behind the level's, "-sti", so that no two exporters have the same.
  std::string_view usual_suffix = {};
  // The names of all files that it may write besides the one that is named, or in the folder; a * stands for
  // the name that was given, without its extension, and ** for the whole name.
  std::span<const std::string_view> beside = {};
  bool shares_sheet = false;  // a PNG of it shows the tiles and no more: that of another one is the same
  bool keeps_code = false;  // what it writes has the code of the cart that the level was, and TIC-80 runs it

  bool is_folder() const { return extensions.empty(); }
  // Makes the files. When the request's progress is stopped, that is an error like any other.
  FormatResult<Exported> make(const ExportRequest& request) const;
};

// The name of a file of Exporter::beside, for an output of this name, without its folders.
std::string name_beside(std::string_view pattern, const std::string& output);

std::span<const Exporter> exporters();
const Exporter* find_exporter(std::string_view id);  // null when there is none

// One sentence on why `output` is no name for what the exporter writes; empty when it is one.
std::string name_problem(const Exporter& exporter, const std::string& output);

// Takes out what only replaces, where there is nothing to replace.
void leave_out_unneeded(const Exporter& exporter, Exported& exported, const std::string& output);
// Where each of the files goes, in their order: the file `output` and those beside it, or in the folder.
std::vector<std::string> paths_of(const Exporter& exporter, const Exported& exported,
                                  const std::string& output);

// Told before each file how many have been written, of how many bytes; false: go no further.
using WriteProgress = std::function<bool(std::size_t files, std::size_t bytes)>;

// Writes them there, and makes the folders that are missing. All are written beside their places first and
// then put there together, as StagedFile does: after an error, or when `progress` ends it, all old files are
// as they were, but where a StagedFile::doubt() is the error. Nothing is written where one of them would
// leave the bounds. The error's place is the name of the file, where it has one.
FormatResult<void> write_exported(const Exporter& exporter, const Exported& exported,
                                  const std::string& output, const WriteProgress& progress = nullptr,
                                  const ExportBounds& bounds = {});

}  // namespace talus
