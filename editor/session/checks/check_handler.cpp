// Finds problems, and where a player gets to, and proves the level.
#include "check_handler.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "level/ground_level.h"
#include "level/lint/layer_rules.h"
#include "session/run/work_share.h"

namespace talus {
namespace {

constexpr double kLintSeconds = 0.003;   // of processor time, for a call of advance()
constexpr double kReachSeconds = 0.006;  // the same

}  // namespace

template <>
void CheckHandler::carry_out(const action::SetLintOptions& a) {
  const double most = max_seam(open_.level.map.tile_size());
  lint_options_.seam = a.options.seam >= 0 ? std::min(a.options.seam, most) : 0;
  lint_cache_.note_rest();
}

template <>
void CheckHandler::carry_out(const action::FindReach&) {
  if (!is_compiled()) return;
  const Body* chosen = run_.simulation().state().find(choices_.choices().body);
  const auto origin = chosen != nullptr ? std::optional(chosen->origin) : std::nullopt;
  if (const auto problem = reach_.start(*run_.timeline().level_scene(), origin))
    return messages_.tell_error(*problem);
  choices_.show_overlay(overlay::reach, true);
}

template <>
void CheckHandler::carry_out(const action::CancelReach&) {
  reach_.cancel();
}

template <>
void CheckHandler::carry_out(const action::ShowWay& a) {
  follow_scene();
  if (reach_.found() == nullptr || reach_.is_stale()) return;
  if (const std::vector<Input> way = reach_.found()->way_to(a.cell); !way.empty()) run_.play_new(way);
}

template <>
void CheckHandler::carry_out(const action::Prove& a) {
  if (!is_compiled()) return;
  prover_.start(open_.level, a.near);
  choices_.show_overlay(overlay::findings, true);
}

template <>
void CheckHandler::carry_out(const action::CancelProof&) {
  prover_.cancel();
}

template <>
void CheckHandler::carry_out(const action::PlayFinding& a) {
  if (!is_compiled()) return;
  const Proof* proof = prover_.found();
  if (proof == nullptr || a.index >= proof->findings.size()) return;
  const Finding& finding = proof->findings[a.index];
  std::vector<Input> inputs;
  for (int frame = 1; frame <= finding.frame; ++frame) inputs.push_back(input_of(finding.trial, frame));
  run_.play_alone(lone_body_of(finding.trial), inputs, std::string(info_of(finding.kind).label));
}

void CheckHandler::apply(const CheckAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

bool CheckHandler::is_compiled() {
  run_.refresh_scene();
  follow_scene();
  if (!run_.compile_progress()) return true;
  messages_.tell_error("The level is still being compiled: try again when that is done.");
  return false;
}

const std::vector<Problem>& CheckHandler::problems() {
  const Level& level = linted();
  lint_cache_.finish(level, lint_options_, ground_names_);
  return lint_cache_.problems();
}

const Level& CheckHandler::linted() {
  if (has_plain_ground(open_.level)) {
    if (ground_) {
      lint_cache_.note_map();
      lint_cache_.note_rest();
    }
    ground_.reset();
    ground_names_ = {};
    noted_cells_.clear();
    return open_.level;
  }
  for (const Cell cell : std::exchange(noted_cells_, {}))
    if (ground_ && !update_cell(open_.level, cell, *ground_)) ground_.reset();
  if (!ground_) {
    ground_ = linted_level(open_.level, &ground_names_);
    lint_cache_.note_map();
    lint_cache_.note_rest();
  }
  return *ground_;
}

// The level is not edited yet when an edit is noted, so its cells are taken later.
void CheckHandler::note_ground(const Edit& edit) {
  const bool are_cells = std::all_of(edit.changes.begin(), edit.changes.end(), [](const Change& change) {
    return std::holds_alternative<CellChange>(change);
  });
  if (!are_cells) ground_.reset();
  for (const Change& change : edit.changes)
    if (const auto* cell = std::get_if<CellChange>(&change)) noted_cells_.push_back(cell->cell);
}

void CheckHandler::note_edit(const Edit& edit) {
  note_ground(edit);
  for (const Change& change : edit.changes) {
    if (const auto* cell = std::get_if<CellChange>(&change)) {
      lint_cache_.note_cell(cell->cell);
    } else if (std::holds_alternative<MapChange>(change)) {
      lint_cache_.note_map();
    } else {
      lint_cache_.note_rest();
    }
  }
}

void CheckHandler::forget_level() {
  ground_.reset();
  lint_cache_.note_map();
  reach_.forget();
  prover_.forget();
}

void CheckHandler::follow_scene() {
  if (std::exchange(scene_, run_.scenes()) == run_.scenes()) return;
  reach_.note_change();
  prover_.note_change();
}

void CheckHandler::advance() {
  lint_some();
  follow_scene();
  reach_.advance(kReachSeconds);
  const bool may_prove = !run_.compile_progress();
  if (const auto problem = prover_.advance(may_prove ? &open_.level : nullptr))
    messages_.tell_error(*problem);
}

void CheckHandler::lint_some() {
  const Stopwatch watch;
  const Level& level = linted();
  lint_cache_.advance(
      level, lint_options_, [&] { return watch.seconds() < kLintSeconds; }, ground_names_);
}

}  // namespace talus
