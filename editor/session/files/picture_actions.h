// Actions: pictures of the sheets and of the palette, out and in.
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
struct OpenPng {  // to be taken into the level: see Session::png_import()
  std::string path;
};
struct SetPngImport {
  PngImportOptions options;
};
struct ApplyPngImport {};  // while its plan is an error, nothing happens
struct CancelPngImport {};

}  // namespace action

// What PictureHandler carries out.
using PictureAction = std::variant<action::ExportPng, action::OpenPng, action::SetPngImport,
                                   action::ApplyPngImport, action::CancelPngImport>;

}  // namespace talus
