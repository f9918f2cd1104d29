// Recordings together with their level in one file, `.talusrec`: JSON that version control can compare row by
// row.
//
//   "talus_recording"  version of the file: 2 if it has "alone", else 1. A newer version is refused.
//   "frames"  number of steps, from 0.
//   "marks"   objects with "frame", 0..frames, and "name" (""); by frame, each frame once. Default: no
//             marks.
//   "level"   a native level (see native.h): that of frame 0.
//   "alone"   a body that plays in the level instead of its bodies: the members of a native level's body,
//             "stands", whether it stands on a floor at the start (false), and "run_speed" in px/frame, of a
//             player (that of the level's tuning). Default: the bodies of the level play.
//   "edits"   objects with "frame", 1..frames, the step after which the level was edited, and "patch", a
//             JSON patch (RFC 6902) that only has "add", "remove" and "replace" and leads from the native
//             level before to the one after; by frame. Only what the physics sees is written; what a patch
//             makes of the cart is not read. Default: no edits.
//   "input"   entries as in `talus sim --input` (see input_entry.h); by frame, each frame once, up to
//             `frames`. Each entry holds until the next one; nothing is held before the first. Default: no
//             entries.
//   "hashes"  texts of hexadecimal hashes (see sim/frame_hash.h) of 16 digits with a space between them.
//             All texts together hold the hashes of frames 0..frames; or no hashes, for a recording of up to
//             kMaxUnhashedFrames frames that was recorded but not run.
//
// Unknown keys are refused, as a recording without one of its parts would be another recording. A faulty file
// is refused as a whole; the error names the first faulty key. There are up to kMaxRecordedEdits edits, whose
// levels have up to kMaxEditedBytes (see size_of in level/limits.h) and whose versions take up to
// kMaxVersionBytes; more are neither read nor written.
#pragma once

#include <talus/formats/format.h>
#include <talus/level/limits.h>
#include "../../level/recording.h"

namespace talus {

inline constexpr int kRecordingVersion = 2;
inline constexpr std::string_view kRecordingExtension = "talusrec";
inline constexpr std::string_view kRecordingKey = "talus_recording";  // of the version

inline constexpr std::int64_t kMaxUnhashedFrames = 1 << 21;  // nearly ten hours

// Whether the file could be a recording: by its first bytes or, if these do not tell, by its extension.
bool is_recording(std::string_view bytes, const FormatContext& context);
FormatResult<Recording> read_recording(std::string_view bytes, const Progress& progress = {});
FormatResult<std::string> write_recording(const Recording& recording);

FormatResult<Recording> load_recording(const std::string& path, const Progress& progress = {});
FormatResult<void> save_recording(const Recording& recording, const std::string& path);  // atomically

}  // namespace talus
