// Presets of a level that would write one another's files, and paths without such clashes.
#pragma once

#include <span>
#include <string>

#include "exporter.h"

namespace talus {

// One sentence without its full stop on a file that both presets[index] and another preset would write, or
// that is the level's own; empty if there is none. Several presets may write the same picture of the tiles.
// level_file: the file that paths are relative to; empty: the level has none.
std::string clash_problem(std::span<const ExportPreset> presets, std::size_t index,
                          const std::string& level_file);

// Where a preset writes to, unless the user says otherwise: "export/cave.tmj", "export/love-2". It is the
// first such path that clashes with no other preset.
std::string free_usual_path(const Exporter& exporter, const std::string& level_name,
                            std::span<const ExportPreset> others, const std::string& level_file);

// Returns the path for a preset's copy: "mine/cave-2.tmj" for "mine/cave.tmj".
std::string free_path_like(ExportPreset preset, const Exporter& exporter,
                           std::span<const ExportPreset> others, const std::string& level_file);

// The preset with another target. Its name and its path change if they were the usual ones of the old target.
// others: the level's other presets.
ExportPreset with_target(ExportPreset preset, const Exporter& target, std::span<const ExportPreset> others,
                         const std::string& level_name, const std::string& level_file);

}  // namespace talus
