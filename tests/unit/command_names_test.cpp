// The sources of the editor name only commands that there are, and take keys from the commands' rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "formats/files/atomic_file.h"
#include "panels/commands/commands.h"
#include "paths.h"

namespace talus::command_names_test {

namespace fs = std::filesystem;

struct Literal {
  std::string text;
  bool is_command = false;  // "play/step"_command
};

// The texts in quotes of a source, without those in comments.
std::vector<Literal> literals_of(const std::string& source) {
  std::vector<Literal> found;
  for (std::size_t at = 0; at < source.size(); ++at) {
    if (source.compare(at, 2, "//") == 0) {
      at = std::min(source.find('\n', at), source.size());
    } else if (source[at] == '\'' && source.compare(at + 2, 1, "'") == 0) {
      at += 2;
    } else if (source[at] == '"') {
      std::size_t end = at + 1;
      while (end < source.size() && source[end] != '"') end += source[end] == '\\' ? 2 : 1;
      found.push_back({source.substr(at + 1, end - at - 1), source.compare(end + 1, 8, "_command") == 0});
      at = end;
    }
  }
  return found;
}

struct Source {
  std::string path;
  std::string text;
};

std::vector<Source> sources_of(const std::string& folder) {
  std::vector<Source> found;
  for (const auto& entry : fs::recursive_directory_iterator(source_path(folder))) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    found.push_back({entry.path().string(), read_file(entry.path().string()).value()});
  }
  return found;
}

TEST(CommandNames, AreIdsOfTheTable) {
  std::set<std::string> ids;
  for (const Command& command : commands()) ids.insert(command.id);
  int count = 0;
  for (const Source& source : sources_of("editor")) {
    for (const Literal& literal : literals_of(source.text)) {
      if (!literal.is_command || literal.text.empty()) continue;  // empty: the declaration of _command
      ++count;
      EXPECT_TRUE(ids.contains(literal.text)) << source.path << " names " << literal.text;
    }
  }
  EXPECT_GT(count, 100);
}

// Otherwise the test above would not find the name.
TEST(CommandNames, AreWrittenAsCommands) {
  for (const Source& source : sources_of("editor"))
    for (const char* made : {"CommandId{\"", "CommandId(\""})
      EXPECT_EQ(source.text.find(made), std::string::npos) << source.path << " makes a CommandId of a text";
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_part = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '+');
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_part(at - 1)) && !is_part(at + word.size())) return true;
  return false;
}

// Keys with Ctrl or Alt and function keys. The names of other keys are also plain words, such as "Home".
TEST(CommandNames, PanelsTakeKeysFromTheTable) {
  std::set<std::string> keys;
  for (const Command& command : commands()) {
    for (const KeyChord key : {command.key, command.other_key}) {
      if (key.ctrl || key.alt || (key.key >= kKeyF1 && key.key <= kKeyF12)) keys.insert(to_string(key));
    }
  }
  EXPECT_TRUE(keys.contains("Ctrl+S") && keys.contains("F10"));
  for (const Source& source : sources_of("editor/panels")) {
    for (const Literal& literal : literals_of(source.text)) {
      for (const std::string& key : keys)
        EXPECT_FALSE(has_word(literal.text, key))
            << source.path << " has a fixed key: \"" << literal.text << '"';
    }
  }
}

}  // namespace talus::command_names_test
