// Recognises files by their content, as their names may say anything.
#include "output_file.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include <talus/level/limits.h>
#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/native/companion.h"
#include "formats/native/recording_file.h"
#include "formats/pictures/png_picture.h"
#include "formats/text/json_text.h"
#include "formats/tic80/tic_png.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string_view first_line(std::string_view bytes) { return bytes.substr(0, bytes.find('\n')); }

// For a cart also its companion, and for a companion its cart. A level that was imported from a project of
// LDtk may have the name of the project's companion, which it is not.
bool reads(const std::string& input, const std::string& output) {
  if (input.empty()) return false;
  const std::string beside = companion_path(input);
  const bool is_companion_there = context_for_file(input).extension != "ldtk" || level_path(beside) != beside;
  return is_same_file(output, input) || (is_companion_there && is_same_file(output, beside)) ||
         is_same_file(output, level_path(input));
}

// Inputs begin with a frame, too, but only a trace has bodies behind it.
bool is_trace(std::string_view bytes) {
  constexpr std::string_view kFrame = "{\"frame\":", kBodies = ",\"bodies\":[";
  if (!bytes.starts_with(kFrame)) return false;
  const std::size_t end = bytes.find_first_not_of("0123456789", kFrame.size());
  return end != bytes.npos && bytes.substr(end).starts_with(kBodies);
}

bool is_of_kind(std::string_view old_bytes, std::string_view new_bytes) {
  const std::string_view kind = content_kind(new_bytes);
  return content_kind(old_bytes) == kind && (!kind.empty() || first_line(old_bytes) == first_line(new_bytes));
}

}  // namespace

// Texts may have the names of these keys anywhere, so only keys of the document itself count, wherever they
// stand.
std::string_view content_kind(std::string_view bytes) {
  constexpr std::array<std::string_view, 1> kOfRecordings = {kRecordingKey}, kOfLevels = {"talus"};
  if (is_png(bytes)) return has_tic_cart(bytes) ? find_format("tic-png")->label : "PNG picture";
  if (is_trace(bytes)) return "trace of a simulation";
  if (has_key(bytes, kOfRecordings)) return "recording";
  for (const Format& format : formats()) {
    const bool is_native = format.id == "native";
    if (is_native ? has_key(bytes, kOfLevels) : format.accepts(bytes, {})) return format.label;
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
  // All that Talus reads is recognised by its first bytes; a trace may have more of them.
  const auto old = read_start_of_file(output.path, kMaxFileBytes);
  if (!old)
    return "exists, and its kind is not known, since it " + old.error().message + "; name another file";
  if (old->empty()) return "";
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
