// The list of formats, and reading by content. level_file.cpp has the functions for files.
#include <talus/formats/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "last_catch.h"
#include "ldtk/ldtk_format.h"
#include "native/native.h"
#include "text/utf8_text.h"
#include "tic80/tic_cart.h"
#include "tic80/tic_png.h"
#include "tic80/tic_text.h"
#include "tiled/tiled_format.h"

namespace talus {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// Returns the format with the longest extension that the name ends with: "a.talus.json" is not another
// format's ".json".
const Format* format_of_name(std::string_view lower_name, bool must_write) {
  const Format* best = nullptr;
  std::size_t length = 0;
  for (const Format& format : formats()) {
    if (must_write && !format.write) continue;
    for (const std::string_view extension : format.extensions) {
      if (extension.size() > length && lower_name.ends_with(std::string(1, '.').append(extension))) {
        best = &format;
        length = extension.size();
      }
    }
  }
  return best;
}

std::string labels_of_formats() {
  std::string labels;
  for (const Format& format : formats()) labels.append(labels.empty() ? "" : "; ").append(format.label);
  return labels;
}

}  // namespace

tl::unexpected<FormatError> error_at_line(std::string_view text, std::size_t offset, std::string message) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  const auto line = 1 + std::count(text.begin(), end, '\n');
  return tl::unexpected(FormatError{"line " + std::to_string(line), std::move(message)});
}

tl::unexpected<FormatError> was_cancelled() { return tl::unexpected(FormatError{"", "was cancelled"}); }

FormatError error_within(const std::string& place, FormatError error) {
  error.place = error.place.empty() ? place : place + ", " + error.place;
  return error;
}

std::string to_string(const FormatError& error, std::string_view file) {
  constexpr std::size_t kMaxShown = 2000;  // bytes, of the place and of the message
  return printable_line(
      std::string(file) + (error.place.empty() ? "" : ":" + shortened(error.place, kMaxShown)) +
      ": error: " + shortened(error.message, kMaxShown) + (error.remedy.empty() ? "" : ": " + error.remedy));
}

std::span<const Format> formats() {
  static constexpr std::array<std::string_view, 2> kNativeExtensions = {"talus.json", "json"};
  static constexpr std::array<std::string_view, 1> kTicExtensions = {"tic"};
  static constexpr std::array<std::string_view, 1> kPngExtensions = {"png"};
  static constexpr std::array<std::string_view, 2> kLdtkExtensions = {"ldtk", "ldtkl"};
  static constexpr std::array<std::string_view, 2> kTiledJsonExtensions = {"tmj", "tsj"};
  static constexpr std::array<std::string_view, 2> kTiledXmlExtensions = {"tmx", "tsx"};
  static constexpr std::array<std::string_view, 4> kCartMembers = {"palette", "tiles", "sprites", "map"};
  static constexpr std::array<std::string_view, 7> kTiledMembers = {
      "tiles", "tile_shapes", "map", "spawns", "curves", "objects", "background"};
  static constexpr std::array<std::string_view, 3> kLdtkChoices = {"layer", "level", "mapping"};
  static constexpr std::array<std::string_view, 2> kTiledChoices = {"layer", "used_tiles"};
  static const std::array<Format, 7> list = {{
      {"ldtk",
       "LDtk project",
       kLdtkExtensions,
       accepts_ldtk,
       read_ldtk,
       nullptr,
       {},
       false,
       true,
       kLdtkChoices},
      {"tmj", "Tiled map, JSON", kTiledJsonExtensions, accepts_tiled_json, read_tiled, write_tiled,
       kTiledMembers, true, false, kTiledChoices},
      {"tmx", "Tiled map, XML", kTiledXmlExtensions, accepts_tiled_xml, read_tiled, write_tiled,
       kTiledMembers, true, false, kTiledChoices},
      {"native", "Talus level", kNativeExtensions, accepts_native, read_native, write_native},
      {"tic", "TIC-80 cartridge", kTicExtensions, accepts_tic, read_tic, write_tic, kCartMembers},
      {"tic-png", "TIC-80 PNG cartridge", kPngExtensions, accepts_tic_png, read_tic_png, nullptr,
       kCartMembers},
      {"tic-text", "TIC-80 text project", text_extensions(), accepts_text, read_text, write_text,
       kCartMembers},
  }};
  return list;
}

const Format* find_format(std::string_view id) {
  const auto all = formats();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Format& format) { return format.id == id; });
  return found == all.end() ? nullptr : &*found;
}

const Format* format_for_file(const std::string& path) { return format_of_name(lower_case(path), true); }

FormatContext context_for_file(const std::string& path) {
  const std::size_t dot = path.find_last_of("./"), slash = path.rfind('/');
  FormatContext context;
  if (dot != std::string::npos && path[dot] != '/') context.extension = lower_case(path.substr(dot + 1));
  context.folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  return context;
}

FormatResult<LoadedLevel> read_level(std::string_view bytes, const FormatContext& context) {
  const auto all = formats();
  const auto accepting = std::find_if(all.begin(), all.end(),
                                      [&](const Format& format) { return format.accepts(bytes, context); });
  const Format* format =
      accepting != all.end() ? &*accepting : format_of_name("." + context.extension, false);
  if (!format) return tl::unexpected(FormatError{"", "is in none of these formats: " + labels_of_formats()});
  LoadedLevel loaded{Level(), format};
  FormatContext noting = context;
  noting.dropped = &loaded.dropped;
  noting.linked = &loaded.linked;
  noting.refused = &loaded.refused;
  noting.missing = &loaded.missing;
  auto level = read_guarded([&] { return format->read(bytes, noting); });
  if (!level) return tl::unexpected(level.error());
  loaded.level = *std::move(level);
  return loaded;
}

}  // namespace talus
