// Pictures on the command line.
#include "png_convert.h"

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "formats/files/atomic_file.h"
#include "formats/text/append_number.h"
#include "formats/tilesets/new_tileset.h"
#include "formats/tilesets/tile_cut.h"
#include "formats/tilesets/tileset_pixels.h"
#include "output_file.h"

namespace talus {
namespace {

void write_level(CommandContext& context, const Level& level, const CompanionFile& known,
                 const std::string& output, const std::string& picture) {
  const Format* format = output == "-" ? find_format("native") : format_for_file(output);
  if (format == nullptr)
    return fail(context, output, "", "must have the extension of a format in which levels can be written");
  const auto written = format->write(level, context_for_file(output));
  if (!written) return fail(context, output, written.error().place, written.error().message);
  if (output == "-") {
    context.out << written->bytes;
    return;
  }
  if (const std::string problem = output_problem({output, written->bytes, {picture}, true}); !problem.empty())
    return fail(context, output, "", problem);
  const auto saved = save_level(level, *format, output, known);
  if (!saved) return fail(context, output, saved.error().place, saved.error().message);
  for (const std::string& what : saved->dropped)
    say(context.err, output + ": warning: not stored in this format: " + what);
  if (!saved->note.empty()) say(context.err, output + ": note: " + saved->note);
}

std::string changes_text(const PngImportPlan& plan) {
  std::string text = std::to_string(plan.pixels) + " pixels of " + std::to_string(plan.tiles) +
                     " tiles and " + std::to_string(plan.colors) +
                     " colours changed; largest colour distance ";
  append_number(text, plan.largest_distance);
  return text;
}

// A sentence of the editor in the form of errors here: without its capital and its full stop.
std::string as_clause(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  if (!sentence.empty() && sentence[0] >= 'A' && sentence[0] <= 'Z')
    sentence[0] = static_cast<char>(sentence[0] - 'A' + 'a');
  return sentence;
}

}  // namespace

std::vector<std::string> png_part_names() { return {"tiles", "sprites", "palette"}; }

void import_png(CommandContext& context, const PngIntoLevel& import) {
  std::optional<LoadedLevel> loaded = load_file_or_fail(context, import.level);
  if (!loaded) return;
  Level& level = loaded->level;
  const auto picture = load_png(import.picture);
  if (!picture) return fail(context, import.picture, picture.error().place, picture.error().message);
  const auto names = png_part_names();
  const auto part = std::find(names.begin(), names.end(), import.part) - names.begin();
  const PngImportOptions options{static_cast<PngPart>(part), import.tile, import.take_palette};
  const auto plan = plan_png_import(level, *picture, options);
  if (!plan) return fail(context, import.picture, "", as_clause(plan.error()));
  apply_edit(level, plan->edit);
  write_level(context, level, loaded->companion, import.output, import.picture);
  if (context.status == kExitGood && import.output != "-")
    say(context.out, import.output + ": " + changes_text(*plan));
}

void make_level_from_tiles(CommandContext& context, const LevelFromTiles& order) {
  const auto read = read_tile_picture(order.picture);
  if (!read) return fail(context, order.picture, read.error().place, read.error().message);
  const RgbaPicture& picture = read->picture;
  const TileCut cut = order.tile ? TileCut{*order.tile, order.spacing, order.margin} : guess_cut(picture);
  const std::string problem = problem_of(cut, picture.width, picture.height);
  if (!problem.empty()) return fail(context, order.picture, "", as_clause(problem));
  if (!is_terrain_size(order.size.width, order.size.height, cut.tile))
    return fail(context, "talus", "", "--size is too large: a map has at most 16777216 cells and px a side");
  const std::string link = std::filesystem::absolute(order.picture).lexically_normal().string();
  const std::string folder = context_for_file(order.output).folder;
  if (order.is_linked && (order.output == "-" || linked_path_in(folder, link).empty()))
    return fail(context, order.picture, "",
                "is not below the folder of the level, so that it cannot be linked");
  const auto level = level_of_tiles({.picture = picture,
                                     .palette = read->palette,
                                     .cut = cut,
                                     .name = std::filesystem::path(order.picture).stem().string(),
                                     .link = order.is_linked ? link : ""},
                                    order.size.width, order.size.height);
  if (!level) return fail(context, order.picture, level.error().place, level.error().message);
  write_level(context, *level, {}, order.output, order.picture);
  if (context.status != kExitGood || order.output == "-") return;
  const CutGrid grid = grid_of(cut, picture.width, picture.height);
  say(context.out, order.output + ": " + std::to_string(grid.count()) + " tiles of " +
                       std::to_string(cut.tile.width) + "x" + std::to_string(cut.tile.height) +
                       " px, spacing " + std::to_string(cut.spacing) + ", margin " +
                       std::to_string(cut.margin));
}

}  // namespace talus
