// Presets of a level that would write one another's files, and paths that no other preset writes to.
#pragma once

#include <span>
#include <string>

#include "exporter.h"

namespace talus {

// One sentence without its full stop on a file that presets[index] would write and another one, too, or that
// is the level's own; empty when there is none. The same picture of the tiles may be written by several.
// level_file: that the paths are counted from; empty: it has none.
std::string clash_problem(std::span<const ExportPreset> presets, std::size_t index,
                          const std::string& level_file);

// Where a preset writes to, unless the user says otherwise: "export/cave.tmj", "export/love-2"; the first of
// them that clashes with none of the others.
std::string free_usual_path(const Exporter& exporter, const std::string& level_name,
                            std::span<const ExportPreset> others, const std::string& level_file);

// The path of a preset's copy: "mine/cave-2.tmj" for "mine/cave.tmj".
std::string free_path_like(ExportPreset preset, const Exporter& exporter,
                           std::span<const ExportPreset> others, const std::string& level_file);

// The preset with another target: its name and its path follow as far as they were its target's usual ones.
// others: the level's other presets.
ExportPreset with_target(ExportPreset preset, const Exporter& target, std::span<const ExportPreset> others,
                         const std::string& level_name, const std::string& level_file);

}  // namespace talus
