// The reference for bodies that meet: boxes that fly straight in a room of fixed boxes, from one contact to
// the next, in rational numbers, and no code of the core. Nothing pulls them, and nothing rubs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "exact_ground.h"

namespace talus::reference {

class ExactBoxes {
 public:
  using Axes = std::array<Exact, 2>;  // x, y
  struct Box {
    Axes size, place, velocity = {};  // px, px, px/frame
    Exact inverse_mass = 0;           // 0: nothing moves it
  };
  // What a step has come to. The world stays where the step could not go on.
  enum class Result {
    done,
    close_call,    // a rounding of a double decides what meets, or what meets first
    large_set,     // too many contacts that push one another at one time, or boxes that touch one another
    endless,       // reflections at one time hardly end: boxes without room between walls
    many_impacts,  // more in a frame than the core promises to follow
  };

  std::vector<Box> boxes;
  Axes bounce = {1, 1};  // of boxes side by side, and above one another

  // One frame.
  Result step();
  // Whether an impact is so near the end of the last frame that a rounding decides in which frame it is.
  bool ends_at_impact() const { return ends_at_impact_; }
  // Sets that were reflected since the last call.
  std::size_t take_impacts() { return std::exchange(impacts_, 0); }
  // The most contacts so far that were reflected at once.
  std::size_t largest_set() const { return largest_; }

 private:
  struct Meeting {
    Exact time;  // frames from now
    bool is_close = false;
  };
  struct Touch {
    std::size_t a, b;
    int axis;
    int side;  // 1: a is behind b on the axis, -1: before it
  };
  struct Span {
    double low[2], high[2];
  };

  bool is_doubtful(const Box& a, const Box& b, int across) const;
  std::optional<Meeting> meeting(const Box& a, const Box& b, const Exact& within) const;
  std::optional<Meeting> first_meeting(const Exact& within) const;
  std::vector<Span> spans(double time) const;
  template <class Visit>
  void for_near(double time, Visit visit) const;
  void fly(const Exact& time);
  bool comes_to_corner(const Box& a, const Box& b) const;
  Result meet();
  Result reflect(const std::vector<Touch>& touches, std::vector<char>& is_hit);
  std::vector<Touch> take_set(std::vector<Touch>& left) const;
  bool push(const std::vector<Touch>& set);
  std::size_t largest_pile(const std::vector<Touch>& touches, const std::vector<char>& is_hit) const;
  bool is_close(const std::vector<char>& is_hit) const;
  Exact speed(const Touch& touch) const;

  std::size_t impacts_ = 0, largest_ = 0;
  bool ends_at_impact_ = false;
};

}  // namespace talus::reference
