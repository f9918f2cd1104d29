// The place of the user's own files, whatever the environment is.
#include "platform/user_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "environment.h"

namespace talus::user_folder_test {

using Variable = EnvironmentVariable;

TEST(UserFolder, IsBelowHome) {
  const Variable own("TALUS_STATE_DIR", std::nullopt), xdg("XDG_STATE_HOME", std::nullopt),
      home("HOME", "/home/me");
  EXPECT_EQ(state_folder(), "/home/me/.local/state/talus");
  const Variable other("XDG_STATE_HOME", "/elsewhere");
  EXPECT_EQ(state_folder(), "/elsewhere/talus");
}

// A downloaded folder could contain permissions, records of exports and command lines.
TEST(UserFolder, IsNeverRelativeToTheWorkingFolder) {
  const Variable own("TALUS_STATE_DIR", std::nullopt), own_config("TALUS_CONFIG_DIR", std::nullopt);
  for (const std::optional<std::string>& bad : {std::optional<std::string>(), {""}, {"home"}, {"./home"}}) {
    const Variable home("HOME", bad), state("XDG_STATE_HOME", bad), config("XDG_CONFIG_HOME", bad);
    for (const std::string& folder : {state_folder(), config_folder()}) {
      EXPECT_TRUE(std::filesystem::path(folder).is_absolute()) << folder;
    }
  }
}

}  // namespace talus::user_folder_test
