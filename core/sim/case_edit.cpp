#include "case_edit.h"

#include <vector>

namespace talus {
namespace {

void remove_body(int id, State& state) {
  std::erase_if(state.bodies, [&](const Body& body) { return body.id == id; });
  if (state.grabbed == id) state.grabbed = 0;
}

void turn_round(State& state) {
  for (Body& body : state.bodies) {
    body.velocity = body.velocity * -1;
    body.spin = -body.spin;
  }
}

}  // namespace

void make_edits(std::span<const CaseEdit> edits, State& state) {
  for (const CaseEdit& edit : edits) {
    if (edit.frame != state.frame) continue;
    if (edit.remove != 0) remove_body(edit.remove, state);
    if (edit.turns_round) turn_round(state);
  }
}

}  // namespace talus
