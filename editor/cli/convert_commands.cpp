// talus import FILE -o LEVEL.talus.json, talus export FILE --to FORMAT -o OUT

#include <ostream>

#include "command.h"
#include "formats/format.h"

namespace talus {
namespace {

struct Conversion {
  std::string input, output, format;
};

// A file named as another format's would be taken for that. An error's message, or nothing.
std::string wrong_name(const std::string& output, const Format& format) {
  const Format* named = output == "-" ? nullptr : format_for_file(output);
  if (named == nullptr || named == &format) return "";
  return "has the name of a " + std::string(named->label) + ", but a " + std::string(format.label) +
         " would be written: use talus export --to " + std::string(named->id) + ", or another name";
}

void convert(CommandContext& context, const Conversion& conversion) {
  const std::optional<Level> level = load_or_fail(context, conversion.input);
  if (!level) return;
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

std::vector<std::string> format_ids() {
  std::vector<std::string> ids;
  for (const Format& format : formats()) ids.emplace_back(format.id);
  return ids;
}

}  // namespace

void add_import_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("import", "Turn any readable file into a native level");
  auto conversion = std::make_shared<Conversion>();
  conversion->format = "native";
  command->add_option("FILE", conversion->input, "Level or cart")->required();
  command->add_option("-o,--output", conversion->output, "Native level to write; - for standard output")
      ->required();
  command->callback([&context, conversion] { convert(context, *conversion); });
}

void add_export_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("export", "Write a level in a game's format");
  auto conversion = std::make_shared<Conversion>();
  command->add_option("FILE", conversion->input, "Level or cart")->required();
  command->add_option("--to", conversion->format, "Format to write")
      ->required()
      ->check(CLI::IsMember(format_ids()));
  command->add_option("-o,--output", conversion->output, "File to write; - for standard output")->required();
  command->callback([&context, conversion] { convert(context, *conversion); });
}

}  // namespace talus
