// Two convex figures overlap if no direction separates them. For a box and a part there are five such
// directions: both axes and the normal of the part's line. Along each of them the moving box overlaps the
// part during one interval of time. The box is inside while it overlaps along all of them.
#include "exact_ground.h"

#include <algorithm>

namespace talus::reference {
namespace {

struct Range {
  Exact from, to;
};

struct Direction {
  Exact x, y;
  Exact of(const Exact& px, const Exact& py) const { return x * px + y * py; }
};

Range range_of(const Direction& n, const ExactBox& box) {
  const Exact at = n.of(box.x, box.y), w = n.x * box.w, h = n.y * box.h;
  Range r{at, at};
  (w < 0 ? r.from : r.to) += w;
  (h < 0 ? r.from : r.to) += h;
  return r;
}

Range range_of(const Direction& n, const Part& part) {
  const ExactPoint& first = part.corners.empty() ? part.a : part.corners.front();
  Range r{n.of(first.x, first.y), n.of(first.x, first.y)};
  const auto add = [&](const Exact& x, const Exact& y) {
    const Exact at = n.of(x, y);
    if (at < r.from) r.from = at;
    if (at > r.to) r.to = at;
  };
  for (const ExactPoint& corner : part.corners) add(corner.x, corner.y);
  if (!part.corners.empty()) return r;
  add(part.b.x, part.b.y);
  if (part.level) {
    add(part.a.x, *part.level);
    add(part.b.x, *part.level);
  }
  return r;
}

// A rectangle around the motion, which quickly rules out parts far away.
struct Area {
  Exact x0, y0, x1, y1;
  Area(const ExactBox& box, const Exact& dx, const Exact& dy)
      : x0(dx < 0 ? Exact(box.x + dx) : box.x),
        y0(dy < 0 ? Exact(box.y + dy) : box.y),
        x1(box.x + box.w + (dx > 0 ? dx : Exact(0))),
        y1(box.y + box.h + (dy > 0 ? dy : Exact(0))) {}
  bool may_meet(const Part& part) const {
    if (!part.corners.empty()) {
      const auto all = [&](auto is_out) {
        return std::all_of(part.corners.begin(), part.corners.end(), is_out);
      };
      return !all([&](const ExactPoint& p) { return p.x < x0; }) &&
             !all([&](const ExactPoint& p) { return p.x > x1; }) &&
             !all([&](const ExactPoint& p) { return p.y < y0; }) &&
             !all([&](const ExactPoint& p) { return p.y > y1; });
    }
    if (part.b.x < x0 || part.a.x > x1) return false;
    const Exact& level = part.level ? *part.level : part.a.y;
    return !(part.a.y < y0 && part.b.y < y0 && level < y0) && !(part.a.y > y1 && part.b.y > y1 && level > y1);
  }
};

std::vector<Direction> directions_of(const Part& part) {
  std::vector<Direction> all = {{0, 1}, {1, 0}};
  for (std::size_t i = 0; i < part.corners.size(); ++i) {
    const ExactPoint &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
    if (a.x != b.x && a.y != b.y) all.push_back({b.y - a.y, a.x - b.x});
  }
  if (!part.corners.empty()) return all;
  // The normal points up if a is left of b, so that the line's upper side is the outer one.
  if (part.a.x != part.b.x && part.a.y != part.b.y) all.push_back({part.b.y - part.a.y, part.a.x - part.b.x});
  return all;
}

// The open interval of time during which the box overlaps the part, and the directions in which the overlap
// begins.
struct Overlap {
  bool never = false;
  std::optional<Exact> from, to;       // empty: it always overlapped, or will for ever
  std::vector<std::size_t> beginning;  // indices of the directions in which the overlap begins at `from`
};

Overlap overlap_of(const ExactBox& box, const Exact& dx, const Exact& dy, const Part& part,
                   const std::vector<Direction>& directions) {
  Overlap overlap;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Range ours = range_of(directions[i], box), theirs = range_of(directions[i], part);
    const Exact speed = directions[i].of(dx, dy);
    if (speed == 0) {
      overlap.never = overlap.never || ours.to <= theirs.from || ours.from >= theirs.to;
      continue;
    }
    Exact from = (theirs.from - ours.to) / speed, to = (theirs.to - ours.from) / speed;
    if (speed < 0) std::swap(from, to);
    if (!overlap.from || from > *overlap.from) {
      overlap.from = from;
      overlap.beginning.clear();
    }
    if (from == *overlap.from) overlap.beginning.push_back(i);
    if (!overlap.to || to < *overlap.to) overlap.to = to;
  }
  overlap.never = overlap.never || (overlap.from && *overlap.from >= *overlap.to);
  return overlap;
}

// The number of directions, of those in which an overlap begins, in which the box comes from the side that
// the part stops.
std::size_t stopping_directions(const Part& part, const Overlap& overlap,
                                const std::vector<Direction>& directions, const Exact& dx, const Exact& dy) {
  const auto stops = [&](std::size_t i) {
    if (part.a.x == part.b.x) {
      return directions[i].x != 0 && (part.stops == Part::Stops::from_above ? dx > 0 : dx < 0);
    }
    if (directions[i].y == 0) return false;
    // The first direction points down, and the last one up.
    const Exact down = directions[i].y > 0 ? directions[i].of(dx, dy) : Exact(-directions[i].of(dx, dy));
    return part.stops == Part::Stops::from_above ? down > 0 : down < 0;
  };
  return static_cast<std::size_t>(std::count_if(overlap.beginning.begin(), overlap.beginning.end(), stops));
}

}  // namespace

Exact rounded_to_256th(const Exact& value) {
  const Exact scaled = abs(value) * 256 + Exact(1, 2);
  const mpz_class whole = scaled.get_num() / scaled.get_den();
  Exact rounded(whole, 256);
  rounded.canonicalize();
  return value < 0 ? Exact(-rounded) : rounded;
}

long double wide(const Exact& value) {
  const double head = value.get_d();
  return static_cast<long double>(head) + Exact(value - head).get_d();
}

Exact height_at(const Part& part, const Exact& x) {
  return part.a.y + (part.b.y - part.a.y) * (x - part.a.x) / (part.b.x - part.a.x);
}

ExactHit ExactGround::cast(const ExactBox& box, const Exact& dx, const Exact& dy, const Exact& reach) const {
  ExactHit first{2, parts.size()};
  std::optional<Exact> passed;
  const Area area(box, dx, dy);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!area.may_meet(parts[i])) continue;
    const std::vector<Direction> directions = directions_of(parts[i]);
    const bool thin = parts[i].stops != Part::Stops::everywhere;
    Overlap overlap = overlap_of(box, dx, dy, parts[i], directions);
    if (overlap.never || (overlap.to && *overlap.to <= 0)) continue;
    if (thin && reach != 0 && overlap.from && *overlap.from < 0) {
      const Overlap less = overlap_of(box.grown(-reach), dx, dy, parts[i], directions);
      if (!less.never && less.from && *less.from >= 0) overlap.from = 0, overlap.beginning = less.beginning;
    }
    const bool inside_at_once = !overlap.from || *overlap.from < 0;
    const Exact t = inside_at_once ? Exact(0) : *overlap.from;
    if (t >= 1 || t >= first.t) continue;
    const std::size_t stopping =
        !thin || inside_at_once ? 0 : stopping_directions(parts[i], overlap, directions, dx, dy);
    if (thin && stopping < overlap.beginning.size() && (!passed || t < *passed)) passed = t;
    if (!thin || stopping != 0) first = ExactHit{t, i};
  }
  first.passed_a_line = passed && *passed <= first.t;
  return first;
}

bool ExactGround::meets(const ExactBox& box) const {
  const Area area(box, 0, 0);
  return std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
    return part.stops == Part::Stops::everywhere && area.may_meet(part) &&
           !overlap_of(box, 0, 0, part, directions_of(part)).never;
  });
}

Exact ExactGround::depth(const ExactBox& box) const {
  Exact deepest = 0;
  const Area area(box, 0, 0);
  for (const Part& part : parts) {
    if ((!part.level && part.corners.empty()) || !area.may_meet(part)) continue;
    std::optional<Exact> least;
    for (const Direction& n : directions_of(part)) {
      const Range ours = range_of(n, box), theirs = range_of(n, part);
      // The exact length along the normal of a sloped line needs a root. The larger of its components is
      // within a factor of 1.5, so the result is too large rather than too small.
      const Exact length = std::max(Exact(abs(n.x)), Exact(abs(n.y)));
      const Exact out = std::min(Exact(ours.to - theirs.from), Exact(theirs.to - ours.from)) / length;
      if (!least || out < *least) least = out;
    }
    if (*least > deepest) deepest = *least;
  }
  return deepest;
}

std::optional<Exact> ExactGround::floor_below(const ExactBox& box) const {
  std::optional<Exact> floor;
  const Exact right = box.x + box.w, bottom = box.y + box.h;
  const auto add = [&](const Part& part) {
    if (part.stops == Part::Stops::from_below || part.a.x == part.b.x) return;
    if (part.b.x < box.x || part.a.x > right) return;
    if (box.w > 0 && (part.b.x == box.x || part.a.x == right)) return;  // the part is beside the box
    const Exact from = std::max(part.a.x, box.x), to = std::min(part.b.x, right);
    Exact y = std::min(height_at(part, from), height_at(part, to));
    if (part.level && *part.level < y) y = *part.level;  // the part hangs from its level
    if (y >= bottom && (!floor || y < *floor)) floor = y;
  };
  for (const Part& part : parts) {
    if (part.corners.empty()) add(part);
    for (std::size_t i = 0; i < part.corners.size(); ++i) {  // the sides of a triangle, as lines
      const ExactPoint &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
      add(a.x < b.x ? Part{a, b, {}} : Part{b, a, {}});
    }
  }
  return floor;
}

std::optional<Exact> ExactGround::floor_below(const ExactPoint& point) const {
  return floor_below(ExactBox{point.x, point.y, 0, 0});
}

}  // namespace talus::reference
