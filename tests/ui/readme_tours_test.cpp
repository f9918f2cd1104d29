// The tours of the README, clicked and typed as they say. tests/games/readme_test runs their commands.
#include <algorithm>

#include "debug/explain.h"
#include "harness.h"
#include "level/lint/lint.h"
#include "panels/level/problem_list.h"
#include "paths.h"

namespace talus::readme_tours_test {

// "The first five minutes", with the demo.
class UiFirstTour : public UiTest {
 protected:
  // px, how deep the ball sinks into the blue ramp of the tiles 7 and 8; not above 0: it is not in it.
  static double depth_in_ramp(const Body& body) {
    const double x = body.box.center().x - 160;
    return 0 < x && x < 16 ? body.box.bottom() - (120 - x / 2) : 0;
  }
  const Body* ball_in_the_ramp() {
    for (const Body& body : session().state().bodies)
      if (depth_in_ramp(body) > 2) return &body;
    return nullptr;
  }
};

TEST_F(UiFirstTour, GoesAsTheReadmeSays) {
  constexpr int kEscape = 27;
  constexpr KeyChord kReturn{'\r'};
  open_as_users_do();
  begin_with_the_first_layout();
  start("");
  ASSERT_NE(find("welcome/tour"), nullptr);
  ASSERT_NE(find("welcome/example0"), nullptr);
  key(kEscape);
  frames(2);
  EXPECT_EQ(find("welcome/page"), nullptr);
  ASSERT_TRUE(session().playback().running);
  key(kKeyF5);
  EXPECT_FALSE(session().playback().running);
  const std::int64_t frame = session().state().frame;
  key(kKeyF10);
  EXPECT_EQ(session().state().frame, frame + 1);
  key(ctrl('r'));
  EXPECT_LT(session().state().frame, frame);
  frames(240);  // until it lies still
  const int thrown = session().state().bodies.back().id;
  const auto place = [&] { return session().state().find(thrown)->box.center(); };
  const Vec2 at = place();
  move(on_canvas("play", at));
  press();
  frames(2);
  EXPECT_EQ(session().state().grabbed, thrown);
  move(on_canvas("play", at - Vec2{16, 8}));
  frames(10);
  release();
  frames(2);
  EXPECT_EQ(session().state().grabbed, 0);
  EXPECT_LT(place().x, at.x - 4);

  key(ctrl('r'));
  for (int i = 0; i < 1200 && ball_in_the_ramp() == nullptr; ++i) frames();
  ASSERT_NE(ball_in_the_ramp(), nullptr);
  const int sunk = ball_in_the_ramp()->id;
  const float right_of_it = on_sheet(7).x + on_sheet(1).x - on_sheet(0).x;
  EXPECT_LE(right_of_it, find("sheet/canvas")->max.x) << "it is in sight";
  click(on_sheet(7));
  click("flags/lamp2");
  frames();
  EXPECT_EQ(level().tile_flags(7), 1 << 2);
  EXPECT_TRUE(session().playback().running);
  EXPECT_LT(depth_in_ramp(*session().state().find(sunk)), 1);
  key(ctrl('z'));
  EXPECT_EQ(level().tile_flags(7), 0);

  key(kKeyF5);
  click("overlay/presets");
  click("overlays/article");
  key(kKeyF10);
  key('p');
  const Body& other = session().state().bodies.back();
  click(on_canvas("play", other.box.center()));
  EXPECT_EQ(session().choices().body, other.id);
  frames(2);

  drag(on_sheet(3), on_sheet(4));
  click(on_canvas("play", level().map.box_of({12, 9}).center()));
  EXPECT_EQ(tile_at({12, 9}), 3);
  EXPECT_EQ(tile_at({13, 9}), 4);

  key(ctrl_shift('s'));
  frames(2);
  click("files/name");
  key(ctrl('a'));
  type(path("mine.talus.json"));
  key(kReturn);
  frames(2);
  EXPECT_EQ(session().path(), path("mine.talus.json"));
  click("tabs/tuning");
  click("tuning/solver");
  frames(2);
  click("tuning/solver_exact");
  key(ctrl('s'));
  const auto saved = load_level(path("mine.talus.json"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->level.tuning.solver, SolverKind::exact);
  EXPECT_EQ(saved->level.map.tile_at({12, 9}), 3);
}

// The guide's tour: the article's wish.
TEST_F(UiFirstTour, ADraggedBallMovesTheOthers) {
  start(source_path("assets/demo.talus.json"));
  click("tabs/tuning");
  click("tuning/bodies");
  frames(2);
  click("tuning/bodies_meet");
  key(kKeyF5);
  frames(240);  // until they lie still
  const auto& bodies = session().state().bodies;
  const auto by_x = [](const Body& a, const Body& b) { return a.box.x < b.box.x; };
  const int lone = std::min_element(bodies.begin(), bodies.end(), by_x)->id;
  const int dragged = std::max_element(bodies.begin(), bodies.end(), by_x)->id;
  const auto box_of = [&](int id) { return session().state().find(id)->box; };
  const Rect before = box_of(lone);
  std::vector<ImVec2> way;  // looking a place up moves the mouse
  for (const Vec2 beside : {Vec2{75, -30}, Vec2{40, -24}, Vec2{16, 0}, Vec2{0, 0}})
    way.push_back(on_canvas("play", before.center() + beside));
  move(on_canvas("play", box_of(dragged).center()));
  press();
  for (const ImVec2 place : way) {
    move(place);
    for (int i = 0; i < 30; ++i) {
      frames();
      const Rect a = box_of(dragged), b = box_of(lone);
      EXPECT_LE(std::min(b.right() - a.x, b.bottom() - a.y), 1e-9) << "none is in the other";
    }
  }
  EXPECT_EQ(session().state().grabbed, dragged);
  EXPECT_LT(box_of(lone).x, before.x - 2);
  move(way[1]);
  release();
  frames(2);
  EXPECT_GT(session().state().find(dragged)->velocity.x, 1) << "it is thrown";
}

// "Five minutes with a map of Tiled".
class UiSecondTour : public UiTest {
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

TEST_F(UiSecondTour, TheSeamIsFoundMendedAndSaved) {
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
            "Lower the left end of tile 9's slope from 8.5 to 8 px, in every cell with that tile");
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

TEST_F(UiSecondTour, WhyTellsWhatStopsThePlayer) {
  start_tour();
  key(ctrl('r'));
  click(on_canvas("play", {100, 100}));
  hold(kKeyRight);
  frames(140);
  let_go(kKeyRight);
  frames(20);
  const std::int64_t now = session().state().frame;
  click("tabs/why");
  frames(2);
  EXPECT_EQ(session().choices().body, player().id) << "the panel is about the player";
  click("why/last_stop");
  ASSERT_TRUE(frames_until([&] { return session().debugger().stop().has_value(); }));
  EXPECT_LT(session().state().frame, now);
  EXPECT_FALSE(session().playback().running);
  const std::string why = explain_step(session().frame_view(), player().id);
  EXPECT_NE(why.find("stopped by the left side of the tile at (10, 21)"), std::string::npos) << why;
  key(ctrl_shift('d'));
  frames(2);
  EXPECT_EQ(session().choices().body, 0) << "none stays chosen";
}

// With the seam, its first ramp stops the player.
TEST_F(UiSecondTour, ThePlayerRunsOverTheMendedRamp) {
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

}  // namespace talus::readme_tours_test
