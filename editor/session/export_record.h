// ExportRecord: which files exports have written, so that they may be written again without a question.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace talus {

class ExportRecord {
 public:
  static constexpr std::size_t kMostFiles = 10'000;

  // file: where it is kept between starts; empty: nowhere. One that cannot be read counts as empty.
  explicit ExportRecord(std::string file = {});
  // Whether an export wrote what the file holds now. path: absolute.
  bool has(const std::string& path, std::uint64_t content) const;
  void note(const std::string& path, std::uint64_t content);  // content_hash
  void save() const;  // what cannot be kept is asked about again, which is no loss

 private:
  std::string file_;
  std::map<std::string, std::uint64_t> contents_;
};

}  // namespace talus
