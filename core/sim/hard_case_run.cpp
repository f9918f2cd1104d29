#include "hard_case_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <talus/sim/solver.h>
#include "../level/transform.h"
#include "case_edit.h"
#include "case_input.h"

namespace talus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What is kept of one body in one frame.
struct Sample {
  Rect box;
  Vec2 velocity;
  double spin = 0;  // px/frame
  double mass = 0;
  double further = 0;         // px moved further than asked for
  std::vector<Vec2> normals;  // of its contacts
};
// By frame, then by body in the order of ids; frame 0 is the start. A body that was removed keeps its last
// box and speed.
using Run = std::vector<std::vector<Sample>>;

// The larger number; NaN wins.
double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

double length(Vec2 v) { return std::hypot(v.x, v.y); }

class InputAt {
 public:
  InputAt(const HardCase& hard, bool mirrored, Vec2 by, double width)
      : hard_(hard), mirrored_(mirrored), by_(by), width_(width) {}
  Input operator()(std::int64_t frame) const {
    Input held = case_input(hard_.input, frame);
    if (mirrored_) {
      std::swap(held.left, held.right);
      held.mouse.x = width_ - held.mouse.x;
    } else {
      held.mouse = held.mouse + by_;
    }
    return held;
  }

 private:
  const HardCase& hard_;
  bool mirrored_;
  Vec2 by_;
  double width_;  // px of the map
};

// Ids are from 1, in the order of the start.
std::size_t index_of(int body) { return static_cast<std::size_t>(body - 1); }

// before: samples of the frame before; empty at the start.
std::vector<Sample> sample(const State& state, const StepRecord& record, const std::vector<Sample>& before) {
  std::vector<Sample> samples(before.empty() ? state.bodies.size() : before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Sample& last = before[i];
    samples[i] = {last.box, last.velocity, last.spin, last.mass, 0, {}};
  }
  for (const Body& body : state.bodies) {
    const double mass = mass_of(body.kind, {body.box.w, body.box.h});
    samples[index_of(body.id)] = {body.box, body.velocity, body.spin, mass, 0, {}};
  }
  for (const BodyPath& path : record.paths) {
    const double asked = length(path.goal - path.from.position());
    const double went = length(path.to.position() - path.from.position());
    samples[index_of(path.body)].further = went - asked;
  }
  for (const ContactRecord& contact : record.contacts) {
    if (contact.handled) samples[index_of(contact.body)].normals.push_back(contact.normal);
  }
  return samples;
}

// Thrown and caught in this file only: a case that cannot be run.
struct Refused {
  std::string message;
};

// bodies, contacts: of all frames of the run.
void check_amounts(std::size_t bodies, std::size_t contacts, const HardCase& hard, const State& state) {
  if (bodies <= kMaxCaseBodies && contacts <= kMaxCaseContacts) return;
  throw Refused{"makes " + std::to_string(hard.frames) + " frames of " + std::to_string(state.bodies.size()) +
                " bodies, but all frames together may have at most " + std::to_string(kMaxCaseBodies) +
                " bodies and " + std::to_string(kMaxCaseContacts) + " contacts"};
}

std::size_t normals_of(const std::vector<Sample>& samples) {
  std::size_t count = 0;
  for (const Sample& sample : samples) count += sample.normals.size();
  return count;
}

// Every body that is removed must be there.
void check_edits(const HardCase& hard, const State& state) {
  const auto bodies = static_cast<int>(state.bodies.size());
  std::vector<int> gone;
  for (const CaseEdit& edit : hard.edits) {
    if (edit.remove == 0) continue;
    const std::string body = "removes body " + std::to_string(edit.remove);
    if (edit.remove > bodies) throw Refused{body + ", but the level has " + std::to_string(bodies)};
    if (std::count(gone.begin(), gone.end(), edit.remove) > 0) throw Refused{body + " twice"};
    gone.push_back(edit.remove);
  }
}

enum class Way {
  plain,
  new_solvers,  // a new one in each frame, which remembers nothing
  unrecorded    // bodies may sleep, and samples are without contacts
};

Run run(const HardCase& hard, const Level& level, InputAt input, Way way = Way::plain) {
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  auto solver = make_solver(scene);
  State state = initial_state(*scene);
  const std::size_t bodies = state.bodies.size() * static_cast<std::size_t>(hard.frames + 1);
  std::size_t contacts = 0;
  check_amounts(bodies, contacts, hard, state);
  check_edits(hard, state);
  StepRecord record;
  Run frames = {sample(state, record, {})};
  make_edits(hard.edits, state);
  for (std::int64_t frame = 1; frame <= hard.frames; ++frame) {
    if (way == Way::new_solvers) solver = make_solver(scene);
    solver->step(state, input(frame), way == Way::unrecorded ? nullptr : &record);
    frames.push_back(sample(state, record, frames.back()));
    make_edits(hard.edits, state);
    check_amounts(bodies, contacts += normals_of(frames.back()), hard, state);
  }
  return frames;
}

// Greatest distance between two runs. `image` gives the sample of the other run that belongs to each sample.
template <class Image>
double distance(const Run& run, const Run& other, Image image) {
  double most = 0;
  for (std::size_t frame = 0; frame < run.size(); ++frame) {
    for (std::size_t body = 0; body < run[frame].size(); ++body) {
      const Vec2 at = image(other[frame], body);
      most = worse(length(run[frame][body].box.position() - at), most);
    }
  }
  return most;
}

class Measurer {
 public:
  Measurer(const HardCase& hard, const Level& level)
      : hard_(hard),
        level_(level),
        width_(level.map.px_width()),
        run_(run(hard, level, {hard, false, {}, width_})) {}

  double measure(const CaseCheck& check) const {
    using M = CaseCheck::Measure;
    if (static_cast<std::size_t>(check.body) > run_[0].size()) return kInfinity;
    switch (check.measure) {
      case M::position:
        return in_range(check, hard_.frames,
                        [&](const Sample& s, const Sample&) { return off(check, s.box); });
      case M::velocity:
        return in_range(check, hard_.frames, [&](const Sample& s, const Sample&) {
          return worse(off(check.x, s.velocity.x), off(check.y, s.velocity.y));
        });
      case M::sink:
        return in_range(check, 1, [&](const Sample& s, const Sample&) { return -above_floor(s.box); });
      case M::gap:
        return in_range(check, 1, [&](const Sample& s, const Sample&) { return above_floor(s.box); });
      case M::reaches:
        return missing(check);
      case M::backwards:
        return in_range(check, 1, [&](const Sample& s, const Sample& before) {
          return (before.box.x - s.box.x) * direction(check);
        });
      case M::further:
        return in_range(check, 1, [](const Sample& s, const Sample&) { return s.further; });
      case M::walls:
        return walls(check);
      case M::untouched:
        return total(check, [](const Sample& s) { return s.normals.empty(); });
      case M::normal:
        return off_normal(check);
      case M::changes:
        return total(check, [&, y = sample_at(check, std::max<std::int64_t>(check.first, 1)).box.y](
                                const Sample& s) { return s.box.y != y; });
      case M::energy:
        return energy(check);
      case M::total_energy:
        return total_energy();
      case M::apex:
        return apex(check);
      case M::returns:
        return returns();
      case M::mirror:
      case M::translate:
      case M::permute:
      case M::repeat:
        return variant(check);
    }
    return kInfinity;
  }

 private:
  static double off(const std::optional<double>& wanted, double got) {
    return wanted ? std::abs(got - *wanted) : 0;
  }
  static double off(const CaseCheck& check, const Rect& box) {
    return worse(worse(off(check.x, box.x), off(check.y, box.y)),
                 worse(off(check.right, box.right()), off(check.bottom, box.bottom())));
  }
  double above_floor(const Rect& box) const {
    return hard_.floor.top(box.x, box.right()).value_or(kInfinity) - box.bottom();
  }
  double start(const CaseCheck& check) const { return sample_at(check, 0).box.x; }
  double direction(const CaseCheck& check) const {
    return check.x.value_or(kInfinity) < start(check) ? -1 : 1;
  }
  const Sample& sample_at(const CaseCheck& check, std::int64_t frame) const {
    return run_[static_cast<std::size_t>(frame)][index_of(check.body)];
  }

  // The greatest value over the check's frames, by default from `first` to the last one.
  template <class Value>
  double in_range(const CaseCheck& check, std::int64_t first, Value value) const {
    double most = -kInfinity;
    const std::int64_t last = check.last > 0 ? check.last : hard_.frames;
    for (std::int64_t frame = check.first > 0 ? check.first : first; frame <= last; ++frame) {
      most = worse(value(sample_at(check, frame), sample_at(check, frame - 1)), most);
    }
    return most;
  }

  double missing(const CaseCheck& check) const {
    double least = kInfinity;
    for (std::int64_t frame = 0; frame <= hard_.frames; ++frame) {
      least =
          std::min(least, (check.x.value_or(kInfinity) - sample_at(check, frame).box.x) * direction(check));
    }
    return std::max(least, 0.0);
  }

  // The sum over the check's frames.
  template <class Value>
  double total(const CaseCheck& check, Value value) const {
    double sum = 0;
    in_range(check, 1, [&](const Sample& s, const Sample&) { return sum += static_cast<double>(value(s)); });
    return sum;
  }

  double walls(const CaseCheck& check) const {
    return total(check, [](const Sample& s) {
      return std::count_if(s.normals.begin(), s.normals.end(),
                           [](Vec2 normal) { return normal.x != 0 && normal.y == 0; });
    });
  }

  double off_normal(const CaseCheck& check) const {
    const Vec2 right{check.x.value_or(0), check.y.value_or(0)};
    double most = -kInfinity;
    in_range(check, 1, [&](const Sample& s, const Sample&) {
      for (const Vec2 n : s.normals) {
        const double angle = std::atan2(right.x * n.y - right.y * n.x, dot(right, n));
        most = worse(std::abs(angle) * 180 / std::numbers::pi, most);
      }
      return most;
    });
    return most < 0 ? kInfinity : most;
  }

  // The share of the greatest energy of motion that is gained or lost. sum(frame, energy): the energy of all
  // that counts in a frame, if `energy` gives that of a sample for each unit of mass. A body without spin has
  // none to gain; half of a disc's mass counts at its rim.
  template <class Sum>
  double energy_change(Sum sum) const {
    const double gravity = level_.tuning.exact.gravity;
    const auto of_motion = [](const Sample& s) {
      return dot(s.velocity, s.velocity) / 2 + s.spin * s.spin / 4;
    };
    const auto whole = [&](const Sample& s) { return of_motion(s) - gravity * s.box.y; };
    const double start = sum(0, whole);
    double most = 0, off = 0;
    for (std::int64_t frame = 0; frame <= hard_.frames; ++frame) {
      most = worse(sum(frame, of_motion), most);
      off = worse(std::abs(sum(frame, whole) - start), off);
    }
    return most > 0 ? off / most : kInfinity;
  }
  double energy(const CaseCheck& check) const {
    return energy_change(
        [&](std::int64_t frame, const auto& energy) { return energy(sample_at(check, frame)); });
  }
  double total_energy() const {
    return energy_change([&](std::int64_t frame, const auto& energy) {
      double sum = 0;
      for (const Sample& s : run_[static_cast<std::size_t>(frame)]) sum += s.mass * energy(s);
      return sum;
    });
  }

  double returns() const {
    double most = 0;
    for (std::size_t i = 0; i < run_[0].size(); ++i)
      most = worse(length(run_.back()[i].box.position() - run_[0][i].box.position()), most);
    return most;
  }

  double apex(const CaseCheck& check) const {
    double most = -kInfinity;
    for (std::int64_t frame = 1; frame < hard_.frames; ++frame) {
      const double y = sample_at(check, frame).box.y;
      if (y < sample_at(check, frame - 1).box.y && y <= sample_at(check, frame + 1).box.y) {
        most = worse(off(check.y, y), most);
      }
    }
    return most < 0 ? kInfinity : most;
  }

  double variant(const CaseCheck& check) const {
    using M = CaseCheck::Measure;
    const auto same = [](const std::vector<Sample>& samples, std::size_t body) {
      return samples[body].box.position();
    };
    if (check.measure == M::repeat) {
      const auto off = [&](Way way) {
        return distance(run_, run(hard_, level_, {hard_, false, {}, width_}, way), same);
      };
      return worse(off(Way::new_solvers), off(Way::unrecorded));
    }
    if (check.measure == M::mirror) {
      return distance(run_, run(hard_, mirrored(level_), {hard_, true, {}, width_}),
                      [&](const std::vector<Sample>& samples, std::size_t body) {
                        const Rect& box = samples[body].box;
                        return Vec2{width_ - box.right(), box.y};
                      });
    }
    if (check.measure == M::translate) {
      const Vec2 by{check.x.value_or(0), check.y.value_or(0)};
      const Cell cells = level_.map.cell_at(by);
      const Level image = moved(level_, cells.x, cells.y);
      return distance(run_, run(hard_, image, {hard_, false, by, width_}),
                      [&](const std::vector<Sample>& samples, std::size_t body) {
                        return samples[body].box.position() - by;
                      });
    }
    Level image = level_;
    std::reverse(image.spawns.begin(), image.spawns.end());
    std::reverse(image.curves.begin(), image.curves.end());
    HardCase reversed = hard_;
    for (CaseEdit& edit : reversed.edits) {
      if (edit.remove != 0) edit.remove = static_cast<int>(run_[0].size()) + 1 - edit.remove;
    }
    return distance(run_, run(reversed, image, {hard_, false, {}, width_}),
                    [](const std::vector<Sample>& samples, std::size_t body) {
                      return samples[samples.size() - 1 - body].box.position();
                    });
  }

  const HardCase& hard_;
  const Level& level_;
  double width_;  // px of the map
  Run run_;
};

}  // namespace

tl::expected<std::vector<CaseResult>, std::string> run_hard_case(const HardCase& hard, const Level& level) {
  try {
    const Measurer measurer(hard, level);
    std::vector<CaseResult> results;
    for (const CaseCheck& check : hard.checks) {
      const double measured = measurer.measure(check);
      results.push_back({check, measured <= check.bound, measured});
    }
    return results;
  } catch (Refused& refused) {
    return tl::unexpected(std::move(refused.message));
  }
}

}  // namespace talus
