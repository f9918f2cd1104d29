// FileReader: reads what may be a large file beside the editor, which goes on with what it has.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <talus/level/progress.h>

namespace talus {

// What is being read.
struct ReadingProgress {
  std::string name;    // of the file
  double share = 0;    // that is read, 0..1
  double seconds = 0;  // since it began
};

class FileReader {
 public:
  // What becomes of what was read: called on the editor's thread, once, unless the reading was cancelled.
  using Finish = std::function<void()>;
  // Reads, on another thread; never empty.
  using Work = std::function<Finish(const Progress& progress)>;

  FileReader() = default;
  ~FileReader();  // waits until all that was cancelled has given up
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  // Begins, in the place of what is under way, and waits up to `patience` for it to be done.
  void start(std::string name, Work work, std::chrono::milliseconds patience);
  // What is under way will not be finished.
  void cancel();
  bool is_busy() const { return job_ != nullptr; }
  std::optional<ReadingProgress> progress() const;  // of what is under way
  // Finishes what is done. True when it did.
  bool finish();
  // Until what is under way is done and finished, and whatever that has begun.
  void wait();

 private:
  using Clock = std::chrono::steady_clock;
  struct Job {
    std::string name;
    Clock::time_point start = Clock::now();
    std::atomic<double> share = 0;
    std::atomic<bool> wanted = true;
    std::future<Finish> result;
  };
  void forget_ended();  // of what was cancelled

  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> cancelled_;  // that have not yet given up
};

}  // namespace talus
