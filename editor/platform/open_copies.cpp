// Writes copies, once and again.
#include "open_copies.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "asset_path.h"
#include "export/export_plan.h"
#include "formats/files/atomic_file.h"
#include "formats/files/keep_aside.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

const ProgramInfo& info_of(ProgramId program) { return program_infos()[static_cast<std::size_t>(program)]; }

tl::expected<Exported, std::string> make_copy(const Level& level, const Exporter& exporter,
                                              const std::string& path) {
  const ReadAsset read = [](const std::string& asset) { return read_file(asset_path(asset)); };
  auto exported = exporter.make({level, fs::path(path).filename().string(), read});
  if (!exported) return tl::unexpected(to_string(exported.error(), path));
  leave_out_unneeded(exporter, *exported, path);
  return *std::move(exported);
}

tl::expected<void, std::string> write_copy(const Exported& copy, const Exporter& exporter,
                                           const std::string& path) {
  const auto written = write_exported(exporter, copy, path);
  if (!written) return tl::unexpected(to_string(written.error(), path));
  return {};
}

}  // namespace

tl::expected<OpenCopies::Written, std::string> OpenCopies::write(const Session& session,
                                                                 const ProgramInfo& program) {
  const Exporter& exporter = *find_exporter(program.format);
  const std::string name = session.file_name();
  const std::string copy_name =
      name.substr(0, name.find('.')) + "." + std::string(exporter.extensions.front());
  const std::string path = (fs::path(folder_) / copy_name).string();
  std::error_code error;
  fs::create_directories(folder_, error);  // if this fails, so does the writing
  auto copy = make_copy(session.level(), exporter, path);
  if (!copy) return tl::unexpected(copy.error());
  const std::vector<std::string> files = paths_of(exporter, *copy, path);
  auto kept = make_room(files);
  if (!kept) return tl::unexpected(kept.error());
  if (const auto written = write_copy(*copy, exporter, path); !written)
    return tl::unexpected(written.error() +
                          (kept->empty() ? "" : ". What another program had saved there is " + *kept));
  const std::string record_problem = note(files);
  if (level_file_ != session.path()) forget();
  level_file_ = session.path();
  saves_ = session.saves();
  std::erase_if(copies_, [&](const Copy& old) { return old.program == program.id; });
  copies_.push_back(
      {program.id, {path, std::move(copy->dropped), *std::move(kept), record_problem}, stamp_of_file(path)});
  return copies_.back().written;
}

// Renames a file that was not written here. Returns the new name, or nothing.
tl::expected<std::string, std::string> OpenCopies::make_room(const std::vector<std::string>& files) const {
  std::string all;
  for (const std::string& file : files) {
    std::error_code error;
    if (fs::status(file, error).type() == fs::file_type::not_found) continue;
    const auto bytes = read_file(file);
    if (bytes && record().has(file, content_hash(*bytes))) continue;
    const auto kept = keep_aside(file);
    if (!kept)
      return tl::unexpected(file + " holds what another program has saved, and " + kept.error().message);
    all += (all.empty() ? "" : " and ") + *kept;
  }
  return all;
}

std::string OpenCopies::note(const std::vector<std::string>& files) const {
  ExportRecord written = record();
  for (const std::string& file : files) {
    if (const auto bytes = read_file(file)) written.note(file, content_hash(*bytes));
  }
  const auto kept = written.save();
  return kept ? "" : kept.error();
}

void OpenCopies::follow(Session& session) {
  if (session.saves() == std::exchange(saves_, session.saves())) return;
  if (level_file_.empty()) level_file_ = session.path();
  if (level_file_ != session.path()) forget();  // the copies belong to the file before
  std::string told, problems;
  const auto add = [](std::string& text, const std::string& more) {
    text += (text.empty() ? "" : " ") + more;
  };
  std::erase_if(copies_, [&](Copy& copy) {
    const std::string problem = write_again(session, copy);
    if (problem.empty()) add(problems, copy.written.record_problem);
    add(problem.empty() ? told : problems,
        problem.empty() ? "Wrote the copy for " + std::string(info_of(copy.program).label) + " again."
                        : problem);
    return !problem.empty();
  });
  if (told.empty() && problems.empty()) return;
  std::string text = session.message() ? session.message()->text : "";
  add(text, told);
  const bool failed = !problems.empty();
  if (failed) add(text, problems);
  session.apply(action::ShowMessage{std::move(text), failed});
}

// One sentence on why it was not written; empty if it was.
std::string OpenCopies::write_again(const Session& session, Copy& copy) const {
  const ProgramInfo& info = info_of(copy.program);
  if (copy.stamp && file_change(copy.written.path, *copy.stamp) == FileChange::content)
    return "The copy for " + std::string(info.label) +
           " was changed by another program and stays as it is: it no longer follows this level.";
  const Exporter& exporter = *find_exporter(info.format);
  const auto made = make_copy(session.level(), exporter, copy.written.path);
  const auto written = made ? write_copy(*made, exporter, copy.written.path) : tl::unexpected(made.error());
  if (!written)
    return "The copy for " + std::string(info.label) + " cannot be written again: " + written.error() + ".";
  copy.written.record_problem = note(paths_of(exporter, *made, copy.written.path));
  copy.stamp = stamp_of_file(copy.written.path);
  return "";
}

}  // namespace talus
