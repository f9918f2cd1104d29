// The place of the user's own files, whatever the environment is.
#include "platform/user_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <optional>
#include <string>

namespace talus::user_folder_test {

// Sets a variable, or removes it, for its lifetime.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = ::getenv(name)) old_ = old;
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST(UserFolder, IsBelowHome) {
  const Variable own("TALUS_STATE_DIR", nullptr), xdg("XDG_STATE_HOME", nullptr), home("HOME", "/home/me");
  EXPECT_EQ(state_folder(), "/home/me/.local/state/talus");
  const Variable other("XDG_STATE_HOME", "/elsewhere");
  EXPECT_EQ(state_folder(), "/elsewhere/talus");
}

// A downloaded folder could contain permissions, records of exports and command lines.
TEST(UserFolder, IsNeverRelativeToTheWorkingFolder) {
  const Variable own("TALUS_STATE_DIR", nullptr), own_config("TALUS_CONFIG_DIR", nullptr);
  for (const char* bad : {static_cast<const char*>(nullptr), "", "home", "./home"}) {
    const Variable home("HOME", bad), state("XDG_STATE_HOME", bad), config("XDG_CONFIG_HOME", bad);
    for (const std::string& folder : {state_folder(), config_folder()}) {
      EXPECT_TRUE(std::filesystem::path(folder).is_absolute()) << folder;
    }
  }
}

}  // namespace talus::user_folder_test
