// The levels that come with the program, by what they are about.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "panels/files/files_view.h"

namespace talus {

struct ExampleGroup {
  std::string_view label;          // on its button
  std::string_view help;           // a sentence
  std::vector<std::string> files;  // paths, in order
};

// The scenes, and the hard cases by theme; each level is in one group. No group is empty.
std::vector<ExampleGroup> example_groups(const FilesView& files);

}  // namespace talus
