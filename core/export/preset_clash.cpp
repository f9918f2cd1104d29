// Compares paths as text, from the root, without a look at the disk.
#include "preset_clash.h"

#include <algorithm>
#include <filesystem>

#include "../formats/native/companion.h"
#include "export_plan.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

struct ClaimedFile {
  fs::path path;
  bool is_sheet = false;  // a picture of the tiles, which is the same from every exporter
  bool is_named = false;  // whether the preset's path names it
};

fs::path whole_path(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  return (error ? path : whole).lexically_normal();
}

// The files that a preset may write; nothing if they are not known.
std::vector<ClaimedFile> claimed_files(const ExportPreset& preset, const std::string& level_file) {
  const Exporter* exporter = find_exporter(preset.exporter);
  if (exporter == nullptr || preset.path.empty()) return {};
  const fs::path output = whole_path(fs::path(level_file).parent_path() / preset.path);
  const fs::path folder = exporter->is_folder() ? output : output.parent_path();
  const auto claim = [&](const fs::path& path) {
    return ClaimedFile{path.lexically_normal(), exporter->shares_sheet && path.extension() == ".png"};
  };
  std::vector<ClaimedFile> files;
  if (!exporter->is_folder()) {
    files.push_back(claim(output));
    files.back().is_named = true;
  }
  for (const std::string_view pattern : exporter->beside)
    files.push_back(claim(folder / name_beside(pattern, output.filename().string())));
  return files;
}

// Whether two paths may be those of one file. Either may stand for all with a number, see name_beside().
bool is_one_file(const fs::path& a, const fs::path& b) {
  const auto stands_for = [](const fs::path& many, const fs::path& one) {
    return many.parent_path() == one.parent_path() &&
           many.filename().string() == without_picture_number(one.filename().string());
  };
  return a == b || stands_for(a, b) || stands_for(b, a);
}

// A file that both write; empty if there is none.
fs::path common_file(const std::vector<ClaimedFile>& a, const std::vector<ClaimedFile>& b) {
  for (const ClaimedFile& file : a) {
    const auto same = [&](const ClaimedFile& other) {
      return is_one_file(other.path, file.path) && !(other.is_sheet && file.is_sheet);
    };
    if (std::any_of(b.begin(), b.end(), same)) return file.path;
  }
  return {};
}

std::string quoted_name(const ExportPreset& preset) {
  return "\"" + (preset.name.empty() ? preset.path : preset.name) + "\"";
}

bool is_free(const ExportPreset& preset, std::span<const ExportPreset> others,
             const std::string& level_file) {
  const auto files = claimed_files(preset, level_file);
  return std::all_of(others.begin(), others.end(), [&](const ExportPreset& other) {
    return common_file(files, claimed_files(other, level_file)).empty();
  });
}

// "love" and "love 2" of the target "love".
bool is_automatic_name(const std::string& name, const std::string& target) {
  if (!name.starts_with(target)) return name.empty();
  const std::string rest = name.substr(target.size());
  return rest.empty() ||
         (rest.size() > 1 && rest[0] == ' ' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
}

std::string free_name(const std::string& target, std::span<const ExportPreset> others) {
  for (int number = 1;; ++number) {
    const std::string name = number == 1 ? target : target + " " + std::to_string(number);
    if (std::none_of(others.begin(), others.end(), [&](const ExportPreset& p) { return p.name == name; }))
      return name;
  }
}

}  // namespace

std::string clash_problem(std::span<const ExportPreset> presets, std::size_t index,
                          const std::string& level_file) {
  const auto files = claimed_files(presets[index], level_file);
  const auto shown = [&](const fs::path& file) {
    return path_for(file.string(),
                    level_file.empty() ? whole_path("level").string() : whole_path(level_file).string());
  };
  const fs::path own = level_file.empty() ? fs::path() : whole_path(level_file);
  const fs::path companion = own.string() + std::string(kCompanionEnding);
  for (const ClaimedFile& file : files) {
    if (!file.is_named && file.path == own)  // output_of() checks the named file
      return shown(own) + " is the level's own file, which the preset would overwrite: give another path";
    if (file.path == companion)
      return shown(companion) +
             " belongs to the level's own file, and the preset would overwrite it: give another path";
  }
  for (std::size_t i = 0; i < presets.size(); ++i) {
    if (i == index) continue;
    const fs::path file = common_file(files, claimed_files(presets[i], level_file));
    if (file.empty()) continue;
    return "the presets " + quoted_name(presets[std::min(i, index)]) + " and " +
           quoted_name(presets[std::max(i, index)]) + " would both write " + shown(file) +
           ": give one of them another path";
  }
  return "";
}

std::string free_usual_path(const Exporter& exporter, const std::string& level_name,
                            std::span<const ExportPreset> others, const std::string& level_file) {
  ExportPreset preset{.name = "", .exporter = std::string(exporter.id), .path = "", .extra = ""};
  for (int number = 1;; ++number) {
    preset.path = usual_path(exporter, level_name, number);
    if (number > static_cast<int>(kMaxExports) || is_free(preset, others, level_file)) return preset.path;
  }
}

std::string free_path_like(ExportPreset preset, const Exporter& exporter,
                           std::span<const ExportPreset> others, const std::string& level_file) {
  std::string stem = preset.path, ending;
  for (const std::string_view extension : exporter.extensions) {
    const std::string known = "." + std::string(extension);
    if (!stem.ends_with(known)) continue;
    stem.resize(stem.size() - known.size());
    ending = known;
    break;
  }
  for (int number = 2; !is_free(preset, others, level_file) && number <= static_cast<int>(kMaxExports) + 1;
       ++number)
    preset.path = stem + "-" + std::to_string(number) + ending;
  return preset.path;
}

ExportPreset with_target(ExportPreset preset, const Exporter& target, std::span<const ExportPreset> others,
                         const std::string& level_name, const std::string& level_file) {
  if (preset.exporter == target.id) return preset;
  const Exporter* before = find_exporter(preset.exporter);
  if (is_automatic_name(preset.name, preset.exporter))
    preset.name = free_name(std::string(target.id), others);
  if (before == nullptr || is_usual_path(preset.path, *before, level_name))
    preset.path = free_usual_path(target, level_name, others, level_file);
  else
    preset.path = path_for_other(preset.path, *before, target);
  preset.exporter = target.id;
  return preset;
}

}  // namespace talus
