#include "explain.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "../sim/exact_mover.h"
#include "metrics.h"
#include "number_text.h"

namespace talus {
namespace {

bool is_slanted(Vec2 normal) { return normal.x != 0 && normal.y != 0; }
std::string px(double distance) { return short_text(distance) + " px"; }

std::string place_of(Cell cell) {
  return " at (" + std::to_string(cell.x) + ", " + std::to_string(cell.y) + ")";
}

// "the left side of the tile at (12, 9)". For a slope's own line it names the slope, for an overlap the whole
// tile.
std::string met_part(const Scene& scene, const ContactRecord& contact) {
  const Vec2 n = contact.normal;
  if (is_slanted(n) && n.y > 0) {
    return contact.other.curve >= 0 ? "the underside of " + name_of(scene, contact.other)
                                    : "the sloped ceiling" + place_of(contact.other.cell);
  }
  if (is_slanted(n) || n == Vec2{}) return name_of(scene, contact.other);
  const char* side = n.x < 0 ? "left side" : n.x > 0 ? "right side" : n.y < 0 ? "top" : "bottom";
  return std::string("the ") + side + " of " + name_of(scene, contact.other);
}

// "down", "up to the left": the directions that a motion mainly has.
std::string direction_of(Vec2 way) {
  const double least = 0.1 * length(way);
  const std::string vertical = way.y > least ? "down" : way.y < -least ? "up" : "";
  const std::string sideways = way.x > least ? "right" : way.x < -least ? "left" : "";
  if (vertical.empty()) return "to the " + sideways;
  return sideways.empty() ? vertical : vertical + " to the " + sideways;
}

class ContactSentence {
 public:
  ContactSentence(const Frame& frame, std::size_t index)
      : frame_(frame),
        contact_(frame.record.contacts[index]),
        index_(index),
        path_(path_of(frame.record, contact_.body)) {}

  std::string sentence() const {
    const bool is_crossed = contact_.response == Response::cross;
    if (is_crossed)
      return is_article() ? article_slope()
                          : "passed above the floor of " + name_of(*frame_.scene, contact_.other);
    std::string text = stopped() + carried() + rest();
    if (!contact_.handled) text += "; its velocity was left alone, as a slope had put the body on its floor";
    return text;
  }

  // Says what stopped the body and when, but not what happened afterwards.
  std::string stopped() const {
    if (contact_.overlaps) return "was inside " + name_of(*frame_.scene, contact_.other) + pushed_out();
    return what_it_did() + met_part(*frame_.scene, contact_) + when();
  }

  std::string numbers() const {
    const Vec2 normal = normal_of_effect(contact_);
    std::string text = normal == Vec2{} ? "no normal" : "normal " + short_text(normal);
    if (contact_.slope) {
      text += ", slope delta " + short_text(contact_.slope->delta);
      text += (contact_.slope->normal.y > 0 ? ", ceiling at y " : ", floor at y ") +
              short_text(contact_.slope->floor_y);
    } else if (normal.y < 0 && path_ != nullptr) {
      text += ", floor at y " + short_text(contact_.touch.y + path_->from.h);
    }
    return text;
  }

 private:
  const Tuning& tuning() const { return frame_.scene->tuning; }
  bool is_article() const { return tuning().solver == SolverKind::article; }
  bool is_exact() const { return tuning().solver == SolverKind::exact; }
  bool rebounds() const { return is_exact() && (meets() || tuning().exact.rebound != 0); }
  // Whether the body is one of those that move all at the same time.
  bool meets() const {
    const Body* body = frame_.state.find(contact_.body);
    return frame_.scene->features.meets && body != nullptr && traits_of(body->kind).rule == BodyRule::fall;
  }
  bool is_cut() const { return is_exact() && tuning().exact.substeps > 1; }  // into parts of a step

  // What a conveyor does to what rubs on it or walks on it.
  std::string carried() const {
    if (!is_exact() || frame_.ground == nullptr || contact_.other.body != 0) return "";
    const Body* body = frame_.state.find(contact_.body);
    if (body == nullptr) return "";
    const bool rubs = meets() && traits_of(body->kind).friction > 0;
    const bool walks = traits_of(body->kind).takes_keys && body->gait.grounded && contact_.normal.y < 0;
    if (!rubs && !walks) return "";
    const double speed = conveyor_of(contact_.other);
    if (speed == 0) return "";
    const Vec2 way = Vec2{-contact_.normal.y, contact_.normal.x} * speed;
    return ", whose conveyor carries it " + direction_of(way) + " at " + short_text(std::abs(speed)) +
           " px/frame";
  }

  // px/frame, as TileShape::conveyor.
  double conveyor_of(const Obstacle& other) const {
    const Terrain& ground = *frame_.ground;
    if (other.curve >= 0) return ground.conveyor_of(-1 - other.curve);
    return ground.contains(other.cell) ? ground.conveyor_of(other.cell.y * ground.width() + other.cell.x) : 0;
  }

  // A body that meets others may be moved by what it did not run into.
  std::string what_it_did() const {
    if (!meets() || dot(contact_.move, contact_.normal) < 0) return "stopped by ";
    const bool is_moved = contact_.after && dot(*contact_.after, contact_.normal) > kOnlyRounding;
    return is_moved ? "hit by " : "pressed by ";
  }

  std::string when() const {
    if (contact_.ti < kOnlyRounding) return " at once";
    const bool is_whole = path_ != nullptr && contact_.move == path_->goal - path_->from.position();
    const bool of_step = !is_cut() && (meets() || contact_.order == 0 || is_whole);
    const std::string what = of_step ? "the step" : is_cut() ? "a part of the step" : "the remaining motion";
    if (contact_.ti > 0.995) return " at the end of " + what;
    return " at " + short_text(contact_.ti) + " of " + what;
  }

  std::string pushed_out() const {
    if (contact_.normal == Vec2{}) return " from the start";
    const char* way = contact_.normal.x < 0   ? "to the left"
                      : contact_.normal.x > 0 ? "to the right"
                      : contact_.normal.y < 0 ? "up"
                                              : "down";
    return std::string(" from the start and was put out of it ") + way;
  }

  Vec2 motion_left() const { return contact_.move * (1 - std::clamp(contact_.ti, 0.0, 1.0)); }

  // The motion after this contact; nothing if the record does not have it.
  std::optional<Vec2> motion_after() const {
    const auto& contacts = frame_.record.contacts;
    if (!is_exact()) {
      const Vec2 left = motion_left();
      return left - contact_.normal * std::min(0.0, dot(left, contact_.normal));
    }
    if (is_cut() || meets()) return contact_.after;
    if (path_ == nullptr) return std::nullopt;
    const bool is_last = index_ + 1 == contacts.size() || contacts[index_ + 1].body != contact_.body;
    return is_last ? path_->to.position() - contact_.touch : contacts[index_ + 1].move;
  }

  std::string rest() const {
    if (contact_.overlaps) return "";
    const double left = length(motion_left());
    const std::optional<Vec2> after = motion_after();
    if (left < kLeastShown || !after) return "";
    const double went = length(*after);
    if (went < kLeastShown) return "; " + px(left) + " of remaining motion went into it and is lost";
    if (rebounds() && dot(*after, contact_.normal) > kOnlyRounding)
      return "; it bounced off and went on " + px(went) + " " + direction_of(*after);
    const std::string slid = " slid " + direction_of(*after);
    if (short_text(went) == short_text(left)) return "; " + px(left) + " of remaining motion" + slid;
    return "; of " + px(left) + " of remaining motion " + px(went) + slid;
  }

  // The article's bodies cross slopes and are put on their floors afterwards.
  std::string article_slope() const {
    std::string text = "came into the box of " + name_of(*frame_.scene, contact_.other);
    if (!contact_.overlaps) text += when();
    if (!contact_.handled) return text + "; another slope had already put the body on its floor";
    if (!contact_.slope)
      return text + "; it moved up, or no slope was straight below it, so it was left as it was";
    const SlopeProbe& probe = *contact_.slope;
    text += "; under its centre the floor of " + name_of(*frame_.scene, probe.slope) + " is at y " +
            short_text(probe.floor_y);
    if (probe.corrected) return text + ", so its top was put at y " + short_text(probe.placed_y);
    return text + ", and its top was above y " + short_text(probe.placed_y) +
           " already, so it was left as it was";
  }

  const Frame& frame_;
  const ContactRecord& contact_;
  const std::size_t index_;
  const BodyPath* const path_;
};

// Whether the body neither wanted to go anywhere nor went.
bool stays(const BodyPath& path) {
  return length(path.goal - path.from.position()) < kLeastShown &&
         length(path.to.position() - path.from.position()) < kLeastShown;
}

// px, how far below a body the floor may be that it stands on, by rounding
constexpr double kTouching = 1.0 / kWeldParts;

// Whether a body stands on a side that is too steep to stand on alone.
bool is_on_steep_side(const Frame& frame, const Body& body) {
  if (frame.ground == nullptr) return false;
  const auto floor = cast_box<double>(*frame.ground, {body.box, {0, kTouching}, body.foot});
  return floor && !is_level(floor, frame.scene->tuning.exact.steepest);
}

// Where a body is that stays.
std::string resting_place(const Frame& frame, const Body& body) {
  if (!body.gait.grounded) return " stays where it is";
  return is_on_steep_side(frame, body)
             ? " stands still between two sides that are too steep to stand on alone"
             : " stands still on its floor";
}

// "Body 1 wanted to go (2, 5) px and went (2, 1.2) px."
std::string wanted_and_got(const Frame& frame, const BodyPath& path) {
  const Vec2 wanted = path.goal - path.from.position(), got = path.to.position() - path.from.position();
  std::string text = "Body " + std::to_string(path.body);
  if (frame.state.grabbed == path.body) text += ", held by the mouse,";
  if (stays(path)) {
    return text + resting_place(frame, *frame.state.find(path.body)) + ": nothing moves it.";
  }
  text += " wanted to go " + motion_text(wanted) + " px";
  return length(wanted - got) < kLeastShown ? text + " and did."
                                            : text + " and went " + motion_text(got) + " px.";
}

// Whether a contact took some of the motion though the solver did not respond to it. World slides a body
// along the boxes that it meets, and only then the article asks whether a slope has put the body on its
// floor.
bool only_stops(const ContactRecord& contact) {
  if (contact.handled || contact.response == Response::cross) return false;
  return dot(contact.move, contact.normal) * (1 - std::clamp(contact.ti, 0.0, 1.0)) <= -kLeastShown;
}

// The contact with the strongest impulse on a body that meets others; nothing if it had none.
std::optional<std::size_t> strongest_impact(const Frame& frame, int body) {
  const Body* const hit = frame.state.find(body);
  if (!frame.scene->features.meets || traits_of(hit->kind).rule != BodyRule::fall) return std::nullopt;
  std::optional<std::size_t> strongest;
  const auto& contacts = frame.record.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].body != body || !(contacts[i].impulse > 0)) continue;
    if (!strongest || contacts[i].impulse > contacts[*strongest].impulse) strongest = i;
  }
  return strongest;
}

// Explains in full the first contact that turned the body, and the first one that only stopped it; of bodies
// that meet the strongest impact. Counts the others.
std::string reasons(const Frame& frame, const BodyPath& path) {
  const auto& contacts = frame.record.contacts;
  if (const auto impact = strongest_impact(frame, path.body)) {
    const auto all = std::count_if(contacts.begin(), contacts.end(),
                                   [&](const ContactRecord& c) { return c.body == path.body; });
    const std::string others = all == 2  ? "; it had 1 more contact"
                               : all > 2 ? "; it had " + std::to_string(all - 1) + " more contacts"
                                         : "";
    return " It was " + explain_contact(frame, *impact).sentence + others + ".";
  }
  std::string text;
  bool has_met = false, has_turned = false, has_stopped = false;
  std::size_t more = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].body != path.body) continue;
    has_met = true;
    const bool stops = only_stops(contacts[i]);
    if (!stops && !has_effect(contacts[i])) continue;
    if (std::exchange(stops ? has_stopped : has_turned, true)) {
      ++more;
      continue;
    }
    const bool was_put = contacts[i].overlaps || contacts[i].response == Response::cross;
    text += text.empty() ? " It " : ". Then it ";
    text += (was_put ? "" : "was ") + explain_contact(frame, i).sentence;
  }
  if (more > 0)
    text += "; " + std::to_string(more) + (more == 1 ? " more contact" : " more contacts") + " followed";
  if (!text.empty()) return text + ".";
  if (stays(path)) return {};
  const std::string met = has_met ? " Nothing that it met changed its way" : " It met nothing";
  const Vec2 off = path.to.position() - path.goal;
  if (length(off) < kLeastShown) return met + ".";
  const Body* body = frame.state.find(path.body);
  const bool walks = traits_of(body->kind).rule == BodyRule::run && body->gait.grounded;
  if (walks) return met + ", and then it was moved by " + motion_text(off) + " px, onto its floor.";
  return met + ", and its speed changed on the way.";
}

}  // namespace

std::string name_of_curve(const Scene& scene, int curve) {
  const auto number = static_cast<std::size_t>(curve);
  const bool named = number < scene.curve_names.size() && !scene.curve_names[number].empty();
  return "curve " + (named ? '"' + scene.curve_names[number] + '"' : std::to_string(curve));
}

std::string name_of(const Scene& scene, const Obstacle& other) {
  if (other.body != 0) return "body " + std::to_string(other.body);
  if (other.curve >= 0) return name_of_curve(scene, other.curve);
  if (other.role == TileRole::up_slope) return "the up-slope" + place_of(other.cell);
  if (other.role == TileRole::down_slope) return "the down-slope" + place_of(other.cell);
  return "the tile" + place_of(other.cell);
}

Explanation explain_contact(const Frame& frame, std::size_t index) {
  assert(index < frame.record.contacts.size());
  const ContactSentence contact(frame, index);
  return {contact.sentence(), contact.numbers()};
}

std::string explain_step(const FrameView& view, int body) {
  const Frame& frame = view.now();
  const BodyPath* path = path_of(frame.record, body);
  const Body* after = frame.state.find(body);
  if (path == nullptr || after == nullptr) return {};

  std::string text = wanted_and_got(frame, *path);
  const Body* before = view.is_first() ? nullptr : view.before(1).state.find(body);
  const bool may_be_inside =
      before != nullptr && !before->is_clear && frame.scene->tuning.solver == SolverKind::exact;
  if (may_be_inside && measure(Metric::penetration, view.before(1), *before) > 0)
    text += " It began inside the ground, and was first put out of it.";
  text += reasons(frame, *path);
  if (path->capped) text += " It met more contacts than a step handles, and the rest of its motion is lost.";
  if (path->cut_short) text += " It met the limit of work for a step, and stopped early.";
  if (path->limited) text += " Its way or its speed was cut to the largest allowed.";
  if (before == nullptr) return text;
  const std::string was = motion_text(before->velocity), is = motion_text(after->velocity);
  if (was != is) text += " Its velocity went from " + was + " to " + is + " px/frame.";
  return text;
}

}  // namespace talus
