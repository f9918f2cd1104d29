// Exporters: what games and other programs read. Each is a file of this folder that declares itself in
// export_targets.h and has a row in exporter.cpp; `talus export` and the export window list them all.
#pragma once

#include <functional>
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
};

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

  bool is_folder() const { return extensions.empty(); }
};

std::span<const Exporter> exporters();
const Exporter* find_exporter(std::string_view id);  // null when there is none

// One sentence on why `output` is no name for what the exporter writes; empty when it is one.
std::string name_problem(const Exporter& exporter, const std::string& output);

// Writes the file `output` and those beside it, or all files of the folder `output`, which is made where it
// is missing; each as write_file_atomic does.
FormatResult<void> write_exported(const Exporter& exporter, const Exported& exported,
                                  const std::string& output);

}  // namespace talus
