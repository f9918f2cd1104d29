// Recordings with their level as one file, `.talusrec`: JSON whose level diffs row by row.
//
//   "talus_recording"  version of the file, 1. A newer version is refused.
//   "frames"  steps, from 0.
//   "marks"   objects with "frame", 0..frames, and "name" (""); by frame, each once. Default: none.
//   "level"   a native level (see native.h): of frame 0.
//   "edits"   objects with "frame", 1..frames, after whose step the level was edited, and "patch": a JSON
//   patch
//             (RFC 6902), of "add", "remove" and "replace" alone, from the native level before to the one
//             after; by frame. Only what the physics sees is written. Default: none.
//   "input"   entries as of `talus sim --input` (see input_entry.h), by frame, each once, up to `frames`;
//   each
//             holds until the next, and nothing is held before the first. Default: none.
//   "hashes"  texts of hexadecimal hashes (see sim/frame_hash.h) of 16 digits with a space between them; all
//             texts together hold those of the frames 0..frames, or none, of a run of up to
//             kMostUnhashedFrames that has been recorded, but not run.
//
// Keys that this version does not know are refused, as a recording with a part left out would be another one.
// A file that is wrong is refused as a whole, with the key of the first thing that is. There are up to
// kMaxRecordedEdits edits, whose levels have up to kMaxEditedBytes (see size_of in level/limits.h) and whose
// versions take up to kMaxVersionBytes; more are neither read nor written.
#pragma once

#include <talus/formats/format.h>
#include <talus/level/limits.h>
#include "../../level/recording.h"

namespace talus {

inline constexpr int kRecordingVersion = 1;
inline constexpr std::string_view kRecordingExtension = "talusrec";

inline constexpr std::int64_t kMostUnhashedFrames = 1 << 21;  // nearly ten hours

// Could the file be a recording, by its begin or, where that tells nothing, by its extension?
bool is_recording(std::string_view bytes, const FormatContext& context);
FormatResult<Recording> read_recording(std::string_view bytes, const Progress& progress = {});
FormatResult<std::string> write_recording(const Recording& recording);

FormatResult<Recording> load_recording(const std::string& path, const Progress& progress = {});
FormatResult<void> save_recording(const Recording& recording, const std::string& path);  // atomically

}  // namespace talus
