// Progress: how much of a long task, such as reading a file or an export, is done. Reports it to a listener,
// who may stop the task.
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace talus {

// Copies and parts report to the same listener. One thread at a time may use them.
class Progress {
 public:
  // Gets the share that is done, 0..1, which never decreases. If it returns false, the task is given up.
  using Listener = std::function<bool(double share)>;

  Progress() = default;  // nobody listens, and nothing stops the task
  // listener: not null.
  explicit Progress(Listener listener) : state_(std::make_shared<State>(std::move(listener))) {}

  // The part of the task from one share to another; its own shares go from 0 to 1.
  Progress part(double from, double to) const {
    Progress part = *this;
    part.from_ = from_ + (to_ - from_) * from;
    part.to_ = from_ + (to_ - from_) * to;
    return part;
  }

  // Call it often: it calls the listener at most a thousand times in all. If it returns false, return at once
  // with the result so far; it then keeps returning false.
  bool at(double share) const {
    if (state_ == nullptr) return true;
    const double now = from_ + (to_ - from_) * share;
    if (state_->stopped || now < state_->next) return !state_->stopped;
    state_->next = now + kStep;
    state_->stopped = !state_->listener(now);
    return !state_->stopped;
  }
  // The same for `done` of `all`, such as bytes; if `all` is 0, everything is done.
  template <class Count>
  bool at(Count done, Count all) const {
    return at(all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all));
  }
  // Whether the listener has stopped the task.
  bool stopped() const { return state_ != nullptr && state_->stopped; }

  // In the form that a TerrainSource takes.
  std::function<bool(double)> function() const {
    if (state_ == nullptr) return nullptr;
    return [progress = *this](double share) { return progress.at(share); };
  }

 private:
  static constexpr double kStep = 0.001;
  struct State {
    explicit State(Listener to) : listener(std::move(to)) {}
    Listener listener;
    double next = 0;  // the next share to report
    bool stopped = false;
  };

  std::shared_ptr<State> state_;
  double from_ = 0, to_ = 1;
};

}  // namespace talus
