// Bodies that meet: how far they are from the right answers, and what they cost.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "table.h"

namespace talus {

// A scene with a number of sub-steps. Columns that do not apply to a row are left out.
struct MeetingRow {
  std::string_view scene;
  std::string_view meaning;  // a sentence
  int substeps = 1;
  std::size_t bodies = 0;
  int frames = 0;
  double ns = 0;                           // for a body and frame; the median
  std::optional<double> momentum, energy;  // the largest drift, as a share of what there was
  std::optional<double> penetration;       // px, the deepest overlap of two bodies in any frame
  std::optional<double> error;             // px, the largest distance from the closed form in any frame
};

// share: of the frames of each scene that are run, 0..1.
std::vector<MeetingRow> measure_meetings(double share);

std::string meetings_csv(std::span<const MeetingRow> rows, const BuildFacts& facts);
// A section of the page, in Markdown.
std::string meetings_section(std::span<const MeetingRow> rows);

}  // namespace talus
