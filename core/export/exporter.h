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
  // For an exporter of folders: the path in that folder, with '/' between names. For others: empty for the
  // named file, and the name of each file beside it.
  std::string name;
  std::string bytes;
  // A start for the user's own code: a file that is there already is kept. See own_starters().
  bool is_starter = false;
  // Written only if a file is there already, which would mean something else now: an empty companion of a
  // cart.
  bool only_replaces = false;
};

struct Exported {
  std::vector<ExportedFile> files;  // at least one
  // What the format cannot hold, one phrase each, as in WrittenLevel::dropped.
  std::vector<std::string> dropped;
  // For code that TIC-80 runs: how many of the kMaxTicCode bytes the exporter's own part takes.
  std::optional<std::size_t> code_bytes = {};
};

// The content of a single named file. Its bytes are moved; a list in braces would copy them.
Exported exported_file(std::string bytes, std::vector<std::string> dropped = {});

// Whether an export writes the code of the level's cart, which TIC-80 runs, and other programs may. id: of
// the exporter; no code with an unknown one.
bool brings_code(const Level& level, std::string_view id);

inline constexpr std::size_t kMaxTicCode = 65'536;  // bytes of code that TIC-80's free version allows

// The text of a file that comes with the program, such as "runtime/base.lua".
using ReadAsset = std::function<FormatResult<std::string>(const std::string& name)>;

struct ExportRequest {
  const Level& level;
  // Name of the output file or folder without its folders: "cave.tmj". "-": standard output.
  std::string name;
  const ReadAsset& read_asset;
  std::string_view parts = {};  // runtime parts to add to those that the level uses: see lua_parts.h
  Progress progress = {};       // receives the progress, and says whether to go on
  // The level with its layers of tiles, if `level` has only the ground of all of them as its one layer, see
  // Exporter::draws_layers; null: `level` is all that there is.
  const Level* layered = nullptr;
  // The level as it is, if `level` and `layered` have more tiles and layers, which were made of its layers
  // and objects; null: they have not.
  const Level* source = nullptr;

  // The level that is drawn.
  const Level& drawn() const { return layered == nullptr ? level : *layered; }
  // The level with the layers, tiles and objects that its author made.
  const Level& whole() const { return source == nullptr ? drawn() : *source; }

  std::string stem() const;  // the name up to its first dot: "cave"; "level" for "-" and for an empty name
  std::string sheet_name() const;  // name of a picture of the tiles beside the file: "cave-tiles.png"
  // Name of another picture beside the file: "cave-picture-1.png". number: from 1.
  std::string picture_name(int number) const;
};

struct Exporter {
  std::string_view id;     // "love", as in `talus export --to love`
  std::string_view label;  // "game for LÖVE 11"
  // Extensions of the file, without the dot; the first one is the usual one. Empty: the output is a folder.
  std::span<const std::string_view> extensions = {};
  // Implements make(), which callers use. After its progress was stopped the result is not valid.
  FormatResult<Exported> (*write)(const ExportRequest& request);
  std::string_view purpose = {};  // one sentence: what it is for and what is in it; may be empty
  bool takes_layers =
      false;  // whether it takes all layers of tiles and turns; else they are made one, see flat_level.h
  // Whether it draws all layers of tiles, but collides with their ground as one: a level with several layers,
  // or with turned tiles, comes as ground_level() of it, with the level itself as ExportRequest::layered.
  bool draws_layers = false;
  // Whether it takes cells that mirror their tile; those with a quarter turn have tiles of their own. A level
  // with mirrored tiles comes as with draws_layers, with one layer.
  bool takes_mirrors = false;
  bool draws_pictures = false;  // whether it draws large tiles, and the pictures of objects and layers
  bool takes_groups = false;    // whether it has groups of layers; else their layers get their looks
  bool takes_objects =
      false;  // whether it takes layers of objects, or nothing of the map; else it tells them
  bool lists_objects =
      false;  // whether it takes layers of objects, and layers of pictures as far as it draws them
  // Whether it has all layers of tiles and their turns besides the flat map, of which nothing is lost then.
  bool lists_layers = false;
  // Whether it has no more tiles than a cart, so that those of flat_level() take the places of blank ones.
  bool has_cart_tiles = false;
  bool takes_parts = false;  // whether it writes the Lua runtime, which has parts
  // The suffix of its usual file name, "-sti", so that no two exporters have the same.
  std::string_view usual_suffix = {};
  // Names of all files that it may write besides the named one, or in the folder. * stands for the given name
  // without its extension, ** for the whole name, # for any number.
  std::span<const std::string_view> beside = {};
  bool shares_sheet = false;  // whether its PNG shows only the tiles: those of other exporters are the same
  bool keeps_code = false;    // whether it keeps the code of the level's cart, which TIC-80 runs
  // Whether it keeps members that Talus does not know, as the level has them. Another program could take them
  // for its own under a name like package.json, so presets name such a file with the usual extension only.
  bool keeps_unknown = false;

  bool is_folder() const { return extensions.empty(); }
  // Makes the files. A stopped progress is an error like any other.
  FormatResult<Exported> make(const ExportRequest& request) const;
};

// The name of a file of Exporter::beside, for an output of this name, without its folders; # stays.
std::string name_beside(std::string_view pattern, const std::string& output);
// The name of a file without its number, as name_beside() gives it: "cave-picture-#.png" for
// "cave-picture-12.png". Other names stay.
std::string without_picture_number(const std::string& name);

std::span<const Exporter> exporters();
const Exporter* find_exporter(std::string_view id);  // null if there is no such exporter

// One sentence on why `output` is not a valid name for what the exporter writes; empty if it is valid.
std::string name_problem(const Exporter& exporter, const std::string& output);
// The same on why a preset, which may have come with the level, must not write there, although a user may.
std::string preset_name_problem(const Exporter& exporter, const std::string& output);

// Removes the files that may only replace, if there is nothing to replace.
void leave_out_unneeded(const Exporter& exporter, Exported& exported, const std::string& output);
// Where each file goes, in the same order: the file `output` and those beside it, or into the folder.
std::vector<std::string> paths_of(const Exporter& exporter, const Exported& exported,
                                  const std::string& output);

// Called before each file with the files written so far and their bytes; false: stop.
using WriteProgress = std::function<bool(std::size_t files, std::size_t bytes)>;

// Writes the files, and makes missing folders. All files are written beside their places first and then moved
// there together, as StagedFile does. So after an error, or when `progress` stops it, all old files are as
// they were, unless the error is a StagedFile::doubt(). Nothing is written if one file would leave the
// bounds. The error's place is the name of the file, if it has one.
FormatResult<void> write_exported(const Exporter& exporter, const Exported& exported,
                                  const std::string& output, const WriteProgress& progress = nullptr,
                                  const ExportBounds& bounds = {});

}  // namespace talus
