// How a mover continues after a contact: the four responses, filters, and responses of the user.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/collision/world.h>

namespace talus::world_response_test {

using testing::ElementsAre;

// A filter that gives every other item the same response.
struct Always {
  Response response;
  Response operator()(ItemId, ItemId) const { return response; }
};

std::vector<ItemId> others(const std::vector<Collision>& hits) {
  std::vector<ItemId> items;
  for (const Collision& hit : hits) items.push_back(hit.other);
  return items;
}

//   o---->+--+
//         |  |    with each response: where a mover aimed 20 right and 4 down ends
//         +--+
class Responses : public testing::Test {
 protected:
  Vec2 move(Response response) { return world.move(ball, {20, 4}, Always{response}, hits); }

  World world;
  ItemId wall = world.add({12, -20, 8, 80});
  ItemId ball = world.add({0, 0, 8, 8});
  std::vector<Collision> hits;
};

TEST_F(Responses, TouchStopsAtTheContact) {
  EXPECT_EQ(move(Response::touch), (Vec2{4, 0.8}));
  EXPECT_THAT(others(hits), ElementsAre(wall));
  EXPECT_EQ(world.rect(ball), (Rect{4, 0.8, 8, 8}));
  EXPECT_FALSE(hits[0].aim);
}

TEST_F(Responses, CrossGoesThroughAndReports) {
  EXPECT_EQ(move(Response::cross), (Vec2{20, 4}));
  EXPECT_THAT(others(hits), ElementsAre(wall));
  EXPECT_FALSE(hits[0].aim);
}

TEST_F(Responses, SlideKeepsTheMotionAlongTheSurface) {
  EXPECT_EQ(move(Response::slide), (Vec2{4, 4}));
  EXPECT_EQ(hits.at(0).aim, (Vec2{4, 4}));
}

TEST_F(Responses, BounceMirrorsTheRestOfTheMotion) {
  EXPECT_EQ(move(Response::bounce), (Vec2{-12, 4}));
  EXPECT_EQ(hits.at(0).aim, (Vec2{-12, 4}));
}

TEST_F(Responses, IgnoreGoesThroughWithoutAReport) {
  EXPECT_EQ(move(Response::ignore), (Vec2{20, 4}));
  EXPECT_TRUE(hits.empty());
}

TEST_F(Responses, SlideIsTheDefault) { EXPECT_EQ(world.move(ball, {20, 4}, hits), (Vec2{4, 4})); }

TEST_F(Responses, CheckDoesNotMoveTheItem) {
  const Vec2 end = world.check(ball, {20, 4}, Always{Response::slide}, hits);
  EXPECT_EQ(end, (Vec2{4, 4}));
  EXPECT_EQ(world.rect(ball), (Rect{0, 0, 8, 8}));
  EXPECT_EQ(move(Response::slide), end);
}

//   o->  +--+
//    \   |  |
//   +----+--+   slides along the floor, then meets the wall
//   +-------+
TEST(WorldResponses, SlideContinuesToTheNextContact) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  const ItemId floor = world.add({-50, 12, 200, 8});
  const ItemId wall = world.add({40, -50, 8, 62});
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {60, 20}, hits), (Vec2{32, 4}));
  EXPECT_THAT(others(hits), ElementsAre(floor, wall));
  EXPECT_EQ(hits[1].move, (Vec2{48, 0}));
}

// A box that overlaps and does not move gets the way out in its contact: slide ignores it, bounce takes it.
TEST(WorldResponses, AStillBoxLeavesItsOverlapOnlyByABounce) {
  for (const Response response : {Response::slide, Response::bounce}) {
    World world;
    const ItemId ball = world.add({0, 0, 8, 8});
    world.add({6, 0, 8, 80});
    std::vector<Collision> hits;
    const Vec2 at = response == Response::bounce ? Vec2{-2, 0} : Vec2{0, 0};
    EXPECT_EQ(world.move(ball, {0, 0}, Always{response}, hits), at);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_EQ(hits[0].touch, (Vec2{-2, 0}));
    EXPECT_EQ(hits[0].aim, at);
  }
}

// An item is met once in a move, so the ball goes through the wall the second time.
TEST(WorldResponses, EachItemIsMetOnce) {
  World world;
  const ItemId left = world.add({-10, -10, 10, 30});
  const ItemId right = world.add({20, -10, 10, 30});
  const ItemId ball = world.add({3, 0, 4, 4});
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {203, 0}, Always{Response::bounce}, hits), (Vec2{171, 0}));
  EXPECT_THAT(others(hits), ElementsAre(right, left));
}

//   o
//      \  |wall       the way is o, wall, zone; but the zone's cross looks again along the straight line from
//      o,
//   block |           and there stands the block: bump's quirk, kept in faithful mode only
//      zone
TEST(WorldResponses, CrossLooksFromTheStartOfTheMove) {
  for (const World::Mode mode : {World::Mode::faithful, World::Mode::robust}) {
    World world(64, mode);
    const ItemId ball = world.add({0, 0, 8, 8});
    const ItemId wall = world.add({20, -40, 8, 120});
    const ItemId block = world.add({-4, 20, 8, 4});
    const ItemId zone = world.add({14, 30, 4, 4});
    std::vector<Collision> hits;
    const Vec2 end = world.move(
        ball, {40, 40},
        [&](ItemId, ItemId other) { return other == zone ? Response::cross : Response::slide; }, hits);
    if (mode == World::Mode::faithful) {
      EXPECT_EQ(end, (Vec2{12, 12}));
      EXPECT_THAT(others(hits), ElementsAre(wall, zone, block));
    } else {
      EXPECT_EQ(end, (Vec2{12, 40}));
      EXPECT_THAT(others(hits), ElementsAre(wall, zone));
    }
  }
}

TEST(WorldResponses, HaveNames) {
  World world;
  EXPECT_EQ(world.find_response("touch"), Response::touch);
  EXPECT_EQ(world.find_response("bounce"), Response::bounce);
  EXPECT_EQ(world.find_response("ignore"), std::nullopt);
  EXPECT_EQ(world.find_response("foo"), std::nullopt);
  EXPECT_EQ(world.response_name(Response::slide), "slide");
  EXPECT_THROW(world.response_name(Response{77}), WorldError);
}

TEST(WorldResponses, UnknownOnesThrowWhenReachedAndNothingMoves) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  world.add({12, 0, 8, 8});
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {1, 0}, Always{Response{77}}, hits), (Vec2{1, 0}));
  try {
    world.move(ball, {20, 0}, Always{Response{77}}, hits);
    FAIL();
  } catch (const WorldError& error) {
    EXPECT_STREQ(error.what(), "Unknown collision type: 77 (string)");
  }
  EXPECT_EQ(world.rect(ball), (Rect{1, 0, 8, 8}));
  EXPECT_EQ(world.move(ball, {20, 0}, hits), (Vec2{4, 0}));
}

// Stops half-way to the contact and does not search further.
Vec2 halt(const World&, Collision& hit, Rect start, Vec2, World::Filter, std::vector<Collision>&) {
  return start.position() + (hit.touch - start.position()) * 0.5;
}

TEST(UserResponses, ReturnTheNewGoal) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  world.add({12, 0, 8, 8});
  const Response response = world.add_response("halt", halt);
  EXPECT_EQ(response, Response::first_user);
  EXPECT_EQ(world.find_response("halt"), response);
  EXPECT_EQ(world.response_name(response), "halt");
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {20, 0}, Always{response}, hits), (Vec2{2, 0}));
  EXPECT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].response, response);
}

TEST(UserResponses, ReplaceThoseOfTheSameName) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  world.add({12, 0, 8, 8});
  EXPECT_EQ(world.add_response("slide", halt), Response::slide);
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {20, 0}, hits), (Vec2{2, 0}));
  EXPECT_EQ(world.add_response("ignore", halt), Response::first_user);
}

// The slide as a user would write it: it projects from the contact with the given filter.
Vec2 own_slide(const World& world, Collision& hit, Rect start, Vec2 goal, World::Filter filter,
               std::vector<Collision>& next) {
  (hit.normal.x != 0 ? goal.x : goal.y) = hit.normal.x != 0 ? hit.touch.x : hit.touch.y;
  world.project(hit.item, {hit.touch.x, hit.touch.y, start.w, start.h}, goal, filter, next);
  return goal;
}

TEST(UserResponses, CanProjectWithTheSameFilter) {
  for (const World::Mode mode : {World::Mode::faithful, World::Mode::robust}) {
    World world(64, mode);
    const ItemId ball = world.add({0, 0, 8, 8});
    const ItemId floor = world.add({-50, 12, 200, 8});
    const ItemId wall = world.add({40, -50, 8, 62});
    const Response own = world.add_response("own", own_slide);
    std::vector<Collision> hits;
    EXPECT_EQ(world.check(ball, {60, 20}, Always{own}, hits), (Vec2{32, 4}));
    EXPECT_THAT(others(hits), ElementsAre(floor, wall));
    EXPECT_EQ(world.move(ball, {60, 20}, Always{Response::slide}, hits), (Vec2{32, 4}));
  }
}

// A response may call any function of the world, even a whole check of the same mover. The outer check keeps
// the items that it has met.
TEST(UserResponses, MayCheckTheWorldToo) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  const ItemId near = world.add({12, 0, 8, 8});
  const ItemId far = world.add({30, 0, 8, 8});
  std::vector<ItemId> inner;
  const Response probe =
      world.add_response("probe", [&inner](const World& w, Collision& hit, Rect start, Vec2 goal,
                                           World::Filter filter, std::vector<Collision>& next) {
        std::vector<Collision> nested;
        w.check(hit.item, goal, Always{Response::cross}, nested);
        for (const Collision& n : nested) inner.push_back(n.other);
        w.project(hit.item, start, goal, filter, next);
        return goal;
      });
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {60, 0}, Always{probe}, hits), (Vec2{60, 0}));
  EXPECT_THAT(others(hits), ElementsAre(near, far));
  EXPECT_THAT(inner, ElementsAre(near, far, near, far));
}

TEST(UserResponses, EndlessOnesAreStopped) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  world.add({12, 0, 8, 8});
  const Response echo = world.add_response(
      "echo", [](const World&, Collision& hit, Rect, Vec2 goal, World::Filter, std::vector<Collision>& next) {
        next.push_back(hit);
        return goal;
      });
  std::vector<Collision> hits;
  EXPECT_THROW(world.move(ball, {20, 0}, Always{echo}, hits), WorldError);
  EXPECT_EQ(world.rect(ball), (Rect{0, 0, 8, 8}));
}

TEST(Groups, ChooseTheResponse) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  const ItemId zone = world.add({12, 0, 8, 8}, 3);
  const ItemId wall = world.add({30, 0, 8, 8}, 7);
  World::GroupResponses responses{};
  responses[3] = Response::cross;
  responses[7] = Response::touch;
  std::vector<Collision> hits;
  EXPECT_EQ(world.move(ball, {60, 0}, responses, hits), (Vec2{22, 0}));
  EXPECT_THAT(others(hits), ElementsAre(zone, wall));
  responses[7] = Response::ignore;
  EXPECT_EQ(world.move(ball, {60, 0}, responses, hits), (Vec2{60, 0}));
  EXPECT_TRUE(hits.empty());
}

TEST(Checks, MayStartFromAnyBox) {
  World world;
  const ItemId wall = world.add({12, 0, 8, 8}, 1);
  std::vector<Collision> hits;
  EXPECT_EQ(world.check({0, 0, 8, 8}, {20, 4}, Always{Response::slide}, hits), (Vec2{4, 4}));
  EXPECT_THAT(others(hits), ElementsAre(wall));
  EXPECT_EQ(hits[0].item, ItemId{});
  World::GroupResponses responses{};
  responses[1] = Response::touch;
  EXPECT_EQ(world.check({0, 0, 8, 8}, {20, 0}, responses, hits), (Vec2{4, 0}));
  EXPECT_THROW(world.check({0, 0, 0, 8}, {20, 0}, responses, hits), WorldError);
}

TEST(Filters, AThrowingFilterLeavesTheWorldUsable) {
  World world;
  const ItemId ball = world.add({0, 0, 8, 8});
  const ItemId near = world.add({12, 0, 8, 8});
  world.add({30, 0, 8, 8});
  std::vector<Collision> hits;
  int calls = 0;
  EXPECT_THROW(world.move(
                   ball, {60, 0},
                   [&](ItemId, ItemId) -> Response {
                     if (++calls == 3) throw WorldError("enough");
                     return Response::cross;
                   },
                   hits),
               WorldError);
  EXPECT_EQ(world.move(ball, {60, 0}, hits), (Vec2{4, 0}));
  EXPECT_THAT(others(hits), ElementsAre(near));
}

}  // namespace talus::world_response_test
