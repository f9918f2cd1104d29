// talus import FILE -o LEVEL.talus.json, talus import PNG --into LEVEL -o LEVEL

#include <ostream>

#include "export_writer.h"
#include "formats/files/atomic_file.h"
#include "formats/ldtk/ldtk_companion.h"
#include "png_convert.h"

namespace talus {
namespace {

// Any readable file as a native level.
void import_level(CommandContext& context, const std::string& input, const std::string& output) {
  const std::optional<Level> level = load_or_fail(context, input);
  if (!level) return;
  carry_out(context, {.level = *level, .input = input, .exporter = "native", .output = output});
}

// Returns false after a reported failure.
bool take_mapping(CommandContext& context, const std::string& file) {
  ImportChoices& choices = context.choices;
  const auto text = read_file(file);
  if (!text) return fail(context, file, text.error().place, text.error().message), false;
  choices.mapping = ldtk_mapping_in(*text);
  if (!choices.mapping)
    fail(context, file, "", "is neither a list of what LDtk's things stand for nor has one as \"mapping\"");
  return choices.mapping.has_value();
}

}  // namespace

void add_import_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand(
      "import", "Convert any readable file to a native level, or import a PNG into a level");
  auto input = std::make_shared<std::string>();
  auto into = std::make_shared<PngIntoLevel>();
  command
      ->add_option("FILE", *input,
                   "Level, cart, Tiled map or LDtk project; with --into, a PNG of up to 128x128 px")
      ->required();
  command
      ->add_option("-o,--output", into->output,
                   "Native level to write, with --into in the format of its name; - for standard output")
      ->required();
  CLI::Option* level = command->add_option("--into", into->level, "The level that gets the PNG");
  command->add_option("--part", into->part, "What the PNG becomes: images of a sheet, or the palette")
      ->check(CLI::IsMember(png_part_names()))
      ->needs(level);
  command->add_option("--tile", into->tile, "The image, 0 to 255, where its top left corner goes")
      ->check(CLI::Range(0, kMaxTiles - 1))
      ->needs(level);
  command
      ->add_flag("--take-palette", into->take_palette,
                 "Take over the PNG's palette of up to 16 colours; by default each pixel gets the level's "
                 "colour with the smallest squared distance in RGB")
      ->needs(level);
  for (CLI::Option* part : add_part_options(*command, context)) part->excludes(level);
  command
      ->add_flag("--tiles-used", context.choices.used_tiles,
                 "Take only the tiles that a Tiled map shows, with new numbers, also from several tilesets; "
                 "mirrored ones become tiles of their own")
      ->excludes(level);
  auto mapping = std::make_shared<std::string>();
  command
      ->add_option(
          "--ldtk-map", *mapping,
          "What values, tags and entities of an LDtk project stand for: the companion of a project, or a "
          "JSON list as under \"mapping\" in one")
      ->excludes(level);
  add_outside_option(*command, context);
  command->callback([&context, input, into, level, mapping] {
    if (!mapping->empty() && !take_mapping(context, *mapping)) return;
    if (level->empty()) return import_level(context, *input, into->output);
    into->picture = *input;
    import_png(context, *into);
  });
}

}  // namespace talus
