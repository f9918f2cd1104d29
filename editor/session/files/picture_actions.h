// Actions: import and export of pictures of the sheets and of the palette.
#pragma once

#include <string>
#include <variant>

#include "session/files/png_import.h"

namespace talus {
namespace action {

struct ExportPng {
  PngPart part = PngPart::tiles;
  std::string path;
};
struct OpenPng {  // imports it into the level: see Session::png_import()
  std::string path;
};
struct SetPngImport {
  PngImportOptions options;
};
struct ApplyPngImport {};  // does nothing while its plan is an error
struct CancelPngImport {};

}  // namespace action

// The actions that PictureHandler carries out.
using PictureAction = std::variant<action::ExportPng, action::OpenPng, action::SetPngImport,
                                   action::ApplyPngImport, action::CancelPngImport>;

}  // namespace talus
