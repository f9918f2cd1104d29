// UnsavedMappings: what the user has said that the things in projects of LDtk stand for, until that is saved
// beside the project. So a choice is not lost when nothing is saved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <talus/level/ldtk_origin.h>

namespace talus {

inline constexpr const char* kMappingsFile = "ldtk_mappings";  // in the state folder

class UnsavedMappings {
 public:
  static constexpr std::size_t kMaxKept = 1 << 20;  // bytes of the store, which then forgets the oldest

  // store: where they are kept between starts; empty: they last as long as the session. A store that cannot
  // be read counts as empty, and what cannot be written lasts as long as the session.
  explicit UnsavedMappings(std::string store = {}) : store_(std::move(store)) {}

  // Of the project in that file; nothing if none was kept, or if it was saved since.
  std::optional<LdtkMapping> find(const std::string& file) const;
  void keep(const std::string& file, const LdtkMapping& mapping);
  void forget(const std::string& file);  // it is saved beside the project

 private:
  std::string store_;
  std::vector<std::string> own_;  // the lines, if there is no store
};

}  // namespace talus
