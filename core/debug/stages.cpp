#include "stages.h"

#include <algorithm>
#include <cmath>

#include "explain.h"
#include "level/level_text.h"
#include "number_text.h"

namespace talus {
namespace {

constexpr std::size_t kMaxNames = 4;  // in a sentence

bool is_more_than(Vec2 v, double least) { return std::abs(v.x) > least || std::abs(v.y) > least; }
bool is_told(Vec2 v) { return is_more_than(v, kLeastShown); }

// "the tile at (12, 9), body 3 and 2 more".
std::string names_of(const Scene& scene, const std::vector<Obstacle>& all) {
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), kMaxNames); ++i)
    text += (i == 0 ? "" : ", ") + name_of(scene, all[i]);
  if (all.size() > kMaxNames) text += " and " + std::to_string(all.size() - kMaxNames) + " more";
  return text;
}

// Whether a moving box reaches another box, at least side to side.
bool comes_to(const Rect& box, Vec2 motion, const Rect& other) {
  return other.x <= box.right() + std::max(motion.x, 0.0) &&
         other.right() >= box.x + std::min(motion.x, 0.0) &&
         other.y <= box.bottom() + std::max(motion.y, 0.0) &&
         other.bottom() >= box.y + std::min(motion.y, 0.0);
}

class StageList {
 public:
  StageList(const Frame& frame, const BodyPath& path)
      : frame_(frame), path_(path), foot_(frame.state.find(path.body)->foot), box_(path.from) {}

  std::vector<Stage> make() {
    const Vec2 wanted = path_.goal - path_.from.position();
    add(StageKind::wanted, wanted,
        is_more_than(wanted, kOnlyRounding) ? "wants to go " + motion_text(wanted) + " px" : "wants to stay");
    const auto& contacts = frame_.record.contacts;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (contacts[i].body == path_.body) add_contact(i);
    }
    if (!met_) search(wanted, nullptr);
    add_end();
    return std::move(stages_);
  }

 private:
  bool is_exact() const { return frame_.scene->tuning.solver == SolverKind::exact; }
  bool is_cut() const { return is_exact() && frame_.scene->tuning.exact.substeps > 1; }  // into parts

  Stage& add(StageKind kind, Vec2 motion, std::string sentence) {
    Stage& stage = stages_.emplace_back();
    stage.kind = kind;
    stage.box = box_;
    stage.motion = motion;
    stage.sentence = std::move(sentence);
    return stage;
  }

  // Exact searches again for each contact; the other solvers find all contacts of a motion at once.
  void search(Vec2 motion, const ContactRecord* found) {
    if (!is_exact() && searched_) return;
    searched_ = true;
    Stage& stage = add(StageKind::searched, motion, {});
    if (is_exact()) {
      if (frame_.ground == nullptr) return stages_.pop_back();
      CastTrace trace = trace_cast(*frame_.ground, {box_, motion, foot_});
      stage.cells = std::move(trace.cells);
      stage.candidates = std::move(trace.candidates);
      const std::size_t sides = stage.candidates.size();
      stage.sentence =
          "looked at " + count_text(stage.cells.size(), "cell") + ": " +
          (sides == 0 ? "no side faces" : count_text(sides, "side") + (sides == 1 ? " faces" : " face")) +
          " the motion";
      add_bodies(stage, found);
      return;
    }
    for (const TestedBox& tested : frame_.record.tested) {
      if (tested.body == path_.body) stage.tested.push_back(tested.other);
    }
    stage.sentence =
        stage.tested.empty() ? "no box was in its way" : "tested " + names_of(*frame_.scene, stage.tested);
  }

  // The record of exact does not have the bodies that it tested, which are those that the motion came to.
  // Bodies with a lower number had moved by then. found: what the search found; null: nothing.
  void add_bodies(Stage& stage, const ContactRecord* found) {
    if (!frame_.scene->features.pairs) return;
    const int met = found != nullptr ? found->other.body : 0;
    for (const BodyPath& path : frame_.record.paths) {
      const Rect& box = path.body < path_.body ? path.to : path.from;
      const bool near = path.body == met || comes_to(stage.box, stage.motion, box);
      if (path.body == path_.body || !near) continue;
      stage.tested.push_back({TileRole::ball, frame_.state.find(path.body)->origin.cell, path.body, box});
    }
    if (!stage.tested.empty()) stage.sentence += "; tested " + names_of(*frame_.scene, stage.tested);
    if (met == 0) return;
    for (CastCandidate& candidate : stage.candidates) candidate.is_first = false;
  }

  void add_contact(std::size_t index) {
    const ContactRecord& contact = frame_.record.contacts[index];
    met_ = true;
    if (is_cut()) box_ = at(start_of(contact));
    search(contact.move, &contact);
    const Explanation why = explain_contact(frame_, index);
    Stage& met = add(StageKind::met, contact.move, why.sentence);
    met.numbers = why.numbers;
    met.contact = static_cast<int>(index);
    if (contact.response == Response::cross) return add_correction(contact, index);
    box_position_ = contact.touch;
    box_ = at(box_position_);
    Stage& placed = add(StageKind::placed, {}, "put at " + short_text(box_position_));
    placed.contact = static_cast<int>(index);
    const Vec2 left = motion_after(index);
    if (!is_told(left)) return;
    Stage& on = add(StageKind::went_on, left, "goes on by " + motion_text(left) + " px");
    on.contact = static_cast<int>(index);
  }

  // A body that crosses a slope goes on. It may be put on the slope's floor after all of its motion.
  void add_correction(const ContactRecord& contact, std::size_t index) {
    if (!contact.slope || !contact.slope->corrected) return;
    box_position_ = {path_.to.x, contact.slope->placed_y};
    box_ = at(box_position_);
    Stage& placed =
        add(StageKind::placed, {}, "put on the slope's floor, its top at y " + short_text(box_position_.y));
    placed.contact = static_cast<int>(index);
  }

  // Where the part of the step began that led to a contact. The parts before it may have met nothing.
  Vec2 start_of(const ContactRecord& contact) const {
    const Vec2 start = contact.touch - contact.move * std::clamp(contact.ti, 0.0, 1.0);
    return is_more_than(start - box_position_, kOnlyRounding) ? start : box_position_;
  }

  // The motion that the next contact began with; after the last contact, the motion to the body's end.
  Vec2 motion_after(std::size_t index) const {
    const auto& contacts = frame_.record.contacts;
    if (is_cut()) return contacts[index].after.value_or(Vec2{});
    for (std::size_t i = index + 1; i < contacts.size(); ++i) {
      if (contacts[i].body == path_.body) return contacts[i].move;
    }
    return path_.to.position() - box_.position();
  }

  // A walking body is put on the floor below after all of its motion. The last motion of another body leads
  // to the end.
  void add_end() {
    const Vec2 rest = path_.to.position() - box_.position();
    const bool snaps = is_exact() && !met_ && is_told(path_.to.position() - path_.goal);
    if (snaps) {
      box_ = at(path_.goal);
      const Vec2 by = path_.to.position() - path_.goal;
      add(StageKind::snapped, by, "put on the floor that it walks on, " + motion_text(by) + " px away");
    } else if (is_told(rest) && !met_) {
      add(StageKind::went_on, rest, "nothing in the way: goes " + motion_text(rest) + " px");
    }
    box_ = path_.to;
    std::string text = "arrives at " + short_text(path_.to.position());
    if (path_.capped) text += "; it met more than a step handles, and the rest of its motion is lost";
    if (path_.cut_short) text += "; it met the limit of work for a step, and stopped early";
    if (path_.limited) text += "; its way or its speed was cut to the largest allowed";
    add(StageKind::arrived, {}, std::move(text));
  }

  Rect at(Vec2 position) const { return {position.x, position.y, path_.from.w, path_.from.h}; }

  const Frame& frame_;
  const BodyPath& path_;
  const Foot foot_;
  Rect box_;  // where the body is at the current stage
  Vec2 box_position_ = path_.from.position();
  bool met_ = false, searched_ = false;
  std::vector<Stage> stages_;
};

}  // namespace

std::vector<Stage> stages_of(const Frame& frame, int body) {
  const auto& paths = frame.record.paths;
  const auto path =
      std::find_if(paths.begin(), paths.end(), [&](const BodyPath& p) { return p.body == body; });
  if (path == paths.end() || frame.state.find(body) == nullptr) return {};
  return StageList(frame, *path).make();
}

}  // namespace talus
