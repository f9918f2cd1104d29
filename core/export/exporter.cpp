// The list of exporters, and writing what they make.
#include "exporter.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <talus/level/placed_picture.h>
#include "../formats/files/atomic_file.h"
#include "../formats/import/import_drops.h"
#include "../level/ground_cells.h"
#include "../level/ground_level.h"
#include "../level/layer_tree.h"
#include "../level/object_ground.h"
#include "export_targets.h"
#include "flat_level.h"
#include "lua_pictures.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

template <std::size_t N>
using Extensions = std::array<std::string_view, N>;

constexpr Extensions<1> kPng = {"png"};
constexpr Extensions<1> kTmj = {"tmj"};
constexpr Extensions<1> kTmx = {"tmx"};
constexpr Extensions<1> kLdtk = {"ldtk"};
constexpr Extensions<1> kSvg = {"svg"};
constexpr Extensions<1> kLua = {"lua"};
constexpr Extensions<1> kJson = {"json"};
constexpr Extensions<1> kHeader = {"h"};

template <std::size_t N>
using Names = std::array<std::string_view, N>;

constexpr std::string_view kPictureWord = "-picture-";
constexpr Names<1> kSheetBeside = {"*-tiles.png"};
constexpr Names<2> kMapBeside = {"*-tiles.png", "*-picture-#.png"};
constexpr Names<1> kCompanion = {"**.talus.json"};
constexpr Names<16> kLoveFiles = {"talus.lua",    "level.lua",       "sheet.png",        "main.lua",
                                  "conf.lua",     "rules.lua",       "trace.lua",        "area.lua",
                                  "camera.lua",   "controls.lua",    "curve_points.lua", "frames.lua",
                                  "pictures.lua", "tile_bodies.lua", "pictures.png",     kLicenseFile};
constexpr Names<3> kRuntimeFiles = {"talus.lua", "level.lua", kLicenseFile};
constexpr Names<12> kBumpFiles = {"level.lua",  "sheet.png",    "bump_slopes.lua", "main.lua",
                                  "conf.lua",   "area.lua",     "camera.lua",      "controls.lua",
                                  "frames.lua", "pictures.lua", "pictures.png",    kLicenseFile};
constexpr Names<20> kCppFiles = {"level.talus.json", "main.cpp",         "CMakeLists.txt", "bodies.cpp",
                                 "bodies.h",         "level_camera.cpp", "level_camera.h", "controls.cpp",
                                 "controls.h",       "layers.cpp",       "layers.h",       "painter.cpp",
                                 "painter.h",        "play.cpp",         "play.h",         "headless.cpp",
                                 "headless.h",       "sheet.cpp",        "sheet.h",        kLicenseFile};
constexpr Names<10> kCsvFiles = {"map.csv",      "flags.csv", "sprite_flags.csv", "flag_names.csv",
                                 "polygons.csv", "lines.csv", "bodies.csv",       "roles.csv",
                                 "tuning.csv",   "sizes.csv"};

// Levels and maps of Tiled hold objects; the ground of theirs is in all others.
void tell_objects(const Exporter& exporter, const Level& level, std::vector<std::string>& dropped) {
  if (!level.large_tiles.empty() && !exporter.draws_pictures)
    dropped.emplace_back("the parts of tiles that are outside of their cells");
  for (const ObjectLayer& layer : level.objects) {
    if (exporter.lists_objects && !layer.image) continue;
    if (exporter.draws_pictures && drawn_pictures(layer).size() == layer.objects.size()) continue;
    const std::string kind = layer.image ? "the layer of a picture " : "the layer of objects ";
    if (!layer.is_ground) dropped.push_back(kind + quoted_name(layer.name));
  }
}

// The same request for a level that was made of its own.
ExportRequest request_for(const ExportRequest& request, const Level& level, const Level* layered = nullptr) {
  return {level,   request.name,    request.read_asset, request.parts, request.progress,
          layered, &request.whole()};
}

// The ground of all layers of tiles as one layer.
FormatResult<Level> ground_for_export(const Level& level, const GroundCells& cells) {
  if (cells.overflow > 0) return tl::unexpected(FormatError{"", *ground_problem(level, cells)});
  return ground_level(level);
}

// With all layers of tiles made one.
FormatResult<Exported> write_flat(const Exporter& exporter, const ExportRequest& request) {
  const auto flat = flat_level(request.level, exporter.takes_mirrors);
  if (!flat) return tl::unexpected(flat.error());
  const bool is_turned = flat->level.map.cells().has_turned();
  auto level = is_turned                 ? ground_for_export(flat->level, ground_cells(flat->level))
               : exporter.has_cart_tiles ? with_cart_tiles(flat->level)
                                         : flat->level;
  if (!level) return tl::unexpected(level.error());
  auto exported = exporter.write(request_for(request, *level, is_turned ? &flat->level : nullptr));
  if (exported && !exporter.lists_layers)
    exported->dropped.insert(exported->dropped.end(), flat->dropped.begin(), flat->dropped.end());
  return exported;
}

// How many bodies are lost where a cell has a body's tile in one layer of ground and ground in another.
std::size_t bodies_in_stacks(const Level& level, const GroundCells& ground) {
  std::vector<std::size_t> bodies;  // by stack
  for (const TileStack& stack : ground.stacks)
    bodies.push_back(static_cast<std::size_t>(std::count_if(
        stack.begin(), stack.end(), [&](MapCell cell) { return is_ball_tile(level, cell.tile); })));
  std::size_t count = 0;
  for (const TileNumber number : ground.cells)
    if (number >= level.tile_count()) count += bodies[static_cast<std::size_t>(number - level.tile_count())];
  return count;
}

// With the ground of all layers of tiles as one layer, and the layers to be drawn.
FormatResult<Exported> write_layered(const Exporter& exporter, const ExportRequest& request) {
  const GroundCells cells = ground_cells(request.level);
  const auto ground = ground_for_export(request.level, cells);
  if (!ground) return tl::unexpected(ground.error());
  auto exported = exporter.write(request_for(request, *ground, &request.level));
  const std::size_t lost = bodies_in_stacks(request.level, cells);
  if (exported && lost > 0)
    exported->dropped.push_back(std::to_string(lost) + (lost == 1 ? " body" : " bodies") +
                                " in cells that have ground in another layer");
  return exported;
}

FormatResult<Exported> write_one(const Exporter& exporter, const ExportRequest& request) {
  const bool is_plain = request.level.layers.is_plain() && !request.level.map.cells().has_turned();
  if (exporter.takes_layers || (is_plain && !(exporter.draws_pictures && has_pictures(request.level))))
    return exporter.write(request);
  return exporter.draws_layers ? write_layered(exporter, request) : write_flat(exporter, request);
}

}  // namespace

FormatResult<Exported> with_license(const ExportRequest& request, Exported exported) {
  FormatResult<std::string> text = request.read_asset("templates/" + std::string(kLicenseFile));
  if (!text) return tl::unexpected(text.error());
  exported.files.push_back({std::string(kLicenseFile), *std::move(text)});
  return exported;
}

Exported exported_file(std::string bytes, std::vector<std::string> dropped) {
  Exported exported;
  exported.files.push_back({"", std::move(bytes)});
  exported.dropped = std::move(dropped);
  return exported;
}

std::string ExportRequest::stem() const {
  const std::string first = name.substr(0, name.find('.'));
  return first.empty() || first == "-" ? "level" : first;
}

namespace {

// name: of the output.
std::string stem_beside(const std::string& name) {
  const std::string stem = name == "-" ? "" : fs::path(name).stem().string();
  return stem.empty() ? "level" : stem;
}

}  // namespace

std::string ExportRequest::sheet_name() const { return stem_beside(name) + "-tiles.png"; }

std::string ExportRequest::picture_name(int number) const {
  return stem_beside(name) + std::string(kPictureWord) + std::to_string(number) + ".png";
}

FormatResult<Exported> Exporter::make(const ExportRequest& request) const {
  if (!takes_groups && !request.level.layers.groups.empty()) {
    const Level flat = without_groups(request.level);
    auto exported = make({flat, request.name, request.read_asset, request.parts, request.progress});
    if (exported && draws_layers)
      exported->dropped.emplace_back("the groups of layers: each layer looks as it does in its groups");
    return exported;
  }
  FormatResult<Exported> exported;
  if (!takes_layers && has_object_ground(request.level)) {
    Level tiles = with_object_tiles(request.level, true);
    tiles.objects = request.level.objects;  // what is drawn of them
    for (ObjectLayer& layer : tiles.objects) layer.is_ground = false;
    exported = write_one(*this, request_for(request, tiles));
  } else {
    exported = write_one(*this, request);
  }
  if (exported && !takes_objects) tell_objects(*this, request.level, exported->dropped);
  if (request.progress.stopped()) return was_cancelled();
  return exported;
}

std::string name_beside(std::string_view pattern, const std::string& output) {
  if (pattern.starts_with("**")) return output + std::string(pattern.substr(2));
  if (pattern.starts_with('*')) return fs::path(output).stem().string() + std::string(pattern.substr(1));
  return std::string(pattern);
}

std::string without_picture_number(const std::string& name) {
  const auto word = name.rfind(kPictureWord), end = name.rfind(".png");
  if (word == name.npos || end == name.npos || end + 4 != name.size()) return name;
  const auto from = word + kPictureWord.size();
  if (from >= end || name.find_first_not_of("0123456789", from) != end) return name;
  return name.substr(0, from) + "#" + name.substr(end);
}

std::span<const Exporter> exporters() {
  static const std::vector<Exporter> list = {
      {.id = "native",
       .label = "Talus level",
       .extensions = find_format("native")->extensions,
       .write = export_native,
       .purpose = "A copy of the level for Talus itself.",
       .takes_layers = true,
       .takes_groups = true,
       .takes_objects = true,
       .keeps_unknown = true},
      {.id = "tic",
       .label = "TIC-80 cartridge",
       .extensions = find_format("tic")->extensions,
       .write = export_tic,
       .purpose = "Tiles, flags, map and palette in a cart; its code, sounds and all else stay as they were.",
       .has_cart_tiles = true,
       .beside = kCompanion,
       .keeps_code = true},
      {.id = "tic-text",
       .label = "TIC-80 text project",
       .extensions = find_format("tic-text")->extensions,
       .write = export_tic_text,
       .purpose = "The same as text, for version control and other editors.",
       .has_cart_tiles = true,
       .usual_suffix = "-tic",
       .beside = kCompanion,
       .keeps_code = true},
      {.id = "tic-playable",
       .label = "TIC-80 cartridge that plays the level",
       .extensions = find_format("tic")->extensions,
       .write = export_tic_playable,
       .purpose = "A game that runs at once: balls, players and the mouse behave as in Talus.",
       .has_cart_tiles = true,
       .takes_parts = true,
       .usual_suffix = "-playable",
       .beside = kCompanion},
      {.id = "tic-text-playable",
       .label = "TIC-80 text project that plays the level",
       .extensions = find_format("tic-text")->extensions,
       .write = export_tic_text_playable,
       .purpose = "The same game as text, with Lua code that you can build on.",
       .has_cart_tiles = true,
       .takes_parts = true,
       .usual_suffix = "-playable",
       .beside = kCompanion},
      {.id = "love",
       .label = "game for LÖVE 11",
       .write = export_love,
       .purpose = "A folder that LÖVE runs as it is: a start for your own game.",
       .draws_layers = true,
       .draws_pictures = true,
       .lists_objects = true,
       .takes_parts = true,
       .beside = kLoveFiles},
      {.id = "lua-runtime",
       .label = "Lua runtime and level",
       .write = export_lua_runtime,
       .purpose = "The exact solver and the level, for any game in Lua 5.3 or LuaJIT.",
       .draws_layers = true,
       .lists_objects = true,
       .takes_parts = true,
       .beside = kRuntimeFiles},
      {.id = "bump",
       .label = "game for LÖVE with bump.lua",
       .write = export_bump,
       .purpose = "Slopes as a response for bump.lua, the level, and an example that uses them.",
       .draws_layers = true,
       .draws_pictures = true,
       .lists_objects = true,
       .beside = kBumpFiles},
      {.id = "cpp",
       .label = "game in C++",
       .write = export_cpp,
       .purpose = "A program for SDL2 that draws and plays the level: a start for your own game.",
       .takes_layers = true,
       .takes_groups = true,
       .takes_objects = true,
       .beside = kCppFiles},
      {.id = "tmj",
       .label = "Tiled map, JSON",
       .extensions = kTmj,
       .write = export_tmj,
       .purpose =
           "Map and tileset for Tiled, with a collision polygon for each shape and flags as properties.",
       .takes_layers = true,
       .takes_groups = true,
       .takes_objects = true,
       .beside = kMapBeside,
       .shares_sheet = true},
      {.id = "tmx",
       .label = "Tiled map, XML",
       .extensions = kTmx,
       .write = export_tmx,
       .purpose = "The same map and tileset as XML.",
       .takes_layers = true,
       .takes_groups = true,
       .takes_objects = true,
       .beside = kMapBeside,
       .shares_sheet = true},
      {.id = "sti",
       .label = "Lua map for Simple Tiled Implementation",
       .extensions = kLua,
       .write = export_sti,
       .purpose = "A map for the STI library of LÖVE and its bump plugin.",
       .draws_layers = true,
       .takes_objects = true,
       .usual_suffix = "-sti",
       .beside = kMapBeside,
       .shares_sheet = true},
      {.id = "ldtk",
       .label = "LDtk project",
       .extensions = kLdtk,
       .write = export_ldtk,
       .purpose =
           "A project for LDtk: shapes as an IntGrid, tiles as a layer, flags with the tileset, objects "
           "as entities.",
       .takes_mirrors = true,
       .lists_objects = true,
       .beside = kSheetBeside,
       .shares_sheet = true},
      {.id = "lua",
       .label = "Lua table of plain data",
       .extensions = kLua,
       .write = export_lua,
       .purpose = "Layers, flags, objects, floor heights, outlines, bodies and tuning for a Lua game with "
                  "physics of its "
                  "own.",
       .takes_objects = true,
       .lists_layers = true},
      {.id = "json",
       .label = "JSON file of plain data",
       .extensions = kJson,
       .write = export_json,
       .purpose = "Layers, flags, objects, floor heights, outlines, bodies and tuning for any language.",
       .takes_objects = true,
       .lists_layers = true},
      {.id = "csv",
       .label = "set of CSV tables",
       .write = export_csv,
       .purpose = "Map, flags, floor heights, outlines, bodies and tuning, each in a table of its own.",
       .beside = kCsvFiles},
      {.id = "c",
       .label = "C99 header",
       .extensions = kHeader,
       .write = export_c,
       .purpose =
           "Map, flags, floors, bodies and tuning, and a function that finds the floor below a point."},
      {.id = "png",
       .label = "PNG picture of the map",
       .extensions = kPng,
       .write = export_png,
       .purpose = "The map with all of its layers, one pixel a px.",
       .takes_layers = true,
       .takes_objects = true},
      {.id = "svg",
       .label = "SVG drawing of the map and its outline",
       .extensions = kSvg,
       .write = export_svg,
       .purpose = "The map with its outline, normals, curves and bodies, as lines of any size."},
      {.id = "tiles-png",
       .label = "PNG picture of the tiles",
       .extensions = kPng,
       .write = export_tiles_png,
       .purpose = "The tiles as one picture, in true colour if they have it, else 8x8 px each.",
       .takes_layers = true,
       .takes_objects = true,
       .usual_suffix = "-tiles",
       .shares_sheet = true},
      {.id = "sprites-png",
       .label = "PNG picture of the sprites",
       .extensions = kPng,
       .write = export_sprites_png,
       .purpose = "The sprites as one picture, 8x8 px each.",
       .takes_layers = true,
       .takes_objects = true,
       .usual_suffix = "-sprites"},
      {.id = "palette-png",
       .label = "PNG picture of the palette",
       .extensions = kPng,
       .write = export_palette_png,
       .purpose = "The 16 colours as a picture of 16x1 px.",
       .takes_layers = true,
       .takes_objects = true,
       .usual_suffix = "-palette"},
  };
  return list;
}

bool brings_code(const Level& level, std::string_view id) {
  const Exporter* exporter = find_exporter(id);
  return exporter != nullptr && exporter->keeps_code && level.cart != nullptr;
}

const Exporter* find_exporter(std::string_view id) {
  const auto all = exporters();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Exporter& e) { return e.id == id; });
  return found == all.end() ? nullptr : &*found;
}

std::string name_problem(const Exporter& exporter, const std::string& output) {
  const std::string label(exporter.label);
  if (exporter.is_folder())
    return output == "-" ? "is standard output, but a " + label + " is a folder: name a folder" : "";
  const auto ends = [&](std::string_view extension) {
    return output.ends_with(std::string(1, '.').append(extension));
  };
  if (output == "-" || std::any_of(exporter.extensions.begin(), exporter.extensions.end(), ends)) return "";
  return "is not a name for a " + label + ": it must end with ." + std::string(exporter.extensions.front());
}

std::string preset_name_problem(const Exporter& exporter, const std::string& output) {
  const std::string ending = exporter.is_folder() ? "" : "." + std::string(exporter.extensions.front());
  if (!exporter.keeps_unknown || output.ends_with(ending)) return "";
  return "is not a name for a " + std::string(exporter.label) + " that a preset writes: it must end with " +
         ending + ", as another program could run what the level has in it under another name";
}

void leave_out_unneeded(const Exporter& exporter, Exported& exported, const std::string& output) {
  const std::vector<std::string> paths =
      output.empty() ? std::vector<std::string>() : paths_of(exporter, exported, output);
  for (std::size_t i = exported.files.size(); i-- > 0;) {
    std::error_code ignored;
    const bool is_there = !paths.empty() && fs::exists(fs::symlink_status(paths[i], ignored));
    if (exported.files[i].only_replaces && !is_there)
      exported.files.erase(exported.files.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

std::vector<std::string> paths_of(const Exporter& exporter, const Exported& exported,
                                  const std::string& output) {
  const fs::path folder = exporter.is_folder() ? fs::path(output) : fs::path(output).parent_path();
  std::vector<std::string> paths;
  for (const ExportedFile& file : exported.files)
    paths.push_back(file.name.empty() ? output : (folder / file.name).string());
  return paths;
}

namespace {

InPlace in_place(const ExportBounds& bounds, bool is_named) {
  if (holds(bounds, is_named)) return InPlace::refuse_links;
  return is_named && bounds.takes_pipe ? InPlace::write : InPlace::follow_links;
}

}  // namespace

FormatResult<void> write_exported(const Exporter& exporter, const Exported& exported,
                                  const std::string& output, const WriteProgress& progress,
                                  const ExportBounds& bounds) {
  std::vector<std::string> paths = paths_of(exporter, exported, output);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    auto place = place_within(bounds, paths[i], exported.files[i].name.empty());
    if (!place) return tl::unexpected(FormatError{"", place.error().message});
    paths[i] = *std::move(place);
  }
  std::vector<StagedFile> staged;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const ExportedFile& file = exported.files[i];
    if (progress && !progress(i, bytes)) return was_cancelled();
    std::error_code failure;
    const fs::path folder = fs::path(paths[i]).parent_path();
    // For a single file named on a command line, a missing folder is more likely a slip.
    if (!file.name.empty() && !folder.empty()) fs::create_directories(folder, failure);
    if (failure)
      return tl::unexpected(
          FormatError{"", "the folder " + folder.string() + " cannot be created: " + failure.message()});
    auto written = StagedFile::write(paths[i], file.bytes, in_place(bounds, file.name.empty()));
    if (!written) return tl::unexpected(FormatError{file.name, written.error().message});
    staged.push_back(*std::move(written));
    bytes += file.bytes.size();
  }
  if (progress && !progress(paths.size(), bytes)) return was_cancelled();
  // A file precedes those that it names, such as its picture. So the named ones are written first: a killed
  // process leaves no file that names a missing one.
  for (std::size_t i = staged.size(); i-- > 0;) {
    if (const auto put = staged[i].put(); !put)
      return tl::unexpected(FormatError{exported.files[i].name, put.error().message});
  }
  for (std::size_t i = 0; i < staged.size(); ++i) {
    if (!staged[i].doubt().empty())
      return tl::unexpected(FormatError{exported.files[i].name, staged[i].doubt()});
  }
  return {};
}

}  // namespace talus
