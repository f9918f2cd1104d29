#include "plots.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>

#include "formats/text/append_number.h"

namespace talus {
namespace {

using S = ReportScene;

// The rows that are drawn as one line.
struct PlotLine {
  std::string title;
  std::function<bool(const Setup&)> has;
};

struct Axes {
  std::string x, y;  // labels
  std::function<double(const Row&)> at_x, at_y;
  bool log_x = true, log_y = true;
};

// Zero has no place on a logarithmic axis; it is drawn at the smallest error that matters.
constexpr double kZero = 1e-17;
double shown(double error) { return std::max(error, kZero); }

constexpr std::string_view kStyle =
    "set terminal svg size 1040,440 font 'sans-serif,12' background 'white'\n"
    "set border 3 lc rgb '#666666'\nset tics nomirror\nset grid lc rgb '#dddddd'\n"
    "set key outside right top\nset format '%g'\n";

std::string chart(std::span<const Row> rows, const std::string& title, const Axes& axes,
                  std::span<const PlotLine> series) {
  std::string data, plot;
  int count = 0;
  for (const PlotLine& one : series) {
    std::string points;
    for (const Row& row : rows) {
      if (row.setup.tile != kCartTileSize || !one.has(row.setup)) continue;
      append_number(points, axes.at_x(row));
      points += ' ';
      append_number(points, axes.at_y(row));
      points += '\n';
    }
    if (points.empty()) continue;
    const std::string block = "$line" + std::to_string(count);
    data += block + " << END\n" + points + "END\n";
    plot += std::string(count == 0 ? "plot " : ", ") + block + " with linespoints pt " +
            std::to_string(count + 4) + " title \"" + one.title + '"';
    ++count;
  }
  std::string script = data;
  script += axes.log_x ? "set logscale x\n" : "";
  script += axes.log_y ? "set logscale y\n" : "";
  script += "set title '" + title + "'\nset xlabel '" + axes.x + "'\nset ylabel '" + axes.y + "'\n";
  return std::string(kStyle) + script + plot + '\n';
}

bool is(const Setup& s, std::optional<SolverKind> solver, bool single) {
  return s.solver == solver && s.single == single;
}

std::vector<PlotLine> by_solver(S scene) {
  std::vector<PlotLine> series;
  const auto add = [&](const std::string& title, SolverKind solver, bool single) {
    series.push_back({title, [=](const Setup& s) {
                        return s.scene == scene && is(s, solver, single) && s.substeps == 1 &&
                               s.segments == 0;
                      }});
  };
  add("article", SolverKind::article, false);
  add("bump", SolverKind::bump, false);
  add("exact, float", SolverKind::exact, true);
  add("exact, double", SolverKind::exact, false);
  return series;
}

const Axes kOverScale = {"coordinates, px", "largest error, px", [](const Row& r) { return r.setup.scale; },
                         [](const Row& r) { return shown(r.geometry->max); }};

std::string curve_script(std::span<const Row> rows) {
  std::vector<PlotLine> series;
  for (const bool polyline : {true, false}) {
    for (const bool single : {false, true}) {
      const std::string precision = single ? "float" : "double";
      series.push_back(
          {(polyline ? "4 to 1024 segments, " : "the arc itself, ") + precision, [=](const Setup& s) {
             return s.scene == S::arc && s.scale == 1 && s.substeps == 1 && s.single == single &&
                    (s.segments != 0) == polyline;
           }});
    }
  }
  return chart(rows, "An arc of radius 64, and polylines in its place",
               {"largest error, px", "ns a move", [](const Row& r) { return shown(r.geometry->max); },
                [](const Row& r) { return *r.ns; }},
               series);
}

std::string scale_script(std::span<const Row> rows) {
  return chart(rows, "Boxes onto slopes of 16x8 px", kOverScale, by_solver(S::slope_tiles));
}

std::string wall_script(std::span<const Row> rows) {
  const Axes axes = {
      "coordinates, px",
      "ghosts, % of the moves",
      [](const Row& r) { return r.setup.scale; },
      [](const Row& r) { return 100 * static_cast<double>(r.counts->ghosts) / static_cast<double>(r.moves); },
      true,
      false};
  return chart(rows, "A wall of two boxes: pushed, slid along, left", axes, by_solver(S::wall_of_bodies));
}

std::string bounce_script(std::span<const Row> rows) {
  std::vector<PlotLine> series;
  for (const S scene : {S::bounce_fall, S::bounce_gravity, S::bounce_rebound}) {
    const std::string name(info_of(scene).name.substr(8));
    series.push_back({"exact, " + name, [=](const Setup& s) {
                        return s.scene == scene && s.scale == 1 && is(s, SolverKind::exact, false);
                      }});
  }
  for (const SolverKind solver : {SolverKind::article, SolverKind::bump}) {
    series.push_back({std::string(solver_name(solver)), [=](const Setup& s) {
                        return s.scene == S::bounce_fall && s.scale == 1 && s.solver == solver;
                      }});
  }
  return chart(rows, "Bouncing without loss for 240 frames, in 1, 2, 4, 8 and 16 sub-steps",
               {"ns a frame", "largest distance from the model, px", [](const Row& r) { return *r.ns; },
                [](const Row& r) { return shown(r.model->max); }, false, true},
               series);
}

constexpr std::array kPlots = {
    Plot{{"curves", "What a polyline costs and errs in place of an arc."}, curve_script},
    Plot{{"scales", "Errors grow with the coordinates, as their last place does."}, scale_script},
    Plot{{"walls", "Moves along and away from a wall that were stopped or bent by nothing."}, wall_script},
    Plot{{"bounces", "What sub-steps buy where a bounce is measured against the physics."}, bounce_script},
};

std::string read_all(int from) {
  std::string text;
  char buffer[4096];
  for (ssize_t n; (n = read(from, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<std::size_t>(n));
  return text;
}

}  // namespace

std::span<const Plot> report_plots() { return kPlots; }

std::optional<std::string> run_gnuplot(const std::string& script_file) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  std::string program = "gnuplot", file = script_file;
  char* arguments[] = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  const bool started = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string text = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  const bool good =
      started && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!good || text.empty()) return std::nullopt;
  return text;
}

}  // namespace talus
