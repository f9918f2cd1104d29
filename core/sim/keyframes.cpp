// Keyframes and their budget.
#include "keyframes.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace talus {
namespace {

std::size_t bytes_of(const State& state) { return sizeof(State) + state.bodies.size() * sizeof(Body); }

}  // namespace

const Keyframe* Keyframes::before(std::int64_t frame) const {
  const auto next = std::upper_bound(list_.begin(), list_.end(), frame,
                                     [](std::int64_t f, const Keyframe& k) { return f < k.frame; });
  return next == list_.begin() ? nullptr : &*(next - 1);
}

void Keyframes::drop_from(std::int64_t frame) {
  const auto first = std::lower_bound(list_.begin(), list_.end(), frame,
                                      [](const Keyframe& k, std::int64_t f) { return k.frame < f; });
  list_.erase(first, list_.end());
}

void KeyframeStore::offer(Keyframes& keyframes, const State& state, bool is_edit) const {
  const auto fewer = static_cast<std::int64_t>(std::bit_ceil(state.bodies.size() / kBodiesAStep));
  if (state.frame == 0 || (state.frame % std::max(stride_, fewer) != 0 && !is_edit)) return;
  assert(keyframes.list_.empty() || keyframes.list_.back().frame < state.frame);
  *bytes_ += bytes_of(state);
  std::shared_ptr<const State> kept(new State(state), [total = bytes_](const State* old) {
    *total -= bytes_of(*old);
    delete old;
  });
  keyframes.list_.push_back({state.frame, is_edit, std::move(kept)});
}

void KeyframeStore::thin(Keyframes& keyframes, bool keep_edits) const {
  std::erase_if(keyframes.list_,
                [&](const Keyframe& k) { return k.frame % stride_ != 0 && !(k.is_edit && keep_edits); });
}

}  // namespace talus
