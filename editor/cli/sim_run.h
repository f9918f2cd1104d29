// What `talus sim` needs to run a level or a recording.
#pragma once

#include <optional>
#include <string>

#include <talus/sim/record.h>
#include <talus/sim/state.h>
#include "command.h"
#include "formats/files/atomic_file.h"

namespace talus {

struct SimOptions {
  std::string file, input, trace;
  std::string until;  // see until.h; empty: all frames are run
  std::int64_t frames = 0;
  bool hash = false;
  bool no_contacts = false;
  bool verify = false;
  PhysicsOptions physics;
};

// Where the trace goes: a file, a pipe, standard output or nowhere. A failure to write makes the command
// fail. finish() puts a file in its place, whole; without it an older file stays.
class TraceFile {
 public:
  TraceFile(CommandContext& context, const SimOptions& options);
  bool good() const { return good_; }
  bool wanted() const { return file_ || out_ != nullptr; }
  // Does nothing if no trace is wanted.
  void write(const State& state, const StepRecord* record);
  bool finish();

 private:
  CommandContext& context_;
  const SimOptions& options_;
  bool fails(const FormatResult<void>& done);

  std::optional<StagedFile> file_;
  std::string part_;             // of the file's text, to be written when it is long
  std::ostream* out_ = nullptr;  // standard output
  bool good_ = true;
};

// Says once which ground of the level its solver does not know.
void warn_of_ignored_ground(CommandContext& context, const std::string& file, const Level& level);

bool is_recording_file(const std::string& path);
// Plays a recording with its own input and edits; to verify it, until the first frame that differs from the
// recording.
void simulate_recording(CommandContext& context, const SimOptions& options);

}  // namespace talus
