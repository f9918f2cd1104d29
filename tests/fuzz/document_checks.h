// What the readers of documents promise for every document: a value or one clear sentence, no exception, and
// a value that was read can be written and read again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>
#include "formats/ldtk/ldtk_companion.h"
#include "formats/ldtk/ldtk_format.h"
#include "formats/native/hard_case_file.h"
#include "formats/native/input_entry.h"
#include "formats/native/native.h"
#include "formats/native/recording_file.h"
#include "formats/native/replay.h"
#include "formats/text/utf8_text.h"
#include "formats/tiled/tiled_format.h"

namespace talus {

struct Checked {
  bool is_read = false;
  std::string problem = {};  // the promise that was broken; empty: all hold
};

inline Checked checked_error(const FormatError& error) {
  constexpr std::size_t kMaxShown = 5000;
  const std::string line = to_string(error, "file");
  if (error.message.empty()) return {.problem = "there is no message"};
  if (line.size() > kMaxShown) return {.problem = "the error is too long"};
  if (line != printable_line(line)) return {.problem = "the error is not printable: " + line};
  return {};
}

inline Checked checked_level(const Level& level) {
  const auto written = write_native(level, {});
  if (!written) return {true, "cannot be written: " + to_string(written.error(), "level")};
  const auto again = read_native(written->bytes, {});
  if (!again) return {true, "cannot be read again: " + to_string(again.error(), "level")};
  if (*again != level) return {true, "is another level when it is read again"};
  if (write_native(*again, {})->bytes != written->bytes) return {true, "is written in another way again"};
  return {true};
}

inline Checked check_native(std::string_view document) {
  const auto level = read_native(document, {});
  if (!level) return checked_error(level.error());
  if (const auto hard = hard_case_of(*level); !hard) {
    if (const Checked error = checked_error(hard.error()); !error.problem.empty()) return error;
  }
  // A file written by hand may hold a cart without parts of the level. Writing adds them.
  const auto written = write_native(*level, {});
  const auto settled = written ? read_native(written->bytes, {}) : level;
  return settled ? checked_level(*settled) : Checked{true, "cannot be read again"};
}

inline Checked check_recording(std::string_view document) {
  const auto recording = read_recording(document);
  if (!recording) return checked_error(recording.error());
  const auto written = write_recording(*recording);
  if (!written) return {true, "cannot be written: " + to_string(written.error(), "recording")};
  const auto again = read_recording(*written);
  if (!again) return {true, "cannot be read again: " + to_string(again.error(), "recording")};
  if (*write_recording(*again) != *written) return {true, "is written in another way again"};
  return {true};
}

inline Checked check_scenario(std::string_view document) {
  bool has_lines = false;
  const auto replayed = replay_scenario(document, [&](std::string_view answer) {
    has_lines = has_lines || answer.find('\n') != answer.npos;
    return true;
  });
  if (has_lines) return {true, "an answer has several lines"};
  return replayed ? Checked{true} : checked_error(replayed.error());
}

inline std::string input_lines(const std::vector<RecordedInput>& inputs) {
  std::string text;
  RecordedInput before;
  for (const RecordedInput& input : inputs) {
    text += input_entry(input, before).dump() + "\n";
    before = input;
  }
  return text;
}

inline Checked check_input(std::string_view document) {
  const auto inputs = read_input_lines(document);
  if (!inputs) return checked_error(inputs.error());
  const auto again = read_input_lines(input_lines(*inputs));
  if (!again) return {true, "cannot be read again: " + to_string(again.error(), "input")};
  if (input_lines(*again) != input_lines(*inputs)) return {true, "is another input when it is read again"};
  return {true};
}

// Checks that saving a level of Tiled again changes no byte, and that a changed cell is there afterwards.
inline Checked check_saving_tiled(Level level, std::string_view document) {
  const FormatContext context{"tmj"};
  const auto same = write_tiled(level, context);
  if (!same) return checked_error(same.error());
  if (same->bytes != document) return {true, "an unchanged map of Tiled gets other bytes"};
  TileNumber& cell = level.map.cells().tiles()[level.map.cells().size() / 2];
  cell = cell == 0 ? static_cast<TileNumber>(level.tile_count() - 1) : TileNumber{0};
  const auto changed = write_tiled(level, context);
  if (!changed) return checked_error(changed.error());
  auto again = read_tiled_again(changed->bytes, context, {});
  return again ? Checked{true, ""} : checked_error(again.error());
}

// Checks a document in JSON or XML, without the files beside it.
inline Checked check_tiled(std::string_view document) {
  Checked checked;
  for (const bool used_tiles : {false, true}) {
    std::vector<std::string> dropped;
    FormatContext context{"tmj"};
    context.choices.used_tiles = used_tiles;
    context.dropped = &dropped;
    const auto level = read_tiled(document, context);
    checked = level ? checked_level(*level) : checked_error(level.error());
    if (!checked.problem.empty()) return checked;
    for (const std::string& phrase : dropped) {
      if (phrase != printable(phrase)) return {true, "a phrase is not printable: " + phrase};
    }
    if (level && !used_tiles) {
      if (const Checked saved = check_saving_tiled(*level, document); !saved.problem.empty()) return saved;
    }
  }
  return checked;
}

// Whether what is added to a level of LDtk is there again after saving it.
inline Checked check_saving_ldtk(Level level) {
  const Level held = level;
  TileNumber& cell = level.map.cells().tiles()[level.map.cells().size() / 2];
  cell = cell == 0 ? static_cast<TileNumber>(level.tile_count() - 1) : TileNumber{0};
  const auto companion = write_ldtk_companion(level, "", "small.ldtk");
  if (!companion) return checked_error(companion.error());
  const auto again = join_ldtk_companion(*companion, held, "small.ldtk");
  if (!again) return checked_error(again.error());
  return again->level == level ? Checked{true, ""} : Checked{true, "a painted cell is lost by saving"};
}

// Checks a project of LDtk, without the files beside it.
inline Checked check_ldtk(std::string_view document) {
  std::vector<std::string> dropped;
  FormatContext context{"ldtk"};
  context.choices.level_number = 1;
  context.dropped = &dropped;
  const auto level = read_ldtk(document, context);
  for (const std::string& phrase : dropped) {
    if (phrase != printable(phrase)) return {true, "a phrase is not printable: " + phrase};
  }
  if (!level) return checked_error(level.error());
  if (const Checked saved = check_saving_ldtk(*level); !saved.problem.empty()) return saved;
  return checked_level(*level);
}

// Checks what goes with a project of LDtk: its mapping, and what was added to its level.
inline Checked check_ldtk_companion(std::string_view document) {
  FormatContext context{"ldtk"};
  context.companion = document;
  const auto held = read_ldtk(
      R"({"iid":"p","defs":{"tilesets":[],"layers":[{"uid":2,"identifier":"Ground","intGridValues":[]}]},)"
      R"("levels":[{"iid":"c","identifier":"Cave","pxWid":32,"pxHei":16,"layerInstances":[{"__type":"IntGrid",)"
      R"("__identifier":"Grid","__cWid":4,"__cHei":2,"__gridSize":8,"layerDefUid":2,)"
      R"("intGridCsv":[0,3,1,0,1,1,1,4]}]}]})",
      context);
  if (!held) return {.problem = "a companion makes its project unreadable: " + held.error().message};
  const auto joined = join_ldtk_companion(document, *held, "small.ldtk");
  return joined ? checked_level(joined->level) : checked_error(joined.error());
}

}  // namespace talus
