// BoundedSystem: the smallest value of x'Ax/2 + b'x with each number of x between two bounds. Sets of
// contacts are such systems: x are their impulses, which push and never pull.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace talus {

// A is symmetric and never makes x'Ax negative; it may be singular, as for a box on two others. Then x is one
// of several answers, but Ax, what the impulses do to the velocities, is the same for all of them.
class BoundedSystem {
 public:
  // Begins a system of so many numbers: A and b are 0, and x is 0 between bounds of 0.
  void begin(std::size_t size);

  std::size_t size() const { return size_; }
  double& a(std::size_t row, std::size_t column) { return a_[row * size_ + column]; }  // both halves of A
  double& b(std::size_t row) { return b_[row]; }
  // Sets the bounds of a number, low <= high (asserted), and brings it between them.
  void bound(std::size_t row, double low, double high);
  double x(std::size_t row) const { return x_[row]; }  // the answer

  // Finds x to the end: it frees one number after the other and solves for those that are free (Lawson and
  // Hanson 1974, "Solving Least Squares Problems", chapter 23, with two bounds). Begins at the current x.
  // Returns false if it stopped at a limit that only rounding can reach; x is between its bounds then, too.
  bool solve();

  // The same, and of several answers the one that shares the load most evenly, whatever the order of the
  // numbers: friction depends on it.
  bool solve_evenly();

  // The work since the last call, in units of about 20 ns.
  std::int64_t take_work();

 private:
  void index();
  bool solve_on();
  std::span<const std::size_t> near(std::size_t row) const {
    return {near_.data() + near_begin_[row], near_.data() + near_begin_[row + 1]};
  }
  void release(std::size_t row);
  void hold(std::size_t at);
  bool extend(double least);
  bool has_one_answer();
  void aim();
  bool go(bool is_one);
  double pull_on(std::size_t row);

  std::size_t size_ = 0;
  std::vector<double> a_, b_, low_, high_, x_;
  // By row, the columns in which A is not 0: a contact knows only those of its own two bodies. Empty: not
  // looked for yet.
  std::vector<std::size_t> near_, near_begin_;
  std::vector<double> slope_;      // Ax + b
  std::vector<std::size_t> free_;  // the numbers that are not at rest at a bound, in the order of `lower_`
  std::vector<char> is_free_, is_barred_;
  std::vector<double> lower_;       // row by row, the Cholesky factor of A for the free numbers
  std::vector<std::size_t> first_;  // by row of it, the first column that is not 0
  std::size_t factored_ = 0;        // its rows
  std::vector<double> goal_;        // of the free numbers
  std::int64_t work_ = 0;           // multiplications
};

}  // namespace talus
