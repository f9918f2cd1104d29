// The interface for C: each function checks what it is given, and lets no exception through.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <utility>

#include <talus/c/talus.h>
#include <talus/formats/format.h>
#include <talus/level/ground.h>
#include <talus/sim/solver.h>
#include "../collision/ground_queries.h"
#include "../formats/files/atomic_file.h"
#include "../formats/last_catch.h"
#include "../formats/native/hard_case_file.h"
#include "../sim/case_input.h"

// The numbers of kinds in C.
static_assert(static_cast<int>(talus::StepEvent::Kind::hit) == TALUS_EVENT_HIT &&
              static_cast<int>(talus::StepEvent::Kind::landed) == TALUS_EVENT_LANDED &&
              static_cast<int>(talus::StepEvent::Kind::left) == TALUS_EVENT_LEFT);

struct talus_game {
  talus::Level level;
  std::vector<talus::CaseInput> script;  // of a hard case
  std::shared_ptr<const talus::Scene> scene;
  std::unique_ptr<talus::Solver> solver;
  talus::State state;
  talus::State next;                             // storage of talus_step
  talus::StepRecord record;                      // of the last step; its events alone
  talus::StepRecord next_record;                 // storage of talus_step
  std::shared_ptr<const talus::Terrain> ground;  // of queries; null until the first query
};

namespace talus {
namespace {

// Returns the result of the function, or `otherwise` if it throws. It throws only if memory runs out.
template <class Result, class Function>
Result guarded(Result otherwise, Function function) {
  try {
    return function();
  } catch (...) {
    return otherwise;
  }
}

void tell(const char* text, char* error, std::size_t error_size) {
  if (error == nullptr || error_size == 0) return;
  const std::size_t length = std::min(std::strlen(text), error_size - 1);
  std::memcpy(error, text, length);
  error[length] = '\0';
}

FormatResult<std::unique_ptr<talus_game>> game_of(FormatResult<LoadedLevel> loaded) {
  if (!loaded) return tl::unexpected(loaded.error());
  auto game = std::make_unique<talus_game>();
  game->level = std::move(loaded->level);
  const auto hard = hard_case_of(game->level);
  if (!hard) return tl::unexpected(hard.error());
  if (*hard) game->script = (*hard)->input;
  if (const auto problem = ground_problem(game->level))
    return tl::unexpected(FormatError{"", "the level " + *problem});
  game->scene = std::make_shared<const Scene>(compile_scene(game->level));
  game->solver = make_solver(game->scene);
  game->state = initial_state(*game->scene);
  game->record.only_events = game->next_record.only_events = true;
  return game;
}

// load: returns the level of that name.
template <class Load>
talus_game* opened(const char* name, char* error, std::size_t error_size, Load load) {
  tell("", error, error_size);
  try {
    auto game = read_guarded([&] { return game_of(load()); });
    if (game) return game->release();
    tell(to_string(game.error(), name).c_str(), error, error_size);
  } catch (...) {  // the text of the error did not fit in memory either
    tell("error: there is not enough memory", error, error_size);
  }
  return nullptr;
}

// Limit for the coordinates of a query, px.
constexpr double kFarthest = 1e12;

bool are_near(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](double number) { return std::abs(number) <= kFarthest; });  // false for no number
}

bool are_finite(std::initializer_list<double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

const Terrain& queried_ground(talus_game& game) {
  if (!game.ground) game.ground = game.scene->ground;
  if (!game.ground) game.ground = std::make_shared<const Terrain>(terrain_of(game.level));
  return *game.ground;
}

Input input_of_call(std::uint32_t keys, Vec2 mouse, bool mouse_down) {
  Input input;
  if (are_finite({mouse.x, mouse.y})) {
    input.mouse = mouse;
    input.mouse_down = mouse_down;
  }
  input.left = (keys & TALUS_LEFT) != 0;
  input.right = (keys & TALUS_RIGHT) != 0;
  input.jump = (keys & TALUS_JUMP) != 0;
  return input;
}

}  // namespace
}  // namespace talus

talus_game* talus_open(const char* path, char* error, size_t error_size) {
  using namespace talus;
  if (path == nullptr) {
    tell("error: the path is null", error, error_size);
    return nullptr;
  }
  return opened(path, error, error_size, [path] { return load_level(path, {.outside = {"/"}}); });
}

talus_game* talus_read(const void* bytes, size_t size, const char* name, char* error, size_t error_size) {
  using namespace talus;
  if (bytes == nullptr && size != 0) {
    tell("error: the bytes are null", error, error_size);
    return nullptr;
  }
  const char* shown = name == nullptr ? "level" : name;
  return opened(shown, error, error_size, [&]() -> FormatResult<LoadedLevel> {
    if (size > kMaxFileBytes) return tl::unexpected(too_large_file(kMaxFileBytes));
    const std::string_view content =
        size == 0 ? std::string_view() : std::string_view(static_cast<const char*>(bytes), size);
    return read_level(content, {name == nullptr ? "" : context_for_file(name).extension});
  });
}

void talus_close(talus_game* game) { delete game; }

int talus_step(talus_game* game, uint32_t keys, double mouse_x, double mouse_y, int mouse_down) {
  using namespace talus;
  if (game == nullptr) return 0;
  return guarded(0, [&] {
    game->next = game->state;
    const Input given = input_of_call(keys, {mouse_x, mouse_y}, mouse_down != 0);
    game->solver->step(game->next, added(case_input(game->script, game->next.frame + 1), given),
                       &game->next_record);
    std::swap(game->state, game->next);
    std::swap(game->record, game->next_record);
    return 1;
  });
}

int talus_restart(talus_game* game) {
  if (game == nullptr) return 0;
  return talus::guarded(0, [&] {
    game->state = talus::initial_state(*game->scene);
    game->record.clear();
    return 1;
  });
}

int64_t talus_frame(const talus_game* game) { return game == nullptr ? -1 : game->state.frame; }

int32_t talus_tile_width(const talus_game* game) {
  return game == nullptr ? 0 : game->scene->tile_size.width;
}
int32_t talus_tile_height(const talus_game* game) {
  return game == nullptr ? 0 : game->scene->tile_size.height;
}

int32_t talus_body_count(const talus_game* game) {
  return game == nullptr ? 0 : static_cast<int32_t>(game->state.bodies.size());
}

int talus_body_at(const talus_game* game, int32_t index, talus_body* body) {
  if (body == nullptr || index < 0 || index >= talus_body_count(game)) return 0;
  const talus::State& state = game->state;
  const talus::Body& found = state.bodies[static_cast<std::size_t>(index)];
  const talus::Vec2 size{found.box.w, found.box.h};
  *body = {.id = found.id,
           .kind = static_cast<int32_t>(found.kind),
           .is_grounded = found.gait.grounded ? 1 : 0,
           .is_held = state.grabbed == found.id ? 1 : 0,
           .x = found.box.x,
           .y = found.box.y,
           .w = found.box.w,
           .h = found.box.h,
           .vx = found.velocity.x,
           .vy = found.velocity.y,
           .mass = talus::mass_of(found.kind, size),
           .radius = talus::radius_of(found.kind, size),
           .spin = found.spin,
           .turn = found.turn};
  return 1;
}

int32_t talus_event_count(const talus_game* game) {
  return game == nullptr ? 0 : static_cast<int32_t>(game->record.events.size());
}

int talus_event_at(const talus_game* game, int32_t index, talus_event* event) {
  if (event == nullptr || index < 0 || index >= talus_event_count(game)) return 0;
  const talus::StepEvent& found = game->record.events[static_cast<std::size_t>(index)];
  *event = {.kind = static_cast<int32_t>(found.kind),
            .body = found.body,
            .other = found.other,
            .nx = found.normal.x,
            .ny = found.normal.y,
            .impulse = found.impulse};
  return 1;
}

const char* talus_kind_word(int32_t kind) {
  const auto kinds = talus::body_kinds();
  const bool is_known = kind >= 0 && static_cast<std::size_t>(kind) < kinds.size();
  return is_known ? kinds[static_cast<std::size_t>(kind)].word.data() : nullptr;
}

uint64_t talus_hash(const talus_game* game) { return game == nullptr ? 0 : talus::state_hash(game->state); }

int talus_floor(talus_game* game, double x, double y, double w, double h, double reach, double* floor_y) {
  using namespace talus;
  const bool usable =
      are_near({x, y, w, h, reach}) && w > 0 && h > 0 && w <= kMaxBodySize && h <= kMaxBodySize && reach >= 0;
  if (game == nullptr || !usable) return 0;
  return guarded(0, [&] {
    const auto floor = floor_below(queried_ground(*game), {x, y, w, h}, reach);
    if (!floor) return 0;
    if (floor_y != nullptr) *floor_y = floor->y;
    return 1;
  });
}
