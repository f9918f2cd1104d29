// RawForm: what is solid of a body that meets others, a box or a circle, against the parts of a RawGround.
#pragma once

#include "raw_ground.h"

namespace talus {

class RawForm {
 public:
  // A box; or, with a radius over 0, px, a circle on the middle of its bottom.
  RawForm(const Rect& box, double radius) : box_(box), radius_(radius) {}

  bool is_round() const { return radius_ > 0; }
  double radius() const { return radius_; }  // px
  // px: the middle of its bottom.
  Vec2 foot() const { return {box_.x + box_.w / 2, box_.bottom()}; }
  // px: the middle of its circle.
  Vec2 middle() const { return {box_.x + box_.w / 2, box_.bottom() - radius_}; }
  RawForm moved(Vec2 way) const { return {{box_.x + way.x, box_.y + way.y, box_.w, box_.h}, radius_}; }
  // Holds all of it.
  FineBox around() const;

  // Whether a part is in it by more than `slack`, px.
  bool meets(const RawPart& part, double slack) const;
  // Whether the part stops it on its way to a place close by. It may be in a part by `slack`, px. A line that
  // it is in already does not stop it; nor does one that faces the other way.
  bool is_stopped_by(const RawPart& part, const RawForm& there, double slack) const;

 private:
  Rect box_;
  double radius_;
};

}  // namespace talus
