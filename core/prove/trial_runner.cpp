#include "trial_runner.h"

#include <algorithm>
#include <cmath>

#include "sim/lone_body.h"

namespace talus {
namespace {

constexpr int kMaxSteps = 240;    // of one trial
constexpr int kJumpHeld = 12;     // frames
constexpr int kLongJump = 60;     // frames; such jumps come as high as a jump can
constexpr int kRollFrames = 24;   // at least, of a body without keys: the floor slows it
constexpr int kStillFrames = 20;  // after so many frames without a motion a body rests
constexpr double kStill = 1e-3;   // px; a smaller motion is none
constexpr int kMaxReach = 16;     // cells; a trial ends further away
constexpr double kLift =
    1.0 / (1 << 20);  // px; bodies start so much above their floor, as its height is rounded
constexpr double kFloatLift = 1.0 / (1 << 21);  // the same for single precision, of the height
constexpr double kIntoEdge = 1.0 / 64;  // px; the cell of an edge is that of the ground so far behind it
constexpr double kPhaseOfPx = 0.37;     // px; one of the places of a body between two pixels
constexpr double kBeyondJoint = 2;      // px; walks end so far behind one
constexpr int kDropRows = 2;            // cells above its floor from which a body is dropped
constexpr int kMaxDropRows = 12;        // the same between steep sides
constexpr double kSlowWay = 1;          // px; the slowest body goes so far, over a joint

int cells_of(double px, int tile) {
  return 1 + static_cast<int>(std::ceil(std::min(px / tile, kMaxReach - 1.0)));
}

Cell cell_at(Vec2 place, const RawGround& ground) {
  const TileSize tile = ground.tile_size();
  const auto cell = [](double px, int side, int cells) {
    return static_cast<int>(std::clamp(std::floor(px / side), 0.0, cells - 1.0));
  };
  return {cell(place.x, tile.width, ground.columns()), cell(place.y, tile.height, ground.rows())};
}

Vec2 foot_of(const Rect& box) { return {box.x + box.w / 2, box.bottom()}; }

// Ground ends at the sides of the map, wherever the shapes of its tiles reach.
bool meets_ground_above_map(const FineBox& box, const RawGround& ground) {
  return box.y0 < 0 &&
         !ground.for_parts(box, [](const RawPart& part) { return std::min(part.top.y0, part.top.y1) >= 0; });
}

bool leaves_map(const Rect& box, const RawGround& ground) {
  const TileSize tile = ground.tile_size();
  return box.x < 0 || box.right() > 1.0 * ground.columns() * tile.width || box.bottom() < 0 ||
         box.bottom() > 1.0 * ground.rows() * tile.height;
}

Trial start_at(const ProveBody& body, const Rect& box) {
  Trial trial;
  trial.body.id = 1;
  trial.body.origin.spawn = kLoneSpawn;
  trial.body.box = box;
  trial.body.previous = box.position();
  trial.body.kind = body.kind;
  trial.body.foot = body.foot;
  return trial;
}

bool has_moved(const Body& before, const Body& after) {
  return std::abs(after.box.x - before.box.x) + std::abs(after.box.y - before.box.y) >= kStill;
}

// Whether a trial of such a body is steered by keys: the other solvers move players as balls.
bool is_steered(BodyKind kind, SolverKind solver) {
  return traits_of(kind).takes_keys && solver == SolverKind::exact;
}

}  // namespace

// The slowest walks begin beside a joint at a side of a cell, and in a cell's middle, where shapes have
// joints. Steps of fractions of a pixel come to many places between two pixels, so slower walks begin at two.
const std::array<TrialRunner::Start, 5> TrialRunner::kStarts = {{
    {.walks = true, .walks_slower = true, .from_rest = true, .jumps = true, .drops = true},
    {.px = kPhaseOfPx, .walks = true, .jumps = true, .drops = true, .slowest = -1},
    {.share = 0.5, .walks = true, .jumps_onto_sides = true},
    {.share = 0.5, .px = 2 * kPhaseOfPx, .walks = true, .walks_slower = true, .drops = true, .slowest = -1},
    {.share = 1, .px = -kPhaseOfPx, .slowest = 1},
}};

void ProveCounts::add(const ProveCounts& other) {
  places += other.places;
  alike += other.alike;
  trials += other.trials;
  steps += other.steps;
}

TrialRunner::TrialRunner(const ProveScene& scene)
    : scene_(scene), is_single_(scene.speeds().front().scene->single_ground != nullptr) {
  for (const ProveScene::Speed& speed : scene.speeds()) solvers_.push_back(make_solver(speed.scene));
  if (scene.meeting() != nullptr) meeting_ = make_solver(scene.meeting());
}

BlockProof TrialRunner::prove(int block) {
  proof_ = {};
  found_.clear();
  surroundings_.clear();
  const Cell first = scene_.first_cell(block);
  const int last_x = std::min(first.x + kProveBlock, scene_.ground().columns());
  const int last_y = std::min(first.y + kProveBlock, scene_.ground().rows());
  for (int y = first.y; y < last_y; ++y) {
    for (int x = first.x; x < last_x; ++x) {
      for (std::size_t body = 0; body < scene_.bodies().size(); ++body) try_cell({x, y}, body);
    }
  }
  return std::move(proof_);
}

double TrialRunner::held(double px) const {
  return is_single_ ? static_cast<double>(static_cast<float>(px)) : px;
}

TrialRunner::Reach TrialRunner::reach_of(const ProveBody& body) const {
  const TileSize tile = scene_.ground().tile_size();
  const Tuning& tuning = scene_.speeds().front().scene->tuning;
  const PlayerTuning& player = tuning.player;
  const double jump = player.gravity > 0 ? player.jump_speed * player.jump_speed / (2 * player.gravity) : 0;
  return {cells_of(2.0 * tile.width + body.size.x, tile.width), cells_of(jump + body.size.y, tile.height), 3};
}

// Places whose surroundings are the same have the same findings. Lines that are free of the grid are no part
// of that comparison, so cells near one have none.
std::string TrialRunner::surroundings_of(Cell cell, std::size_t body) const {
  const RawGround& ground = scene_.ground();
  const Reach reach = reach_of(scene_.bodies()[body]);
  const TileSize tile = ground.tile_size();
  const Rect area{1.0 * (cell.x - reach.columns) * tile.width, 1.0 * (cell.y - reach.up) * tile.height,
                  (2.0 * reach.columns + 1) * tile.width, (1.0 + reach.up + reach.down) * tile.height};
  if (ground.has_curve_in(fine_box(area))) return {};
  std::string around(1, static_cast<char>(body));
  for (int y = cell.y - reach.up; y <= cell.y + reach.down; ++y) {
    for (int x = cell.x - reach.columns; x <= cell.x + reach.columns; ++x) {
      const TileNumber number = ground.number_at({x, y});
      around.push_back(static_cast<char>(number & 255));
      around.push_back(static_cast<char>(number >> 8));
    }
  }
  return around;
}

// The tops of the ground that are in a cell, at an x.
std::vector<TrialRunner::Top> TrialRunner::tops_at(Cell cell, double x) const {
  const TileSize tile = scene_.ground().tile_size();
  const double steepest = scene_.speeds().front().scene->tuning.exact.steepest;
  const Fine at = fine(x), top = fine(1.0 * cell.y * tile.height),
             bottom = fine((cell.y + 1.0) * tile.height);
  std::vector<Top> tops;
  scene_.ground().for_parts({at, top, at, bottom}, [&](const RawPart& part) {
    const Fine y = part.top.at(at);
    if (part.is_floor() && y >= top && y < bottom)
      tops.push_back({px_of(y), part.top.is_steeper_than(steepest, at)});
    return true;
  });
  std::sort(tops.begin(), tops.end());
  tops.erase(std::unique(tops.begin(), tops.end()), tops.end());
  return tops;
}

void TrialRunner::try_cell(Cell cell, std::size_t body) {
  const int width = scene_.ground().tile_size().width;
  const auto x_of = [&](const Start& start) { return (cell.x + start.share) * width + start.px; };
  std::array<std::vector<Top>, kStarts.size()> tops;
  std::transform(kStarts.begin(), kStarts.end(), tops.begin(),
                 [&](const Start& start) { return tops_at(cell, x_of(start)); });
  const auto is_any = [&](auto is_it) {
    return std::any_of(tops.begin(), tops.end(), [&](const std::vector<Top>& at_start) {
      return std::any_of(at_start.begin(), at_start.end(), is_it);
    });
  };
  if (!is_any([](Top) { return true; })) return;
  std::string around = surroundings_of(cell, body);
  if (const auto known = surroundings_.find(around); known != surroundings_.end()) {
    if (known->second) ++proof_.counts.places, ++proof_.counts.alike;
    return;
  }
  const std::int64_t before = proof_.counts.places;
  for (std::size_t i = 0; i < kStarts.size(); ++i)
    for (const Top top : tops[i]) try_top({cell, body, kStarts[i], {}}, x_of(kStarts[i]), top);
  const bool is_place = proof_.counts.places > before;
  proof_.counts.places = before + (is_place ? 1 : 0);  // a cell counts once
  if (!around.empty()) surroundings_.emplace(std::move(around), is_place);
}

void TrialRunner::try_top(Place place, double x, Top top) {
  const ProveBody& tried = scene_.bodies()[place.body];
  const ProveScene::Speed& speed = scene_.speeds().front();
  if (scene_.meets(tried.kind)) return try_meeting(place, x, top);
  place.box = {held(x - tried.size.x / 2), top.y - tried.size.y, tried.size.x, tried.size.y};
  if (top.is_steep) return drop(place, nullptr);
  const double rise = tried.foot == Foot::box ? tried.size.x / 2 * speed.scene->tuning.exact.steepest : 0;
  const auto y =
      speed.judge->standing_place(place.box, tried.foot, rise + 1.0 / kWeldParts, 1.0 / kWeldParts);
  if (!y) return;
  place.box.y = held(*y - (is_single_ ? std::max(kLift, *y * kFloatLift) : kLift));
  ++proof_.counts.places;
  try_place(place);
}

// A body that meets others rolls from where it stands, and is dropped and thrown from above.
void TrialRunner::try_meeting(Place place, double x, Top top) {
  const ProveBody& tried = scene_.bodies()[place.body];
  const MeetJudge& judge = scene_.meet_judge();
  const Rect lowest{x - tried.size.x / 2, top.y - tried.size.y, tried.size.x, tried.size.y};
  const auto standing = judge.standing_place(tried.kind, lowest, tried.size.x);
  if (!standing) return;
  ++proof_.counts.places;
  const auto start = [&](const Rect& box, double speed) {
    Trial trial = start_at(tried, box);
    trial.speed = std::abs(speed);
    trial.direction = speed < 0 ? -1 : speed > 0 ? 1 : 0;
    trial.body.velocity.x = speed;
    trial.frames = kMaxSteps;
    run(trial, place, 0);
  };
  const double fast = tried.speed, slow = fast * scene_.speeds().back().share;
  if (place.start.walks)
    for (const double speed : {fast, -fast}) start(*standing, speed);
  if (place.start.slowest != 0) start(*standing, place.start.slowest * slow);
  if (!place.start.drops) return;
  Rect above = *standing;
  above.y -= kDropRows * scene_.ground().tile_size().height + kPhaseOfPx;
  if (!judge.is_clear(tried.kind, above)) above = *standing;
  for (const double speed : {0.0, fast, -fast}) start(above, speed);
}

void TrialRunner::try_place(const Place& place) {
  const ProveBody& body = scene_.bodies()[place.body];
  Trial standing = start_at(body, place.box);
  const bool stands = stand(standing.body);
  if (stands) walk_from(place, standing);
  drop(place, stands ? &standing.body : nullptr);
  if (!stands || !is_steered(body.kind, scene_.solver())) return;
  if (place.start.jumps)
    for (const int direction : {0, 1, -1}) jump(place, standing, {.direction = direction, .held = kJumpHeld});
  if (place.start.jumps_onto_sides)
    for (const int direction : {1, -1})
      jump(place, standing, {.direction = direction, .run_from = kJumpHeld, .held = kLongJump});
}

void TrialRunner::walk_from(const Place& place, const Trial& standing) {
  const std::size_t slowest = solvers_.size() - 1;
  const Start& start = place.start;
  if (start.slowest != 0) walk(place, standing, slowest, start.slowest, false);
  for (const int direction : {1, -1}) {
    if (start.walks) walk(place, standing, 0, direction, false);
    if (start.walks_slower) walk(place, standing, 1, direction, false);
    if (start.from_rest && is_steered(standing.body.kind, scene_.solver()))
      walk(place, standing, 0, direction, true);
  }
}

// Puts a body on the floor just below, as the solver exact puts players on it. Returns whether it stands
// there.
bool TrialRunner::stand(Body& body) {
  if (scene_.solver() != SolverKind::exact) return true;
  state_ = {.frame = 0, .bodies = {body}, .grabbed = 0, .next_id = 2};
  Body& standing = state_.bodies.front();
  standing.kind = BodyKind::player;
  standing.gait.grounded = true;
  solvers_.front()->step(state_, {});
  ++proof_.counts.steps;
  const bool stands = standing.gait.grounded && standing.box.x == body.box.x &&
                      std::abs(standing.box.y - body.box.y) < kStill;
  body.box = standing.box;
  body.is_clear = standing.is_clear;
  body.gait.grounded = traits_of(body.kind).takes_keys;
  return stands;
}

// px, from a start over the next joint at a side of a cell that is not close by.
double TrialRunner::way_past_joint(const Start& start, int direction) const {
  const int width = scene_.ground().tile_size().width;
  const double to_right = (1 - start.share) * width - start.px;
  const double way = direction > 0 ? to_right : width - to_right;
  return (way < width / 4.0 ? way + width : way) + kBeyondJoint;
}

void TrialRunner::walk(const Place& place, Trial trial, std::size_t speed, int direction, bool at_rest) {
  const ProveBody& body = scene_.bodies()[place.body];
  const PlayerTuning& player = scene_.speeds()[speed].scene->tuning.player;
  trial.direction = direction;
  trial.speed =
      is_steered(body.kind, scene_.solver()) ? player.run_speed : body.speed * scene_.speeds()[speed].share;
  if (!at_rest) trial.body.velocity.x = direction * trial.speed;
  const bool is_slowest = speed + 1 == solvers_.size();
  const double way = is_slowest ? kSlowWay : way_past_joint(place.start, direction);
  const int frames = 2 + static_cast<int>(way / std::max(trial.speed, 0.01));
  trial.frames = std::clamp(frames, is_steered(body.kind, scene_.solver()) ? 0 : kRollFrames, kMaxSteps);
  run(trial, place, speed);
}

void TrialRunner::jump(const Place& place, Trial trial, Jump jump) {
  trial.direction = jump.direction;
  trial.run_from = jump.run_from;
  trial.speed = scene_.speeds().front().scene->tuning.player.run_speed;
  trial.jump_frames = jump.held;
  trial.frames = kMaxSteps;
  run(trial, place, 0);
}

// From two cells above the ground, or from one. A body that stands there is dropped from there if there is no
// more room. Between two steep sides, where it cannot stand, it has room further up.
void TrialRunner::drop(const Place& place, const Body* standing) {
  if (!place.start.drops) return;
  const ProveBody& body = scene_.bodies()[place.body];
  const int tile = scene_.ground().tile_size().height;
  Rect box = place.box;
  const auto is_free_above = [&](int rows) {
    box.y = held(place.box.y - (rows * tile + kPhaseOfPx));
    const Judge& judge = *scene_.speeds().front().judge;
    return judge.is_free(box, body.foot, Judge::Corners::in_its_floor) && !judge.touches(box, body.foot);
  };
  int rows = kDropRows;
  while (rows > 0 && !is_free_above(rows)) --rows;
  if (rows == 0 && standing == nullptr) {
    rows = kDropRows + 1;
    while (rows <= kMaxDropRows && !is_free_above(rows)) ++rows;
    if (rows > kMaxDropRows) return;
  }
  Trial trial = start_at(body, rows == 0 ? standing->box : box);
  trial.speed = scene_.speeds().front().scene->tuning.player.run_speed;
  trial.frames = kMaxSteps / 2;
  run(trial, place, 0);
}

void TrialRunner::run(Trial trial, const Place& place, std::size_t speed) {
  ++proof_.counts.trials;
  const auto finding = play(trial, speed, &place);
  if (!finding) return;
  const auto [known, is_new] = found_.try_emplace(
      {finding->cell.y, finding->cell.x, finding->kind, place.body, trial.direction}, proof_.findings.size());
  if (is_new) {
    proof_.findings.push_back(*finding);
  } else {
    add_alike(proof_.findings[known->second], *finding);
  }
}

std::optional<Finding> TrialRunner::play(const Trial& trial) {
  std::size_t speed = 0;
  for (std::size_t i = 0; i < solvers_.size(); ++i)
    if (scene_.speeds()[i].scene->tuning.player.run_speed == trial.speed) speed = i;
  return play(trial, speed, nullptr);
}

void TrialRunner::begin(const Trial& trial) {
  state_ = {.frame = 0, .bodies = {trial.body}, .grabbed = 0, .next_id = 2};
}

bool TrialRunner::is_beyond(const Reach& reach, const Place& place) const {
  const Cell at = cell_at(foot_of(state_.bodies.front().box), scene_.ground());
  return std::abs(at.x - place.cell.x) >= reach.columns || at.y - place.cell.y >= reach.down;
}

Finding TrialRunner::finding_of(const Trial& trial, int frame, const Verdict& verdict) const {
  Finding finding;
  finding.kind = verdict.kind;
  finding.solver = scene_.solver();
  finding.trial = trial;
  finding.frame = frame;
  finding.place = verdict.edge.value_or(foot_of(state_.bodies.front().box));
  finding.cell = cell_at(finding.place + Vec2{verdict.side * kIntoEdge, 0}, scene_.ground());
  finding.amount = verdict.amount;
  if (!record_.contacts.empty()) finding.met = record_.contacts.back().other;
  return finding;
}

std::optional<Finding> TrialRunner::play_meeting(const Trial& trial, const Place* place) {
  const MeetJudge& judge = scene_.meet_judge();
  begin(trial);
  const Body& body = state_.bodies.front();
  const Reach reach = place != nullptr ? reach_of(scene_.bodies()[place->body]) : Reach();
  int still = 0;
  for (int frame = 1; frame <= trial.frames && still < kStillFrames; ++frame) {
    if (leaves_map(body.box, scene_.ground())) break;
    const Body before = body;
    meeting_->step(state_, {}, &record_);
    ++proof_.counts.steps;
    if (meets_ground_above_map(hull(fine_box(before.box), fine_box(body.box)), scene_.ground())) break;
    still = has_moved(before, body) ? 0 : still + 1;
    auto verdict = judge.judge(before, body, record_);
    if (!verdict && still == kStillFrames) verdict = judge.judge_rest(body);
    if (verdict) return finding_of(trial, frame, *verdict);
    if (place != nullptr && is_beyond(reach, *place)) break;
  }
  return std::nullopt;
}

std::optional<Finding> TrialRunner::play(const Trial& trial, std::size_t speed, const Place* place) {
  if (scene_.meets(trial.body.kind)) return play_meeting(trial, place);
  const Judge& judge = *scene_.speeds()[speed].judge;
  begin(trial);
  const Body& body = state_.bodies.front();
  const bool walks = trial.body.gait.grounded && trial.jump_frames == 0;
  const bool takes_keys = is_steered(body.kind, scene_.solver());
  const Reach reach = place != nullptr ? reach_of(scene_.bodies()[place->body]) : Reach();
  int still = 0;
  for (int frame = 1; frame <= trial.frames; ++frame) {
    if (leaves_map(body.box, scene_.ground())) break;
    const Body before = body;
    const bool is_across = judge.is_across_line(body);
    const Input input = input_of(trial, frame);
    solvers_[speed]->step(state_, input, &record_);
    ++proof_.counts.steps;
    if (meets_ground_above_map(hull(fine_box(before.box), fine_box(body.box)), scene_.ground())) break;
    std::optional<Verdict> verdict;
    if (!is_across)
      verdict = judge.judge(before, body, input, record_);
    else if (judge.comes_into_ground(before, body))
      verdict = Verdict{FindingKind::inside};
    still = has_moved(before, body) ? 0 : still + 1;
    const bool has_landed =
        takes_keys && !walks && body.gait.grounded && frame > std::min(trial.jump_frames, kJumpHeld);
    const bool hangs =
        body.gait.grounded ? has_landed && !judge.is_on_floor(body) : takes_keys && still == kStillFrames;
    if (!verdict && hangs && is_wedged(state_, speed)) verdict = Verdict{FindingKind::wedged};
    if (verdict) return finding_of(trial, frame, *verdict);
    if (walks && (!body.gait.grounded || (trial.direction != 0 && body.velocity.x == 0))) break;
    if (has_landed || (!walks && still > kStillFrames)) break;
    if (place != nullptr && is_beyond(reach, *place)) break;
  }
  return std::nullopt;
}

// Whether a player comes back to its place from every jump.
bool TrialRunner::is_wedged(const State& state, std::size_t speed) {
  const Rect start = state.bodies.front().box;
  // A player that does not run comes back from every jump.
  if (!(scene_.speeds()[speed].scene->tuning.player.run_speed > 0)) return false;
  for (const int direction : {0, -1, 1}) {
    Trial keys;
    keys.direction = direction;
    keys.jump_frames = kLongJump;
    State tried = state;
    const Body& body = tried.bodies.front();
    for (int frame = 1; frame <= kMaxSteps; ++frame) {
      solvers_[speed]->step(tried, input_of(keys, frame));
      ++proof_.counts.steps;
      if (frame > kLongJump && body.gait.grounded) break;
    }
    if (std::abs(body.box.x - start.x) + std::abs(body.box.y - start.y) > 1) return false;
  }
  return true;
}

}  // namespace talus
