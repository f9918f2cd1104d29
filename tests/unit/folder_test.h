// Tests that work on files: each has its own empty folder, which is removed when the test ends.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "environment.h"
#include "formats/files/atomic_file.h"
#include "waiting.h"

namespace talus {

// Makes an empty folder that no other test has, as tests run side by side. `beginning`: of its name.
inline std::filesystem::path new_folder(const std::string& beginning) {
  std::string name = ::testing::TempDir() + beginning + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + name);
  return name;
}

// Removes a folder, into which a program that the test started may still write.
inline void remove_folder(const std::filesystem::path& folder) {
  EXPECT_TRUE(comes_true([&] {
    std::error_code error;
    std::filesystem::remove_all(folder, error);
    return !std::filesystem::exists(folder);
  }));
}

class FolderTest : public ::testing::Test {
 protected:
  ~FolderTest() override { remove_folder(folder_); }

  // The path of a file in the folder.
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  std::string bytes_of(const std::string& name) const { return read_file(path(name)).value_or("(none)"); }
  // Writes a file, and returns its path.
  std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  const std::filesystem::path folder_ = new_folder("talus test ");  // with spaces, as names of users have
  // Files that commands remember are this test's own.
  const EnvironmentVariable state_folder_{"TALUS_STATE_DIR", path(".state")};
};

}  // namespace talus
