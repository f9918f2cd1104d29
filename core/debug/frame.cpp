#include "frame.h"

#include <cassert>

#include <talus/level/ground.h>

namespace talus {

std::shared_ptr<const Terrain> measured_ground(const Scene& scene, const Level& level) {
  return scene.ground ? scene.ground : std::make_shared<const Terrain>(terrain_of(level));
}

FrameHistory::FrameHistory(int before) : ring_(static_cast<std::size_t>(before) + 1) {}

void FrameHistory::clear() { count_ = 0; }

Frame& FrameHistory::next() {
  newest_ = (newest_ + 1) % ring_.size();
  count_ = std::min(count_ + 1, ring_.size());
  return ring_[newest_];
}

void FrameHistory::go_to(const FrameSource& source, std::int64_t frame) {
  while (!approach(source, frame)) {
  }
}

bool FrameHistory::approach(const FrameSource& source, std::int64_t frame) {
  const auto before = static_cast<std::int64_t>(ring_.size()) - 1;
  const std::int64_t first = std::max<std::int64_t>(frame - before, 0);
  const std::int64_t newest = count_ > 0 ? ring_[newest_].state.frame : -1;
  const bool leads_there = count_ > 0 && newest >= first - 1 && newest < frame;
  if (!leads_there) clear();
  const std::int64_t read = leads_there ? newest + 1 : first;
  if (!source.approach(read)) return false;
  source.read(read, next());
  return read == frame;
}

FrameView FrameHistory::view() const {
  assert(count_ > 0);
  std::vector<const Frame*> frames(count_);
  for (std::size_t back = 0; back < count_; ++back)
    frames[back] = &ring_[(newest_ + ring_.size() - back) % ring_.size()];
  return FrameView(std::move(frames));
}

}  // namespace talus
