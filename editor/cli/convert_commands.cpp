// talus import FILE -o LEVEL.talus.json, talus import PNG --into LEVEL -o LEVEL,
// talus export FILE --to FORMAT -o OUT

#include <ostream>

#include "command.h"
#include "formats/atomic_file.h"
#include "formats/exporter.h"
#include "platform/asset_path.h"
#include "png_convert.h"

namespace talus {
namespace {

struct Conversion {
  std::string input, output, format;
  bool playable = false;  // a cart with code that plays the level
};

FormatResult<std::string> read_asset(const std::string& name) { return read_file(asset_path(name)); }

// A file named as another format's would be taken for that. An error's message, or nothing.
std::string wrong_name(const std::string& output, const Format& format) {
  const Format* named = output == "-" ? nullptr : format_for_file(output);
  if (named == nullptr || named == &format) return "";
  return "has the name of a " + std::string(named->label) + ", but a " + std::string(format.label) +
         " would be written: use talus export --to " + std::string(named->id) + ", or another name";
}

void convert(CommandContext& context, const Conversion& conversion) {
  std::optional<Level> level = load_or_fail(context, conversion.input);
  if (!level) return;
  if (conversion.playable) {
    FormatResult<Level> cart = playable_cart(*level, read_asset);
    if (!cart) return fail(context, conversion.input, cart.error().place, cart.error().message);
    level = std::move(*cart);
  }
  const Format& format = *find_format(conversion.format);
  if (const std::string wrong = wrong_name(conversion.output, format); !wrong.empty())
    return fail(context, conversion.output, "", wrong);
  std::vector<std::string> dropped;
  if (conversion.output == "-") {
    FormatResult<WrittenLevel> written = format.write(*level, {});
    if (!written) return fail(context, conversion.input, written.error().place, written.error().message);
    context.out << written->bytes;
    dropped = std::move(written->dropped);
  } else {
    FormatResult<std::vector<std::string>> saved = save_level(*level, format, conversion.output);
    if (!saved) return fail(context, conversion.output, saved.error().place, saved.error().message);
    dropped = std::move(*saved);
  }
  for (const std::string& what : dropped) {
    context.err << conversion.output << ": warning: not stored in this format: " << what << '\n';
  }
}

// Writes the folder of an exporter.
void export_folder(CommandContext& context, const std::string& input, const Exporter& exporter,
                   const std::string& output) {
  const std::optional<Level> level = load_or_fail(context, input);
  if (!level) return;
  if (output == "-")
    return fail(context, output, "",
                "is one file, but a " + std::string(exporter.label) + " is a folder: name one");
  FormatResult<Exported> exported = exporter.write(*level, read_asset);
  if (!exported) return fail(context, input, exported.error().place, exported.error().message);
  if (auto written = write_exported(*exported, output); !written)
    return fail(context, output, written.error().place, written.error().message);
  for (const std::string& what : exported->dropped)
    context.err << output << ": warning: not stored in this format: " << what << '\n';
}

std::vector<std::string> format_ids() {
  std::vector<std::string> ids;
  for (const Format& format : formats()) ids.emplace_back(format.id);
  for (const PngPartInfo& info : png_part_infos()) ids.emplace_back(info.id);
  for (const Exporter& exporter : exporters()) ids.emplace_back(exporter.id);
  return ids;
}

}  // namespace

void add_import_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand(
      "import", "Turn any readable file into a native level, or take a PNG into a level");
  auto conversion = std::make_shared<Conversion>();
  auto into = std::make_shared<PngIntoLevel>();
  conversion->format = "native";
  command->add_option("FILE", conversion->input, "Level or cart; with --into, a PNG of up to 128x128 px")
      ->required();
  command
      ->add_option("-o,--output", conversion->output,
                   "Native level to write, with --into in the format of its name; - for standard output")
      ->required();
  CLI::Option* level = command->add_option("--into", into->level, "The level that the PNG is taken into");
  command->add_option("--part", into->part, "What the PNG becomes: images of a sheet, or the palette")
      ->check(CLI::IsMember(png_part_names()))
      ->needs(level);
  command->add_option("--tile", into->tile, "The image, 0 to 255, where its top left corner goes")
      ->check(CLI::Range(0, kTileCount - 1))
      ->needs(level);
  command
      ->add_flag(
          "--take-palette", into->take_palette,
          "Take over its palette of up to 16 colours; without, each pixel takes the level's colour with "
          "the smallest squared distance in RGB")
      ->needs(level);
  command->callback([&context, conversion, into, level] {
    if (level->empty()) return convert(context, *conversion);
    into->picture = conversion->input;
    into->output = conversion->output;
    import_png(context, *into);
  });
}

void add_export_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("export", "Write a level in a game's format");
  auto conversion = std::make_shared<Conversion>();
  command->add_option("FILE", conversion->input, "Level or cart")->required();
  command->add_option("--to", conversion->format, "Format to write")
      ->required()
      ->check(CLI::IsMember(format_ids()));
  command
      ->add_option("-o,--output", conversion->output,
                   "File to write, - for standard output; of lua and love a folder")
      ->required();
  command->add_flag("--playable", conversion->playable,
                    "With tic and tic-text: put code into the cart that plays the level at once");
  command->callback([&context, conversion] {
    const bool is_cart = conversion->format == "tic" || conversion->format == "tic-text";
    if (conversion->playable && !is_cart)
      throw CLI::ValidationError("--playable", "goes with --to tic and --to tic-text alone");
    if (const auto part = png_part_of(conversion->format))
      export_png(context, conversion->input, *part, conversion->output);
    else if (const Exporter* exporter = find_exporter(conversion->format))
      export_folder(context, conversion->input, *exporter, conversion->output);
    else
      convert(context, *conversion);
  });
}

}  // namespace talus
