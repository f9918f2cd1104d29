// Tests that work on files: each has its own empty folder, which is removed when the test ends.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "formats/files/atomic_file.h"

namespace talus {

class FolderTest : public ::testing::Test {
 protected:
  // Tests run side by side, so no other test may have this folder. Its name has spaces, as names of users do.
  FolderTest() {
    std::string name = ::testing::TempDir() + "talus test XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + name);
    folder_ = name;
    ::setenv("TALUS_STATE_DIR", path(".state").c_str(),
             1);  // files that commands remember are this test's own
  }
  ~FolderTest() override {
    ::unsetenv("TALUS_STATE_DIR");
    std::filesystem::remove_all(folder_);
  }

  // The path of a file in the folder.
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  std::string bytes_of(const std::string& name) const { return read_file(path(name)).value_or("(none)"); }
  // Writes a file, and returns its path.
  std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  std::filesystem::path folder_;
};

}  // namespace talus
