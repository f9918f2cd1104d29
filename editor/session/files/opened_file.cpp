// Tells recordings, levels, and files that leave a choice apart.
#include "opened_file.h"

#include <utility>

#include "formats/files/atomic_file.h"

namespace talus {
namespace {

template <class Content>
void put(FormatResult<Content> read, OpenedFile& opened) {
  if (read)
    opened.content = *std::move(read);
  else
    opened.content = std::move(read.error());
}

}  // namespace

OpenedFile read_for_opening(const std::string& path, bool has_choice, const ImportChoices& first,
                            const Progress& progress) {
  OpenedFile opened{stamp_of_level(path), FormatError{}, {}};  // first: changes while it is read show later
  if (const auto bytes = read_file(path, std::nullopt, progress.part(0, 0.05));
      bytes && is_recording(*bytes, context_for_file(path))) {
    put(read_recording(*bytes, progress.part(0.05, 0.6)), opened);
    if (const auto* recording = std::get_if<Recording>(&opened.content))
      opened.scenes = compile_ends(*recording, progress.part(0.6, 1));
    return opened;
  }
  if (has_choice && context_for_file(path).extension == "ldtk") {
    LevelImport import = first_level_import(path, first, progress.part(0.05, 1));
    opened.stamp = import.stamp;
    if (!import.levels.empty() && leaves_choice(import))
      opened.content = std::move(import);
    else
      put(std::move(import.plan), opened);
    return opened;
  }
  const std::int64_t began = time_for_stamps();
  FormatResult<LoadedLevel> loaded = load_level(path, first, progress.part(0.05, 0.7));
  if (loaded && opened.stamp) add_linked(loaded->linked, began, *opened.stamp);
  if (!loaded && !loaded.error().remedy.empty() && has_choice)
    opened.content = first_level_import(path, first, progress.part(0.7, 1));
  else
    put(std::move(loaded), opened);
  return opened;
}

std::vector<std::string> refused_in(const OpenedFile& opened) {
  if (const auto* level = std::get_if<LoadedLevel>(&opened.content)) return level->refused;
  const auto* import = std::get_if<LevelImport>(&opened.content);
  return import != nullptr && import->plan ? import->plan->refused : std::vector<std::string>();
}

}  // namespace talus
