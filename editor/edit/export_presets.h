// Editing the level's presets of exports.
#pragma once

#include "edit.h"

namespace talus {

// Each is empty when nothing changes; `index` of none, or a full list, changes nothing.
Edit add_export(const Level& level, ExportPreset preset);
Edit set_export(const Level& level, std::size_t index, ExportPreset preset, std::string label);
Edit remove_export(const Level& level, std::size_t index);

// "love", "love 2", ...: the first of them that no preset has.
std::string free_export_name(const Level& level, const std::string& name);

}  // namespace talus
