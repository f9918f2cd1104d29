// One file for each process: a line of JSON about the level, then the recordings, and the level as its own
// file had it, whose sizes the line says, then the level, both in the native format. Beside it is a file that
// is locked as long as the process lives; the system releases the lock however the process ends.
#include "autosave.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <exception>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "formats/files/atomic_file.h"
#include "formats/files/held_file.h"
#include "formats/last_catch.h"
#include "formats/native/recording_file.h"
#include "formats/reading_choices.h"
#include "formats/text/json_text.h"
#include "formats/text/utf8_text.h"

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

// The descriptor of the locked file; -1 with errno if there is none, EWOULDBLOCK if another process has the
// lock.
int locked(const std::string& file, int flags) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | flags, 0600);
  if (descriptor < 0 || try_lock(descriptor, file)) return descriptor;
  const int error = errno;
  ::close(descriptor);
  errno = error;
  return -1;
}

// A running process would have made a lock file.
bool owner_runs(const std::string& file) {
  const int lock = locked(lock_file(file), 0);
  if (lock < 0) return errno == EWOULDBLOCK;
  ::close(lock);
  return false;
}

// Removes files that killed processes left half written, and locks that belong to no file.
void remove_remains(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> remains;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const fs::path& path = entry.path();
    const bool is_lock = path.extension() == kLockExtension && path.stem().extension() == kExtension;
    std::error_code unknown;
    if (path.extension() == kTemporaryEnding ||
        (is_lock && !fs::exists(path.parent_path() / path.stem(), unknown) && !unknown))
      remains.push_back(path.string());
  }
  for (const std::string& file : remains) remove_if_unlocked(file);
}

// The entry for a file that cannot be read.
SavedWork unreadable(const std::string& file, std::string problem) {
  SavedWork work{file, {}, fs::path(file).filename().string(), 0, nullptr};
  struct stat status = {};
  if (::stat(file.c_str(), &status) == 0) work.time = status.st_mtime;
  work.problem = std::move(problem);
  return work;
}

std::string to_text(const FormatError& error) {
  return error.place.empty() ? error.message : error.place + ": " + error.message;
}

tl::unexpected<std::string> damaged(const std::string& what) { return tl::unexpected("is damaged: " + what); }

// The bytes of the file after its first line, which `about` holds.
tl::expected<SavedWork, std::string> read_parts(const std::string& file, const json& about,
                                                std::string_view rest, const Progress& progress) {
  SavedWork work{file, {}, kUnnamed, 0, nullptr};
  for (const json& size : about.value("recording_bytes", json::array())) {
    if (!size.is_number_unsigned() || size.get<std::size_t>() > rest.size())
      return damaged("a recording is missing");
    auto recording =
        read_guarded([&] { return read_recording(rest.substr(0, size.get<std::size_t>()), progress); });
    if (progress.stopped()) return tl::unexpected<std::string>("was not read to its end");
    if (recording)
      work.recordings.push_back(std::make_shared<const Recording>(std::move(*recording)));
    else
      work.unread_recordings.push_back(to_text(recording.error()));
    rest.remove_prefix(size.get<std::size_t>());
  }
  FormatContext context{kNativeExtension};
  context.progress = progress;
  if (const json size = about.value("base_bytes", json()); size.is_number_unsigned()) {
    if (size.get<std::size_t>() > rest.size()) return damaged("its level is missing");
    const std::string_view text = rest.substr(0, size.get<std::size_t>());
    rest.remove_prefix(text.size());
    if (auto base = read_guarded([&] { return find_format("native")->read(text, context); }))
      work.base = std::make_shared<const Level>(std::move(*base));
  }
  auto level = read_guarded([&] { return find_format("native")->read(rest, context); });
  if (!level) return damaged("its level " + to_text(level.error()));
  work.level = std::make_shared<const Level>(std::move(*level));
  if (about.contains("choices") && about["choices"].is_string())
    work.choices = choices_in(about["choices"].get<std::string>());
  if (about.contains("path") && about["path"].is_string()) work.path = about["path"];
  if (about.contains("name") && about["name"].is_string()) work.name = about["name"];
  if (about.contains("time") && is_whole(about["time"], 0, std::numeric_limits<std::int64_t>::max()))
    work.time = about["time"];
  return work;
}

}  // namespace

tl::expected<void, std::string> write_saved_work(const SavedWork& work) {
  const Format& native = *find_format("native");
  const auto written = native.write(*work.level, {kNativeExtension});
  if (!written) return tl::unexpected("the level " + written.error().message);
  std::string recordings, problem;
  std::vector<std::size_t> sizes;
  for (const auto& each : work.recordings) {
    const auto recording = write_recording(*each);
    if (!recording) {
      problem = "a recording " + recording.error().message + "; all else is saved";
      continue;
    }
    sizes.push_back(recording->size());
    recordings += *recording;
  }
  json about = {{"path", work.path}, {"name", work.name}, {"time", work.time}, {"recording_bytes", sizes}};
  std::string base;
  if (work.base) {
    if (auto its = native.write(*work.base, {kNativeExtension})) base = std::move(its->bytes);
    about["base_bytes"] = base.size();
    about["choices"] = text_of_choices(work.choices);
  }
  const std::string text =
      about.dump(-1, ' ', true, json::error_handler_t::replace) + "\n" + recordings + base + written->bytes;
  if (const auto saved = write_file_atomic(work.file, text, InPlace::follow_links, Readers::owner); !saved)
    return tl::unexpected("the file " + saved.error().message);
  if (!problem.empty()) return tl::unexpected(std::move(problem));
  return {};
}

// A file is read whatever its size: the readers of its level and of its recordings have limits of their own.
tl::expected<SavedWork, std::string> read_saved_work(const std::string& file, const Progress& progress) try {
  constexpr std::size_t kAnySize = std::numeric_limits<std::size_t>::max() / 2;
  const auto bytes = read_file(file, kAnySize, progress.part(0, 0.1));
  if (!bytes) return tl::unexpected(bytes.error().message);
  const std::size_t line = bytes->find('\n');
  if (line == std::string::npos) return damaged("its first line has no end");
  const auto about = parse_json(std::string_view(*bytes).substr(0, line));
  if (!about || !about->is_object()) return damaged("its first line does not say what it holds");
  return read_parts(file, *about, std::string_view(*bytes).substr(line + 1), progress.part(0.1, 1));
} catch (...) {
  return tl::unexpected("cannot be read: " + caught_text());
}

Autosave::Autosave(std::string folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
  finish_writing();
  if (lock_ >= 0) ::close(lock_);
}

// The first free name: a process may have several sessions, and process ids are used again. The lock is lost
// with the folder, if somebody removes that.
tl::expected<void, std::string> Autosave::hold_lock() {
  if (lock_ >= 0 && has_name(lock_, lock_file(file_))) return {};
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return tl::unexpected("the folder cannot be created: " + error.message());
  fs::permissions(folder_, fs::perms::owner_all, error);  // the files in it are private in any case
  remove_remains(folder_);
  constexpr int kAttempts = 100;
  for (int i = 0; i < kAttempts && lock_ < 0; ++i) {
    file_ =
        (fs::path(folder_) / (std::to_string(::getpid()) + "-" + std::to_string(i) + std::string(kExtension)))
            .string();
    if (!fs::exists(file_, error)) lock_ = locked(lock_file(file_), O_CREAT);
  }
  if (lock_ >= 0) return {};
  return tl::unexpected("no file can be created: " + std::generic_category().message(errno));
}

std::optional<std::string> Autosave::follow(const Session& session, double now) {
  if (is_writing()) return {};
  const bool had_problem = problem_.has_value();
  finish_writing();
  if (!session.modified() && session.unsaved_branches().empty())
    remove();
  else if (revision_of(session) != written_revision_)
    write_when_due(session, now);
  return had_problem ? std::nullopt : problem_;
}

void Autosave::write_when_due(const Session& session, double now) {
  if (!changed_since_) changed_since_ = now;
  if (now < *changed_since_ + kDelay) return;
  changed_since_.reset();
  if (const auto held = hold_lock(); !held) {
    problem_ = held.error();
    changed_since_ = now;
    return;
  }
  writing_revision_ = revision_of(session);
  writing_ = std::async(std::launch::async, [work = work_of(session)]() -> tl::expected<void, std::string> {
    try {
      return write_saved_work(work);
    } catch (...) {
      return tl::unexpected("the level cannot be written: " + caught_text());
    }
  });
}

tl::expected<void, std::string> Autosave::save_now(const Session& session) {
  finish_writing();
  changed_since_.reset();
  auto saved = hold_lock();
  if (saved) saved = write_saved_work(work_of(session));
  note(saved, revision_of(session));
  return saved;
}

SavedWork Autosave::work_of(const Session& session) const {
  SavedWork work{file_, session.path(), session.file_name(), seconds_since_1970(),
                 std::make_shared<const Level>(session.level())};
  if (!work.path.empty()) {
    work.base = session.stored_level();
    work.choices = session.stored_choices();
  }
  for (const Branch* branch : session.unsaved_branches())
    work.recordings.push_back(
        std::make_shared<const Recording>(session.timeline().whole_recording(*branch, session.level())));
  return work;
}

std::optional<double> Autosave::due() const {
  if (!changed_since_) return std::nullopt;
  return *changed_since_ + kDelay;
}

void Autosave::finish_writing() {
  if (writing_.valid()) note(writing_.get(), writing_revision_);
}

// Work that was not written still has to be written.
void Autosave::note(const tl::expected<void, std::string>& written, Revision revision) {
  problem_ = written ? std::nullopt : std::optional(written.error());
  if (written) written_revision_ = revision;
}

// If a file cannot be removed, its lock stays, and the next call tries again.
void Autosave::remove() {
  changed_since_.reset();
  written_revision_.reset();
  problem_.reset();
  if (lock_ < 0) return;
  finish_writing();
  written_revision_.reset();
  problem_.reset();
  if (::unlink(file_.c_str()) != 0 && errno != ENOENT) return;
  ::unlink(lock_file(file_).c_str());
  ::close(lock_);
  lock_ = -1;
}

std::vector<SavedWork> Autosave::left_behind_in(const std::string& folder, const std::string& own,
                                                const Progress& progress) try {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == kExtension) files.push_back(entry.path().string());
  }
  std::vector<SavedWork> found;
  const auto share = [&](std::size_t done) {
    return static_cast<double>(done) / static_cast<double>(files.size());
  };
  for (std::size_t i = 0; i < files.size() && !progress.stopped(); ++i) {
    if (files[i] == own || owner_runs(files[i])) continue;
    auto work = read_saved_work(files[i], progress.part(share(i), share(i + 1)));
    found.push_back(work ? std::move(*work) : unreadable(files[i], work.error()));
  }
  if (error && error != std::errc::no_such_file_or_directory)
    found.push_back(unreadable(folder, "cannot be read: " + error.message()));
  std::sort(found.begin(), found.end(), [](const SavedWork& a, const SavedWork& b) {
    return a.time != b.time ? a.time > b.time : a.file < b.file;
  });
  return found;
} catch (...) {
  return {unreadable(folder, "cannot be read: " + caught_text())};
}

std::uintmax_t Autosave::bytes_in(const std::string& folder) {
  std::uintmax_t bytes = 0;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    std::error_code unknown;
    if (entry.path().extension() == kExtension && entry.is_regular_file(unknown))
      bytes += entry.file_size(unknown);
  }
  return bytes;
}

tl::expected<std::string, std::string> Autosave::set_aside(const SavedWork& work) {
  std::string kept = work.file;
  std::error_code unknown;
  for (int n = 1; kept == work.file || fs::exists(fs::symlink_status(kept, unknown)); ++n)
    kept = work.file + ".kept" + std::to_string(n);
  if (::rename(work.file.c_str(), kept.c_str()) != 0)
    return tl::unexpected(work.file + " cannot be renamed: " + std::generic_category().message(errno) + ".");
  ::unlink(lock_file(work.file).c_str());
  return kept;
}

tl::expected<void, std::string> Autosave::discard(const SavedWork& work) {
  if (::unlink(work.file.c_str()) != 0 && errno != ENOENT)
    return tl::unexpected(work.file + " cannot be removed: " + std::generic_category().message(errno) + ".");
  ::unlink(lock_file(work.file).c_str());
  return {};
}

}  // namespace talus
