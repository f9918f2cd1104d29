// Threads read large files: a dialog shows the progress, and can cancel it.
#include <fstream>

#include "harness.h"
#include "held_reading.h"
#include "panels/files/reading_panel.h"

namespace talus::reading_test {

class UiReading : public UiTest {
 protected:
  static constexpr int kSide = 1000;  // cells

  // Writes a map of Tiled that is read by a thread, 2 MB.
  std::string save_large_map() {
    std::ofstream map(path("large.tmx"));
    map << R"(<map orientation="orthogonal" width="1000" height="1000" tilewidth="8" tileheight="8">)"
           R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="16" columns="16"/>)"
           R"(<layer name="ground" width="1000" height="1000"><data encoding="csv">)";
    std::string row;
    for (int x = 0; x < kSide; ++x) row += "2,";
    for (int y = 1; y < kSide; ++y) map << row;
    row.pop_back();
    map << row << "</data></layer></map>";
    return path("large.tmx");
  }
};

TEST_F(UiReading, ALargeFileShowsItsProgressAndCanBeCancelled) {
  start();
  const std::string before = session().path();
  const std::string file = save_large_map();
  const ImVec2 on_the_map = on_map({12, 9});
  const HeldReading held(file);
  drop(file);
  ASSERT_TRUE(frames_until([&] { return find("reading/cancel") != nullptr; }));
  frames(2);
  EXPECT_EQ(session().path(), before) << "the level stays until the new one is whole";
  EXPECT_NE(find("reading/progress"), nullptr);
  click(on_sheet(1));
  click(on_the_map);
  EXPECT_FALSE(session().modified()) << "nothing is edited meanwhile";
  key(SDLK_ESCAPE);
  frames(3);
  EXPECT_FALSE(session().reading());
  EXPECT_EQ(find("reading/cancel"), nullptr);
  EXPECT_EQ(session().path(), before);
  EXPECT_FALSE(session().message()) << "who cancels knows";
  click(on_sheet(1));
  click(on_the_map);
  EXPECT_TRUE(session().modified());
}

TEST_F(UiReading, QuittingMeanwhileWorks) {
  start();
  const std::string file = save_large_map();
  session().apply(action::OpenFile{file});
  ASSERT_TRUE(session().reading());
  session().finish_reading();
  frames(2);
  EXPECT_EQ(level().map.width(), kSide);
  EXPECT_EQ(tile_at({kSide - 1, kSide - 1}), 1);
  session().apply(action::OpenFile{file});
  ASSERT_TRUE(session().reading());
  session().apply(action::Quit{});
  EXPECT_TRUE(session().wants_quit());
  EXPECT_FALSE(session().reading());
}

// The result is measured in the first frame and visible in later ones, even if nobody moves the mouse.
TEST_F(UiReading, TheWindowIsDrawnAfterALargeFileWasRead) {
  start();
  turn_for(1);  // finishes the work of the start
  const std::string broken = save_large_map();
  std::filesystem::resize_file(broken, std::filesystem::file_size(broken) - 10);
  session().apply(action::OpenFile{broken});
  ASSERT_TRUE(session().reading());
  while (session().reading()) turn_for(0.01);
  ASSERT_TRUE(session().message());
  const int before = app().drawn_frames();
  turn_for(0.3);
  EXPECT_GT(app().drawn_frames(), before + 1);
}

}  // namespace talus::reading_test
