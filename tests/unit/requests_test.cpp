// Requests of panels to each other: who takes them, and when they expire.
#include "panels/requests.h"

#include <gtest/gtest.h>

namespace talus::requests_test {
namespace {

TEST(Requests, AreTakenOnce) {
  Requests requests;
  EXPECT_FALSE(requests.take<request::ShowCell>());
  requests.ask(request::ShowCell{{3, 4}});
  EXPECT_FALSE(requests.take<request::FitMap>());
  const auto taken = requests.take<request::ShowCell>();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->cell, (Cell{3, 4}));
  EXPECT_FALSE(requests.has<request::ShowCell>());
}

TEST(Requests, NamedOnesWaitForTheirName) {
  Requests requests;
  requests.ask(request::ShowTab("why"));
  EXPECT_FALSE(requests.take<request::ShowTab>("plots"));
  EXPECT_TRUE(requests.has<request::ShowTab>("why"));
  EXPECT_TRUE(requests.take<request::ShowTab>("why"));
  EXPECT_FALSE(requests.take<request::ShowTab>("why"));
}

TEST(Requests, ANewerRequestReplacesAnOlderOne) {
  Requests requests;
  requests.ask(request::ShowTab("why"));
  requests.ask(request::FitMap{});
  requests.ask(request::ShowTab("plots"));
  EXPECT_FALSE(requests.has<request::ShowTab>("why"));
  EXPECT_TRUE(requests.take<request::ShowTab>("plots"));
  EXPECT_TRUE(requests.has<request::FitMap>());
}

TEST(Requests, ScrollsAndZoomsAddUp) {
  Requests requests;
  requests.ask(request::Zoom{1});
  requests.ask(request::Zoom{1});
  requests.ask(request::Scroll{{64, 0}});
  requests.ask(request::Scroll{{0, -64}});
  EXPECT_EQ(requests.take<request::Zoom>()->steps, 2);
  EXPECT_EQ(requests.take<request::Scroll>()->by, (Vec2{64, -64}));
}

TEST(Requests, RequestsForTheKeysExpire) {
  Requests requests;
  requests.ask(request::FocusField("transport/frame"));
  requests.ask(request::ShowTab("why"));
  EXPECT_EQ(requests.waiting_for_keys(), "transport/frame");
  for (int i = 0; i < Requests::kMaxFramesForKeys; ++i) requests.end_frame();
  EXPECT_TRUE(requests.has<request::FocusField>("transport/frame"));
  requests.end_frame();
  EXPECT_EQ(requests.waiting_for_keys(), "");
  EXPECT_TRUE(requests.has<request::ShowTab>("why")) << "its panel may come later";
}

}  // namespace
}  // namespace talus::requests_test
