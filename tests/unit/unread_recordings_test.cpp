// Recordings in an autosave that no reader accepts: everything else is kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "folder_test.h"
#include "platform/autosave.h"
#include "platform/recovery_dialog.h"
#include "sim/timeline.h"

namespace talus::unread_recordings_test {

using testing::Contains;
using testing::HasSubstr;

Recording recording_of(const Level& level) {
  Timeline timeline(level);
  timeline.step({});
  return timeline.whole_recording(timeline.current(), level);
}

class UnreadRecordings : public FolderTest {
 protected:
  SavedWork work() const {
    Level level;
    level.map.set({1, 1}, 5);
    return {path("1-0.talus-autosave"),
            "",
            "name",
            5,
            std::make_shared<const Level>(level),
            {std::make_shared<const Recording>(recording_of(level))}};
  }
};

TEST_F(UnreadRecordings, InAnAutosaveDoNotAffectTheRest) {
  SavedWork saved = work();
  saved.recordings.push_back(saved.recordings.front());
  ASSERT_TRUE(write_saved_work(saved));
  std::string bytes = bytes_of("1-0.talus-autosave");
  const std::size_t at = bytes.find("\"frames\"");
  ASSERT_NE(at, bytes.npos);
  bytes[at + 1] = 'x';
  put("1-0.talus-autosave", bytes);
  const std::vector<SavedWork> found = Autosave::left_behind_in(folder_.string(), "", {});
  ASSERT_EQ(found.size(), 1u);
  ASSERT_NE(found[0].level, nullptr) << found[0].problem;
  EXPECT_EQ(*found[0].level, *saved.level);
  EXPECT_EQ(found[0].recordings.size(), 1u) << "the other one";
  ASSERT_EQ(found[0].unread_recordings.size(), 1u);
  EXPECT_THAT(found[0].unread_recordings[0], HasSubstr("is not a key of recordings"));
  EXPECT_THAT(about_work(found[0]),
              Contains("A recording with it cannot be read: key xrames: is not a key of recordings."));
  const auto kept = Autosave::set_aside(found[0]);
  ASSERT_TRUE(kept);
  EXPECT_EQ(read_file(*kept).value(), bytes);
  EXPECT_TRUE(Autosave::left_behind_in(folder_.string(), "", {}).empty());
}

TEST_F(UnreadRecordings, UnwritableOnesAreReportedAndTheRestIsSaved) {
  SavedWork saved = work();
  auto bad = std::make_shared<Recording>(*saved.recordings.front());
  bad->marks.push_back({0, "\xff"});
  saved.recordings.push_back(bad);
  const auto written = write_saved_work(saved);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error(), "a recording has a name that is not valid UTF-8; all else is saved");
  const auto found = read_saved_work(saved.file);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found->level, *saved.level);
  EXPECT_EQ(found->recordings.size(), 1u);
}

}  // namespace talus::unread_recordings_test
