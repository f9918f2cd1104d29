// A thread for one file at a time.
#include "file_reader.h"

#include <utility>

namespace talus {

FileReader::~FileReader() { cancel(); }  // a future of std::async waits for its thread

void FileReader::start(std::string name, Work work, std::chrono::milliseconds patience) {
  cancel();
  job_ = std::make_unique<Job>();
  job_->name = std::move(name);
  job_->result = std::async(std::launch::async, [job = job_.get(), work = std::move(work)] {
    return work(Progress([job](double share) {
      job->share = share;
      return job->wanted.load();
    }));
  });
  if (patience.count() > 0 && job_->result.wait_for(patience) == std::future_status::ready) finish();
}

void FileReader::cancel() {
  forget_ended();
  if (!job_) return;
  job_->wanted = false;
  cancelled_.push_back(std::move(job_));
  forget_ended();
}

std::optional<ReadingProgress> FileReader::progress() const {
  if (!job_) return std::nullopt;
  const std::chrono::duration<double> since = Clock::now() - job_->start;
  return ReadingProgress{job_->name, job_->share, since.count()};
}

bool FileReader::finish() {
  forget_ended();
  if (!job_ || job_->result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  const Finish done = std::exchange(job_, nullptr)->result.get();
  if (done) done();
  return true;
}

void FileReader::wait() {
  while (job_) {
    job_->result.wait();
    finish();
  }
}

void FileReader::forget_ended() {
  std::erase_if(cancelled_, [](const std::unique_ptr<Job>& job) {
    return job->result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  });
}

}  // namespace talus
