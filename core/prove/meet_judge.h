// MeetJudge: says whether the geometry of the ground explains what a body that meets others did alone in it.
#pragma once

#include <optional>

#include <talus/sim/scene.h>
#include "judge.h"
#include "raw_form.h"

namespace talus {

class MeetJudge {
 public:
  // scene: has bodies that meet. lip: px; higher edges are walls that are meant. Refers to both.
  MeetJudge(const RawGround& ground, const Scene& scene, double lip);

  // Of a step; nothing: all of it is explained. record: of the step.
  std::optional<Verdict> judge(const Body& before, const Body& after, const StepRecord& record) const;
  // Of a body that rests: `stops` if its weight pulls it to where nothing is in its way.
  std::optional<Verdict> judge_rest(const Body& body) const;

  // The box in which a body of this kind is free, at most `rise` px above this one, nearly as low as it can
  // be; nothing: there is no room.
  std::optional<Rect> standing_place(BodyKind kind, Rect box, double rise) const;
  // Whether neither ground nor a line is in what is solid of such a body.
  bool is_clear(BodyKind kind, const Rect& box) const;

 private:
  bool is_free(const RawForm& form, double slack) const;
  bool is_clear(const RawForm& form) const;
  bool is_across_line(const RawForm& form) const;
  bool is_held(const RawForm& form, double friction) const;
  bool is_stopped(const RawForm& from, const RawForm& to, double slack) const;
  bool is_stopped(const RawForm& from, const RawForm& to) const;
  bool is_there(const RawForm& touching, Vec2 normal) const;
  double depth_in_ground(const RawForm& form) const;
  double depth_below_floor(const RawForm& before, const RawForm& after) const;
  double free_way(const RawForm& touching, Vec2 normal) const;
  std::optional<Verdict> judge_contacts(const Body& before, const StepRecord& record) const;
  std::optional<Verdict> lip_met(const RawForm& touching, Vec2 normal) const;
  std::optional<double> lip_before(const RawForm& touching, Vec2 normal) const;
  double pull_on(const Body& before) const;
  double gain(const Body& before, const Body& after) const;

  const RawGround& ground_;
  const SharedTuning& tuning_;
  const double gravity_;          // px/frame^2
  const bool only_weight_moves_;  // no conveyor and no wind does
  const double lip_;              // px
};

}  // namespace talus
