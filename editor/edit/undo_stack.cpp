// The history of edits.
#include "undo_stack.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace talus {

void UndoStack::push(Level& level, Edit edit, int stroke) {
  if (edit.empty()) return;
  apply_edit(level, edit);
  if (can_redo()) {
    edits_.resize(next_);
    bytes_.resize(next_);
    if (saved_ > static_cast<std::ptrdiff_t>(next_)) saved_ = -1;
  }
  if (stroke > 0 && stroke == open_stroke_ && layer_after(edits_.back()) == edit.layer) {
    merger_.merge(edits_.back(), edit);
    if (!edits_.back().empty()) return;
    edits_.pop_back();
    bytes_.pop_back();
    --next_;
    open_stroke_ = 0;
    return;
  }
  open_stroke_ = stroke;
  merger_ = stroke > 0 ? EditMerger(edit) : EditMerger();
  if (!edits_.empty()) bytes_.back() = memory_of(edits_.back());
  bytes_.push_back(memory_of(edit));
  edits_.push_back(std::move(edit));
  ++next_;
  forget_oldest();
}

void UndoStack::forget_oldest() {
  std::size_t bytes = std::accumulate(bytes_.begin(), bytes_.end(), std::size_t{0});
  std::ptrdiff_t count = 0;
  for (; bytes > most_bytes_ && count + 1 < static_cast<std::ptrdiff_t>(edits_.size()); ++count)
    bytes -= bytes_[static_cast<std::size_t>(count)];
  edits_.erase(edits_.begin(), edits_.begin() + count);
  bytes_.erase(bytes_.begin(), bytes_.begin() + count);
  next_ -= static_cast<std::size_t>(count);
  saved_ = std::max<std::ptrdiff_t>(saved_ - count, -1);
}

void UndoStack::undo(Level& level) {
  assert(can_undo());
  revert_edit(level, edits_[--next_]);
  open_stroke_ = 0;
}

void UndoStack::redo(Level& level) {
  assert(can_redo());
  apply_edit(level, edits_[next_++]);
  open_stroke_ = 0;
}

void UndoStack::clear() { *this = UndoStack(most_bytes_); }

}  // namespace talus
