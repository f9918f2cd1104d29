// Reads the parts of the runtime and joins them.
#include "lua_runtime.h"

#include <algorithm>
#include <sstream>

#include "lua_parts.h"
#include "lua_text.h"

namespace talus {
namespace {

// A line of Lua without spaces that are not needed. Two hyphens side by side would begin a comment.
std::string without_spaces(const std::string& line) {
  std::string kept;
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') is_quoted = !is_quoted;
    if (c != ' ' || is_quoted) {
      kept += c;
      continue;
    }
    const std::size_t next = line.find_first_not_of(' ', i);
    if (kept.empty() || next == std::string::npos) continue;
    const bool joins_words = is_lua_word(kept.back()) && is_lua_word(line[next]);
    const bool joins_hyphens = kept.back() == '-' && line[next] == '-';
    if (joins_words || joins_hyphens) kept += ' ';
    i = next - 1;
  }
  return kept;
}

// The list of parts follows the comment of the first file, which says what the module is.
std::string lay_out(const std::vector<std::string>& texts, const std::vector<std::string>& parts) {
  std::string joined;
  for (const std::string& text : texts) joined.append(joined.empty() ? "" : "\n\n").append(text);
  std::string names;
  for (const std::string& part : parts) names.append(names.empty() ? "" : ", ").append(part);
  joined.insert(joined.find("\n\n") + 1,
                "--\n-- The parts of this module: " + (names.empty() ? "none" : names) + ".\n");
  return joined;
}

}  // namespace

FormatResult<std::string> lua_runtime(const ExportRequest& request, LuaForm form, bool plays) {
  std::string more = std::string(request.parts) + (plays ? ",mouse" : "");
  if (form == LuaForm::readable) {  // carts are short of space
    more += ",events,steer,data";
    if (plays) more += ",pairs";  // as rules of the game add bodies
  }
  const auto parts = lua_parts(request.level, more);
  if (!parts) return tl::unexpected(parts.error());
  std::vector<std::string> texts;
  for (const std::string& file : lua_part_files(*parts)) {
    if (form == LuaForm::small && file == "luajit") continue;  // for carts, which TIC-80 runs by Lua 5.3
    FormatResult<std::string> text = request.read_asset("runtime/" + file + ".lua");
    if (!text) return text;
    texts.push_back(std::move(*text));
  }
  return form == LuaForm::small ? join_lua(texts) : lay_out(texts, *parts);
}

std::string join_lua(const std::vector<std::string>& texts) {
  std::string joined;
  bool is_head = true;  // the very first comment says what the module is
  for (const std::string& text : texts) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const bool is_comment = line.compare(0, 2, "--") == 0;
      is_head = is_head && is_comment;
      const std::string kept = is_head ? line : without_spaces(line.substr(0, line.find("--")));
      if (!kept.empty()) joined += kept + '\n';
    }
  }
  return joined;
}

std::vector<std::string> dropped_physics(const Level& level) {
  std::vector<std::string> dropped;
  if (level.tuning.solver != SolverKind::exact)
    dropped.push_back("the solver " + std::string(solver_name(level.tuning.solver)) +
                      ": the game uses exact instead");
  return dropped;
}

}  // namespace talus
