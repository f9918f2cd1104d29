// Times of contacts are quotients, so that numbers would grow with each impact. Places, velocities and times
// are rounded to 2^-200: that shares no rounding with the core, and errs by less than 1e-50 px. What is
// exactly at one time, or exactly still, is then so but for a little, and counts within kTouch and kStill.
#include "exact_boxes.h"

#include <algorithm>
#include <utility>

namespace talus::reference {
namespace {

Exact power_of_two(unsigned long below) {
  Exact value = 1;
  mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), below);
  return value;
}

const Exact kTouch = power_of_two(48);         // px
const Exact kStill = power_of_two(64);         // px/frame, or frames
const Exact kNear = Exact(1) / 100'000'000;    // px, that the core may take for a touch
const Exact kSlow = Exact(1) / 1'000'000'000;  // px/frame, or frames, that the core may take for none
constexpr std::size_t kMaxContacts = 8;        // that push one another at one time
constexpr std::size_t kMaxBoxes = 16;          // that touch; the core solves more of them part by part
constexpr std::size_t kMaxImpacts = 40;        // in a frame
// The core lets nothing bounce after 32 turns, and 4 for each box, nor what approaches more slowly than
// kFaint.
constexpr int kMaxTurns = 36, kMaxFaintTurns = 400;
const Exact kFaint = Exact(1) / 100'000'000'000;  // px/frame

Exact rounded(const Exact& value) {
  constexpr unsigned long kBits = 200;
  mpz_class whole = value.get_num() << kBits;
  mpz_fdiv_q(whole.get_mpz_t(), whole.get_mpz_t(), value.get_den().get_mpz_t());
  Exact result = whole;
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), kBits);
  return result;
}

// px between two boxes along an axis; less than 0: they overlap there.
Exact gap(const ExactBoxes::Box& a, const ExactBoxes::Box& b, int axis, const Exact& time) {
  const Exact at = a.place[axis] - b.place[axis] + (a.velocity[axis] - b.velocity[axis]) * time;
  return std::max<Exact>(at - b.size[axis], -a.size[axis] - at);
}

// px/frame, at which that gap closes.
Exact closing(const ExactBoxes::Box& a, const ExactBoxes::Box& b, int axis, const Exact& time) {
  const Exact speed = a.velocity[axis] - b.velocity[axis];
  const Exact at = a.place[axis] - b.place[axis] + speed * time + (a.size[axis] - b.size[axis]) / 2;
  return at < 0 ? speed : Exact(-speed);
}

bool is_about_zero(const Exact& value, const Exact& slack) { return abs(value) <= slack; }

// The numbers of the rows in `free` for which these rows of b + A x are 0; nothing if they are not
// determined.
std::optional<std::vector<Exact>> solved(const std::vector<std::vector<Exact>>& a,
                                         const std::vector<Exact>& b, const std::vector<std::size_t>& free) {
  const std::size_t count = free.size();
  std::vector<std::vector<Exact>> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t k : free) rows[i].push_back(a[free[i]][k]);
    rows[i].push_back(-b[free[i]]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(i), rows.end(),
                                    [&](const auto& row) { return row[i] != 0; });
    if (pivot == rows.end()) return std::nullopt;
    std::swap(rows[i], *pivot);
    for (std::size_t k = 0; k < count; ++k) {
      if (k == i || rows[k][i] == 0) continue;
      const Exact share = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j <= count; ++j) rows[k][j] -= share * rows[i][j];
    }
  }
  std::vector<Exact> x;
  for (std::size_t i = 0; i < count; ++i) x.push_back(rows[i][count] / rows[i][i]);
  return x;
}

// The least impulses that let nothing approach: 0 <= l, 0 <= b + A l, and one of the two is 0 in each row. A
// is symmetric and has no negative eigenvalues. Tries which rows press, all of them first. One of the answers
// has independent rows, and all of them give the boxes the same velocities.
std::optional<std::vector<Exact>> complementary(const std::vector<std::vector<Exact>>& a,
                                                const std::vector<Exact>& b) {
  const std::size_t count = b.size();
  for (std::size_t mask = std::size_t{1} << count; mask-- > 0;) {
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < count; ++i)
      if ((mask >> i & 1) != 0) free.push_back(i);
    const auto x = solved(a, b, free);
    if (!x || std::any_of(x->begin(), x->end(), [](const Exact& l) { return l < 0; })) continue;
    std::vector<Exact> all(count, 0), rest = b;
    for (std::size_t k = 0; k < free.size(); ++k) {
      all[free[k]] = (*x)[k];
      for (std::size_t i = 0; i < count; ++i) rest[i] += a[i][free[k]] * (*x)[k];
    }
    if (std::all_of(rest.begin(), rest.end(), [](const Exact& w) { return w >= 0; })) return all;
  }
  return std::nullopt;
}

}  // namespace

// ---- Flight ----

// Whether the core may take a corner that is passed exactly for one that is met. At the ground's a rounding
// decides that, and where a frame ends just then, the core bounces off it without any. And boxes that bounced
// less than fully, and then go on side by side, it lets come nearer by up to 1e-11 px/frame, so that one may
// be in the way of the other.
bool ExactBoxes::is_doubtful(const Box& a, const Box& b, int across) const {
  const bool is_ground = a.inverse_mass == 0 || b.inverse_mass == 0;
  const bool is_parting = abs(a.velocity[across] - b.velocity[across]) > kStill;
  return is_parting ? is_ground : !is_ground && bounce[across] != 1;
}

// When two boxes meet. On the axis on which they come together last they hit one another.
std::optional<ExactBoxes::Meeting> ExactBoxes::meeting(const Box& a, const Box& b,
                                                       const Exact& within) const {
  std::optional<Meeting> first;
  for (const int axis : {0, 1}) {
    const int across = 1 - axis;
    const Exact speed = a.velocity[axis] - b.velocity[axis];
    if (is_about_zero(speed, kStill)) continue;
    const Exact at = a.place[axis] - b.place[axis];
    const Exact apart = speed > 0 ? Exact(-a.size[axis] - at) : Exact(at - b.size[axis]);
    if (apart < -kTouch) continue;
    const Exact time = std::max<Exact>(0, apart / abs(speed));
    if (time > within || (first && time >= first->time)) continue;
    const Exact beside = gap(a, b, across, time);
    if (beside > kNear) continue;
    const bool is_passed = is_about_zero(beside, kTouch) && closing(a, b, across, time) <= kStill;
    if (is_passed && !is_doubtful(a, b, across)) continue;
    first = Meeting{time, beside >= -kNear};
  }
  return first;
}

// What holds the ways of the boxes from now on, in doubles, to rule out what is far away.
std::vector<ExactBoxes::Span> ExactBoxes::spans(double time) const {
  constexpr double kSlack = 1e-6;  // px
  std::vector<Span> spans(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const int axis : {0, 1}) {
      const double from = boxes[i].place[axis].get_d(), way = boxes[i].velocity[axis].get_d() * time;
      spans[i].low[axis] = from + std::min(way, 0.0) - kSlack;
      spans[i].high[axis] = from + boxes[i].size[axis].get_d() + std::max(way, 0.0) + kSlack;
    }
  }
  return spans;
}

// Calls visit(a, b) for pairs that may come together within this time, of which at least one moves.
template <class Visit>
void ExactBoxes::for_near(double time, Visit visit) const {
  const std::vector<Span> all = spans(time);
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      if (boxes[a].inverse_mass == 0 && boxes[b].inverse_mass == 0) continue;
      const auto is_apart = [&](int axis) {
        return all[a].high[axis] < all[b].low[axis] || all[b].high[axis] < all[a].low[axis];
      };
      if (!is_apart(0) && !is_apart(1)) visit(a, b);
    }
  }
}

// A close call that is about as early as the first meeting counts: the core may take it first.
std::optional<ExactBoxes::Meeting> ExactBoxes::first_meeting(const Exact& within) const {
  std::optional<Meeting> first, close;
  for_near(within.get_d(), [&](std::size_t a, std::size_t b) {
    const auto found = meeting(boxes[a], boxes[b], within);
    if (!found) return;
    if (!first || found->time < first->time) first = found;
    if (found->is_close && (!close || found->time < close->time)) close = found;
  });
  if (close && close->time <= first->time + kSlow) first->is_close = true;
  return first;
}

void ExactBoxes::fly(const Exact& time) {
  for (Box& box : boxes) {
    if (box.inverse_mass == 0) continue;
    for (const int axis : {0, 1}) box.place[axis] = rounded(box.place[axis] + box.velocity[axis] * time);
  }
}

ExactBoxes::Result ExactBoxes::step() {
  Exact left = 1;
  ends_at_impact_ = false;
  for (std::size_t impacts = 0;; ++impacts) {
    const auto next = first_meeting(left + kSlow);
    ends_at_impact_ = ends_at_impact_ || (next && next->time >= left - kSlow);
    if (next && next->is_close) return Result::close_call;
    if (!next || next->time >= left - kStill) break;
    if (impacts >= kMaxImpacts) return Result::many_impacts;
    const Exact time = rounded(next->time);
    fly(time);
    left -= time;
    if (const Result result = meet(); result != Result::done) return result;
  }
  fly(left);
  return Result::done;
}

// ---- Impacts ----

// How fast two boxes that touch go away from one another.
Exact ExactBoxes::speed(const Touch& touch) const {
  return (boxes[touch.a].velocity[touch.axis] - boxes[touch.b].velocity[touch.axis]) * touch.side;
}

// Whether two boxes come together corner to corner. If one of them is hit at that time, a rounding decides
// whether they meet.
bool ExactBoxes::comes_to_corner(const Box& a, const Box& b) const {
  bool comes = false;
  for (const int axis : {0, 1}) {
    if (!is_about_zero(gap(a, b, axis, 0), kNear)) return false;
    comes = comes || closing(a, b, axis, 0) > kStill;
  }
  return comes;
}

// All that touches now is one set.
ExactBoxes::Result ExactBoxes::meet() {
  ++impacts_;
  std::vector<Touch> touches[2];
  std::vector<std::size_t> at_corners;
  for_near(0, [&](std::size_t a, std::size_t b) {
    if (comes_to_corner(boxes[a], boxes[b])) at_corners.insert(at_corners.end(), {a, b});
    for (const int axis : {0, 1}) {
      if (!is_about_zero(gap(boxes[a], boxes[b], axis, 0), kTouch)) continue;
      if (gap(boxes[a], boxes[b], 1 - axis, 0) >= -kTouch) continue;
      const int side = boxes[a].place[axis] < boxes[b].place[axis] ? -1 : 1;
      touches[axis].push_back({a, b, axis, side});
    }
  });
  std::vector<char> is_hit(boxes.size(), 0);
  for (const auto& all : touches) {
    for (const Touch& touch : all) {
      const Exact size = abs(speed(touch));
      if (size > kStill && size < kSlow) return Result::close_call;
    }
  }
  for (const int axis : {0, 1}) {
    if (const Result result = reflect(touches[axis], is_hit); result != Result::done) return result;
  }
  for (const std::size_t box : at_corners)
    if (is_hit[box] && boxes[box].inverse_mass != 0) return Result::close_call;
  touches[0].insert(touches[0].end(), touches[1].begin(), touches[1].end());
  if (largest_pile(touches[0], is_hit) > kMaxBoxes) return Result::large_set;
  return is_close(is_hit) ? Result::close_call : Result::done;
}

// How many boxes touch one that was hit, or one that does.
std::size_t ExactBoxes::largest_pile(const std::vector<Touch>& touches,
                                     const std::vector<char>& is_hit) const {
  std::size_t largest = 0;
  std::vector<char> is_known(boxes.size(), 0);
  for (std::size_t first = 0; first < boxes.size(); ++first) {
    if (!is_hit[first] || is_known[first] || boxes[first].inverse_mass == 0) continue;
    std::vector<std::size_t> pile;
    const auto join = [&](std::size_t box) {
      if (!is_known[box] && boxes[box].inverse_mass != 0) pile.push_back(box), is_known[box] = 1;
    };
    join(first);
    for (std::size_t i = 0; i < pile.size(); ++i) {
      for (const Touch& touch : touches) {
        if (touch.a == pile[i]) join(touch.b);
        if (touch.b == pile[i]) join(touch.a);
      }
    }
    largest = std::max(largest, pile.size());
  }
  return largest;
}

// Takes one of these contacts out, and all that it pushes, or is pushed by, through boxes that move.
std::vector<ExactBoxes::Touch> ExactBoxes::take_set(std::vector<Touch>& left) const {
  std::vector<Touch> set = {left.back()};
  left.pop_back();
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Touch touch = set[i];
    const auto is_apart = [&](const Touch& other) {
      const auto is_of = [&](std::size_t box) {
        return boxes[box].inverse_mass != 0 && (box == other.a || box == other.b);
      };
      return !is_of(touch.a) && !is_of(touch.b);
    };
    const auto rest = std::stable_partition(left.begin(), left.end(), is_apart);
    set.insert(set.end(), rest, left.end());
    left.erase(rest, left.end());
  }
  return set;
}

// Reflects what approaches, again until nothing does (Smith and others 2012, "Reflections on Simultaneous
// Impact"). Impulses on one axis change nothing on the other one. What does not bounce at all is from then on
// reflected with the others, as boxes that meet so stay together unless they are drawn apart.
ExactBoxes::Result ExactBoxes::reflect(const std::vector<Touch>& touches, std::vector<char>& is_hit) {
  std::vector<char> is_kept(touches.size(), 0);
  for (int turn = 0; turn < kMaxFaintTurns; ++turn) {
    std::vector<Touch> left;
    bool approaches = false;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const bool comes = speed(touches[i]) < -kStill;
      approaches = approaches || comes;
      if (turn >= kMaxTurns && speed(touches[i]) < -kFaint) return Result::endless;
      if (comes && bounce[touches[i].axis] == 0) is_kept[i] = 1;
      if (comes || is_kept[i]) left.push_back(touches[i]);
    }
    if (!approaches) return Result::done;
    while (!left.empty()) {
      const std::vector<Touch> set = take_set(left);
      for (const Touch& touch : set) is_hit[touch.a] = is_hit[touch.b] = 1;
      if (set.size() > kMaxContacts || !push(set)) return Result::large_set;
    }
  }
  return Result::endless;
}

// Reflects the velocities of a set once: v' = v + (1 + e) M^-1 N l. Returns false if it cannot.
bool ExactBoxes::push(const std::vector<Touch>& set) {
  largest_ = std::max(largest_, set.size());
  const auto part = [](const Touch& touch, std::size_t box) {
    return box == touch.a ? touch.side : box == touch.b ? -touch.side : 0;
  };
  std::vector<std::vector<Exact>> matrix(set.size());
  std::vector<Exact> speeds;
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (const Touch& other : set) {
      const auto of = [&](std::size_t box) -> Exact {
        return boxes[box].inverse_mass * (part(set[i], box) * part(other, box));
      };
      matrix[i].push_back(of(set[i].a) + of(set[i].b));
    }
    speeds.push_back(speed(set[i]));
  }
  const auto impulses = complementary(matrix, speeds);
  if (!impulses) return false;
  const int axis = set.front().axis;
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (const std::size_t box : {set[i].a, set[i].b}) {
      Exact& velocity = boxes[box].velocity[axis];
      const Exact gain = (1 + bounce[axis]) * (*impulses)[i] * part(set[i], box);
      velocity = rounded(velocity + boxes[box].inverse_mass * gain);
    }
  }
  return true;
}

// Whether something almost touches what was hit, so that the core may take it for a part of the impact.
bool ExactBoxes::is_close(const std::vector<char>& is_hit) const {
  bool found = false;
  for_near(0, [&](std::size_t a, std::size_t b) {
    const bool is_concerned =
        (is_hit[a] && boxes[a].inverse_mass != 0) || (is_hit[b] && boxes[b].inverse_mass != 0);
    if (found || !is_concerned) return;
    for (const int axis : {0, 1}) {
      const Exact along = gap(boxes[a], boxes[b], axis, 0);
      const bool is_near = abs(along) > kTouch && abs(along) < kNear;
      if (is_near && gap(boxes[a], boxes[b], 1 - axis, 0) < kNear) found = true;
    }
  });
  return found;
}

}  // namespace talus::reference
