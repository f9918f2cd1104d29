// Proofs of the open level, which a thread makes while the session goes on.
#include <gtest/gtest.h>

#include <cmath>

#include <talus/level/ground.h>
#include "session/checks/prover.h"
#include "session/session.h"
#include "waiting.h"

namespace talus::prover_test {

// A floor in row 5 with a plate of half a px on it, and a player.
Level lipped_level() {
  Level level;
  level.map = TileMap(16, 8);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .heights = {0.5, 0.5}};
  for (int x = 0; x < 16; ++x) level.map.set({x, 5}, 1);
  level.map.set({8, 4}, 2);
  Spawn player;
  player.kind = BodyKind::player;
  player.position = {16, 24};
  level.spawns = {player};
  return level;
}

bool proof_ends(Session& session) {
  return comes_true([&] {
    session.advance(0);
    return !session.prover().running();
  });
}

action::EditLevel paint(Cell cell, TileNumber before, TileNumber after) {
  return {Edit{"Paint", {CellChange{cell, before, after}}}};
}

TEST(Prover, FindsALipOfTheOpenLevel) {
  Session session(lipped_level());
  EXPECT_EQ(session.prover().found(), nullptr);
  session.apply(action::Prove{});
  EXPECT_TRUE(session.prover().running());
  ASSERT_TRUE(proof_ends(session));
  ASSERT_NE(session.prover().found(), nullptr);
  const Proof& proof = *session.prover().found();
  ASSERT_FALSE(proof.findings.empty());
  EXPECT_EQ(proof.findings[0].kind, FindingKind::lip);
  EXPECT_NEAR(proof.findings[0].amount, 0.5, 0.001);
  EXPECT_FALSE(session.prover().is_stale());
  EXPECT_FALSE(session.message());
}

TEST(Prover, AnEditMakesTheProofOutOfDate) {
  Session session(lipped_level());
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  session.apply(
      action::EditLevel{Edit{"Colour", {ColorChange{3, session.level().palette[3], Rgb{1, 2, 3}}}}});
  EXPECT_FALSE(session.prover().is_stale()) << "no body meets a colour";
  session.apply(paint({8, 4}, 2, 0));
  EXPECT_TRUE(session.prover().is_stale());
  EXPECT_FALSE(session.prover().found()->findings.empty()) << "they stay until the next proof";
  session.advance(0);
  EXPECT_TRUE(session.prover().running()) << "the edit is proved";
  ASSERT_TRUE(proof_ends(session));
  EXPECT_FALSE(session.prover().is_stale());
  EXPECT_TRUE(session.prover().found()->findings.empty());
}

TEST(Prover, DoesNotFollowEditsAfterItIsStopped) {
  Session session(lipped_level());
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  session.apply({action::CancelProof{}, paint({8, 4}, 2, 0)});
  session.advance(0);
  EXPECT_FALSE(session.prover().running());
  EXPECT_TRUE(session.prover().is_stale());
  EXPECT_FALSE(session.prover().found()->findings.empty());
}

TEST(Prover, PlaysAFindingAsARecording) {
  Session session(lipped_level());
  session.apply(action::PlayFinding{0});  // there is none yet
  session.apply(action::StepFrame{});
  const int own = session.timeline().current().id;
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  EXPECT_TRUE(session.choices().overlays.has(overlay::findings));
  for (std::size_t i = 0; i < session.prover().found()->findings.size(); ++i) {
    const Finding finding = session.prover().found()->findings[i];
    session.apply(action::PlayFinding{i});
    EXPECT_EQ(session.state().frame, finding.frame);
    ASSERT_EQ(session.state().bodies.size(), 1u);
    const Body& body = session.state().bodies[0];
    EXPECT_EQ(session.choices().body, body.id);
    const bool is_left = finding.trial.direction < 0;
    EXPECT_EQ(is_left ? body.box.x : body.box.right(), finding.place.x) << "the same bits as in the proof";
    EXPECT_EQ(body.box.bottom(), finding.place.y + finding.amount);
    EXPECT_FALSE(session.stages().empty()) << "Why explains the step";
    EXPECT_EQ(session.timeline().branches().size(), 2u) << "the finding before is gone";
  }
  session.apply(action::SwitchBranch{own});
  EXPECT_EQ(session.state().frame, 1);
  EXPECT_EQ(session.state().bodies.size(), session.scene().items.size());
  session.apply(action::PlayFinding{1000});  // there is none
  EXPECT_EQ(session.timeline().current().id, own);
}

TEST(Prover, AFindingThatWasPlayedOnStays) {
  Session session(lipped_level());
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  session.apply(action::PlayFinding{0});
  session.apply(action::StepFrame{});
  session.apply(action::PlayFinding{0});
  EXPECT_EQ(session.timeline().branches().size(), 2u);
}

TEST(Prover, AnEditDuringTheProofIsProvedAfterIt) {
  Session session(lipped_level());
  session.apply({action::Prove{}, paint({8, 4}, 2, 0)});
  EXPECT_TRUE(session.prover().running());
  ASSERT_TRUE(proof_ends(session));
  ASSERT_NE(session.prover().found(), nullptr);
  EXPECT_FALSE(session.prover().is_stale());
  EXPECT_TRUE(session.prover().found()->findings.empty()) << "of the level as it is";
}

TEST(Prover, CanBeCancelledAndKeepsTheLastProof) {
  Session session(lipped_level());
  session.apply({action::Prove{}, action::CancelProof{}});
  EXPECT_FALSE(session.prover().running());
  session.advance(0);
  EXPECT_EQ(session.prover().found(), nullptr);
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  for (int i = 0; i < 3; ++i) session.apply({action::Prove{}, action::Prove{}, action::CancelProof{}});
  EXPECT_FALSE(session.prover().running());
  session.advance(0);
  ASSERT_NE(session.prover().found(), nullptr);
  EXPECT_FALSE(session.prover().found()->findings.empty());
}

TEST(Prover, BelongsToOneLevelAndEndsWithIt) {
  Session session(lipped_level());
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  session.apply(action::Prove{});
  session.apply(action::NewLevel{});
  EXPECT_FALSE(session.prover().running());
  EXPECT_EQ(session.prover().found(), nullptr);
  session.apply(action::Prove{});  // which nobody waits for
}

// A level that no solver can have the ground of.
Level overfull_level() {
  Level level = lipped_level();
  MapObject star{.form = MapObject::Form::polygon, .points = {}};
  for (int i = 0; i < 2000; ++i) star.points.push_back({64 + 20 * std::cos(i * 0.00314), 30 + i % 7 * 1.0});
  level.objects = {{.name = "walls", .is_ground = true, .objects = {star}}};
  return level;
}

TEST(Prover, AnEditThatCannotBeProvedIsSaidOnce) {
  Session session(lipped_level());
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  session.apply(action::EditLevel{
      replace_by(session.level(), std::make_shared<const Level>(overfull_level()), "Fill")});
  ASSERT_TRUE(proof_ends(session));
  ASSERT_TRUE(session.message());
  session.apply(action::DismissMessage{});
  for (int i = 0; i < 3; ++i) session.advance(0);
  EXPECT_FALSE(session.prover().running());
  EXPECT_FALSE(session.message());
}

TEST(Prover, ALevelWithTooMuchGroundSaysSo) {
  const Level level = overfull_level();
  ASSERT_TRUE(ground_problem(level));
  Session session(level);
  session.apply(action::Prove{});
  ASSERT_TRUE(proof_ends(session));
  EXPECT_EQ(session.prover().found(), nullptr);
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_EQ(session.message()->text.find("The level has "), 0u) << session.message()->text;
}

}  // namespace talus::prover_test
