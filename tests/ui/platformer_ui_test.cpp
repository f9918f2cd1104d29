// The second tour of the README: a map of Tiled with 16x16 px tiles is opened, mended, saved and played.
#include <algorithm>

#include "harness.h"
#include "level/lint/lint.h"
#include "panels/level/problem_list.h"
#include "paths.h"

namespace talus::platformer_ui_test {

class UiPlatformer : public UiTest {
 protected:
  std::string map() const { return path("platformer/meadow.tmx"); }
  void start_tour() {
    std::filesystem::copy(source_path("assets/platformer"), path("platformer"));
    start(map());
    frames(8);  // the lint and the fixes are computed a few at a time
  }
  const std::vector<Problem>& problems() { return *app().ui().problems; }
  const Body& player() {
    const auto& bodies = session().state().bodies;
    return *std::find_if(bodies.begin(), bodies.end(), [](const Body& body) { return body.box.w == 10; });
  }
};

TEST_F(UiPlatformer, TheSeamIsFoundMendedAndSaved) {
  start_tour();
  EXPECT_EQ(level().map.tile_size(), (TileSize{16, 16}));
  EXPECT_EQ(level().layers.count(), 4);
  EXPECT_EQ(level().layers.chosen, 2) << "the layer with the ground";
  ASSERT_EQ(problems().size(), 6u) << "wherever the tile with the half pixel is";
  for (const Problem& problem : problems()) {
    EXPECT_EQ(problem.rule->code, "seam");
    EXPECT_NE(problem.message.find("jumps 0.5 px"), std::string::npos) << problem.message;
  }
  const std::string before = bytes_of(map()), tiles_before = bytes_of(path("platformer/meadow.tsx"));
  click("problems/fix" + std::to_string(listed_rows(app().ui()).front()));
  frames(8);
  EXPECT_EQ(session().history().edits().back().label,
            "Lower the left end of tile 9's slope from 8.5 to 8 px, wherever the tile is");
  EXPECT_TRUE(problems().empty());
  key(ctrl('s'));
  frames(2);
  EXPECT_FALSE(session().question());
  EXPECT_EQ(bytes_of(map()), before) << "no cell was painted";
  const std::string tiles_after = bytes_of(path("platformer/meadow.tsx"));
  const auto part = [](const std::string& text, const char* from, const char* to) {
    return text.substr(text.find(from), text.find(to) - text.find(from));
  };
  constexpr auto kFirst = "<?xml", kMended = "<tile id=\"9\">", kNext = "<tile id=\"10\">",
                 kLast = "</tileset>";
  EXPECT_EQ(part(tiles_after, kFirst, kMended), part(tiles_before, kFirst, kMended));
  EXPECT_NE(part(tiles_after, kMended, kNext), part(tiles_before, kMended, kNext));
  EXPECT_EQ(part(tiles_after, kNext, kLast), part(tiles_before, kNext, kLast));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("platformer")), {}), 4)
      << "the map, its tileset and picture, and the companion with the picture of the player";
  start(map());
  frames(8);
  EXPECT_TRUE(problems().empty());
  EXPECT_FALSE(level().spawns.front().picture.empty());
}

// With the seam, its first ramp stops the player.
TEST_F(UiPlatformer, ThePlayerRunsOverTheMendedRamp) {
  start_tour();
  const auto run = [this] {
    key(ctrl('r'));
    click(on_canvas("play", {100, 100}));
    hold(kKeyRight);
    frames(120);
    let_go(kKeyRight);
    return player().box.x;
  };
  const double with_seam = run();
  click("problems/fix" + std::to_string(listed_rows(app().ui()).front()));
  frames(8);
  EXPECT_GT(run(), with_seam + 16);
}

}  // namespace talus::platformer_ui_test
