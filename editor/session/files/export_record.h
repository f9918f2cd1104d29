// ExportRecord: the files that exports have written, which may be replaced without a question.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace talus {

// Several programs may use the same file at a time: what one adds, the others find when they refresh.
class ExportRecord {
 public:
  static constexpr std::size_t kMaxFiles = 10'000;  // with more, missing files are forgotten
  static constexpr std::size_t kMaxBytes = 8
                                           << 20;  // of the file; with more, some older entries are forgotten

  // file: where it is kept between starts; empty: nowhere. A file that cannot be read counts as empty.
  explicit ExportRecord(std::string file = {});
  bool refresh();  // reads the file again; returns false if it exists but cannot be read
  // Whether an export wrote the current content of the file. path: of any form.
  bool has(const std::string& path, std::uint64_t content) const;
  bool knows(const std::string& path) const;                  // whether an export ever wrote there
  void note(const std::string& path, std::uint64_t content);  // content_hash
  // Adds the new entries to the file. The error is one sentence; files that could not be stored are asked
  // about again.
  tl::expected<void, std::string> save();

 private:
  std::string file_;
  std::map<std::string, std::uint64_t> contents_;
  std::map<std::string, std::uint64_t> noted_;  // the entries that are not in the file yet
};

}  // namespace talus
