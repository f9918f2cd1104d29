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

FormatResult<std::vector<std::string>> read_files(const ExportRequest& request,
                                                  const std::vector<std::string>& files) {
  std::vector<std::string> texts;
  for (const std::string& file : files) {
    FormatResult<std::string> text = request.read_asset("runtime/" + file + ".lua");
    if (!text) return tl::unexpected(text.error());
    texts.push_back(std::move(*text));
  }
  return texts;
}

// The title of a comment, or its first sentence. lines: without hyphens and indentation.
std::string in_one_line(const std::vector<std::string>& lines) {
  if (lines.front().starts_with("-")) return lines.front();
  std::string text;
  for (const std::string& line : lines) text.append(text.empty() ? "" : " ").append(line);
  for (std::size_t at = text.find(". "); at != std::string::npos; at = text.find(". ", at + 1))
    if (text[at + 2] >= 'A' && text[at + 2] <= 'Z') return text.substr(0, at + 1);
  return text;
}

}  // namespace

FormatResult<std::string> lua_runtime(const ExportRequest& request, bool plays) {
  const std::string more = std::string(request.parts) + ",events,steer,data" + (plays ? ",mouse,pairs" : "");
  const auto parts = lua_parts(request.level, more);
  if (!parts) return tl::unexpected(parts.error());
  const auto texts = read_files(request, lua_part_files(*parts));
  if (!texts) return tl::unexpected(texts.error());
  return lay_out(*texts, *parts);
}

FormatResult<std::vector<std::string>> cart_runtime(const ExportRequest& request,
                                                    const std::vector<std::string>& parts) {
  std::vector<std::string> files = lua_part_files(parts);
  std::erase(files, "luajit");
  return read_files(request, files);
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

std::string brief_lua(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) {
    std::istringstream lines(text);
    std::vector<std::string> comment;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
      const std::string code = line.substr(begin), indent(begin / 2, ' ');
      if (code.starts_with("--")) {
        comment.push_back(code.substr(std::min(code.find_first_not_of(' ', 2), code.size())));
        continue;
      }
      if (!comment.empty()) joined += indent + "-- " + in_one_line(comment) + '\n';
      comment.clear();
      if (!code.empty()) joined += indent + code;
      joined += '\n';
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
