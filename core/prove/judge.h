// Judge: says whether the geometry of the ground explains what a body did in a step.
#pragma once

#include <cmath>
#include <optional>

#include <talus/sim/solver.h>
#include "finding.h"
#include "floor_line.h"

namespace talus {

struct Verdict {
  FindingKind kind;
  double amount = 0;              // px, as Finding::amount
  std::optional<Vec2> edge = {};  // px, of a lip: the top of the edge; of a gap: where the floor ends
  int side = 0;                   // of an edge: -1 it is the right side of its ground, 1 the left one
};

// Lengths of edges, without what searches and slacks add to them.
inline double rounded_px(double px) { return std::round(px * 1024) / 1024; }

class Judge {
 public:
  // lip: px; higher edges are walls that are meant. Refers to both.
  Judge(const RawGround& ground, const Tuning& tuning, double lip);

  // Of a step of a body alone in the ground; nothing: all of it is explained. record: of the step.
  std::optional<Verdict> judge(const Body& before, const Body& after, const Input& input,
                               const StepRecord& record) const;

  // Whether it was not in the ground, and is.
  bool comes_into_ground(const Body& before, const Body& after) const;

  // The ground in which the corners of a body on its centre may be, beside its middle.
  enum class Corners {
    in_its_floor,  // the floor that its middle stands on, and what is below that
    in_any_floor   // as deep as such a floor can reach into it
  };
  // Whether a body may be there: it is not in the ground.
  bool is_free(const Rect& box, Foot foot, Corners corners) const;
  // Whether the bottom or the top of its box, or of the middle of one on its centre, touches ground or a
  // line: it may be in that, by rounding.
  bool touches(const Rect& box, Foot foot) const;
  // Whether a line that stops bodies from above is in the box of a body, or at the middle of one on its
  // centre. Such a body is behind the line, and comes out by either side: all that is said is whether it
  // comes into the ground.
  bool is_across_line(const Body& body) const;
  // Whether a floor is at its foot that is not too steep to stand on.
  bool is_on_floor(const Body& body) const;
  // The y of the body's top at which it stands at that x, at most `rise` px higher than it is or `drop` px
  // lower; nothing: there is no floor, or it is too steep.
  std::optional<double> standing_place(const Rect& box, Foot foot, double rise, double drop) const;

 private:
  enum class Way { free, blocked, lip };
  struct Edge {
    Fine height;  // from the floor on which the body stands
    Fine x, top;  // of its upper end
  };
  struct Ahead {
    Way way;
    Edge edge = {};  // of a lip
  };
  std::optional<Verdict> judge_walk(const Body& before, const Body& after, double speed,
                                    const StepRecord& record) const;
  bool is_walker(const Body& body) const {
    return tuning_.solver == SolverKind::exact && traits_of(body.kind).takes_keys;
  }
  bool has_landed_on_curve(const Body& before, const Body& after, int direction) const;
  bool rises_to_ceiling(const FineBox& box, Foot foot, int direction) const;
  bool leads_to(const Body& body, Fine x, Fine y, int direction) const;
  bool goes_under(const RawPart& part, const Body& body) const;
  bool is_stopped_before(const Body& before, const Body& after, int direction,
                         const StepRecord& record) const;
  std::optional<Verdict> judge_stop(const Body& after, int direction) const;
  std::optional<Verdict> ramp_missed(const Body& before, const Body& after, int direction) const;
  std::optional<Verdict> gap_after(const Body& before, int direction) const;
  std::optional<FloorLine> floor_under(const Body& body) const;
  bool has_floor_to(Fine x, Fine y, int direction) const;
  std::optional<Verdict> judge_contacts(const Body& before, const StepRecord& record, bool jumps) const;
  bool is_below_floor(const Body& body, const ContactRecord& contact) const;
  bool is_steep(Vec2 normal) const;
  std::optional<Verdict> judge_roll(const Body& before, const Body& after) const;
  std::optional<Verdict> lip_met(const Body& before, const ContactRecord& contact) const;
  Verdict lip_of(int direction, const Edge& edge) const;
  Ahead ahead_of(const Body& body, int direction) const;
  Ahead ahead_of(const Body& body, int direction, Fine way) const;
  bool passes(const FineBox& from, const FineBox& to, Foot foot, Fine floor) const;
  bool passes(const FineBox& from, const FineBox& to, Foot foot) const {
    return passes(from, to, foot, to.y1);
  }
  bool ends_under(const RawLine& line, const FineBox& from, const FineBox& to) const;
  bool stops_at(const FineBox& from, const FineBox& to) const;
  bool stops_middle(const FineBox& from, const FineBox& to) const;
  bool falls_through(const Body& before, const Body& after) const;
  bool has_floor_above(const FineBox& box, Foot foot, Fine way) const;
  bool has_floor_in(const FineBox& area) const;
  bool is_free(const Rect& box, Foot foot, Corners corners, Fine slack) const;
  FineBox inside_of(const Body& body) const;  // what meets lines: the box, or the middle of it
  bool floor_goes_on(const Body& before, const Body& after, int direction) const;
  bool was_on_end_behind(Fine middle, const FineBox& box, int direction) const;
  bool is_on_end(const FineBox& box, Foot foot, bool bottom, bool only_upright) const;
  enum class Under { corners, middle_of_slopes };  // what stands on slopes
  bool has_floor_at_foot(const Body& body, Under under) const;
  bool is_there(const ContactRecord& contact, const Body& body) const;
  std::optional<Fine> floor_near(const FineBox& box, Foot foot, Fine up, Fine down) const;
  std::optional<Edge> bevel_at(const FineBox& box, Foot foot, int direction) const;
  std::optional<Edge> edge_at(const FineBox& box, Foot foot, int direction, Fine way) const;
  std::optional<Fine> rise_onto(const FineBox& from, FineBox box, Foot foot) const;
  FloorLine floor_line(const FineBox& box, Fine floor, Fine weld) const {
    return {ground_, box.middle(), floor, box.x0, box.x1, tuning_.exact.steepest, weld};
  }

  const RawGround& ground_;
  const Tuning& tuning_;
  const Fine slack_;       // how far off a place may be by the solver's rounding
  const Fine weld_;        // how far apart two ends may be that count as one
  const Fine least_weld_;  // two ends that are nearer must count as one
  const Fine ahead_;       // how far ahead its way is looked at: far more than roundings
  const Fine lip_;
};

}  // namespace talus
