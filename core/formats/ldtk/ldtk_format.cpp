// The files of a project: the project, a level, its pictures.
#include "ldtk_format.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "../files/atomic_file.h"
#include "../import/linked_files.h"
#include "../last_catch.h"
#include "../text/utf8_text.h"
#include "ldtk_companion.h"
#include "ldtk_keys.h"
#include "ldtk_level.h"
#include "ldtk_reader.h"

namespace talus {
namespace {

constexpr double kLdtkParsed = 0.5, kLdtkRead = 0.7;    // shares of the time
constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";  // the byte order mark

std::string_view without_mark(std::string_view bytes) {
  if (bytes.starts_with(kUtf8Mark)) bytes.remove_prefix(kUtf8Mark.size());
  return bytes;
}

// The number in the text, from 1; else 0.
int ldtk_number_in(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, problem] = std::from_chars(text.data(), end, number);
  return problem == std::errc() && stopped == end && number > 0 ? number : 0;
}

// With its world, if there are several.
std::string shown_name(const LdtkLevelHead& level) {
  return quoted_name(level.world.empty() ? level.name : level.world + "/" + level.name);
}

// "Cave", or "World/Cave".
bool is_called(const LdtkLevelHead& level, const std::string& name) {
  return level.name == name || (!level.iid.empty() && level.iid == name) ||
         (!level.world.empty() && level.world + "/" + level.name == name);
}

FormatResult<const LdtkLevelHead*> chosen_level(const LdtkProject& project, const ImportChoices& choices) {
  constexpr std::size_t kMaxNamed = 50;
  const auto& levels = project.levels;
  const auto count = static_cast<int>(levels.size());
  std::string names;
  for (std::size_t i = 0; i < std::min(levels.size(), kMaxNamed); ++i)
    names += (names.empty() ? "" : ", ") + shown_name(levels[i]);
  if (levels.size() > kMaxNamed) names += " and " + std::to_string(levels.size() - kMaxNamed) + " more";
  const auto at = [&](int number) -> const LdtkLevelHead* {
    return number > 0 && number <= count ? &levels[static_cast<std::size_t>(number - 1)] : nullptr;
  };
  const LdtkLevelHead* chosen = nullptr;
  if (choices.level_number > 0) {
    chosen = at(choices.level_number);
  } else if (!choices.level.empty()) {
    const auto named = std::find_if(levels.begin(), levels.end(), [&](const LdtkLevelHead& level) {
      return is_called(level, choices.level);
    });
    chosen = named != levels.end() ? &*named : at(ldtk_number_in(choices.level));
  } else if (count > 1) {
    return tl::unexpected(FormatError{"", "has the levels " + names + ", but a level is one of them",
                                      "choose one by `--level NAME`"});
  } else {
    chosen = at(1);
  }
  if (chosen != nullptr) return chosen;
  return tl::unexpected(
      FormatError{"", "has no level with the name " + quoted_name(choices.level) + ", but " + names});
}

FormatResult<LdtkLevel> read_chosen_text(const LdtkProject& project, const LdtkLevelHead& head,
                                         const FormatContext& context, LinkedFiles& files) {
  if (head.file.empty()) return read_ldtk_level(project, head, *head.json, head.path);
  const std::string name = with_slashes(head.file);
  if (context.folder.empty())
    return error_in(name, {"", "is a level in a file beside the project, but the project has no file"});
  const auto place = files.place_of(name);
  if (!place) return tl::unexpected(place.error());
  const auto bytes = files.read(name, *place);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = parse_json(without_mark(*bytes));
  if (!json) return error_in(name, json.error());
  auto level = read_ldtk_level(project, head, *json, "");
  if (!level) return error_in(name, level.error());
  return level;
}

FormatResult<LdtkLevel> read_chosen(const LdtkProject& project, const LdtkLevelHead& head,
                                    const FormatContext& context, LinkedFiles& files, ImportDrops& drops) {
  auto level = read_chosen_text(project, head, context, files);
  if (!level || !level->background) return level;
  const std::string of = "the picture behind the level";
  if (context.folder.empty())
    drops.add(of);
  else
    level->background->picture = files.picture(level->background->path, of);
  return level;
}

// With what the companion remembers, where the user has not chosen otherwise.
ImportChoices remembered(const FormatContext& context, const LdtkLevelHead& head) {
  ImportChoices choices = context.choices;
  if (!choices.mapping) choices.mapping = ldtk_memory_of(context.companion).mapping;
  if (choices.ldtk_tiles.empty())
    choices.ldtk_tiles = ldtk_tiles_of_companion(context.companion, head.iid.empty() ? head.name : head.iid);
  return choices;
}

// Indices of the tilesets that the level shows, or that its tiles have shown before.
std::set<std::size_t> shown_tilesets(const LdtkProject& project, const LdtkLevel& level,
                                     const std::vector<std::string>& known) {
  std::set<std::size_t> shown;
  for (const LdtkLayer& layer : level.layers) {
    if (layer.tileset >= 0 && !layer.tiles.empty() && layer.is_visible)
      shown.insert(static_cast<std::size_t>(layer.tileset));
  }
  for (const std::string& text : known) {
    const auto key = read_ldtk_key(text, project, {kMaxTileSide, kMaxTileSide});
    if (!key) continue;
    for (const LdtkKey::Part& part : key->parts)
      if (part.source.tileset >= 0) shown.insert(static_cast<std::size_t>(part.source.tileset));
  }
  return shown;
}

LdtkPictures ldtk_pictures_of(const LdtkProject& project, const LdtkLevel& level,
                              const std::vector<std::string>& known, const FormatContext& context,
                              LinkedFiles& files, ImportDrops& drops) {
  LdtkPictures pictures(project.tilesets.size());
  for (const std::size_t index : shown_tilesets(project, level, known)) {
    const LdtkTileset& tileset = project.tilesets[index];
    const std::string of = "the picture of the tileset " + quoted_name(tileset.name);
    if (!tileset.path.empty() && !context.folder.empty()) {
      pictures[index] = files.picture(tileset.path, of);
      continue;
    }
    drops.add(of + (tileset.path.empty() ? ", which is not in a file" : ""));
    LinkedPicture missing;
    missing.is_missing = true;
    pictures[index] = std::make_shared<const LinkedPicture>(std::move(missing));
  }
  return pictures;
}

FormatResult<Level> read_ldtk_files(std::string_view bytes, const FormatContext& context,
                                    ImportDrops& drops) {
  const auto json = parse_json(without_mark(bytes), context.progress.part(0, kLdtkParsed));
  if (!json) return tl::unexpected(json.error());
  const auto project = read_ldtk_project(*json);
  if (!project) return tl::unexpected(project.error());
  const auto head = chosen_level(*project, context.choices);
  if (!head) return tl::unexpected(head.error());
  LinkedFiles files(context, drops);
  const auto level = read_chosen(*project, **head, context, files, drops);
  if (!level) return tl::unexpected(level.error());
  const ImportChoices choices = remembered(context, **head);
  const LdtkPictures pictures = ldtk_pictures_of(*project, *level, choices.ldtk_tiles, context, files, drops);
  return level_of_ldtk(*project, *level, pictures, choices, drops, context.progress.part(kLdtkRead, 1));
}

}  // namespace

bool accepts_ldtk(std::string_view bytes, const FormatContext& context) {
  constexpr std::size_t kHeader = 1024;  // bytes
  const std::string_view text = without_mark(bytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == text.npos || text[first] != '{') return false;
  if (context.extension == "ldtk" || context.extension == "ldtkl") return true;
  return text.substr(first, kHeader).find("\"LDtk Project JSON\"") != text.npos;
}

std::vector<LdtkLevelName> ldtk_levels_of_file(const std::string& path, const Progress& progress) {
  std::vector<LdtkLevelName> names;
  const auto bytes = read_file(path);
  if (!bytes || !accepts_ldtk(*bytes, context_for_file(path))) return names;
  const auto json = parse_json(without_mark(*bytes), progress);
  if (!json) return names;
  const auto project = read_guarded([&] { return read_ldtk_project(*json); });
  if (!project) return names;
  for (const LdtkLevelHead& level : project->levels) {
    names.push_back({level.iid, printable(level.name), printable(level.world), level.x, level.y, level.depth,
                     level.width, level.height, level.color});
  }
  return names;
}

void read_ldtk_levels(const std::string& path, const ImportChoices& choices,
                      const std::function<void(std::size_t, const Level&)>& use, const Progress& progress) {
  const auto bytes = read_file(path);
  FormatContext context = context_for_file(path);
  context.choices = choices;
  context.choices.layer_number = 0;  // may be that of another level
  if (!bytes || !accepts_ldtk(*bytes, context)) return;
  const auto json = parse_json(without_mark(*bytes), progress.part(0, kLdtkParsed));
  if (!json) return;
  const auto project = read_guarded([&] { return read_ldtk_project(*json); });
  if (!project) return;
  ImportDrops drops;
  LinkedFiles files(context, drops);
  const double share =
      (1 - kLdtkParsed) / static_cast<double>(std::max<std::size_t>(1, project->levels.size()));
  for (std::size_t i = 0; i < project->levels.size(); ++i) {
    const double from = kLdtkParsed + share * static_cast<double>(i);
    const Progress of_level = progress.part(from, from + share);
    if (!of_level.at(0)) return;
    const LdtkLevelHead& head = project->levels[i];
    const auto level = read_guarded([&]() -> FormatResult<Level> {
      const auto read = read_chosen(*project, head, context, files, drops);
      if (!read) return tl::unexpected(read.error());
      const LdtkPictures pictures = ldtk_pictures_of(*project, *read, {}, context, files, drops);
      return level_of_ldtk(*project, *read, pictures, context.choices, drops, of_level);
    });
    if (level) use(i, *level);
  }
}

FormatResult<Level> read_ldtk(std::string_view bytes, const FormatContext& context) {
  ImportDrops drops;
  auto level = read_ldtk_files(bytes, context, drops);
  if (level && context.dropped != nullptr) {
    for (std::string& phrase : drops.phrases()) context.dropped->push_back(std::move(phrase));
  }
  return level;
}

}  // namespace talus
