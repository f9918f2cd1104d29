// One file for each process: a line of JSON about the level, then the recordings, of as many bytes as it
// says, then the level in the native format. Beside it lies a file that is locked as long as the process
// lives; the system gives the lock back however it ends.
#include "autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "formats/atomic_file.h"
#include "formats/json_text.h"
#include "formats/last_catch.h"
#include "formats/recording.h"
#include "formats/utf8_text.h"

namespace talus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view kExtension = ".talus-autosave", kLockExtension = ".lock";
constexpr const char* kNativeExtension = "talus.json";

std::int64_t seconds_since_1970() {
  return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string lock_file(const std::string& file) { return file + std::string(kLockExtension); }

// The descriptor of the locked file; -1 when another process has the lock.
int try_lock(const std::string& file, int flags) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | flags, 0600);
  if (descriptor < 0) return -1;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

// Without a lock file nobody can be running that would have made one.
bool owner_runs(const std::string& file) {
  std::error_code error;
  if (!fs::exists(lock_file(file), error)) return false;
  const int lock = try_lock(lock_file(file), 0);
  if (lock < 0) return true;
  ::close(lock);
  return false;
}

}  // namespace

tl::expected<void, std::string> write_saved_work(const SavedWork& work) {
  const Format& native = *find_format("native");
  const auto written = native.write(*work.level, {kNativeExtension});
  if (!written) return tl::unexpected("The level cannot be saved by itself: " + written.error().message);
  std::string recordings;
  std::vector<std::size_t> sizes;
  for (const auto& each : work.recordings) {
    const auto recording = write_recording(*each);
    if (!recording)
      return tl::unexpected("The recording cannot be saved by itself: " + recording.error().message);
    sizes.push_back(recording->size());
    recordings += *recording;
  }
  const json about = {
      {"path", work.path}, {"name", work.name}, {"time", work.time}, {"recording_bytes", sizes}};
  const std::string text =
      about.dump(-1, ' ', true, json::error_handler_t::replace) + "\n" + recordings + written->bytes;
  std::error_code error;
  fs::create_directories(fs::path(work.file).parent_path(), error);
  if (const auto saved = write_file_atomic(work.file, text); !saved)
    return tl::unexpected("The level cannot be saved by itself: " + to_string(saved.error(), work.file));
  return {};
}

tl::expected<SavedWork, std::string> read_saved_work(const std::string& file) {
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected(to_string(bytes.error(), file));
  const std::size_t line = bytes->find('\n');
  const auto parsed = parse_json(std::string_view(*bytes).substr(0, line));
  if (line == std::string::npos || !parsed || !parsed->is_object())
    return tl::unexpected(printable(file) + " is damaged.");
  const json& about = *parsed;
  std::string_view rest = std::string_view(*bytes).substr(line + 1);
  SavedWork work{file, {}, kUnnamed, 0, nullptr};
  for (const json& size : about.value("recording_bytes", json::array())) {
    if (!size.is_number_unsigned() || size.get<std::size_t>() > rest.size())
      return tl::unexpected(printable(file) + " is damaged.");
    auto recording = read_guarded([&] { return read_recording(rest.substr(0, size.get<std::size_t>())); });
    if (!recording) return tl::unexpected(to_string(recording.error(), file));
    work.recordings.push_back(std::make_shared<const Recording>(std::move(*recording)));
    rest.remove_prefix(size.get<std::size_t>());
  }
  auto level = read_guarded([&] { return find_format("native")->read(rest, {kNativeExtension}); });
  if (!level) return tl::unexpected(to_string(level.error(), file));
  work.level = std::make_shared<const Level>(std::move(*level));
  if (about.contains("path") && about["path"].is_string()) work.path = about["path"];
  if (about.contains("name") && about["name"].is_string()) work.name = about["name"];
  if (about.contains("time") && is_whole(about["time"], 0, std::numeric_limits<std::int64_t>::max()))
    work.time = about["time"];
  return work;
}

Autosave::Autosave(std::string folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
  finish_writing();
  if (lock_ >= 0) ::close(lock_);
}

std::string Autosave::no_room() const { return "Nothing can be saved by itself in " + folder_ + "."; }

// The first free name: a process may have several sessions, and numbers of processes come again.
bool Autosave::hold_lock() {
  if (lock_ >= 0) return true;
  std::error_code error;
  fs::create_directories(folder_, error);
  constexpr int kAttempts = 100;
  for (int i = 0; i < kAttempts && lock_ < 0; ++i) {
    file_ =
        (fs::path(folder_) / (std::to_string(::getpid()) + "-" + std::to_string(i) + std::string(kExtension)))
            .string();
    if (!fs::exists(file_, error)) lock_ = try_lock(lock_file(file_), O_CREAT);
  }
  return lock_ >= 0;
}

std::optional<std::string> Autosave::follow(const Session& session, double now) {
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  std::optional<std::string> error = finish_writing();
  if (!session.modified() && session.unsaved_runs().empty()) {
    remove();
    return error;
  }
  if (revision_of(session) == written_revision_) return error;
  if (!changed_since_) changed_since_ = now;
  if (now < *changed_since_ + kDelay) return error;
  changed_since_.reset();
  written_revision_ = revision_of(session);
  if (!hold_lock()) return no_room();
  writing_ = std::async(std::launch::async, [work = work_of(session)]() -> tl::expected<void, std::string> {
    try {
      return write_saved_work(work);
    } catch (...) {
      return tl::unexpected("The level cannot be saved by itself: " + caught_text() + ".");
    }
  });
  return error;
}

tl::expected<void, std::string> Autosave::save_now(const Session& session) {
  finish_writing();
  changed_since_.reset();
  written_revision_ = revision_of(session);
  if (!hold_lock()) return tl::unexpected(no_room());
  return write_saved_work(work_of(session));
}

SavedWork Autosave::work_of(const Session& session) const {
  SavedWork work{file_, session.path(), session.file_name(), seconds_since_1970(),
                 std::make_shared<const Level>(session.level())};
  for (const Branch* run : session.unsaved_runs())
    work.recordings.push_back(
        std::make_shared<const Recording>(session.timeline().whole_recording(*run, session.level())));
  return work;
}

std::optional<double> Autosave::due() const {
  if (!changed_since_) return std::nullopt;
  return *changed_since_ + kDelay;
}

std::optional<std::string> Autosave::finish_writing() {
  if (!writing_.valid()) return std::nullopt;
  const auto written = writing_.get();
  return written ? std::nullopt : std::optional<std::string>(written.error());
}

void Autosave::remove() {
  changed_since_.reset();
  written_revision_.reset();
  if (lock_ < 0) return;
  finish_writing();
  ::unlink(file_.c_str());
  ::unlink(lock_file(file_).c_str());
  ::close(lock_);
  lock_ = -1;
}

std::vector<SavedWork> Autosave::left_behind() const {
  std::vector<SavedWork> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const std::string file = entry.path().string();
    if (entry.path().extension() != kExtension || (lock_ >= 0 && file == file_) || owner_runs(file)) continue;
    if (auto work = read_saved_work(file)) found.push_back(std::move(*work));
  }
  std::sort(found.begin(), found.end(), [](const SavedWork& a, const SavedWork& b) {
    return a.time != b.time ? a.time > b.time : a.file < b.file;
  });
  return found;
}

void Autosave::discard(const SavedWork& work) {
  ::unlink(work.file.c_str());
  ::unlink(lock_file(work.file).c_str());
}

}  // namespace talus
