// ExportPermissions: which export presets of the open level the user has allowed. A preset that came with a
// file writes nothing until then; what the user makes or changes is his own word.
//
// They are remembered outside of the level, by its file and by the whole preset, so that a preset which
// somebody else has changed is not allowed any more. The presets themselves are kept rather than hashes of
// them, which two presets could share.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include <talus/level/exports.h>
#include "export/export_bounds.h"

namespace talus {

class ExportPermissions {
 public:
  static constexpr std::size_t kMostKept = 10'000;  // of more, those of files that are gone are forgotten
  static constexpr std::size_t kMostBytes = 64
                                            << 10;  // of a preset's text; of a longer one it is asked again

  // store: where they are kept between starts; empty: nowhere. One that cannot be read counts as empty.
  explicit ExportPermissions(std::string store = {}) : store_(std::move(store)) {}

  // Another level is open, of this file; empty: it has none. What is known about the one before is forgotten.
  void open(const std::string& level_file);
  // The level was saved there, with these presets: what is allowed of them is remembered. The error is one
  // sentence on why that failed, so that it is asked about again in the next start.
  tl::expected<void, std::string> save(const std::string& level_file, std::span<const ExportPreset> presets);
  // The user has changed the presets: those that are new are allowed.
  void note_edit(std::span<const ExportPreset> before, std::span<const ExportPreset> after);
  // And remembers it; the error is as above.
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
    // That the user has chosen, as real_path() gives it; empty: none, or not known before the level has a
    // file.
    std::string place = {};
    bool is_chosen = false;  // in this session, so that it goes with the level to other files
  };
  const Entry* find(const ExportPreset& preset) const;
  Entry& entry(const ExportPreset& preset);
  std::string place_of(const ExportPreset& preset) const;
  tl::expected<void, std::string> remember(std::span<const ExportPreset> presets) const;

  std::string store_;
  std::string level_file_, key_;  // key_: what the store calls the file; empty: it has none
  std::vector<Entry> entries_;    // of this file
};

}  // namespace talus
