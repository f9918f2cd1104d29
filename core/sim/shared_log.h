// SharedLog: a list with one entry for each frame. Copies share equal parts.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace talus {

// Copying takes time and memory by the number of chunks. A changed copy gets its own versions of the changed
// chunks. For one thread.
template <class T>
class SharedLog {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return (*chunks_[i / kChunk])[i % kChunk];
  }
  const T& back() const { return (*this)[size_ - 1]; }

  void push_back(const T& entry) {
    if (size_ % kChunk == 0) chunks_.push_back(std::make_shared<Chunk>());
    own(size_).push_back(entry);
    ++size_;
  }
  void set(std::size_t i, const T& entry) {
    assert(i < size_);
    own(i)[i % kChunk] = entry;
  }
  // Keeps at most the first `count` entries.
  void cut(std::size_t count) {
    if (count >= size_) return;
    size_ = count;
    chunks_.resize((size_ + kChunk - 1) / kChunk);
    if (size_ % kChunk != 0) own(size_).resize(size_ % kChunk);
  }

  // Index of the first entry that differs, within the length of both.
  std::optional<std::size_t> first_difference(const SharedLog& other) const {
    const std::size_t both = std::min(size_, other.size_);
    for (std::size_t begin = 0; begin < both; begin += kChunk) {
      const Chunk &a = *chunks_[begin / kChunk], &b = *other.chunks_[begin / kChunk];
      if (&a == &b) continue;
      const auto end = a.begin() + static_cast<std::ptrdiff_t>(std::min(kChunk, both - begin));
      const auto differs = std::mismatch(a.begin(), end, b.begin()).first;
      if (differs != end) return begin + static_cast<std::size_t>(differs - a.begin());
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kChunk = 1024;
  using Chunk = std::vector<T>;

  // The chunk of an entry, not shared.
  Chunk& own(std::size_t i) {
    std::shared_ptr<Chunk>& chunk = chunks_[i / kChunk];
    if (chunk.use_count() > 1) chunk = std::make_shared<Chunk>(*chunk);
    return *chunk;
  }

  std::vector<std::shared_ptr<Chunk>> chunks_;  // all are full except the last
  std::size_t size_ = 0;
};

}  // namespace talus
