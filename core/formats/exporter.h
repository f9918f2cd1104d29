// Exporters: folders of files that games read, and Talus does not read back. To add one, add its row in
// exporter.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "format.h"

namespace talus {

struct ExportedFile {
  std::string
      name;  // in the folder that is written, with '/' before those of its folders; of one file: empty
  std::string bytes;
};

struct Exported {
  std::vector<ExportedFile> files;   // at least one
  std::vector<std::string> dropped;  // as WrittenLevel::dropped
};

// The text of one of the files that come with the program, such as "runtime/base.lua".
using ReadAsset = std::function<FormatResult<std::string>(const std::string& name)>;

struct Exporter {
  std::string_view id;     // "love", as in `talus export --to love`
  std::string_view label;  // "game for LÖVE 11"
  FormatResult<Exported> (*write)(const Level& level, const ReadAsset& read_asset);
};

std::span<const Exporter> exporters();
const Exporter* find_exporter(std::string_view id);  // null when there is none

// The level as a cart whose code plays it: the runtime, the level's shapes, curves and bodies, and what draws
// them; the map, the sheets and the palette are the cart's own. An error where the map does not fit a cart.
// Its own code, if it was a cart, is not kept.
FormatResult<Level> playable_cart(const Level& level, const ReadAsset& read_asset);

// Writes all files into a folder, which is made where it is missing; each as write_file_atomic does.
FormatResult<void> write_exported(const Exported& exported, const std::string& folder);

}  // namespace talus
