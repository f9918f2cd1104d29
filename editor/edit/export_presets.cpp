// Each edit replaces the whole list of presets.
#include "export_presets.h"

#include <algorithm>
#include <utility>

#include "level/single_change.h"

namespace talus {
namespace {

Edit with_exports(const Level& level, std::string label, std::vector<ExportPreset> exports) {
  return single_change(std::move(label), ExportsChange{level.exports, std::move(exports)});
}

}  // namespace

Edit add_export(const Level& level, ExportPreset preset) {
  std::vector<ExportPreset> exports = level.exports;
  if (exports.size() < kMaxExports) exports.push_back(std::move(preset));
  return with_exports(level, "Add export preset", std::move(exports));
}

Edit set_export(const Level& level, std::size_t index, ExportPreset preset, std::string label) {
  std::vector<ExportPreset> exports = level.exports;
  if (index < exports.size()) exports[index] = std::move(preset);
  return with_exports(level, std::move(label), std::move(exports));
}

Edit remove_export(const Level& level, std::size_t index) {
  std::vector<ExportPreset> exports = level.exports;
  if (index < exports.size()) exports.erase(exports.begin() + static_cast<std::ptrdiff_t>(index));
  return with_exports(level, "Remove export preset", std::move(exports));
}

std::optional<std::size_t> find_export(const Level& level, std::string_view exporter) {
  const auto found = std::find_if(level.exports.begin(), level.exports.end(),
                                  [&](const ExportPreset& preset) { return preset.exporter == exporter; });
  if (found == level.exports.end()) return std::nullopt;
  return static_cast<std::size_t>(found - level.exports.begin());
}

std::string free_export_name(const Level& level, const std::string& name) {
  for (int number = 1;; ++number) {
    std::string free = number == 1 ? name : name + " " + std::to_string(number);
    const bool taken = std::any_of(level.exports.begin(), level.exports.end(),
                                   [&](const ExportPreset& preset) { return preset.name == free; });
    if (!taken) return free;
  }
}

}  // namespace talus
