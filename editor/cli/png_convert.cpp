// Pictures on the command line.
#include "png_convert.h"

#include <algorithm>
#include <ostream>

#include "formats/files/atomic_file.h"
#include "formats/text/append_number.h"
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

}  // namespace talus
