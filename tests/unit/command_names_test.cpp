// The sources of the editor name only commands that there are, and take keys from the commands' rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "formats/files/atomic_file.h"
#include "panels/commands/commands.h"

namespace talus::command_names_test {

namespace fs = std::filesystem;

struct Source {
  std::string path;
  std::string text;
};

std::vector<Source> sources_of(const std::string& folder) {
  std::vector<Source> found;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TALUS_SOURCE_DIR) / folder)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    found.push_back({entry.path().string(), read_file(entry.path().string()).value()});
  }
  return found;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    found.push_back(at->str(1));
  return found;
}

TEST(CommandNames, AreIdsOfTheTable) {
  std::set<std::string> ids;
  for (const Command& command : commands()) ids.insert(command.id);
  const std::regex named("\"([^\"]*)\"_command\\b");
  int count = 0;
  for (const Source& source : sources_of("editor")) {
    for (const std::string& id : matches(source.text, named)) {
      ++count;
      EXPECT_TRUE(ids.contains(id)) << source.path << " names " << id;
    }
  }
  EXPECT_GT(count, 100);
}

// Otherwise a name is not found by the test above.
TEST(CommandNames, AreWrittenAsCommands) {
  const std::regex made("(CommandId(?: \\w+)?[{(]\\s*\")");
  for (const Source& source : sources_of("editor"))
    EXPECT_TRUE(matches(source.text, made).empty()) << source.path << " makes a CommandId of a literal";
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
  const std::regex literal("\"((?:[^\"\\\\\n]|\\\\.)*)\""), key("((?:(?:Ctrl|Alt|Shift)\\+)*\\b\\w+)");
  for (const Source& source : sources_of("editor/panels")) {
    for (const std::string& text : matches(source.text, literal)) {
      for (const std::string& word : matches(text, key))
        EXPECT_FALSE(keys.contains(word)) << source.path << " has a fixed key: \"" << text << '"';
    }
  }
}

}  // namespace talus::command_names_test
