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

struct PagePicture {
  std::string_view name;     // of the file beside the page, without ".svg"
  std::string_view meaning;  // a sentence
};

std::string csv_of(std::span<const Row> rows, const BuildFacts& facts);
// In Markdown.
std::string page_of(std::span<const Row> rows, const BuildFacts& facts,
                    std::span<const PagePicture> pictures);

}  // namespace talus
