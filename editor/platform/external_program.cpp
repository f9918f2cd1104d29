// Splits command lines, starts programs, and finds the files for them.
#include "external_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <optional>
#include <system_error>

#include "export/export_plan.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// Replaces the words in braces; an unknown one is an error.
tl::expected<std::string, std::string> filled_in(const std::string& word, const std::string& file,
                                                 const std::string& folder) {
  std::string text;
  for (std::size_t at = 0; at < word.size();) {
    const std::size_t open = word.find('{', at), close = word.find('}', open);
    text += word.substr(at, open - at);
    if (open == std::string::npos) break;
    if (close == std::string::npos) return tl::unexpected("A } is missing after " + word.substr(open) + ".");
    const std::string name = word.substr(open, close + 1 - open);
    if (name == "{file}")
      text += file;
    else if (name == "{folder}")
      text += folder;
    else
      return tl::unexpected(name + " is unknown: write {file} or {folder}.");
    at = close + 1;
  }
  return text;
}

void point_at_nothing() {
  const int null = ::open("/dev/null", O_RDWR);
  for (int descriptor = 0; null >= 0 && descriptor <= 2; ++descriptor) ::dup2(null, descriptor);
}

// Runs in the child of a child, so that nobody has to wait for it. Only calls that are safe after a fork.
[[noreturn]] void become(char* const* arguments, int errors) {
  ::setsid();
  if (::fork() != 0) ::_exit(0);
  point_at_nothing();
  ::signal(SIGXFSZ, SIG_DFL);  // this program ignores it
  ::execvp(arguments[0], arguments);
  const int error = errno;
  const ssize_t told = ::write(errors, &error, sizeof error);
  ::_exit(told == sizeof error ? 1 : 2);
}

struct FileToOpen {
  std::string path;
  std::string note;  // how it was obtained, for the message
};

// Returns the level's own file, saved if needed, or a copy in the program's format. Returns nothing if that
// fails; then a message or question of the session says why.
std::optional<FileToOpen> file_for(Session& session, const ProgramInfo& info, OpenCopies& copies) {
  const auto fail = [&](const std::string& text) {
    session.apply(action::ShowMessage{text, true});
    return std::nullopt;
  };
  const std::string label(info.label);
  const Format* own = session.path().empty() ? nullptr : format_for_file(session.path());
  if (info.format.empty() && own == nullptr)
    return fail("Save the level into the folder of its game first, for " + label + ".");
  if (info.format.empty() || own == find_format(info.format)) {
    if (!session.modified()) return FileToOpen{session.path(), ""};
    session.apply(action::SaveFile{});
    if (!session.history().is_saved() || !session.message()) return std::nullopt;
    return FileToOpen{session.path(), session.message()->text + " "};
  }
  const auto copy = copies.write(session, info);
  if (!copy) return fail(copy.error());
  FileToOpen file{copy->path, "Wrote a copy of the level, which is written again at every save. "};
  if (!copy->kept.empty())
    file.note += "What another program had saved there is kept as " + copy->kept + ". ";
  if (!copy->record_problem.empty()) file.note += copy->record_problem + " ";
  for (const std::string& what : copy->dropped) file.note += "Not in it: " + what + ". ";
  return file;
}

std::string whole_path_of(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  return error ? path : whole.string();
}

void tell_of_command(Session& session, ProgramId program, const std::string& error) {
  const std::string label(program_infos()[static_cast<std::size_t>(program)].label);
  session.apply(action::ShowMessage{label + ": " + error + " Its command is in Edit > Settings.", true});
}

struct WhatToStart {
  std::string file;    // absolute
  std::string folder;  // absolute; empty: that of the file
  std::string note;    // for the message, before its last sentence
};

void start_program(Session& session, ProgramId program, const ProgramCommands& commands,
                   const WhatToStart& what) {
  const auto index = static_cast<std::size_t>(program);
  const auto arguments = split_command(commands[index], what.file, what.folder);
  if (!arguments) return tell_of_command(session, program, arguments.error());
  if (const auto started = start_detached(*arguments); !started)
    return tell_of_command(session, program, started.error());
  session.apply(action::ShowMessage{what.note + "Opened " + (what.folder.empty() ? what.file : what.folder) +
                                        " in " + std::string(program_infos()[index].label) + ".",
                                    false});
}

}  // namespace

tl::expected<std::vector<std::string>, std::string> split_command(std::string_view line,
                                                                  const std::string& file,
                                                                  const std::string& folder) {
  std::vector<std::string> words;
  char quote = 0;        // the open quote
  bool in_word = false;  // true also for an empty word, ""
  for (const char c : line) {
    const bool blank = c == ' ' || c == '\t';
    if (quote == 0 && blank) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = 0;
    else
      words.back() += c;
  }
  if (quote != 0) return tl::unexpected(std::string("A ") + quote + " is missing at the end of the command.");
  if (words.empty()) return tl::unexpected(std::string("The command is empty."));
  for (std::string& word : words) {
    auto filled = filled_in(word, file, folder.empty() ? fs::path(file).parent_path().string() : folder);
    if (!filled) return tl::unexpected(filled.error());
    word = std::move(*filled);
  }
  return words;
}

tl::expected<void, std::string> start_detached(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const auto failure = [&](int error) {
    return tl::unexpected(arguments.front() +
                          " cannot be started: " + std::generic_category().message(error) + ".");
  };
  int pipe[2];  // closes when the program starts; otherwise it brings the reason
  if (::pipe2(pipe, O_CLOEXEC) != 0) return failure(errno);
  const pid_t child = ::fork();
  if (child == 0) become(pointers.data(), pipe[1]);
  const int fork_error = errno;
  ::close(pipe[1]);
  int error = 0;
  const bool failed = child >= 0 && ::read(pipe[0], &error, sizeof error) == sizeof error;
  ::close(pipe[0]);
  if (child < 0) return failure(fork_error);
  ::waitpid(child, nullptr, 0);
  if (failed) return failure(error);
  return {};
}

bool can_open(Session& session, ProgramId program, const ProgramCommands& commands) {
  const auto tried = split_command(commands[static_cast<std::size_t>(program)], "file");
  if (!tried) tell_of_command(session, program, tried.error());
  return tried.has_value();
}

void open_in_program(Session& session, ProgramId program, const ProgramCommands& commands,
                     OpenCopies& copies) {
  if (!can_open(session, program, commands)) return;
  const ProgramInfo& info = program_infos()[static_cast<std::size_t>(program)];
  const auto file = file_for(session, info, copies);
  if (!file) return;
  start_program(session, program, commands, {whole_path_of(file->path), "", file->note});
}

void run_game(Session& session, const ProgramCommands& commands, const std::string& folder) {
  const std::string whole = whole_path_of(folder);
  start_program(session, ProgramId::love, commands, {(fs::path(whole) / "main.lua").string(), whole, ""});
}

}  // namespace talus
