// A picture that was opened to be taken into the level, until the user applies or cancels it.
#pragma once

#include <string>

#include "edit/png_import.h"

namespace talus {

struct PngImport {
  std::string path;
  PngPicture picture;
  PngImportOptions options;
  tl::expected<PngImportPlan, std::string> plan;  // with these options, or why not
};

}  // namespace talus
