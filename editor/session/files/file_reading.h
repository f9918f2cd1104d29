// FileReading: reads files, on a thread if they take long, and reports failures.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "file_reader.h"
#include "session/messages/message_handler.h"

namespace talus {

class FileReading {
 public:
  FileReading(MessageHandler& messages, Patience patience) : messages_(messages), patience_(patience) {}

  // The level stays as it is until the function that `work` returns is called. is_large: it takes long,
  // whatever the size of the file.
  void read(const std::string& file, FileReader::Work work, bool is_large = false);
  void cancel();
  void wait() { reader_.wait(); }
  void finish() { reader_.finish(); }
  const FileReader& reader() const { return reader_; }

  // Called whenever reading is given up: cancelled by anybody, or because the file cannot be read.
  void when_given_up(std::function<void()> call) { on_given_up_ = std::move(call); }

 private:
  MessageHandler& messages_;
  Patience patience_;
  std::function<void()> on_given_up_;
  FileReader reader_;
};

}  // namespace talus
