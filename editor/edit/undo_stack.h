// The history of edits, with merging of strokes and a mark for the saved state.
#pragma once

#include <cstddef>
#include <vector>

#include <talus/level/limits.h>
#include "level/edit.h"

namespace talus {

class UndoStack {
 public:
  // most_bytes: limit for the memory of all entries. Beyond it the oldest ones are forgotten, but never the
  // last one.
  explicit UndoStack(std::size_t most_bytes = kMaxHistoryBytes) : most_bytes_(most_bytes) {}

  // Applies and records an edit. Edits of the same stroke (> 0) in a row are one entry; stroke 0 never
  // merges. An empty edit is ignored, and a stroke that ends where it began leaves no entry.
  void push(Level& level, Edit edit, int stroke = 0);
  bool can_undo() const { return next_ > 0; }
  bool can_redo() const { return next_ < edits_.size(); }
  void undo(Level& level);  // can_undo() must hold
  void redo(Level& level);  // can_redo() must hold
  void clear();

  const std::vector<Edit>& edits() const { return edits_; }
  std::size_t position() const { return next_; }  // edits before it are applied

  // The stroke whose next edits still join the last entry; 0: no stroke.
  int open_stroke() const { return open_stroke_; }

  // Also ends the open stroke, since an entry that grows is no longer what was saved.
  void mark_saved() {
    saved_ = static_cast<std::ptrdiff_t>(next_);
    open_stroke_ = 0;
  }
  // The saved state is gone: the file was lost or replaced.
  void forget_saved() { saved_ = -1; }
  bool is_saved() const { return saved_ == static_cast<std::ptrdiff_t>(next_); }

 private:
  void forget_oldest();

  std::vector<Edit> edits_;
  std::vector<std::size_t> bytes_;  // of each entry; for the last one, its size at its beginning
  std::size_t most_bytes_;
  std::size_t next_ = 0;
  std::ptrdiff_t saved_ = 0;  // -1: the saved state can no longer be reached
  int open_stroke_ = 0;       // the stroke whose edits the last entry still takes; 0: no stroke
  EditMerger merger_;         // for the last entry, while its stroke is open
};

}  // namespace talus
