// Small systems with bounds, whose answers are known.
#include "sim/meet/bounded_system.h"

#include <gtest/gtest.h>

#include <limits>

namespace talus::bounded_system_test {

constexpr double kAny = std::numeric_limits<double>::infinity();

TEST(BoundedSystem, OneNumberGoesToItsBestOrToItsBound) {
  BoundedSystem system;
  for (const auto& [low, high, best] : {std::tuple(0.0, kAny, 3.0), {0.0, 2.0, 2.0}, {4.0, 5.0, 4.0}}) {
    system.begin(1);
    system.a(0, 0) = 2;
    system.b(0) = -6;
    system.bound(0, low, high);
    EXPECT_TRUE(system.solve());
    EXPECT_DOUBLE_EQ(system.x(0), best);
  }
}

// The contacts of a pile of three boxes with masses of 1, from the ground up: each carries what is above it.
TEST(BoundedSystem, APileCarriesItself) {
  BoundedSystem system;
  system.begin(3);
  for (std::size_t i = 0; i < 3; ++i) {
    system.a(i, i) = i == 0 ? 1 : 2;
    if (i > 0) system.a(i, i - 1) = system.a(i - 1, i) = -1;
    system.b(i) = i == 0 ? -1 : 0;
    system.bound(i, 0, kAny);
  }
  EXPECT_TRUE(system.solve());
  EXPECT_NEAR(system.x(0), 3, 1e-14);
  EXPECT_NEAR(system.x(1), 2, 1e-14);
  EXPECT_NEAR(system.x(2), 1, 1e-14);
}

TEST(BoundedSystem, WhatWouldPullIsLeftOut) {
  BoundedSystem system;
  system.begin(2);
  system.a(0, 0) = system.a(1, 1) = 1;
  system.a(0, 1) = system.a(1, 0) = 0.5;
  system.b(0) = -1;
  system.b(1) = 1;
  for (const std::size_t i : {0, 1}) system.bound(i, 0, kAny);
  EXPECT_TRUE(system.solve());
  EXPECT_EQ(system.x(0), 1);
  EXPECT_EQ(system.x(1), 0);
}

// A box on two others: only the sum of both is known.
TEST(BoundedSystem, OneOfManyAnswersIsFoundForASingularSystem) {
  BoundedSystem system;
  system.begin(2);
  for (const std::size_t i : {0, 1})
    for (const std::size_t k : {0, 1}) system.a(i, k) = 1;
  for (const std::size_t i : {0, 1}) {
    system.b(i) = -5;
    system.bound(i, 0, kAny);
  }
  EXPECT_TRUE(system.solve());
  EXPECT_NEAR(system.x(0) + system.x(1), 5, 1e-14);
}

// Masses of a million to one, the heavy one on top.
TEST(BoundedSystem, SolvesHeavyOnLightToTheEnd) {
  BoundedSystem system;
  system.begin(2);
  const double heavy = 1e-6;  // its inverse mass
  system.a(0, 0) = 1;
  system.a(1, 1) = 1 + heavy;
  system.a(0, 1) = system.a(1, 0) = -1;
  system.b(0) = -0.2;
  for (const std::size_t i : {0, 1}) system.bound(i, 0, kAny);
  EXPECT_TRUE(system.solve());
  EXPECT_NEAR(system.x(1) / 2e5, 1, 1e-9);
  EXPECT_NEAR(system.x(0) / (2e5 + 0.2), 1, 1e-9);
}

TEST(BoundedSystem, CountsItsWork) {
  BoundedSystem system;
  EXPECT_EQ(system.take_work(), 0);
  system.begin(64);
  for (std::size_t i = 0; i < 64; ++i) {
    for (std::size_t k = 0; k < 64; ++k) system.a(i, k) = i == k ? 1 : 0.001;
    system.b(i) = -1;
    system.bound(i, 0, kAny);
  }
  EXPECT_TRUE(system.solve());
  EXPECT_GT(system.take_work(), 64 * 64 / 16);
  EXPECT_EQ(system.take_work(), 0);
}

}  // namespace talus::bounded_system_test
