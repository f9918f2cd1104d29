// PlotList: expressions that are plotted, with their values over the whole branch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "debug/plot_series.h"

namespace talus {

// An expression whose value is wanted in every frame.
struct PlotText {
  std::string text;
  int body = 0;  // id of its body; 0: the chosen one
  friend bool operator==(const PlotText&, const PlotText&) = default;
};

class PlotList {
 public:
  static constexpr std::size_t kMaxPoints = 1024;  // of a series

  struct Entry {
    PlotText plot;
    std::optional<Expression> expression;  // nothing: its text is faulty
    ExpressionError error;                 // in that case
    std::size_t series = 0;                // its place in the reader
  };

  const std::vector<Entry>& all() const { return entries_; }
  void put(std::size_t index,
           PlotText plot);  // replaces that one; if there is none, appends it
  void remove(std::size_t index);
  // Its numbers in the frames so far; null: its text is faulty.
  const Series* series(const Entry& entry) const;
  // Its value in the last frame of a history; NaN: there is none.
  static double value(const Entry& entry, const FrameView& view, int chosen_body);

  // The frames belong to another branch now, or another body is chosen.
  void begin_again() { reader_.reset(); }
  // Reads up to so many more frames. Returns true at the last one.
  bool advance(const FrameSource& source, int chosen_body, std::int64_t most_frames);

 private:
  std::vector<Entry> entries_;
  std::optional<PlotReader> reader_;
  int chosen_body_ = 0;  // the body of the reader
};

}  // namespace talus
