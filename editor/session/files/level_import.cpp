// Makes the first choices.
#include "level_import.h"

#include <algorithm>

#include <talus/level/limits.h>

namespace talus {

LevelImport first_level_import(const std::string& path, const Progress& progress) {
  LevelImport import{path, {}, ldtk_levels_of_file(path), {}, tl::unexpected(FormatError{})};
  if (import.levels.empty()) import.layers = tiled_layers_of_file(path);
  if (!import.levels.empty()) import.choices.level_number = 1;
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
