// What an export would write, and what is there now; and where the paths of a level's presets lead.
#pragma once

#include <optional>

#include "../formats/text/content_hash.h"
#include "exporter.h"

namespace talus {

struct PlannedFile {
  // What is at its place now; "other" is anything but a file with the same bytes.
  enum class Place { empty, same, other };
  std::string path;
  std::string name;      // of the file, for people: within the output folder, or without folders
  std::size_t size = 0;  // bytes
  Place place = Place::empty;
  std::uintmax_t old_size = 0;       // bytes, of a file that is there
  std::optional<std::uint64_t> old;  // content_hash of a file that is there; none: it cannot be read
};

struct ExportPlan {
  const Exporter* exporter = nullptr;  // never null
  std::string output;
  Exported content;
  std::vector<PlannedFile> files;  // in the order of content.files
  ExportBounds bounds = {};
};

struct ExportProblem {
  // Which of a preset's fields is to blame, or the level.
  enum class Field { target, path, level };
  Field field = Field::level;
  FormatError error;
  bool is_outside = false;  // as in PlaceProblem, of the path or of a file there
};

// Makes the files of an export by the exporter with this id, and looks at what is at their places. `output`:
// a file or folder; empty: not known yet, and all places are taken for empty. `parts`, `progress`: as in
// ExportRequest. `made`: the content, where an earlier plan of the same level, exporter and output has it
// already; null: it is made. What is outside of the bounds is an error, and is not even looked at.
tl::expected<ExportPlan, ExportProblem> plan_export(const Level& level, std::string_view id,
                                                    const std::string& output, const ReadAsset& read_asset,
                                                    std::string_view parts = {},
                                                    const Progress& progress = {},
                                                    const Exported* made = nullptr,
                                                    const ExportBounds& bounds = {});
// The starters in whose places others are, which are the user's own code by now, but for those that
// `is_exported` takes for what an export wrote: indices of the plan's files, rising.
std::vector<std::size_t> own_starters(const ExportPlan& plan,
                                      const std::function<bool(const PlannedFile&)>& is_exported);
// Takes files out of the plan. which: indices, rising.
void leave_out(ExportPlan& plan, const std::vector<std::size_t>& which);
// The first of the files that is the level's own one, by a link or another name of it, too; null: none is.
const PlannedFile* own_file_in(const ExportPlan& plan, const std::string& level_file);
// Writes what was planned, as write_exported does.
tl::expected<void, ExportProblem> write_plan(const ExportPlan& plan, const WriteProgress& progress = nullptr);

// "game: 3 files, 45,210 bytes"
std::string summary_of(const ExportPlan& plan);
// One sentence without its full stop on a cart's code that is more than TIC-80's free version holds; empty:
// it fits, or is for no cart alone.
std::string code_problem(const Exporter& exporter, std::optional<std::size_t> code_bytes);

// Where a preset's path leads, for a level's file; empty: it has none. The error is of the path. A path that
// leads out of the folder of the file is none: see ExportBounds.
tl::expected<std::string, ExportProblem> output_of(const ExportPreset& preset, const std::string& level_file);
// The path of a preset that leads there: relative when the level has a file and is on the same branch.
std::string path_for(const std::string& output, const std::string& level_file);
// Where a new preset of a level writes to: "export/cave.tmj", "export/love"; the second one of its kind
// "export/cave-2.tmj". No two exporters have the same.
std::string usual_path(const Exporter& exporter, const std::string& level_name, int number = 1);
// Whether it is one of those, or empty.
bool is_usual_path(const std::string& path, const Exporter& exporter, const std::string& level_name);
// What a preset's own path becomes when its target does.
std::string path_for_other(const std::string& path, const Exporter& before, const Exporter& after);

}  // namespace talus
