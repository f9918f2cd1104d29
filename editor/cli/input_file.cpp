#include "input_file.h"

#include "formats/input_entry.h"
#include "sim/case_input.h"

namespace talus {

FormatResult<std::vector<RecordedInput>> read_input(std::string_view text) {
  std::vector<RecordedInput> inputs;
  RecordedInput timed;
  int line_number = 0;
  while (!text.empty()) {
    ++line_number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;

    const std::string place = "line " + std::to_string(line_number);
    const std::int64_t last_frame = timed.frame;
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) return tl::unexpected(FormatError{place, "not a JSON object"});
    const std::string wrong = take_input_entry(json, timed);
    if (!wrong.empty()) return tl::unexpected(FormatError{place, wrong});
    if (timed.frame < last_frame) return tl::unexpected(FormatError{place, "\"frame\" goes backwards"});
    inputs.push_back(timed);
  }
  return inputs;
}

const Input& InputPlayer::at(std::int64_t frame) {
  while (next_ < inputs_.size() && inputs_[next_].frame <= frame) current_ = input_of(inputs_[next_++]);
  return current_;
}

}  // namespace talus
