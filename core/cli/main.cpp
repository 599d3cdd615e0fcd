/// The program `talus`: verbs, options, and exit codes. All else is in core/cli/*.cpp and, for the models, behind
/// program().

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "core/build_info.hpp"
#include "core/cli/outcome.hpp"
#include "core/cli/runner.hpp"
#include "core/cli/show.hpp"
#include "core/config/nearest.hpp"
#include "core/io/files.hpp"
#include "core/io/pictures.hpp"

namespace talus::cli {

namespace {

/// What the verbs share.
struct Arguments {
  std::string file, kind, name, folder, until;
  std::vector<std::string> files, assignments;
  RunOptions run;
  bool json = false, all = false;
};

std::filesystem::path default_folder(std::string const& file) {
  return std::filesystem::path("runs") / std::filesystem::path(file).stem();
}

int report(RunResult const& result, Arguments const& arguments) {
  if (arguments.json)
    fmt::print("{}\n", result.summary.dump(2));
  else {
    if (!result.verdicts.empty()) fmt::print("{}", verdict_table(result.verdicts));
    fmt::print("{}", ledger_lines(result.summary));
    fmt::print("results in {}\n", arguments.run.folder.string());
  }
  return result.code;
}

/// As above, for what `talus resume` can go on with.
int report_run(RunResult const& result, Arguments const& arguments) {
  if (result.code == stopped && !arguments.run.quiet)
    fmt::print(stderr, "\nstopped by a signal; 'talus resume {}' goes on\n", arguments.run.folder.string());
  return report(result, arguments);
}

int resume(Arguments const& arguments) {
  return report_run(
      StudyFolder::is_one(arguments.run.folder) ? resume_study(arguments.run) : resume_case(arguments.run), arguments);
}

int run(Arguments& arguments) {
  std::string given = io::read_file(arguments.file);
  Document const document = load(arguments.file, arguments.assignments);
  if (arguments.run.folder.empty()) arguments.run.folder = default_folder(arguments.file);
  if (is_point(document.value)) throw InputError(arguments.file + ": this is a material point; 'talus point' runs it");
  bool const study = is_study(document.value);
  return report_run(study ? run_study(document, given, arguments.run) : run_case(document, given, arguments.run),
                    arguments);
}

int point(Arguments& arguments) {
  std::string const given = io::read_file(arguments.file);
  Document const document = load(arguments.file, arguments.assignments);
  if (!is_point(document.value))
    throw InputError(arguments.file + ": /schema: this is no material point, whose tag begins with talus/point/");
  if (arguments.run.folder.empty()) arguments.run.folder = default_folder(arguments.file);
  return report(run_point(document, given, arguments.run), arguments);
}

using Verb = std::function<int()>;

CLI::App* add_verb(CLI::App& app, Verb& chosen, std::string const& name, std::string const& help,
                   std::string const& example, Verb verb) {
  CLI::App* sub = app.add_subcommand(name, help);
  sub->footer("Example:\n  " + example);
  sub->callback([&chosen, verb = std::move(verb)] { chosen = verb; });
  return sub;
}

void add_output_options(CLI::App* verb, Arguments& a) {
  verb->add_option("-o,--output", a.run.folder, "Folder of the run; runs/<name of the document> if not given");
  verb->add_option("--set", a.assignments, "Change a value: /pointer=value");
  verb->add_flag("--force", a.run.force, "Replace an earlier run in the folder");
}

void add_quiet_options(CLI::App* verb, Arguments& a) {
  verb->add_flag("-q,--quiet", a.run.quiet, "No progress.");
  verb->add_flag("!--no-pictures", a.run.pictures, "Draw no pictures at the end");
  verb->add_flag("--json", a.json, "The summary as JSON on standard output.");
}

void add_run_options(CLI::App* verb, Arguments& a) {
  verb->add_option("-t,--threads", a.run.threads,
                   "Threads; 0: as many as the machine offers. Results do not depend on it.")
      ->check(CLI::Range(0, 1024));
  verb->add_option("--until", a.run.until, "Stop at the first step at or after this time [s] and write a checkpoint.")
      ->check([](std::string const& text) {
        double time = -1;
        bool const is_time = CLI::detail::lexical_cast(text, time) && time >= 0;
        return is_time ? std::string() : "'" + text + "' is no time; a number of 0 or more, in s, is needed";
      });
  add_quiet_options(verb, a);
}

void add_running_verbs(CLI::App& app, Verb& chosen, Arguments& a) {
  CLI::App* verb = add_verb(app, chosen, "run", "Run a case, or every case of a study.",
                            "talus run verification/studies/dam_break_22.json -o runs/dam --set /time/end=0.4",
                            [&a] { return run(a); });
  verb->add_option("study", a.file, "Document of a case or study")->required();
  add_output_options(verb, a);
  add_run_options(verb, a);

  verb = add_verb(app, chosen, "point", "Lead one material point along a path of motion and stress.",
                  "talus point verification/points/direct_shear.json -o runs/shear", [&a] { return point(a); });
  verb->add_option("study", a.file, "Document of a material point")->required();
  add_output_options(verb, a);
  add_quiet_options(verb, a);

  verb = add_verb(app, chosen, "resume", "Go on with a run or study from its newest checkpoint, with the same bits.",
                  "talus resume runs/dam", [&a] { return resume(a); });
  verb->add_option("folder", a.run.folder, "Folder of the run or study")->required();
  add_run_options(verb, a);

  verb = add_verb(app, chosen, "plot", "Draw the pictures of a run again.", "talus plot runs/dam", [&a] {
    std::string const trouble = io::draw_pictures(a.run.folder);
    if (!trouble.empty()) throw FileError(trouble);
    fmt::print("pictures in {}\n", (a.run.folder / "plots").string());
    return done;
  });
  verb->add_option("folder", a.run.folder, "Folder of the run")->required();
}

void add_looking_verbs(CLI::App& app, Verb& chosen, Arguments& a) {
  auto const json = [&a](CLI::App* verb) { verb->add_flag("--json", a.json, "JSON on standard output"); };
  auto const document = [&a](CLI::App* verb) {
    verb->add_option("file", a.file, "Document of a case")->required();
    verb->add_option("--set", a.assignments, "Change a value: /pointer=value");
  };
  CLI::App* verb = add_verb(app, chosen, "check", "Find every mistake in documents without running them.",
                            "talus check my_case.json", [&a] { return check(a.files, a.json); });
  verb->add_option("files", a.files, "Documents")->required();
  json(verb);

  verb = add_verb(app, chosen, "explain", "Show what a case is composed of, what it stores, runs and leaves out.",
                  "talus explain verification/studies/dam_break_22.json", [&a] {
                    explain(load(a.file, a.assignments), a.json);
                    return done;
                  });
  document(verb);
  json(verb);

  verb = add_verb(app, chosen, "schema", "Print the JSON Schema (draft-07) of cases and studies.",
                  "talus schema > talus.schema.json", [] {
                    fmt::print("{}\n", program().schema().dump(2));
                    return done;
                  });

  verb = add_verb(app, chosen, "list", "List the policies, all or of one kind.", "talus list laws", [&a] {
    list(a.kind, a.json);
    return done;
  });
  verb->add_option("kind", a.kind, "Kind of policy");
  json(verb);

  verb = add_verb(app, chosen, "describe", "Describe a policy, or the document of a case, study or material point.",
                  "talus describe cam_clay", [&a] {
                    if (a.all)
                      fmt::print("{}", manual());
                    else if (a.name.empty())
                      throw InputError("name a policy, or 'case', 'study' or 'point', or give --all");
                    else
                      describe(a.name, a.json);
                    return done;
                  });
  verb->add_option("name", a.name, "Name of a policy, or 'case', 'study' or 'point'");
  verb->add_flag("--all", a.all, "The whole manual");
  json(verb);

  verb = add_verb(app, chosen, "cite", "What to cite for a case.", "talus cite verification/studies/dam_break_22.json",
                  [&a] {
                    cite(load(a.file, a.assignments), a.json);
                    return done;
                  });
  document(verb);
  json(verb);
}

/// Verbs of other programs: `talus NAME` runs `talus-NAME` beside this one. Returns only where there is none.
void hand_over(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string const verb = argv[1];
  std::error_code unknown;
  auto const other = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / ("talus-" + verb);
  if (unknown || !std::filesystem::exists(other)) return;
  execv(other.c_str(), argv + 1);
}

/// Refuses a verb that there is not, with the nearest one that there is; true if it did.
bool refuse_unknown_verb(CLI::App const& app, std::string const& verb) {
  std::vector<std::string> names;
  for (CLI::App const* sub : app.get_subcommands([](CLI::App const*) { return true; }))
    names.push_back(sub->get_name());
  if (std::find(names.begin(), names.end(), verb) != names.end()) return false;
  auto const near = nearest(verb, {names.begin(), names.end()});
  fmt::print(stderr, "talus: '{}' is no verb;{} 'talus --help' lists them\n", verb,
             near ? " did you mean '" + std::string(*near) + "'?" : "");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  take_failed_writes_as_errors();
  Arguments arguments;
  Verb chosen;
  arguments.run.command_line.assign(argv, argv + argc);
  CLI::App app{"Talus: the material point method for granular flow, proven and fast."};
  app.set_version_flag("--version", "talus " + std::string(build_info::version));
  app.footer(
      "Programs of their own, where they are built:\n"
      "  verify                      Run the verification suite and write its report.\n"
      "  bench                       Measure what it costs.");
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::help);
  add_running_verbs(app, chosen, arguments);
  add_looking_verbs(app, chosen, arguments);
  hand_over(argc, argv);
  for (std::string const verb : {"verify", "bench", "report", "compare"})
    if (argc > 1 && verb == argv[1]) {
      fmt::print(stderr, "talus: '{}' is not in this build\n", verb);
      return not_in_this_build;
    }
  if (argc > 1 && argv[1][0] != '-' && refuse_unknown_verb(app, argv[1])) return usage_error;
  try {
    app.parse(argc, argv);
    return after_output(chosen());
  } catch (CLI::ParseError const& error) {
    return after_output(app.exit(error) == 0 ? done : usage_error);
  } catch (std::exception const& error) {
    return told(error);
  }
}

}  // namespace talus::cli

int main(int argc, char** argv) {
  return talus::cli::main(argc, argv);
}
