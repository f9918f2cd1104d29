// Writing carts, and the languages of their code.
#include "cart_files.h"

#include <algorithm>
#include <array>

#include "../formats/native/companion.h"

namespace talus {
namespace {

struct ScriptName {
  std::string_view name, extension;  // as in a cart's line "script: js", and as extension of text projects
};
constexpr std::array<ScriptName, 20> kScripts = {
    {{"lua", "lua"},    {"yue", "yue"},   {"yuescript", "yue"}, {"moon", "moon"},     {"moonscript", "moon"},
     {"fennel", "fnl"}, {"fnl", "fnl"},   {"js", "js"},         {"javascript", "js"}, {"squirrel", "nut"},
     {"nut", "nut"},    {"wren", "wren"}, {"wasm", "wasmp"},    {"ruby", "rb"},       {"rb", "rb"},
     {"scheme", "scm"}, {"scm", "scm"},   {"janet", "janet"},   {"python", "py"},     {"py", "py"}}};

// The extension of text projects in the language of a cart's code. Empty if the code does not name its
// language, or names one that is not known here.
std::string_view extension_of_script(std::string_view code) {
  constexpr std::string_view kKey = "script:";
  for (std::size_t at = code.find(kKey); at != std::string_view::npos; at = code.find(kKey, at + 1)) {
    const std::size_t line = code.rfind('\n', at) + 1;  // begin of the line; npos + 1 is 0 for the first line
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

// What games that run in TIC-80 lack; the companion has it. Empty if a cart has all flags of the tiles.
std::vector<std::string> dropped_flags(const Level& level) {
  std::size_t tiles = 0;
  for (const Sheet& sheet : level.sheets)
    tiles += static_cast<std::size_t>(std::count_if(
        sheet.flags.begin(), sheet.flags.end(), [](FlagSet flags) { return (flags & ~kCartFlagSet) != 0; }));
  if (tiles == 0) return {};
  return {"the flags above 7 of " + std::to_string(tiles) + (tiles == 1 ? " tile" : " tiles") +
          ": a cart has flags 0 to 7, and its companion the others"};
}

FormatResult<Exported> cart_files(const ExportRequest& request, const Level& cart, const Format& format) {
  const FormatContext context = context_for_file(request.name);
  FormatResult<WrittenLevel> written = format.write(cart, context);
  if (!written) return tl::unexpected(written.error());
  const auto held = format.read(written->bytes, context);
  if (!held) return tl::unexpected(held.error());
  auto companion = write_companion(request.level, *held, format, request.name);
  if (!companion) return tl::unexpected(companion.error());
  const bool is_needed = !companion->empty();
  // An old companion would add to the cart what the level no longer has.
  if (!is_needed) companion = write_companion(request.level, *held, format, request.name, true);
  Exported exported{{{"", std::move(written->bytes)}}, std::move(written->dropped)};
  for (std::string& flags : dropped_flags(request.level)) exported.dropped.push_back(std::move(flags));
  if (request.name == "-" && is_needed)
    exported.dropped.emplace_back("what a cart cannot hold, which goes beside a file");
  exported.files.push_back({.name = request.name + std::string(kCompanionEnding),
                            .bytes = *std::move(companion),
                            .only_replaces = !is_needed});
  return exported;
}

}  // namespace

FormatResult<Exported> tic_files(const ExportRequest& request, const Level& cart) {
  return cart_files(request, cart, *find_format("tic"));
}

FormatResult<Exported> tic_text_files(const ExportRequest& request, const Level& cart) {
  FormatResult<Exported> exported = cart_files(request, cart, *find_format("tic-text"));
  if (!exported) return exported;
  const std::string given = context_for_file(request.name).extension;
  const std::string_view needed = extension_of_script(exported->files.front().bytes);
  // Projects in Yue ended with .lua before TIC-80 had .yue.
  const bool is_yue_as_lua = needed == "yue" && given == "lua";
  if (!needed.empty() && !given.empty() && given != needed && !is_yue_as_lua)
    return tl::unexpected(FormatError{"", "the cart's code does not fit the name " + request.name +
                                              ": in its language the name must end with ." +
                                              std::string(needed)});
  return exported;
}

}  // namespace talus
