// Asks before files outside of the map's folder are read.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "file_handler.h"
#include "formats/files/real_path.h"
#include "formats/text/utf8_text.h"

namespace talus {
namespace {

// "cave.tmx names 2 files outside of its folder:" and their names with their whole paths, each on a line.
std::string names_text(const std::string& file, const std::vector<std::string>& names) {
  constexpr std::size_t kMaxFiles = 6, kMaxShown = 200, kMaxPath = 1000;  // files; bytes of a name, a path
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::string text = last_name(file) + " names " + std::to_string(names.size()) +
                     (names.size() == 1 ? " file" : " files") + " outside of its folder:";
  for (std::size_t i = 0; i < std::min(names.size(), kMaxFiles); ++i) {
    const std::string name = std::filesystem::path(names[i]).lexically_normal().generic_string();
    const auto whole = real_path((folder / names[i]).string());
    text += "\n" + printable(shortened(name, kMaxShown));
    if (whole) text += " (" + printable(shortened(*whole, kMaxPath)) + ")";
  }
  if (names.size() > kMaxFiles) text += "\nand " + std::to_string(names.size() - kMaxFiles) + " more";
  return text;
}

// What saving writes of these files.
std::string writing_text(const std::vector<std::string>& names) {
  const bool has_tileset = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    const std::string extension = context_for_file(name).extension;
    return extension == "tsx" || extension == "tsj" || extension == "xml" || extension == "json";
  });
  return has_tileset ? "\nSaving writes a tileset among them once flags or shapes of its tiles are edited."
                     : "";
}

}  // namespace

ImportChoices FileHandler::with_permissions(const std::string& file, ImportChoices choices) const {
  choices.outside = reads_.folders_of(file);
  return choices;
}

bool FileHandler::is_unasked(const std::string& file, const std::vector<std::string>& refused) const {
  return !refused.empty() && unread_for_ != file;
}

// The folder that is allowed has the whole game in it: its tilesets name further files outside of the map's
// folder, about which one question is enough.
void FileHandler::ask_about_outside(const std::string& file, const std::vector<std::string>& refused,
                                    const std::function<void()>& read_again,
                                    const std::function<void()>& go_on) {
  const std::string folder = common_folder(file, refused);
  messages_.ask(Question{names_text(file, refused) + "\nRead " + (refused.size() == 1 ? "it" : "them") +
                             "? All maps in the folder of " + last_name(file) + " may then read files in " +
                             printable(folder) + "." + writing_text(refused),
                         Question::Kind::read_outside},
                [this, file, folder, read_again, go_on](action::Answer answer) {
                  if (answer != action::Answer::allow) {
                    unread_for_ = file;
                    return go_on();
                  }
                  const auto kept = reads_.allow(file, folder);
                  read_again();
                  if (!kept) messages_.tell_error(kept.error());
                });
}

void FileHandler::read_import_again(const std::shared_ptr<LevelImport>& import) {
  import->choices = with_permissions(import->path, import->choices);
  reading_.read(import->path, [this, import](const Progress& progress) {
    auto plan = std::make_shared<FormatResult<LoadedLevel>>(
        load_with_stamp(import->path, import->choices, progress, import->stamp));
    return FileReader::Finish([this, import, plan] {
      if (!*plan) return messages_.tell_error(to_string(plan->error(), import->path));
      import->plan = std::move(*plan);
      take_import(std::move(*import));
    });
  });
}

}  // namespace talus
