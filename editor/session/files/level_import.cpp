// Makes the first choices.
#include "level_import.h"

#include <algorithm>

#include <talus/level/limits.h>
#include "formats/files/atomic_file.h"
#include "formats/ldtk/ldtk_companion.h"

namespace talus {

namespace {

std::string text_beside(const std::string& path) { return read_file(companion_path(path)).value_or(""); }

// From 1.
int last_level(const std::string& path, const std::vector<LdtkLevelName>& levels) {
  const std::string last = ldtk_memory_of(text_beside(path)).last;
  const auto found = std::find_if(levels.begin(), levels.end(), [&](const LdtkLevelName& level) {
    return !last.empty() && (level.iid.empty() ? level.name : level.iid) == last;
  });
  return found == levels.end() ? 1 : static_cast<int>(found - levels.begin()) + 1;
}

}  // namespace

bool leaves_choice(const LevelImport& import) {
  if (import.levels.size() != 1 || !import.plan || !import.plan->level.ldtk) return true;
  return !import.plan->level.ldtk->things.empty() && !ldtk_memory_of(text_beside(import.path)).mapping;
}

LevelImport first_level_import(const std::string& path, const Progress& progress) {
  LevelImport import{path, {}, ldtk_levels_of_file(path), {}, tl::unexpected(FormatError{}), false};
  if (import.levels.empty()) import.layers = tiled_layers_of_file(path);
  if (!import.levels.empty()) import.choices.level_number = last_level(path, import.levels);
  if (import.layers.size() > kMaxLayers) {
    const auto fullest =
        std::max_element(import.layers.begin(), import.layers.end(),
                         [](const TiledLayerName& a, const TiledLayerName& b) { return a.cells < b.cells; });
    import.choices.layer_number = static_cast<int>(fullest - import.layers.begin()) + 1;
  }
  import.plan = load_level(path, import.choices, progress.part(0, 0.5));
  if (!import.plan && !import.plan.error().remedy.empty()) {
    import.choices.used_tiles = true;
    import.plan = load_level(path, import.choices, progress.part(0.5, 1));
  }
  return import;
}

}  // namespace talus
