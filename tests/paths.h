// Where the repository and the build are. Only paths.cpp is compiled with these folders, so that a clone in
// another folder finds every other object in the compiler's cache.
#pragma once

#include <string>
#include <string_view>

namespace talus {

// PATH below the folder of the repository, such as "assets/demo.talus.json".
std::string source_path(std::string_view path);

// PATH below the folder of the build.
std::string build_path(std::string_view path);

}  // namespace talus
