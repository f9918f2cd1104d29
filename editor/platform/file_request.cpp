// One request for each kind of dialog.
#include "file_request.h"

#include <algorithm>
#include <filesystem>

#include <talus/formats/format.h>
#include "formats/native/recording_file.h"

namespace talus {
namespace {

namespace fs = std::filesystem;
using Purpose = FileRequest::Purpose;

std::vector<std::string> endings_to_open() {
  std::vector<std::string> endings;
  for (const Format& format : formats())
    endings.insert(endings.end(), format.extensions.begin(), format.extensions.end());
  return endings;
}

// A map of Tiled can be saved as the kind of file that it was.
std::vector<std::string> endings_to_save(const Level& level) {
  std::vector<std::string> endings;
  for (const Format& format : formats()) {
    if (format.write && !format.writes_back)
      endings.insert(endings.end(), format.extensions.begin(), format.extensions.end());
  }
  if (level.tiled) endings.push_back(level.tiled->extension);
  return endings;
}

// The extension of a level's file in its format: a name without one stays in the format.
std::string ending_of(const std::string& path) {
  const Format* format = path.empty() ? nullptr : format_for_file(path);
  if (format != nullptr && format->write != nullptr) {
    for (const std::string_view ending : format->extensions)
      if (path.ends_with("." + std::string(ending))) return std::string(ending);
  }
  return "talus.json";
}

// "demo.talus.json" gives "demo" + `ending`, in the same folder.
std::string named_like(const Session& session, const std::string& ending) {
  const fs::path path(session.path().empty() ? session.file_name() : session.path());
  const std::string name = path.filename().string();
  return (path.parent_path() / (name.substr(0, name.find('.')) + ending)).string();
}

FileRequest save_picture(const Session& session, FileDialog dialog, const std::string& what) {
  return {
      dialog,  Purpose::saves, "Save the " + what + " as a picture", named_like(session, "-" + what + ".png"),
      {"png"}, ".png"};
}

// Returns nothing if there is no preset, or its target is not known.
std::optional<FileRequest> name_export(const Session& session, const View& view) {
  const auto& exports = session.level().exports;
  if (view.files.exports.preset >= exports.size()) return std::nullopt;
  const ExportPreset& preset = exports[view.files.exports.preset];
  const Exporter* exporter = find_exporter(preset.exporter);
  if (exporter == nullptr) return std::nullopt;
  FileRequest request{FileDialog::export_path,
                      exporter->is_folder() ? Purpose::names_folder : Purpose::names,
                      "Where the " + std::string(exporter->label) + " is written",
                      output_of(preset, session.path()).value_or(preset.path),
                      {exporter->extensions.begin(), exporter->extensions.end()},
                      ""};
  if (!exporter->is_folder()) request.ending = "." + request.endings.front();
  return request;
}

FileRequest open_level(const Session& session, const View& view) {
  const bool has_path = !session.path().empty();
  const std::string near = has_path                          ? session.path()
                           : view.files.recent_files.empty() ? ""
                                                             : view.files.recent_files[0];
  std::vector<std::string> endings = endings_to_open();
  endings.emplace_back(kRecordingExtension);
  return {FileDialog::open, Purpose::opens, "Open a level, cart or recording", near, endings, ""};
}

// Whether a cart alone can hold the level, as when it came from a cart in a PNG.
bool is_mere_cart(const Level& level) {
  const auto has_shape = [](const TileShape& shape) { return shape.kind != TileShape::Kind::none; };
  return level.cart != nullptr && level.tuning == Tuning() && level.spawns.empty() && level.curves.empty() &&
         level.exports.empty() && std::none_of(level.tile_shapes.begin(), level.tile_shapes.end(), has_shape);
}

// A level without a file gets a name of a format that holds all of it.
FileRequest save_level_as(const Session& session) {
  std::string near = session.path();
  if (near.empty() && session.level().cart != nullptr)
    near = named_like(session, is_mere_cart(session.level()) ? ".tic" : ".talus.json");
  return {FileDialog::save_as,  Purpose::saves, "Save the level as", near, endings_to_save(session.level()),
          "." + ending_of(near)};
}

}  // namespace

std::optional<FileRequest> wanted_file(const Session& session, const View& view,
                                       std::optional<FileDialog> asked) {
  const std::string recording = "." + std::string(kRecordingExtension);
  if (session.wants_save_as())
    asked = FileDialog::save_as;
  else if (session.wants_save_recording())
    asked = FileDialog::save_recording;
  if (!asked) return std::nullopt;
  const FileDialog dialog = *asked;
  switch (dialog) {
    case FileDialog::open:
      return open_level(session, view);
    case FileDialog::save_as:
      return save_level_as(session);
    case FileDialog::save_recording:
      return FileRequest{dialog,
                         Purpose::saves,
                         "Save the recording as",
                         named_like(session, recording),
                         {recording.substr(1)},
                         recording};
    case FileDialog::import_png:
      return FileRequest{dialog, Purpose::opens, "Import a picture, a PNG", session.path(), {"png"}, ""};
    case FileDialog::new_from_tiles:
      return FileRequest{dialog, Purpose::opens, "New level from tiles, a PNG", session.path(), {"png"}, ""};
    case FileDialog::add_tileset:
      return FileRequest{dialog, Purpose::opens, "Add a tileset, a PNG", session.path(), {"png"}, ""};
    case FileDialog::export_tiles:
      return save_picture(session, dialog, "tiles");
    case FileDialog::export_sprites:
      return save_picture(session, dialog, "sprites");
    case FileDialog::export_palette:
      return save_picture(session, dialog, "palette");
    case FileDialog::export_path:
      return name_export(session, view);
  }
  return std::nullopt;
}

Action answer_to(FileDialog dialog, const std::string& path, const Session& session, const View& view) {
  switch (dialog) {
    case FileDialog::save_as:
      return action::SaveFileAs{path};
    case FileDialog::save_recording:
      return action::SaveRecording{path};
    case FileDialog::import_png:
      return action::OpenPng{path};
    case FileDialog::new_from_tiles:
      return action::OpenTiles{path, false};
    case FileDialog::add_tileset:
      return action::OpenTiles{path, true};
    case FileDialog::export_tiles:
      return action::ExportPng{PngPart::tiles, path};
    case FileDialog::export_sprites:
      return action::ExportPng{PngPart::sprites, path};
    case FileDialog::export_palette:
      return action::ExportPng{PngPart::palette, path};
    case FileDialog::export_path:
      return action::SetExportPath{view.files.exports.preset, path_for(path, session.path())};
    default:
      return action::OpenFile{path};
  }
}

}  // namespace talus
