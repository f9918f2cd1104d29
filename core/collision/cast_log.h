// Logs that a cast writes into: what it tested, and what it met.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "cast_trace.h"

namespace talus {

// Logs nothing.
struct NoLog {
  // the cells of a row whose bit is set; the int before the bits is the column of bit 0
  void looks_at(int, int, std::uint64_t) {}
  template <class Real>
  void begin(Cell, const Piece<Real>&) {}  // a piece is tested, found in that cell
  void begin(Cell, Facing, int) {}         // the side of so many full tiles is tested, from that cell on
  void meets(double) {}  // the piece or side under test is met at that time, unless another one is met before
  void is_first() {}     // the piece or side under test is the first one met so far
};

// The place of a candidate in a trace; adds the candidate if it is new. A long piece is in several cells, but
// is one candidate.
inline std::size_t place_of(CastTrace& trace, const CastCandidate& candidate) {
  auto& all = trace.candidates;
  const auto same = std::find_if(all.begin(), all.end(), [&](const CastCandidate& c) {
    return c.facing == candidate.facing && c.from == candidate.from && c.to == candidate.to;
  });
  const auto place = static_cast<std::size_t>(same - all.begin());
  if (same == all.end()) all.push_back(candidate);
  return place;
}

// Logs into a trace.
class TraceLog {
 public:
  static constexpr std::size_t kMax =
      1024;  // limit for the cells, and for the candidates, that are kept: nobody would look at more

  explicit TraceLog(const Terrain& terrain, CastTrace& trace) : terrain_(terrain), trace_(trace) {}

  void looks_at(int column, int row, std::uint64_t cells) {
    for (; cells != 0; cells &= cells - 1) {
      const Cell cell{column + std::countr_zero(cells), row};
      const auto& seen = trace_.cells;
      if (seen.size() >= kMax) return;
      const bool is_new = std::find(seen.begin(), seen.end(), cell) == seen.end();
      if (is_new && terrain_.contains(cell)) trace_.cells.push_back(cell);
    }
  }
  void begin(Cell cell, const Piece<double>& piece) {
    add({.cell = cell, .facing = piece.facing, .from = {piece.x0, piece.y0}, .to = {piece.x1, piece.y1}});
  }
  void begin(Cell cell, Facing facing, int count) {
    const bool is_wall = facing == Facing::left || facing == Facing::right;
    const double x = terrain_.x_of(cell.x + (facing == Facing::right ? 1 : 0));
    const double y = terrain_.y_of(cell.y + (facing == Facing::down ? 1 : 0));
    const Vec2 to = is_wall ? Vec2{x, terrain_.y_of(cell.y + 1)} : Vec2{terrain_.x_of(cell.x + count), y};
    add({.cell = cell, .facing = facing, .from = {x, y}, .to = to});
  }
  void meets(double t) {
    if (at_ >= trace_.candidates.size()) return;
    CastCandidate& tested = trace_.candidates[at_];
    tested.t = std::min(tested.t, t);
  }
  void is_first() {
    for (CastCandidate& candidate : trace_.candidates) candidate.is_first = false;
    if (at_ < trace_.candidates.size()) trace_.candidates[at_].is_first = true;
  }

 private:
  void add(const CastCandidate& candidate) {
    at_ = trace_.candidates.size() < kMax ? place_of(trace_, candidate) : kMax;
  }

  const Terrain& terrain_;
  CastTrace& trace_;
  std::size_t at_ = 0;  // index of the candidate under test; kMax if it is not kept
};

// Adds a second cast of the same body; the first contact is that of the cast which met something earlier.
inline void add_trace(CastTrace& trace, CastTrace added) {
  CastTrace& later = added.contact.t < trace.contact.t ? trace : added;
  for (CastCandidate& candidate : later.candidates) candidate.is_first = false;
  for (const Cell cell : added.cells) {
    if (std::find(trace.cells.begin(), trace.cells.end(), cell) == trace.cells.end())
      trace.cells.push_back(cell);
  }
  for (const CastCandidate& candidate : added.candidates) {
    CastCandidate& same = trace.candidates[place_of(trace, candidate)];
    same.t = std::min(same.t, candidate.t);
    same.is_first = same.is_first || candidate.is_first;
  }
}

}  // namespace talus
