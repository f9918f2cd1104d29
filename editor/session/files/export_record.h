// ExportRecord: which files exports have written, so that they may be written again without a question.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace talus {

// Several programs may use the same file at a time: what one notes, the others find when they refresh.
class ExportRecord {
 public:
  static constexpr std::size_t kMostFiles = 10'000;  // of more, those that are gone are forgotten

  // file: where it is kept between starts; empty: nowhere. One that cannot be read counts as empty.
  explicit ExportRecord(std::string file = {});
  bool refresh();  // takes what the file holds by now; false: it is there, and cannot be read
  // Whether an export wrote what the file holds now. path: of any form.
  bool has(const std::string& path, std::uint64_t content) const;
  bool knows(const std::string& path) const;                  // whether an export wrote anything there
  void note(const std::string& path, std::uint64_t content);  // content_hash
  // Adds what was noted to the file. The error is one sentence; what could not be kept is asked about again.
  tl::expected<void, std::string> save();

 private:
  std::string file_;
  std::map<std::string, std::uint64_t> contents_;
  std::map<std::string, std::uint64_t> noted_;  // of them, what the file has not got yet
};

}  // namespace talus
