// ExportPermissions: the export presets of the open level that the user has allowed. A preset that came with
// a file writes nothing before that; presets that the user makes or changes are allowed.
//
// Permissions are stored outside of the level, by its file and by the whole preset, so that a preset which
// somebody else has changed is no longer allowed. The store holds the presets themselves; two presets could
// share a hash.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include <talus/level/exports.h>
#include "export/export_bounds.h"

namespace talus {

inline constexpr const char* kPermissionsFile = "allowed_exports";  // in the state folder

class ExportPermissions {
 public:
  // Limits, bytes: of the store, which then forgets the oldest; and of a preset's text, which is then asked
  // about again.
  static constexpr std::size_t kMaxKept = 4 << 20, kMaxBytes = 64 << 10;

  // store: where they are kept between starts; empty: nowhere. A store that cannot be read counts as empty.
  explicit ExportPermissions(std::string store = {}) : store_(std::move(store)) {}

  // Another level was opened, with this file; empty: it has none. Forgets the permissions of the one before.
  void open(const std::string& level_file);
  // The level was saved there, with these presets: stores which of them are allowed. The error is one
  // sentence on why that failed; the next start then asks again. A preset that cannot be stored is an error
  // once.
  tl::expected<void, std::string> save(const std::string& level_file, std::span<const ExportPreset> presets);
  // The user has changed the presets: new ones are allowed.
  void note_edit(std::span<const ExportPreset> before, std::span<const ExportPreset> after);
  // And stores it; the error is as above.
  tl::expected<void, std::string> allow(std::span<const ExportPreset> presets);
  // The user has chosen this preset's path, which may leave the folder of the level's file from now on.
  void allow_place(const ExportPreset& preset);

  bool allows(const ExportPreset& preset) const;
  // Where its files may go: the folder of the level's file, or the place that the user has chosen, if the
  // path still leads there.
  ExportBounds bounds_of(const ExportPreset& preset) const;

 private:
  struct Entry {
    ExportPreset preset;
    bool is_allowed = false;
    // The place that the user has chosen, as real_path() returns it; empty: no place, or not known before the
    // level has a file.
    std::string place = {};
    bool is_chosen = false;  // in this session, so that it goes with the level to other files
    bool is_told = false;    // that it cannot be kept
  };
  const Entry* find(const ExportPreset& preset) const;
  Entry& entry(const ExportPreset& preset);
  std::string place_of(const ExportPreset& preset) const;
  tl::expected<void, std::string> remember(std::span<const ExportPreset> presets);

  std::string store_;
  std::string level_file_, key_;  // key_: name of the file in the store; empty: it has none
  std::vector<Entry> entries_;    // for this file
};

}  // namespace talus
