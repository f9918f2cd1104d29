#include "paths.h"

namespace talus {

std::string source_path(std::string_view path) { return std::string(TALUS_SOURCE_DIR "/").append(path); }

std::string build_path(std::string_view path) { return std::string(TALUS_BUILD_DIR "/").append(path); }

}  // namespace talus
