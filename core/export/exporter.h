// Exporters: what games and other programs read. Each is a file of this folder that declares itself in
// export_targets.h and has a row in exporter.cpp; `talus export` and the export window list them all.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../formats/format.h"

namespace talus {

struct ExportedFile {
  // Of an exporter of folders: in that folder, with '/' before the names of its own folders. Else empty for
  // the file that was named, and of further ones the name beside it.
  std::string name;
  std::string bytes;
};

struct Exported {
  std::vector<ExportedFile> files;   // at least one
  std::vector<std::string> dropped;  // what could not be held, one phrase each as in WrittenLevel::dropped
  // Of code that TIC-80 is to run: how much of its kMostTicCode bytes the exporter's part of it takes.
  std::optional<std::size_t> code_bytes = {};
};

inline constexpr std::size_t kMostTicCode = 65'536;  // bytes of code that TIC-80's free version holds

// The text of one of the files that come with the program, such as "runtime/base.lua".
using ReadAsset = std::function<FormatResult<std::string>(const std::string& name)>;

struct ExportRequest {
  const Level& level;
  // Of the file or folder that is named, without the folders it is in: "cave.tmj". "-": standard output.
  std::string name;
  const ReadAsset& read_asset;

  std::string stem() const;  // of the name, for files beside it: "cave"; of "-" and without a name: "level"
};

struct Exporter {
  std::string_view id;     // "love", as in `talus export --to love`
  std::string_view label;  // "game for LÖVE 11"
  // That the file's name may have, without the dot; the first is the usual one. Empty: a folder is named.
  std::span<const std::string_view> extensions;
  FormatResult<Exported> (*write)(const ExportRequest& request);
  std::string_view purpose = {};  // one sentence on what it is for and what is in it; may be empty

  bool is_folder() const { return extensions.empty(); }
};

std::span<const Exporter> exporters();
const Exporter* find_exporter(std::string_view id);  // null when there is none

// One sentence on why `output` is no name for what the exporter writes; empty when it is one.
std::string name_problem(const Exporter& exporter, const std::string& output);

// Where each of the files goes, in their order: the file `output` and those beside it, or in the folder.
std::vector<std::string> paths_of(const Exporter& exporter, const Exported& exported,
                                  const std::string& output);

// Told before each file how many have been written, of how many bytes; false: go no further.
using WriteProgress = std::function<bool(std::size_t files, std::size_t bytes)>;

// Writes them there, and makes the folders that are missing. All are written beside their places first and
// then put there together, as StagedFile does: after an error, or when `progress` ends it, all old files are
// as they were. The error's place is the name of the file, where it has one.
FormatResult<void> write_exported(const Exporter& exporter, const Exported& exported,
                                  const std::string& output, const WriteProgress& progress = nullptr);

}  // namespace talus
