#include "bounded_system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace talus {
namespace {

// A number whose row of A is so near to a sum of the free rows is no new direction.
constexpr double kDependent = 1e-13;
// What is left of a slope by rounding, as a share of what it is made of.
constexpr double kNoise = 1e-14;

}  // namespace

std::int64_t BoundedSystem::take_work() {
  constexpr std::int64_t kInAUnit = 16;  // multiplications in about 20 ns
  return std::exchange(work_, 0) / kInAUnit;
}

void BoundedSystem::begin(std::size_t size) {
  size_ = size;
  work_ += static_cast<std::int64_t>(size * size);  // for filling A and looking through it
  a_.assign(size * size, 0);
  for (auto* numbers : {&b_, &low_, &high_, &x_, &slope_}) numbers->assign(size, 0);
  is_free_.assign(size, 0);
  is_barred_.assign(size, 0);
  lower_.assign(size * size, 0);
  first_.assign(size, 0);
  near_begin_.clear();
  free_.clear();
  factored_ = 0;
}

void BoundedSystem::bound(std::size_t row, double low, double high) {
  assert(low <= high);
  low_[row] = low;
  high_[row] = high;
  x_[row] = std::clamp(x_[row], low, high);
}

void BoundedSystem::index() {
  if (!near_begin_.empty()) return;
  near_.clear();
  near_begin_.reserve(size_ + 1);
  near_begin_.push_back(0);
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t k = 0; k < size_; ++k) {
      if (a_[i * size_ + k] != 0) near_.push_back(k);
    }
    near_begin_.push_back(near_.size());
  }
}

bool BoundedSystem::solve() {
  index();
  std::fill(is_free_.begin(), is_free_.end(), 0);
  free_.clear();
  factored_ = 0;
  return solve_on();
}

// Goes on with the numbers that are free, which is quicker where only b has changed a little.
bool BoundedSystem::solve_on() {
  std::fill(is_barred_.begin(), is_barred_.end(), 0);
  // Most contacts press: all that would are tried at once, and then those that are left, the worst first.
  for (std::size_t i = 0; i < size_; ++i) {
    if (!is_free_[i] && pull_on(i) > 0) release(i);
  }
  const auto lift_bars = [&] { std::fill(is_barred_.begin(), is_barred_.end(), 0); };
  if (!free_.empty() && go(false)) lift_bars();
  for (std::size_t tries = 0; tries < 16 * size_ + 16; ++tries) {
    std::size_t worst = size_;
    double most = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (is_free_[i] || is_barred_[i]) continue;
      if (const double pull = pull_on(i); pull > most) {
        most = pull;
        worst = i;
      }
    }
    if (worst == size_) return true;
    release(worst);
    if (go(true)) lift_bars();
  }
  return false;
}

// With a little of x'x added the answer is unique. What that takes from it is put back in each turn; what no
// other number knows of stays as it is (Tikhonov's regularisation, iterated).
bool BoundedSystem::solve_evenly() {
  constexpr double kShare = 1e-5, kSame = 1e-14;
  constexpr int kMaxTurns = 8;
  if (has_one_answer()) return solve();
  double largest = 0;
  for (std::size_t i = 0; i < size_; ++i) largest = std::max(largest, a(i, i));
  const double more = kShare * largest;
  const std::vector<double> whole = b_, diagonal = [&] {
    std::vector<double> values(size_);
    for (std::size_t i = 0; i < size_; ++i) values[i] = a(i, i);
    return values;
  }();
  for (std::size_t i = 0; i < size_; ++i) a(i, i) += more;
  for (int turn = 0; turn < kMaxTurns; ++turn) {
    const std::vector<double> last = x_;
    for (std::size_t i = 0; i < size_; ++i) b_[i] = whole[i] - more * x_[i];
    turn == 0 ? solve() : solve_on();
    double change = 0, scale = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      change = std::max(change, std::abs(x_[i] - last[i]));
      scale = std::max(scale, std::abs(x_[i]));
    }
    if (change <= kSame * scale) break;
  }
  for (std::size_t i = 0; i < size_; ++i) {
    a(i, i) = diagonal[i];
    b_[i] = whole[i];
  }
  return solve();
}

// Whether the rows of A are directions of their own, not nearly sums of others.
bool BoundedSystem::has_one_answer() {
  constexpr double kOwn = 1e-6;
  free_.resize(size_);
  std::iota(free_.begin(), free_.end(), std::size_t{0});
  factored_ = 0;
  return extend(kOwn);
}

// How far from its best a number is that rests, as the slope at it; 0 if a bound or rounding keeps it there.
double BoundedSystem::pull_on(std::size_t row) {
  work_ += static_cast<std::int64_t>(near(row).size());
  double slope = b_[row], scale = std::abs(b_[row]);
  for (const std::size_t k : near(row)) {
    const double part = a_[row * size_ + k] * x_[k];
    slope += part;
    scale += std::abs(part);
  }
  slope_[row] = slope;
  if (std::abs(slope) <= kNoise * scale) return 0;
  return (slope < 0 ? x_[row] < high_[row] : x_[row] > low_[row]) ? std::abs(slope) : 0;
}

void BoundedSystem::release(std::size_t row) {
  is_free_[row] = 1;
  free_.push_back(row);
}

void BoundedSystem::hold(std::size_t at) {
  is_free_[free_[at]] = 0;
  free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(at));
  factored_ = std::min(factored_, at);
}

// Factors the rows of the free numbers that are new. Returns false at the first whose row is no new
// direction: less of it is left than this share.
bool BoundedSystem::extend(double least) {
  for (; factored_ < free_.size(); ++factored_) {
    const std::size_t i = free_[factored_];
    double* const row = &lower_[factored_ * size_];
    std::size_t first = 0;
    while (first < factored_ && a_[i * size_ + free_[first]] == 0) ++first;
    first_[factored_] = first;
    const std::size_t width = factored_ - first;
    work_ += static_cast<std::int64_t>(first / 8 + width * width / 2);
    double rest = a_[i * size_ + i];
    for (std::size_t k = first; k < factored_; ++k) {
      double sum = a_[i * size_ + free_[k]];
      const double* const other = &lower_[k * size_];
      for (std::size_t j = std::max(first, first_[k]); j < k; ++j) sum -= row[j] * other[j];
      row[k] = sum / other[k];
      rest -= row[k] * row[k];
    }
    if (!(rest > least * a_[i * size_ + i])) return false;
    row[factored_] = std::sqrt(rest);
  }
  return true;
}

// Where the free numbers want to be.
void BoundedSystem::aim() {
  const std::size_t count = free_.size();
  goal_.assign(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    double sum = -b_[free_[k]];
    for (const std::size_t j : near(free_[k])) {
      if (!is_free_[j]) sum -= a_[free_[k] * size_ + j] * x_[j];
    }
    const double* const row = &lower_[k * size_];
    for (std::size_t j = first_[k]; j < k; ++j) sum -= row[j] * goal_[j];
    goal_[k] = sum / row[k];
    work_ += static_cast<std::int64_t>(near(free_[k]).size() + 2 * (k - first_[k]));
  }
  for (std::size_t k = count; k-- > 0;) {
    const double* const row = &lower_[k * size_];
    goal_[k] /= row[k];
    for (std::size_t j = first_[k]; j < k; ++j) goal_[j] -= row[j] * goal_[k];
  }
}

// Takes the free numbers to where they want to be. One that comes to a bound on the way rests there. Returns
// whether they moved. is_one: only the newest one is new; if it does not move as it should, it is barred
// until others have moved.
bool BoundedSystem::go(bool is_one) {
  const std::size_t newest = free_.back();
  const double wanted = slope_[newest] < 0 ? 1 : -1;
  bool has_moved = false;
  while (!free_.empty()) {
    if (!extend(kDependent)) {
      is_barred_[free_[factored_]] = 1;
      hold(factored_);
      continue;
    }
    aim();
    if (is_one && !has_moved && free_.back() == newest && !((goal_.back() - x_[newest]) * wanted > 0)) {
      is_barred_[newest] = 1;
      hold(free_.size() - 1);
      return false;
    }
    double share = 1;
    std::size_t first = free_.size();
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const std::size_t i = free_[k];
      if (goal_[k] >= low_[i] && goal_[k] <= high_[i]) continue;
      const double limit = goal_[k] < low_[i] ? low_[i] : high_[i];
      const double part = std::max(0.0, (limit - x_[i]) / (goal_[k] - x_[i]));
      if (first < free_.size() && part >= share) continue;
      share = std::min(part, 1.0);
      first = k;
    }
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const std::size_t i = free_[k];
      const double before = x_[i];
      x_[i] = first == free_.size() ? goal_[k]
                                    : std::clamp(before + share * (goal_[k] - before), low_[i], high_[i]);
      has_moved = has_moved || x_[i] != before;
    }
    if (first == free_.size()) return has_moved;
    const std::size_t i = free_[first];
    x_[i] = goal_[first] < low_[i] ? low_[i] : high_[i];
    hold(first);
  }
  return has_moved;
}

}  // namespace talus
