// Recognises files by their content, as their names may say anything.
#include "output_file.h"

#include <algorithm>
#include <filesystem>

#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/native/companion.h"
#include "formats/native/recording_file.h"
#include "formats/pictures/png_picture.h"
#include "formats/tic80/tic_png.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string_view first_line(std::string_view bytes) { return bytes.substr(0, bytes.find('\n')); }

// For a cart also its companion, and for a companion its cart.
bool reads(const std::string& input, const std::string& output) {
  return !input.empty() && (is_same_file(output, input) || is_same_file(output, companion_path(input)) ||
                            is_same_file(output, level_path(input)));
}

bool is_of_kind(std::string_view old_bytes, std::string_view new_bytes) {
  const std::string_view kind = content_kind(new_bytes);
  return content_kind(old_bytes) == kind && (!kind.empty() || first_line(old_bytes) == first_line(new_bytes));
}

}  // namespace

std::string_view content_kind(std::string_view bytes) {
  constexpr std::size_t kVersionPlace = 200;  // a level names its version at its beginning
  if (is_png(bytes)) return has_tic_cart(bytes) ? find_format("tic-png")->label : "PNG picture";
  if (bytes.starts_with(kTraceBeginning)) return "trace of a simulation";
  if (is_recording(bytes, {})) return "recording";
  for (const Format& format : formats()) {
    if (format.id == "native") {
      if (bytes.substr(0, kVersionPlace).find("\"talus\"") != bytes.npos) return format.label;
    } else if (format.accepts(bytes, {})) {
      return format.label;
    }
  }
  return "";
}

bool is_one_of(const std::vector<std::string>& files, const std::string& path) {
  return std::any_of(files.begin(), files.end(), [&](const std::string& file) { return reads(file, path); });
}

std::string output_problem(const OutputFile& output) {
  if (output.path == "-") return "";
  if (is_one_of(output.inputs, output.path))
    return "is the input of this command, which it would overwrite: name another file";
  std::error_code ignored;
  if (!fs::is_regular_file(output.path, ignored)) return "";
  const auto old = read_file(output.path);
  if (!old || old->empty()) return "";
  const std::string kind(content_kind(*old));
  const bool is_same = is_of_kind(*old, output.bytes);
  if (is_same || (kind.empty() && output.may_be_unknown)) return "";
  return (kind.empty() ? "exists, and is a file of another kind" : "exists, and is a " + kind) +
         ", which would be lost: name another file, or move it away";
}

bool has_name_of_level(const std::string& path) {
  const std::string extension = context_for_file(path).extension;
  if (extension == "json") return path.ends_with(".talus.json");
  return extension == kRecordingExtension ||
         std::any_of(formats().begin(), formats().end(), [&](const Format& format) {
           return std::find(format.extensions.begin(), format.extensions.end(), extension) !=
                  format.extensions.end();
         });
}

std::string ending_problem(const std::string& path, std::string_view ending, std::string_view kind) {
  std::error_code ignored;
  if (path == "-" || context_for_file(path).extension == ending) return "";
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return "";  // a device or a pipe
  return "is not a name for a " + std::string(kind) + ": it must end with ." + std::string(ending);
}

}  // namespace talus
