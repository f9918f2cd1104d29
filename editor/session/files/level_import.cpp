// Makes the first choices.
#include "level_import.h"

namespace talus {

LevelImport first_level_import(const std::string& path, const Progress& progress) {
  LevelImport import{path, {}, ldtk_levels_of_file(path), {}, tl::unexpected(FormatError{})};
  if (import.levels.empty()) import.layers = tiled_layers_of_file(path);
  if (!import.levels.empty()) import.choices.level_number = 1;
  import.plan = load_level(path, import.choices, progress.part(0, 0.5));
  if (!import.plan && !import.plan.error().remedy.empty()) {
    import.choices.used_tiles = true;
    import.plan = load_level(path, import.choices, progress.part(0.5, 1));
  }
  return import;
}

}  // namespace talus
