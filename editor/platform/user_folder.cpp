// As in the XDG base directory specification, with variables of Talus before it.
#include "user_folder.h"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace talus {
namespace {

namespace fs = std::filesystem;

fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// Never a folder below the one in which the program was started: that may be somebody else's, and records and
// settings in it would be trusted.
fs::path home_folder() {
  if (const fs::path home = variable("HOME"); home.is_absolute()) return home;
  const passwd* user = getpwuid(getuid());
  if (user != nullptr && fs::path(user->pw_dir).is_absolute()) return user->pw_dir;
  return "/";
}

std::string folder(const char* own_variable, const char* xdg_variable, const char* below_home) {
  if (const fs::path own = variable(own_variable); !own.empty()) return own.string();
  if (const fs::path xdg = variable(xdg_variable); xdg.is_absolute()) return (xdg / "talus").string();
  return (home_folder() / below_home / "talus").string();
}

}  // namespace

std::string config_folder() { return folder("TALUS_CONFIG_DIR", "XDG_CONFIG_HOME", ".config"); }
std::string state_folder() { return folder("TALUS_STATE_DIR", "XDG_STATE_HOME", ".local/state"); }

}  // namespace talus
