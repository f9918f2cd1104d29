// docs/keys.md is made from the table of commands, and the other pages name only keys that commands have.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>

#include "formats/files/atomic_file.h"
#include "panels/commands/commands.h"
#include "paths.h"

namespace talus::keys_page_test {

const std::string kDocs = source_path("docs/"), kReadme = source_path("README.md");

// Escapes text for a cell of a Markdown table, which ends at a bar.
std::string cell_of(std::string text) {
  for (auto at = text.find('|'); at != text.npos; at = text.find('|', at + 2)) text.insert(at, "\\");
  return text;
}

std::string table_of(Scope scope) {
  std::string text = "\n## " + std::string(scope_label(scope)) + "\n\n";
  if (scope != Scope::everywhere)
    text += "*" + focus_command(scope).label + "* (**" + keys_of(focus_command(scope), KeyBindings()) +
            "**) leads there.\n\n";
  text += "| keys | command |\n| --- | --- |\n";
  for (const Command& command : commands()) {
    const std::string keys = keys_of(command, KeyBindings());
    if (command.scope == scope && !keys.empty())
      text += "| " + cell_of(keys) + " | " + cell_of(command.label) + " |\n";
  }
  return text;
}

std::string keys_page() {
  std::string text =
      "# Keys\n\nThese are the keys of the commands until you change them (*Edit > Change keys*). The window "
      "*Keys "
      "and mouse* (**F1**) shows the\nkeys as they are now, and what each command does. **Ctrl+P** finds the "
      "commands without a key. `docs/write_keys` writes this page.\n";
  for (Scope scope : {Scope::everywhere, Scope::play, Scope::map, Scope::sprites, Scope::shape, Scope::input,
                      Scope::cursor})
    text += table_of(scope);
  return text;
}

TEST(KeysPage, HasTheKeysOfTheCommands) {
  const std::string file = kDocs + "keys.md", page = keys_page();
  if (std::getenv("TALUS_WRITE_KEYS") != nullptr) std::ofstream(file) << page;
  EXPECT_TRUE(read_file(file).value_or("") == page) << "docs/write_keys writes it anew";
}

// Keys are printed bold, as **Ctrl+S**.
TEST(KeysPage, OtherPagesNameKeysOfCommands) {
  std::set<std::string> known;
  for (const Command& command : commands())
    for (const KeyChord key : {command.key, command.other_key}) known.insert(to_string(key));
  int found = 0;
  for (const std::string& page : {kReadme, kDocs + "guide.md", kDocs + "debugger.md"}) {
    const std::string text = read_file(page).value();
    const std::regex bold("\\*\\*([^*\\n]+)\\*\\*");
    for (std::sregex_iterator at(text.begin(), text.end(), bold), end; at != end; ++at) {
      const std::string name = at->str(1);
      if (!parse_chord(name)) continue;
      EXPECT_TRUE(known.contains(name)) << page << " names " << name;
      ++found;
    }
  }
  EXPECT_GT(found, 60);
}

}  // namespace talus::keys_page_test
