// Lists the maps of folders, and says what is missing in an opened one.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "edit/layer_ground.h"
#include "file_handler.h"
#include "formats/files/real_path.h"

namespace talus {

// Folders may be large, and lie on slow disks.
void FileHandler::list_maps(const std::vector<std::string>& paths, bool deep,
                            const std::function<void()>& use) {
  const auto take = [this, use](MapList found) {
    maps_ = std::move(found);
    use();
  };
  const auto work = [paths, deep, take, list = maps_](const Progress& progress) {
    auto found = std::make_shared<MapList>(list);
    found->list(paths, deep, progress);
    return FileReader::Finish([found, take] { take(std::move(*found)); });
  };
  const bool has_folder = std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
  });
  if (!has_folder) return work({})();
  reading_.cancel();
  reading_.read(paths.front(), work, true);
}

void FileHandler::tell_place_in_list() {
  const auto at = maps_.current();
  if (!at || maps_.files().size() < 2) return;
  messages_.tell("Map " + std::to_string(*at + 1) + " of " + std::to_string(maps_.files().size()) + ": " +
                 last_name(maps_.files()[*at]) + ".");
}

void FileHandler::offer_ground(const std::string& told) {
  const auto ways = ways_to_ground(open_.level);
  if (!ways) return;
  const auto& message = messages_.message();
  const std::string opened = message && message->text != told ? " " + message->text : "";
  messages_.offer_ground(
      "Nothing on this map is ground yet: make the tiles of the chosen layer ground here, " + *ways + "." +
      opened);
}

}  // namespace talus
