// talus sim FILE.talusrec: playing and verifying a recording.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "cli_answer.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"
#include "level_picture.h"
#include "sim/timeline.h"

namespace talus::cli_recording_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

CliAnswer sim(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "sim");
  return cli_answer(arguments);
}

// A ball that falls with the exact solver.
Recording fall() {
  Level level = level_of({"o.......", "........", "########"});
  level.tuning.solver = SolverKind::exact;
  Timeline timeline(level);
  for (int frame = 0; frame < 40; ++frame) timeline.step({});
  return timeline.recording(timeline.current(), level);
}

// A ball that is thrown, over a floor that gets a step after 30 frames.
Recording sample() {
  Level level = level_of({"o.......", "........", "........", "########"});
  Timeline timeline(level);
  for (std::int64_t frame = 1; frame <= 60; ++frame) {
    if (frame == 31) {
      level.map.set({3, 2}, 1);
      timeline.edit(level);
    }
    timeline.step({.mouse = {40, 4}, .mouse_down = frame < 10, .grab = frame < 10 ? 1 : 0});
  }
  return timeline.recording(timeline.current(), level_of({"o.......", "........", "........", "########"}));
}

class CliRecording : public FolderTest {
 protected:
  std::string saved(const std::string& name, const Recording& recording) const {
    EXPECT_TRUE(save_recording(recording, path(name)));
    return path(name);
  }
};

TEST_F(CliRecording, VerifiesARecordingWithTheSameHashes) {
  const CliAnswer answer = sim({saved("good.talusrec", sample()), "--verify"});
  EXPECT_EQ(answer.status, kExitGood) << answer.err;
  EXPECT_EQ(answer.out, "passed 60 frames\n");
}

TEST_F(CliRecording, NamesTheFirstFrameThatDiffers) {
  Recording recording = sample();
  recording.hashes[42] ^= 1;
  recording.hashes[50] ^= 1;
  const CliAnswer tampered = sim({saved("tampered.talusrec", recording), "--verify"});
  EXPECT_EQ(tampered.status, kExitBad);
  EXPECT_THAT(tampered.out, StartsWith("failed frame 42: hash "));
  EXPECT_EQ(std::count(tampered.out.begin(), tampered.out.end(), '\n'), 1);

  recording.hashes.clear();
  const CliAnswer unhashed = sim({saved("unhashed.talusrec", recording), "--verify"});
  EXPECT_EQ(unhashed.status, kExitBad);
  EXPECT_EQ(unhashed.out, "failed: the recording has no hashes to compare with\n");
  const CliAnswer other = sim({saved("good.talusrec", sample()), "--verify", "--set", "fall_speed=4"});
  EXPECT_EQ(other.status, kExitBad);
  EXPECT_THAT(other.out, StartsWith("failed frame 10: hash ")) << "the first in which the ball falls";
}

TEST_F(CliRecording, PlaysWithItsOwnInputAndEdits) {
  const std::string file = saved("good.talusrec", sample());
  Timeline timeline(sample());
  timeline.catch_up(60);
  const auto hash = [&](std::int64_t frame) {
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0')
         << state_hash(timeline.state_at(timeline.current(), frame)) << '\n';
    return text.str();
  };
  EXPECT_EQ(sim({file, "--hash"}).out, hash(60));
  EXPECT_EQ(sim({file, "--hash", "--frames", "12"}).out, hash(12));
  EXPECT_EQ(sim({file, "--hash", "--frames", "1000"}).out, hash(60)) << "no further than it goes";
  const CliAnswer traced = sim({file, "--trace", "-"});
  EXPECT_EQ(std::count(traced.out.begin(), traced.out.end(), '\n'), 60);
  EXPECT_THAT(traced.out, StartsWith("{\"frame\":1,"));
  EXPECT_THAT(traced.out, HasSubstr("\"contacts\":["));
  EXPECT_THAT(sim({file, "--trace", "-", "--no-contacts"}).out, Not(HasSubstr("contacts")));
}

TEST_F(CliRecording, HasEventsAlsoWithoutContacts) {
  const CliAnswer traced = sim({saved("fall.talusrec", fall()), "--trace", "-", "--no-contacts"});
  EXPECT_THAT(traced.out, HasSubstr(R"("events":[{"kind":"hit","body":1,)"));
  EXPECT_THAT(traced.out, Not(HasSubstr("contacts")));
}

TEST_F(CliRecording, IsRecognisedByItsContentToo) {
  EXPECT_EQ(sim({saved("good.json", sample()), "--verify"}).out, "passed 60 frames\n");
}

TEST_F(CliRecording, RefusesOtherInputAndBadFiles) {
  const std::string file = saved("good.talusrec", sample());
  const CliAnswer input = sim({file, "--input", "x.jsonl"});
  EXPECT_EQ(input.status, kExitBad);
  EXPECT_THAT(input.err, HasSubstr("has its own input"));
  const std::string bad = put("bad.talusrec", "{\"talus_recording\": 3}");
  const CliAnswer answer = sim({bad, "--verify"});
  EXPECT_EQ(answer.status, kExitBad);
  EXPECT_THAT(answer.err,
              StartsWith(bad + ":key talus_recording: error: is newer than what this Talus reads"));
  EXPECT_EQ(answer.out, "");
  EXPECT_EQ(sim({path("no_such.talusrec")}).status, kExitBad);
}

}  // namespace talus::cli_recording_test
