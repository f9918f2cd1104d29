// PictureHandler: import and export of pictures of the sheets and of the palette.
#pragma once

#include <optional>
#include <string>

#include "file_reading.h"
#include "picture_actions.h"
#include "session/editing/level_handler.h"

namespace talus {

class PictureHandler {
 public:
  PictureHandler(const OpenLevel& open, FileReading& reading, LevelHandler& level,
                 const ChoiceHandler& choices, MessageHandler& messages)
      : open_(open), reading_(reading), level_(level), choices_(choices), messages_(messages) {}

  void apply(const PictureAction& action);
  // Waits for ApplyPngImport or CancelPngImport.
  const std::optional<PngImport>& png_import() const { return png_import_; }

  // What is called instead of an import into the open level; nothing is called for an empty function.
  struct Instead {
    FileReader::Finish cart = nullptr;   // the picture has a cart in it
    FileReader::Finish tiles = nullptr;  // it cannot be drawn on the sheet, or the sheet is in true colour
  };
  // A picture goes into the open level, and loses nothing.
  void open(const std::string& path, const Instead& instead);

 private:
  // For each action of PictureAction, in picture_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  void take(const std::string& path, FormatResult<PngPicture> picture, const Instead& instead);

  const OpenLevel& open_;
  FileReading& reading_;
  LevelHandler& level_;
  const ChoiceHandler& choices_;
  MessageHandler& messages_;
  std::optional<PngImport> png_import_;
};

}  // namespace talus
