// As the XDG base directory specification has them, with variables of our own before it.
#include "user_folder.h"

#include <cstdlib>
#include <filesystem>

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string folder(const char* own_variable, const char* xdg_variable, const char* below_home) {
  const auto from = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value ? value : "");
  };
  if (const fs::path own = from(own_variable); !own.empty()) return own.string();
  if (const fs::path xdg = from(xdg_variable); xdg.is_absolute()) return (xdg / "talus").string();
  return (from("HOME") / below_home / "talus").string();
}

}  // namespace

std::string config_folder() { return folder("TALUS_CONFIG_DIR", "XDG_CONFIG_HOME", ".config"); }
std::string state_folder() { return folder("TALUS_STATE_DIR", "XDG_STATE_HOME", ".local/state"); }

}  // namespace talus
