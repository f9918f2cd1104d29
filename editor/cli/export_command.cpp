// talus export FILE --to FORMAT -o OUT
#include "export_command.h"

#include <filesystem>
#include <ostream>

#include "formats/atomic_file.h"
#include "platform/asset_path.h"

namespace talus {
namespace {

FormatResult<std::string> read_asset(const std::string& name) { return read_file(asset_path(name)); }

struct ExportOptions {
  std::string input, output, target;
  bool playable = false;  // of a cart: with code that plays the level
};

std::vector<std::string> exporter_ids() {
  std::vector<std::string> ids;
  for (const Exporter& exporter : exporters()) ids.emplace_back(exporter.id);
  return ids;
}

}  // namespace

void write_export(CommandContext& context, const Exporter& exporter, const Level& level,
                  const std::string& input, const std::string& output) {
  if (const std::string problem = name_problem(exporter, output); !problem.empty())
    return fail(context, output, "", problem);
  const ReadAsset read = read_asset;
  const auto exported = exporter.write({level, std::filesystem::path(output).filename().string(), read});
  if (!exported) return fail(context, input, exported.error().place, exported.error().message);
  if (output == "-") {
    context.out << exported->files.front().bytes;
  } else if (const auto written = write_exported(exporter, *exported, output); !written) {
    return fail(context, output, written.error().place, written.error().message);
  }
  for (const std::string& what : exported->dropped)
    context.err << output << ": warning: not stored in this format: " << what << '\n';
}

void add_export_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("export", "Write a level in a game's format");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("FILE", options->input, "Level or cart")->required();
  command->add_option("--to", options->target, "Format to write")
      ->required()
      ->check(CLI::IsMember(exporter_ids()));
  command
      ->add_option("-o,--output", options->output,
                   "File to write, - for standard output; of lua and love a folder")
      ->required();
  command->add_flag("--playable", options->playable,
                    "With tic and tic-text: put code into the cart that plays the level at once");
  command->callback([&context, options] {
    const bool is_cart = options->target == "tic" || options->target == "tic-text";
    if (options->playable && !is_cart)
      throw CLI::ValidationError("--playable", "goes with --to tic and --to tic-text alone");
    const std::optional<Level> level = load_or_fail(context, options->input);
    if (!level) return;
    const Exporter& exporter = *find_exporter(options->target + (options->playable ? "-playable" : ""));
    write_export(context, exporter, *level, options->input, options->output);
  });
}

}  // namespace talus
