// Makes the first choices.
#include "level_import.h"

#include <algorithm>

#include <talus/level/limits.h>
#include "formats/files/atomic_file.h"
#include "formats/ldtk/ldtk_companion.h"
#include "overlay/small_picture.h"
#include "session/run/work_share.h"

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

// Of as many levels as can be read in a moment.
std::vector<std::shared_ptr<const SheetPicture>> pictures_of_levels(const std::string& path,
                                                                    const ImportChoices& choices) {
  constexpr int kSide = 128;     // px
  constexpr double kMoment = 1;  // s, of processor time
  const Stopwatch watch;
  std::vector<std::shared_ptr<const SheetPicture>> pictures;
  const auto use = [&](std::size_t index, const Level& level) {
    pictures.resize(index + 1);
    pictures[index] = std::make_shared<const SheetPicture>(small_picture(level, kSide, kSide));
  };
  const Progress progress([&](double) { return watch.seconds() < kMoment; });
  read_ldtk_levels(path, choices, use, progress);
  return pictures;
}

}  // namespace

ImportChoices choices_of(const Level& level, ImportChoices first) {
  if (level.ldtk) {
    return {.layer_number = level.ldtk->layer_number,
            .level = level.ldtk->level,
            .mapping = level.ldtk->mapping,
            .ldtk_tiles = level.ldtk->tiles,
            .outside = first.outside};
  }
  if (!level.tiled) return first;
  const std::vector<int>& layers = level.tiled->layers;
  first.layer_number = layers.size() == 1 ? layers[0] + 1 : 0;
  first.frame = level.tiled->frame;
  return first;
}

bool leaves_choice(const LevelImport& import) {
  if (import.levels.size() != 1 || !import.plan || !import.plan->level.ldtk) return true;
  return !import.plan->level.ldtk->things.empty() && !import.choices.mapping &&
         !ldtk_memory_of(text_beside(import.path)).mapping;
}

FormatResult<LoadedLevel> load_with_stamp(const std::string& path, const ImportChoices& choices,
                                          const Progress& progress, std::optional<LevelStamp>& stamp) {
  stamp = stamp_of_level(path);
  const std::int64_t began = time_for_stamps();
  auto loaded = load_level(path, choices, progress);
  if (loaded && stamp) add_linked(loaded->linked, began, *stamp);
  return loaded;
}

LevelImport first_level_import(const std::string& path, const ImportChoices& first,
                               const Progress& progress) {
  LevelImport import{path, {}, ldtk_levels_of_file(path), first, tl::unexpected(FormatError{}), false};
  if (import.levels.empty()) import.layers = tiled_layers_of_file(path);
  if (!import.levels.empty()) import.choices.level_number = last_level(path, import.levels);
  if (import.layers.size() > kMaxLayers) {
    const auto fullest =
        std::max_element(import.layers.begin(), import.layers.end(),
                         [](const TiledLayerName& a, const TiledLayerName& b) { return a.cells < b.cells; });
    import.choices.layer_number = static_cast<int>(fullest - import.layers.begin()) + 1;
  }
  import.plan = load_with_stamp(path, import.choices, progress.part(0, 0.5), import.stamp);
  if (!import.plan && !import.plan.error().remedy.empty()) {
    import.choices.used_tiles = true;
    import.plan = load_with_stamp(path, import.choices, progress.part(0.5, 1), import.stamp);
  }
  if (import.levels.size() > 1) import.pictures = pictures_of_levels(path, import.choices);
  return import;
}

}  // namespace talus
