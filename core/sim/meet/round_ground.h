// The ground as circles meet it: what one touches, when its path leads to some, and the way out of it.
#pragma once

#include <optional>
#include <vector>

#include "ground_probe.h"
#include "ground_side.h"
#include "round_time.h"

namespace talus {

// A side that a circle touches.
struct SideTouch {
  GroundSide side;
  Nearness near;
  bool is_in_gap = false;  // its end, in a gap as wide as the circle: its normal leads across the gap
};

class RoundGround {
 public:
  explicit RoundGround(const Terrain& ground) : ground_(ground) {}

  // Finds what a circle touches. Valid until the next call.
  const std::vector<SideTouch>& touched(const Form& form, CastBudget& budget);
  // The same. area: px, holds all that the circle may touch; tiles side by side in it are one side.
  const std::vector<SideTouch>& touched(const Form& form, const Rect& area, CastBudget& budget);

  // The first time on its path, before `to`, at which a circle meets the ground. along: sides that stop
  // nothing, as it goes along them. side: gets what it meets.
  std::optional<GroundMeeting> next_meeting(const MovingBox& box, double to,
                                            std::span<const GroundSide> along, CastBudget& budget,
                                            GroundSide& side);

  // The way out of the ground; nothing if it is not inside.
  std::optional<Vec2> way_out(const Form& form, CastBudget& budget);

  // The contact with a side for records, of a body at a place, px.
  Contact<double> contact_with(const SideTouch& touch, const Form& form) const;

 private:
  const GroundSide* hides(std::size_t index, Vec2 middle, double radius) const;
  std::optional<Vec2> across_gap(const GroundSide& side, const Form& form) const;
  std::optional<SideTouch> met_with(std::size_t index, const Nearness& near, const MovingBox& there,
                                    std::span<const GroundSide> along) const;
  std::optional<RoundTouch> time_to(const GroundSide& side, const MovingBox& box, double from,
                                    double to) const;

  const Terrain& ground_;
  std::vector<GroundSide> sides_;
  std::vector<SideTouch> touched_;
  Form asked_;  // what touched() was asked for the last time
  Rect asked_area_;
  std::int64_t asked_cost_ = 0;
};

// px: holds all that a body touches on its way between two places.
Rect area_around(const Rect& a, const Rect& b);

// Puts a circle that touches a side exactly on it.
void put_on(const GroundSide& side, MovingBox& box);

}  // namespace talus
