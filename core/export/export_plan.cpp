// Making an export without writing it, and the paths of presets.
#include "export_plan.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "../formats/files/atomic_file.h"
#include "../formats/files/real_path.h"
#include "../formats/native/companion.h"
#include "../level/with_commas.h"

namespace talus {
namespace {

namespace fs = std::filesystem;
using Field = ExportProblem::Field;

tl::unexpected<ExportProblem> problem_at(Field field, std::string message, std::string place = {}) {
  return tl::unexpected(ExportProblem{field, {std::move(place), std::move(message)}});
}

// Why a file cannot be written there, as far as can be known without writing; empty if nothing is known to
// prevent it.
std::string place_problem(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return path.string() + " is a folder, but must be a file";
  const auto denied = [](const fs::path& what) {
    return what.string() + " cannot be written: " + std::generic_category().message(errno);
  };
  if (fs::exists(path, error)) return ::access(path.c_str(), W_OK) == 0 ? "" : denied(path);
  fs::path folder = path.parent_path();
  while (!folder.empty() && folder != folder.root_path() && !fs::exists(folder, error))
    folder = folder.parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, error)) return folder.string() + " is a file, but must be a folder";
  return ::access(folder.c_str(), W_OK) == 0 ? "" : denied(folder);
}

PlannedFile plan_file(const std::string& path, const ExportedFile& file) {
  PlannedFile planned{.path = path,
                      .name = file.name.empty() ? fs::path(path).filename().string() : file.name,
                      .size = file.bytes.size(),
                      .old = {}};
  std::error_code error;
  if (path.empty() || !fs::exists(path, error)) return planned;
  planned.place = PlannedFile::Place::other;
  if (!fs::is_regular_file(path, error)) return planned;  // a read would take from a pipe, or wait
  planned.old_size = fs::file_size(path, error);
  if (error) planned.old_size = 0;
  const auto bytes = read_file(path);
  if (!bytes) return planned;
  planned.old = content_hash(*bytes);
  if (*bytes == file.bytes) planned.place = PlannedFile::Place::same;
  return planned;
}

}  // namespace

tl::expected<ExportPlan, ExportProblem> plan_export(const Level& level, std::string_view id,
                                                    const std::string& output, const ReadAsset& read_asset,
                                                    std::string_view parts, const Progress& progress,
                                                    const Exported* made, const ExportBounds& bounds) {
  const Exporter* exporter = find_exporter(id);
  if (exporter == nullptr)
    return problem_at(Field::target,
                      id.empty() ? "no target is chosen"
                                 : "\"" + std::string(id) + "\" is not a target that this version knows");
  if (const std::string problem = name_problem(*exporter, output); !output.empty() && !problem.empty())
    return problem_at(Field::path, fs::path(output).filename().string() + " " + problem);
  FormatResult<Exported> exported =
      made != nullptr
          ? FormatResult<Exported>(*made)
          : exporter->make({level, fs::path(output).filename().string(), read_asset, parts, progress});
  if (!exported) return problem_at(Field::level, exported.error().message, exported.error().place);
  ExportPlan plan{exporter, output, *std::move(exported), {}, bounds};
  leave_out_unneeded(*exporter, plan.content, output);
  const auto paths = output.empty() ? std::vector<std::string>(plan.content.files.size())
                                    : paths_of(*exporter, plan.content, output);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const bool is_named = plan.content.files[i].name.empty();
    if (const std::string problem = is_named ? companion_place_problem(paths[i]) : ""; !problem.empty())
      return problem_at(Field::path, fs::path(paths[i]).filename().string() + " " + problem);
    if (const auto place = place_within(bounds, paths[i], is_named); !place && !paths[i].empty())
      return tl::unexpected(
          ExportProblem{Field::path, {"", place.error().message}, place.error().is_outside});
    if (const std::string problem = paths[i].empty() ? "" : place_problem(paths[i]); !problem.empty())
      return problem_at(Field::path, problem);
    plan.files.push_back(plan_file(paths[i], plan.content.files[i]));
  }
  return plan;
}

std::vector<std::size_t> own_starters(const ExportPlan& plan,
                                      const std::function<bool(const PlannedFile&)>& is_exported) {
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < plan.files.size(); ++i) {
    const bool is_other = plan.files[i].place == PlannedFile::Place::other;
    if (is_other && plan.content.files[i].is_starter && !is_exported(plan.files[i])) own.push_back(i);
  }
  return own;
}

void leave_out(ExportPlan& plan, const std::vector<std::size_t>& which) {
  for (auto index = which.rbegin(); index != which.rend(); ++index) {
    const auto at = static_cast<std::ptrdiff_t>(*index);
    plan.files.erase(plan.files.begin() + at);
    plan.content.files.erase(plan.content.files.begin() + at);
  }
}

const PlannedFile* own_file_in(const ExportPlan& plan, const std::string& level_file) {
  const auto own = std::find_if(plan.files.begin(), plan.files.end(), [&](const PlannedFile& file) {
    return !file.path.empty() &&
           (is_same_file(file.path, level_file) ||
            (!level_file.empty() && is_same_file(file.path, companion_path(level_file))));
  });
  return own == plan.files.end() ? nullptr : &*own;
}

tl::expected<void, ExportProblem> write_plan(const ExportPlan& plan, const WriteProgress& progress) {
  std::error_code failure;
  const auto output = place_within(plan.bounds, plan.output, !plan.exporter->is_folder());
  if (!output) return problem_at(Field::path, output.error().message);
  const fs::path folder = fs::path(*output).parent_path();
  if (!folder.empty()) fs::create_directories(folder, failure);
  if (failure) return problem_at(Field::path, folder.string() + " cannot be created: " + failure.message());
  const auto written = write_exported(*plan.exporter, plan.content, plan.output, progress, plan.bounds);
  if (!written) return tl::unexpected(ExportProblem{Field::path, written.error()});
  return {};
}

std::string summary_of(const ExportPlan& plan) {
  std::size_t bytes = 0;
  for (const PlannedFile& file : plan.files) bytes += file.size;
  const std::size_t count = plan.files.size();
  return plan.output + ": " + std::to_string(count) + (count == 1 ? " file, " : " files, ") +
         with_commas(bytes) + " bytes";
}

std::string code_problem(const Exporter& exporter, std::optional<std::size_t> code_bytes) {
  if (exporter.is_folder() || code_bytes.value_or(0) <= kMaxTicCode) return "";
  return "the code has " + with_commas(*code_bytes) + " bytes, but TIC-80's free version allows only " +
         with_commas(kMaxTicCode) + ": use fewer shapes or kinds of bodies";
}

tl::expected<std::string, ExportProblem> output_of(const ExportPreset& preset,
                                                   const std::string& level_file) {
  const fs::path path(preset.path), file(level_file);
  if (path.empty()) return problem_at(Field::path, "the path is empty: name a file or a folder");
  // The system ends a name at NUL, so it would write another file than the one shown.
  if (preset.path.find('\0') != std::string::npos)
    return problem_at(Field::path, "has a NUL character, which file names cannot have");
  if (path.is_relative() && level_file.empty()) {
    return problem_at(Field::path,
                      "the path is relative to the level's file, but the level has no file yet: save it "
                      "first, or give a whole path, from /");
  }
  const fs::path output = (file.parent_path() / path).lexically_normal();
  const Exporter* exporter = find_exporter(preset.exporter);
  if (const std::string problem = exporter != nullptr ? preset_name_problem(*exporter, output.string()) : "";
      !problem.empty())
    return problem_at(Field::path, output.filename().string() + " " + problem);
  if (output == file.lexically_normal())
    return problem_at(Field::path, "this is the level's own file: choose another one");
  return output.string();
}

std::string path_for(const std::string& output, const std::string& level_file) {
  const fs::path to = fs::path(output).lexically_normal();
  const fs::path from = fs::path(level_file).parent_path().lexically_normal();
  if (level_file.empty() || to.is_relative() != from.is_relative()) return to.generic_string();
  // Paths that share only the root stay absolute: they are not moved together.
  const auto first = [](const fs::path& path) {
    const fs::path below = path.relative_path();
    return below.empty() ? fs::path() : *below.begin();
  };
  if (to.is_absolute() && first(to) != first(from)) return to.generic_string();
  return to.lexically_relative(from).generic_string();
}

std::string usual_path(const Exporter& exporter, const std::string& level_name, int number) {
  const std::string count = number == 1 ? "" : "-" + std::to_string(number);
  if (exporter.is_folder()) return "export/" + std::string(exporter.id) + count;
  const std::string stem = level_name.substr(0, level_name.find('.'));
  return "export/" + (stem.empty() ? "level" : stem) + std::string(exporter.usual_suffix) + count + "." +
         std::string(exporter.extensions.front());
}

bool is_usual_path(const std::string& path, const Exporter& exporter, const std::string& level_name) {
  bool is_usual = path.empty();
  for (int number = 1; number <= static_cast<int>(kMaxExports) + 1 && !is_usual; ++number)
    is_usual = path == usual_path(exporter, level_name, number);
  return is_usual;
}

std::string path_for_other(const std::string& path, const Exporter& before, const Exporter& after) {
  std::string stem = path;
  for (const std::string_view extension : before.extensions) {
    const std::string ending = "." + std::string(extension);
    if (!stem.ends_with(ending)) continue;
    stem.resize(stem.size() - ending.size());
    break;
  }
  return after.is_folder() ? stem : stem + "." + std::string(after.extensions.front());
}

}  // namespace talus
