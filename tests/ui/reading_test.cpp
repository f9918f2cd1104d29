// Threads read large files: a dialog shows the progress, and can cancel it.
#include <fstream>

#include "harness.h"
#include "panels/files/reading_panel.h"

namespace talus::reading_test {

class UiReading : public UiTest {
 protected:
  // Writes a map of Tiled that takes a while to read: 4096x4096 cells as text, 33 MB.
  std::string save_large_map() {
    std::ofstream map(path("large.tmx"));
    map << R"(<map orientation="orthogonal" width="4096" height="4096" tilewidth="8" tileheight="8">)"
           R"(<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="16" columns="16"/>)"
           R"(<layer name="ground" width="4096" height="4096"><data encoding="csv">)";
    std::string row;
    for (int x = 0; x < 4096; ++x) row += "2,";
    for (int y = 0; y < 4095; ++y) map << row;
    row.pop_back();
    map << row << "</data></layer></map>";
    return path("large.tmx");
  }
  // Waits until the dialog is there; returns false if it does not come.
  bool wait_for_dialog() {
    while (session().reading() && find("reading/cancel") == nullptr) frames();
    frames(2);
    return find("reading/cancel") != nullptr;
  }
};

TEST_F(UiReading, ALargeFileShowsItsProgressAndCanBeCancelled) {
  start();
  const std::string before = session().path();
  const std::string file = save_large_map();
  const ImVec2 on_the_map = on_map({12, 9});
  drop(file);
  ASSERT_TRUE(wait_for_dialog()) << "it was read in an instant";
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
  EXPECT_EQ(level().map.width(), 4096);
  EXPECT_EQ(tile_at({4095, 4095}), 1);
  session().apply(action::OpenFile{file});
  ASSERT_TRUE(session().reading());
  session().apply(action::Quit{});
  EXPECT_TRUE(session().wants_quit());
  EXPECT_FALSE(session().reading());
}

// The result is measured in the first frame and visible in later ones, even if nobody moves the mouse.
TEST_F(UiReading, TheWindowIsDrawnAfterALargeFileWasRead) {
  start_by_the_machines_clock("");
  turn_for(1);  // finishes the work of the start
  const std::string broken = save_large_map();
  std::filesystem::resize_file(broken, std::filesystem::file_size(broken) - 10);
  session().apply(action::OpenFile{broken});
  ASSERT_TRUE(session().reading());
  while (session().reading()) app().turn();
  ASSERT_TRUE(session().message());
  const int before = app().drawn_frames();
  turn_for(0.3);
  EXPECT_GT(app().drawn_frames(), before + 1);
}

}  // namespace talus::reading_test
