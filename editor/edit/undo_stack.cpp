// The history of edits.
#include "undo_stack.h"

#include <cassert>
#include <utility>

namespace talus {

void UndoStack::push(Level& level, Edit edit, int stroke) {
  if (edit.empty()) return;
  apply_edit(level, edit);
  if (can_redo()) {
    edits_.erase(edits_.begin() + static_cast<std::ptrdiff_t>(next_), edits_.end());
    if (saved_ > static_cast<std::ptrdiff_t>(next_)) saved_ = -1;
  }
  if (stroke > 0 && stroke == open_stroke_) {
    merger_.merge(edits_.back(), edit);
    if (!edits_.back().empty()) return;
    edits_.pop_back();
    --next_;
    open_stroke_ = 0;
    return;
  }
  open_stroke_ = stroke;
  merger_ = stroke > 0 ? EditMerger(edit) : EditMerger();
  edits_.push_back(std::move(edit));
  ++next_;
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

void UndoStack::clear() { *this = UndoStack(); }

}  // namespace talus
