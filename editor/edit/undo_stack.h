// The history of edits, with merging of strokes and a mark for the saved state.
#pragma once

#include <cstddef>
#include <vector>

#include <talus/level/limits.h>
#include "edit.h"

namespace talus {

class UndoStack {
 public:
  // most_bytes: the memory that the entries take together; the oldest are forgotten beyond it, all but the
  // last.
  explicit UndoStack(std::size_t most_bytes = kMaxHistoryBytes) : most_bytes_(most_bytes) {}

  // Applies and records. Edits with the same stroke (> 0) in a row are one entry; stroke 0 never merges. An
  // empty edit is ignored, and a stroke that ends where it began leaves no entry.
  void push(Level& level, Edit edit, int stroke = 0);
  bool can_undo() const { return next_ > 0; }
  bool can_redo() const { return next_ < edits_.size(); }
  void undo(Level& level);  // can_undo() must hold
  void redo(Level& level);  // can_redo() must hold
  void clear();

  const std::vector<Edit>& edits() const { return edits_; }
  std::size_t position() const { return next_; }  // edits before it are applied

  int open_stroke() const { return open_stroke_; }  // that the last entry still takes edits of; 0: none

  // Ends the open stroke too, since an entry that went on growing would no longer be what was saved.
  void mark_saved() {
    saved_ = static_cast<std::ptrdiff_t>(next_);
    open_stroke_ = 0;
  }
  // What was saved is there no longer: it was lost or replaced by others.
  void forget_saved() { saved_ = -1; }
  bool is_saved() const { return saved_ == static_cast<std::ptrdiff_t>(next_); }

 private:
  void forget_oldest();

  std::vector<Edit> edits_;
  std::vector<std::size_t> bytes_;  // of each of them; of the last one, what it had when it was begun
  std::size_t most_bytes_;
  std::size_t next_ = 0;
  std::ptrdiff_t saved_ = 0;  // -1: the saved state can no longer be reached
  int open_stroke_ = 0;       // the stroke that the last entry still takes edits of; 0: none
  EditMerger merger_;         // of the last entry, while its stroke is open
};

}  // namespace talus
