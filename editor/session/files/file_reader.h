// FileReader: a thread reads large files while the editor goes on with the level that it has.
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

// The file that is being read.
struct ReadingProgress {
  std::string name;    // of the file
  double share = 0;    // of the file, 0..1
  double seconds = 0;  // since it began
};

// How long reading may take before the editor goes on meanwhile. By default small files are always there at
// once, and large ones never, however quick the machine is.
struct Patience {
  std::chrono::milliseconds small = std::chrono::hours(24), large{0};
};

class FileReader {
 public:
  // Uses the result: called once on the editor's thread, unless the reading was cancelled.
  using Finish = std::function<void()>;
  // Reads, on another thread; never empty.
  using Work = std::function<Finish(const Progress& progress)>;

  FileReader() = default;
  ~FileReader();  // waits until all cancelled jobs have given up
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  // Starts reading, replaces the current job, and waits up to `patience` for the result; 0: does not look
  // for it, however quick the thread is.
  void start(std::string name, Work work, std::chrono::milliseconds patience);
  // The current job will not be finished.
  void cancel();
  bool is_busy() const { return job_ != nullptr; }
  std::optional<ReadingProgress> progress() const;  // of the current job
  // Finishes a job that is done. Returns true if there was one.
  bool finish();
  // Waits until the current job is done and finished, and whatever that has started.
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
  void forget_ended();  // removes cancelled jobs that have ended

  std::unique_ptr<Job> job_;
  std::vector<std::unique_ptr<Job>> cancelled_;  // those that have not given up yet
};

}  // namespace talus
