// talus prove FILE [--solver S] [--set KEY=VALUE] [--body KIND:WxH[:FOOT]] [--lip PX] [--threads N] [--json]

#include <charconv>
#include <ostream>
#include <thread>

#include <talus/level/ground.h>
#include <nlohmann/json.hpp>
#include "command.h"
#include "level/level_text.h"
#include "progress_line.h"
#include "prove/proof.h"

namespace talus {
namespace {

struct ProveCommand {
  std::string file;
  PhysicsOptions physics;
  std::vector<std::string> bodies;
  double lip = 0;   // px; 0: as ProveOptions has it
  int threads = 0;  // 0: one for each processor
  bool json = false;
};

constexpr double kLeastLip = 0.01, kMaxLipAsked = 256;        // px
constexpr std::string_view kFootWords[] = {"box", "centre"};  // by Foot

// The number that the text begins with, which is then without it; nothing if there is none.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const auto [rest, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return value;
}

// "player:8x12" or "ball:8x8:box".
std::optional<ProveBody> body_of(std::string_view text) {
  const std::size_t colon = text.find(':');
  const auto kind = find_body_kind(text.substr(0, colon));
  if (!kind || colon == std::string_view::npos) return std::nullopt;
  text.remove_prefix(colon + 1);
  const auto is_size = [](const std::optional<double>& px) {
    return px && *px >= kMinBodySize && *px <= kMaxBodySize;
  };
  const auto width = take_number(text);
  if (!is_size(width) || !text.starts_with('x')) return std::nullopt;
  text.remove_prefix(1);
  const auto height = take_number(text);
  if (!is_size(height)) return std::nullopt;
  ProveBody body{*kind, {*width, *height}, traits_of(*kind).foot};
  if (text.empty()) return body;
  for (const Foot foot : {Foot::box, Foot::centre}) {
    body.foot = foot;
    if (text == ":" + std::string(kFootWords[static_cast<std::size_t>(foot)])) return body;
  }
  return std::nullopt;
}

// Also "nan" is no number between two others.
std::string check_lip(const std::string& given) {
  std::string_view text = given;
  const auto px = take_number(text);
  return px && text.empty() && *px >= kLeastLip && *px <= kMaxLipAsked ? "" : "must be 0.01 to 256 px";
}

nlohmann::ordered_json json_of(const ProveBody& body) {
  return {{"kind", traits_of(body.kind).word},
          {"size", {body.size.x, body.size.y}},
          {"foot", kFootWords[static_cast<std::size_t>(body.foot)]}};
}

nlohmann::ordered_json json_of(const Finding& finding) {
  const Trial& trial = finding.trial;
  const Body& body = trial.body;
  return {{"kind", info_of(finding.kind).word},
          {"of", info_of(finding.kind).of_level ? "level" : "solver"},
          {"cell", {finding.cell.x, finding.cell.y}},
          {"place", {finding.place.x, finding.place.y}},
          {"amount", finding.amount},
          {"count", finding.count},
          {"frame", finding.frame},
          {"body", json_of(ProveBody{body.kind, {body.box.w, body.box.h}, body.foot, 0})},
          {"start",
           {{"position", {body.box.x, body.box.y}},
            {"velocity", {body.velocity.x, body.velocity.y}},
            {"grounded", body.gait.grounded}}},
          {"direction", trial.direction},
          {"run_speed", trial.speed},
          {"run_from", trial.run_from},
          {"jump_frames", trial.jump_frames},
          {"message", message_of(finding)}};
}

nlohmann::ordered_json json_of(const Proof& proof) {
  nlohmann::ordered_json bodies = nlohmann::ordered_json::array(), findings = bodies;
  for (const ProveBody& body : proof.bodies) bodies.push_back(json_of(body));
  for (const Finding& finding : proof.findings) findings.push_back(json_of(finding));
  return {{"solver", solver_name(proof.solver)}, {"bodies", bodies},
          {"bodies_left_out", proof.left_out},   {"places", proof.counts.places},
          {"places_alike", proof.counts.alike},  {"trials", proof.counts.trials},
          {"steps", proof.counts.steps},         {"findings", findings},
          {"findings_not_listed", proof.more}};
}

void print(CommandContext& context, const std::string& file, const Proof& proof) {
  for (const Finding& finding : proof.findings) {
    say(context.out, file + ":cell " + std::to_string(finding.cell.x) + "," + std::to_string(finding.cell.y) +
                         ": " + message_of(finding) + " [" + std::string(info_of(finding.kind).word) + "]");
  }
  if (proof.left_out > 0)
    say(context.out, file + ": " + std::to_string(proof.left_out) +
                         " kinds of bodies were not tried: name them by --body");
  if (proof.assumes_body) {
    const Vec2 size = proof.bodies.front().size;
    say(context.out, file + ": the level has no bodies, so a player of " + px_text(size.x) + "x" +
                         px_text(size.y) + " px was tried");
  }
  say(context.out, file + ": " + summary_of(proof));
}

void prove_file(CommandContext& context, const ProveCommand& options) {
  std::optional<Level> level = load_or_fail(context, options.file);
  if (!level) return;
  apply_physics(options.physics, level->tuning);
  if (const auto problem = ground_problem(*level)) return fail(context, options.file, "", *problem);
  ProveOptions asked{.bodies = {}, .lip = options.lip};
  for (const std::string& body : options.bodies) asked.bodies.push_back(body_of(body).value());
  ProgressLine progress(context.err, "Proving", is_terminal(context.err));
  const ProveScene scene(*level, asked);
  const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const auto proof = prove(scene, options.threads > 0 ? options.threads : processors,
                           [&](double share) { return progress.at(share); });
  progress.wipe();
  if (!proof) return;
  if (options.json) {
    context.out << json_of(*proof).dump() << '\n';
  } else {
    print(context, options.file, *proof);
  }
  if (!proof->findings.empty()) context.status = kExitBad;
}

std::string check_body(const std::string& text) {
  if (body_of(text)) return "";
  std::string kinds;
  for (const BodyTraits& traits : body_kinds())
    kinds += (kinds.empty() ? "" : " or ") + std::string(traits.word);
  return "must be KIND:WxH or KIND:WxH:FOOT, as in player:8x12:centre: " + kinds +
         ", sides of 1/256 to 1024 px, box or centre";
}

}  // namespace

void add_prove_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand(
      "prove",
      "Try every place where a body can stand; exits 1 if one does what the ground does not explain");
  auto options = std::make_shared<ProveCommand>();
  command->add_option("FILE", options->file, "Level or cart")->required();
  add_physics_options(*command, options->physics);
  command->add_option("--body", options->bodies, "A body to try, in the place of those of the level; up to 8")
      ->type_name("KIND:WxH[:FOOT]")
      ->check(check_body)
      ->expected(1, static_cast<int>(kMaxBodies));
  command
      ->add_option("--lip", options->lip, "Higher edges are meant as walls, px; default: a quarter of a tile")
      ->check(check_lip, "0.01 to 256");
  command
      ->add_option("--threads", options->threads, "Default: one for each processor; the answer is the same")
      ->check(CLI::Range(1, 256));
  command->add_flag("--json", options->json, "Print one JSON object");
  add_part_options(*command, context);
  add_outside_option(*command, context);
  command->callback([&context, options] { prove_file(context, *options); });
}

}  // namespace talus
