// The report as text: a CSV file with all rows, and a page with the rows that are worth reading.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "measure.h"

namespace talus {

// What the rows were measured with; "unknown" if it cannot be found out.
struct BuildFacts {
  std::string commit, compiler, flags, cpu;
};
BuildFacts build_facts();
// The shortest text that reads back as the same double.
std::string csv_number(double value);
// The last columns of a line of a CSV file: commit, compiler, flags, cpu.
std::string facts_of_csv(const BuildFacts& facts);

struct PagePicture {
  std::string_view name;     // of the file beside the page, without ".svg"
  std::string_view meaning;  // a sentence
};

std::string csv_of(std::span<const Row> rows, const BuildFacts& facts);
// In Markdown. meetings: a section that follows that of the losses.
std::string page_of(std::span<const Row> rows, const BuildFacts& facts, std::span<const PagePicture> pictures,
                    const std::string& meetings);

}  // namespace talus
