// What Talus reads back too: levels, carts, sheets and palettes.
#include <algorithm>
#include <array>

#include "../formats/png_sheet.h"
#include "export_targets.h"

namespace talus {
namespace {

FormatResult<Exported> export_format(const ExportRequest& request, std::string_view id) {
  FormatResult<WrittenLevel> written = find_format(id)->write(request.level, context_for_file(request.name));
  if (!written) return tl::unexpected(written.error());
  return Exported{{{"", std::move(written->bytes)}}, std::move(written->dropped)};
}

struct ScriptName {
  std::string_view name, extension;  // as in a cart's line "script: js", and of text projects
};
constexpr std::array<ScriptName, 18> kScripts = {{{"lua", "lua"},
                                                  {"moon", "moon"},
                                                  {"moonscript", "moon"},
                                                  {"fennel", "fnl"},
                                                  {"fnl", "fnl"},
                                                  {"js", "js"},
                                                  {"javascript", "js"},
                                                  {"squirrel", "nut"},
                                                  {"nut", "nut"},
                                                  {"wren", "wren"},
                                                  {"wasm", "wasmp"},
                                                  {"ruby", "rb"},
                                                  {"rb", "rb"},
                                                  {"scheme", "scm"},
                                                  {"scm", "scm"},
                                                  {"janet", "janet"},
                                                  {"python", "py"},
                                                  {"py", "py"}}};

// The extension of text projects in the language that a cart's code says it is in; empty: it does not say,
// or one that is not known here.
std::string_view extension_of_script(std::string_view code) {
  constexpr std::string_view kKey = "script:";
  for (std::size_t at = code.find(kKey); at != std::string_view::npos; at = code.find(kKey, at + 1)) {
    const std::size_t line = code.rfind('\n', at) + 1;  // of the first line npos + 1, which is 0
    const std::string_view before = code.substr(line, at - line);
    if (before.find_first_not_of("-/#; \t") != std::string_view::npos) continue;
    std::string_view word = code.substr(at + kKey.size());
    word.remove_prefix(std::min(word.find_first_not_of(" \t"), word.size()));
    word = word.substr(0, word.find_first_of(" \t\r\n"));
    const auto known =
        std::find_if(kScripts.begin(), kScripts.end(), [&](const ScriptName& s) { return s.name == word; });
    return known == kScripts.end() ? std::string_view() : known->extension;
  }
  return {};
}

FormatResult<Exported> export_part(const ExportRequest& request, PngPart part) {
  return Exported{{{"", write_png_part(request.level, part)}}, {}};
}

}  // namespace

FormatResult<Exported> export_native(const ExportRequest& request) {
  return export_format(request, "native");
}
FormatResult<Exported> export_tic(const ExportRequest& request) { return export_format(request, "tic"); }
FormatResult<Exported> export_tic_text(const ExportRequest& request) {
  FormatResult<Exported> exported = export_format(request, "tic-text");
  if (!exported) return exported;
  const std::string given = context_for_file(request.name).extension;
  const std::string_view needed = extension_of_script(exported->files.front().bytes);
  if (!needed.empty() && !given.empty() && given != needed)
    return tl::unexpected(FormatError{"", "the cart's code is in another language than the name of " +
                                              request.name + " says: it must end with ." +
                                              std::string(needed)});
  return exported;
}
FormatResult<Exported> export_tiles_png(const ExportRequest& request) {
  return export_part(request, PngPart::tiles);
}
FormatResult<Exported> export_sprites_png(const ExportRequest& request) {
  return export_part(request, PngPart::sprites);
}
FormatResult<Exported> export_palette_png(const ExportRequest& request) {
  return export_part(request, PngPart::palette);
}

}  // namespace talus
