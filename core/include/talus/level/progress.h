// How far something long is, as reading a file or an export: told to who waits for it, and who may end it.
#pragma once

#include <functional>
#include <memory>
#include <utility>

namespace talus {

// Copies, and parts, tell the same listener. One thread may use them at a time.
class Progress {
 public:
  // Gets the share that is done, 0..1, which never goes down. False: what is made is to be given up.
  using Listener = std::function<bool(double share)>;

  Progress() = default;  // nobody waits, and nothing ends it
  // listener: not null.
  explicit Progress(Listener listener) : state_(std::make_shared<State>(std::move(listener))) {}

  // The work from one share of this to another, itself counted from 0 to 1.
  Progress part(double from, double to) const {
    Progress part = *this;
    part.from_ = from_ + (to_ - from_) * from;
    part.to_ = from_ + (to_ - from_) * to;
    return part;
  }

  // To be called often, as it asks the listener a thousand times in all at most. False: end at once, with
  // whatever there is; that is so from then on.
  bool at(double share) const {
    if (state_ == nullptr) return true;
    const double now = from_ + (to_ - from_) * share;
    if (state_->stopped || now < state_->next) return !state_->stopped;
    state_->next = now + kStep;
    state_->stopped = !state_->listener(now);
    return !state_->stopped;
  }
  // The same for `done` of `all`, such as bytes; all of nothing are done.
  template <class Count>
  bool at(Count done, Count all) const {
    return at(all == 0 ? 1 : static_cast<double>(done) / static_cast<double>(all));
  }
  // Whether the listener has said to end.
  bool stopped() const { return state_ != nullptr && state_->stopped; }

  // As a TerrainSource takes it.
  std::function<bool(double)> function() const {
    if (state_ == nullptr) return nullptr;
    return [progress = *this](double share) { return progress.at(share); };
  }

 private:
  static constexpr double kStep = 0.001;
  struct State {
    explicit State(Listener to) : listener(std::move(to)) {}
    Listener listener;
    double next = 0;  // the share from which on it is told again
    bool stopped = false;
  };

  std::shared_ptr<State> state_;
  double from_ = 0, to_ = 1;
};

}  // namespace talus
