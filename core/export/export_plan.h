// ExportPlan: what an export would write, and what is in its places now. Also, where the paths of a level's
// presets lead.
#pragma once

#include <optional>

#include "../formats/text/content_hash.h"
#include "exporter.h"

namespace talus {

struct PlannedFile {
  // What is in the file's place now. "other" is anything except a file with the same bytes.
  enum class Place { empty, same, other };
  std::string path;
  std::string name;      // of the file, for people: relative to the output folder, or without folders
  std::size_t size = 0;  // bytes
  Place place = Place::empty;
  std::uintmax_t old_size = 0;       // bytes, if there is a file
  std::optional<std::uint64_t> old;  // content_hash, if there is a file that can be read
};

struct ExportPlan {
  const Exporter* exporter = nullptr;  // never null
  std::string output;
  Exported content;
  std::vector<PlannedFile> files;  // in the order of content.files
  ExportBounds bounds = {};
};

struct ExportProblem {
  // The field of a preset, or the level, that caused the problem.
  enum class Field { target, path, level };
  Field field = Field::level;
  FormatError error;
  bool is_outside = false;  // as in PlaceProblem, of the path or of a file there
};

// Makes the files of an export with the exporter of this id, and looks at what is in their places. `output`:
// a file or folder; empty: not known yet, and all places count as empty. `parts`, `progress`: as in
// ExportRequest. `made`: the content, if an earlier plan of the same level, exporter and output has it; null:
// it is made. A path outside of the bounds is an error, and is not even looked at.
tl::expected<ExportPlan, ExportProblem> plan_export(const Level& level, std::string_view id,
                                                    const std::string& output, const ReadAsset& read_asset,
                                                    std::string_view parts = {},
                                                    const Progress& progress = {},
                                                    const Exported* made = nullptr,
                                                    const ExportBounds& bounds = {});
// The starters that would replace other files, which are the user's own code by now; except those that
// `is_exported` recognises as exported. Returns indices of the plan's files, rising.
std::vector<std::size_t> own_starters(const ExportPlan& plan,
                                      const std::function<bool(const PlannedFile&)>& is_exported);
// Takes files out of the plan. which: indices, rising.
void leave_out(ExportPlan& plan, const std::vector<std::size_t>& which);
// The first file that is the level's own one or its companion, also by a link or another name; null if there
// is none.
const PlannedFile* own_file_in(const ExportPlan& plan, const std::string& level_file);
// Writes what was planned, as write_exported does.
tl::expected<void, ExportProblem> write_plan(const ExportPlan& plan, const WriteProgress& progress = nullptr);

// "game: 3 files, 45,210 bytes"
std::string summary_of(const ExportPlan& plan);
// One sentence without its full stop if a cart's code is larger than TIC-80's free version allows; empty if
// it fits, or if not only carts need it.
std::string code_problem(const Exporter& exporter, std::optional<std::size_t> code_bytes);

// Returns where a preset's path leads. The level's file may be empty: it has none yet. A path that leads out
// of the folder of the file is no error here: see ExportBounds.
tl::expected<std::string, ExportProblem> output_of(const ExportPreset& preset, const std::string& level_file);
// The path of a preset that leads there. It is relative if the level has a file and both share a folder.
std::string path_for(const std::string& output, const std::string& level_file);
// Where a new preset of a level writes to: "export/cave.tmj", "export/love"; for the second one of its kind
// "export/cave-2.tmj". No two exporters have the same path.
std::string usual_path(const Exporter& exporter, const std::string& level_name, int number = 1);
// Whether the path is one of those, or empty.
bool is_usual_path(const std::string& path, const Exporter& exporter, const std::string& level_name);
// Returns the new path of a preset whose target changes.
std::string path_for_other(const std::string& path, const Exporter& before, const Exporter& after);

}  // namespace talus
