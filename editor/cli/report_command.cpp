// talus report [--quick] [--moves N] -o DIR

#include <filesystem>
#include <ostream>

#include "cli/report/measure.h"
#include "cli/report/meetings.h"
#include "cli/report/plots.h"
#include "cli/report/table.h"
#include "command.h"
#include "formats/files/atomic_file.h"
#include "output_file.h"

namespace talus {
namespace {

struct ReportOptions {
  std::string folder;
  bool quick = false;
  std::size_t moves = 0;  // 0: as --quick says
};

Effort effort_of(const ReportOptions& options) {
  Effort effort = options.quick ? Effort{200, 3} : Effort{2000, 5};
  if (options.moves != 0) effort.moves = options.moves;
  return effort;
}

// Fails if there is something else than a file of a report. text: what will be written, or its beginning.
bool may_write(CommandContext& context, const std::string& path, const std::string& text) {
  const std::string problem = output_problem({path, text, {}});
  if (!problem.empty()) fail(context, path, "", problem);
  return problem.empty();
}

// Writes a file of the report; returns false after a reported failure.
bool write(CommandContext& context, const std::string& path, const std::string& text) {
  if (!may_write(context, path, text)) return false;
  const FormatResult<void> written = write_file_atomic(path, text);
  if (!written) fail(context, path, written.error().place, written.error().message);
  return written.has_value();
}

void report(CommandContext& context, const ReportOptions& options) {
  std::error_code problem;
  std::filesystem::create_directories(options.folder, problem);
  if (problem) return fail(context, options.folder, "", "cannot be created as a folder");
  const std::string folder = options.folder + '/';

  const BuildFacts facts = build_facts();
  // Checks this before the measurement takes its time.
  if (!may_write(context, folder + "report.csv", csv_of({}, facts)) ||
      !may_write(context, folder + "meetings.csv", meetings_csv({}, facts)) ||
      !may_write(context, folder + "report.md", page_of({}, facts, {}, {})))
    return;

  std::vector<Row> rows;
  for (const Setup& setup : report_setups()) rows.push_back(measure(setup, effort_of(options)));
  if (!write(context, folder + "report.csv", csv_of(rows, facts))) return;
  const std::vector<MeetingRow> meetings = measure_meetings(options.quick ? 0.25 : 1);
  if (!write(context, folder + "meetings.csv", meetings_csv(meetings, facts))) return;

  std::vector<PagePicture> pictures;
  for (const Plot& plot : report_plots()) {
    const std::string name = folder + std::string(plot.picture.name);
    if (!write(context, name + ".gnuplot", plot.script(rows))) return;
    const std::optional<std::string> drawn = run_gnuplot(name + ".gnuplot");
    if (!drawn) continue;
    if (!write(context, name + ".svg", *drawn)) return;
    pictures.push_back(plot.picture);
  }
  if (!write(context, folder + "report.md", page_of(rows, facts, pictures, meetings_section(meetings))))
    return;
  say(context.out, std::to_string(rows.size()) + " rows in " + folder + "report.csv, " +
                       std::to_string(pictures.size()) + " plots");
  if (pictures.size() < report_plots().size()) {
    fail(context, options.folder, "",
         "gnuplot is missing or failed: the tables are written, but not all plots");
  }
}

}  // namespace

void add_report_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand(
      "report", "Measure what each solver costs and how far it is from the right answers: tables and plots");
  auto options = std::make_shared<ReportOptions>();
  command->add_option("-o", options->folder, "The folder to write to; it is created if it does not exist")
      ->required()
      ->type_name("DIR");
  command->add_flag("--quick", options->quick, "Measure fewer moves, in less than a minute");
  command
      ->add_option("--moves", options->moves,
                   "Moves in each row; a twentieth as many for balls that roll or bounce")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
  command->callback([&context, options] { report(context, *options); });
}

}  // namespace talus
