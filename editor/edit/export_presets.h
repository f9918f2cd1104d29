// Edits the level's export presets.
#pragma once

#include <optional>
#include <string_view>

#include "level/edit.h"

namespace talus {

// Each is empty if nothing changes, if there is no preset `index`, or if the list is full.
Edit add_export(const Level& level, ExportPreset preset);
Edit set_export(const Level& level, std::size_t index, ExportPreset preset, std::string label);
Edit remove_export(const Level& level, std::size_t index);

// The index of the first preset that exports by this exporter; nothing if there is none.
std::optional<std::size_t> find_export(const Level& level, std::string_view exporter);

// Returns "love", "love 2", ...: the first of them that no preset has.
std::string free_export_name(const Level& level, const std::string& name);

}  // namespace talus
