// The plots of the report, drawn by gnuplot.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "measure.h"
#include "table.h"

namespace talus {

struct Plot {
  PagePicture picture;
  std::string (*script)(std::span<const Row> rows);  // a gnuplot program that prints an SVG
};
std::span<const Plot> report_plots();

// The output of gnuplot for the program in a file; nothing if gnuplot is missing or failed.
std::optional<std::string> run_gnuplot(const std::string& script_file);

}  // namespace talus
