// ReadPermissions: folders in which the files of a map may be read, although they lie outside of its own
// folder. A map comes from anybody: nothing there is read before the user has allowed it.
//
// Permissions are stored outside of the map, by its folder: all maps of a game share their tilesets.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace talus {

inline constexpr const char* kReadPermissionsFile = "allowed_reads";  // in the state folder

class ReadPermissions {
 public:
  static constexpr std::size_t kMaxKept = 1 << 20;  // bytes of the store, which then forgets the oldest

  // store: where they are kept between starts; empty: nowhere. A store that cannot be read counts as empty.
  explicit ReadPermissions(std::string store = {}) : store_(std::move(store)) {}

  // The folders for the maps in the folder of `file`, for ImportChoices::outside.
  std::vector<std::string> folders_of(const std::string& file) const;
  // Allows one more, also for later starts. The error is one sentence on why it cannot be stored; it holds
  // for this session.
  tl::expected<void, std::string> allow(const std::string& file, const std::string& folder);

 private:
  struct Entry {
    std::string map_folder;  // as real_path() returns it
    std::string folder;      // the same
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  static std::optional<Entry> entry_of(const std::string& line);
  static std::string line_of(const Entry& entry);

  std::string store_;
  std::vector<Entry> own_;  // allowed in this session
};

// The smallest folder with the folder of a map and all files of these names in it, after all links are
// followed. Empty: there is none, as links go in a circle. names: relative to the folder of `file`.
std::string common_folder(const std::string& file, const std::vector<std::string>& names);

}  // namespace talus
