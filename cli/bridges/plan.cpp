#include "cli/bridges/commands.h"

#include "bridge/pddl/emit.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/number.h"
#include "disk/installation.h"
#include "disk/output.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <unistd.h>

namespace proskill::cli {
namespace {

using bridge::pddl::Outcomes;

struct PlanArguments {
  std::string goal;
  std::string file;
  std::string output;
  std::string name = "plan";
  std::string planner;
  std::string python = "python3";
  Outcomes outcomes = Outcomes::Best;
  bool anml = false;
  unsigned timeLimit = 60;
  unsigned memoryLimit = 4096;
};

std::vector<std::string> commandOf(const PlanArguments& arguments) {
  std::vector<std::string> words{arguments.python};
  for (auto& word : disk::pythonPackage(disk::folderOfProgram(), "planning"))
    words.push_back(std::move(word));
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--proskill", std::filesystem::read_symlink("/proc/self/exe").string());
  add("--planner", arguments.planner);
  add("--outcomes", arguments.outcomes == Outcomes::Best ? "best" : "all");
  add("--time-limit", fmt::format("{}", arguments.timeLimit));
  add("--memory-limit", fmt::format("{}", arguments.memoryLimit));
  add("--name", arguments.name);
  add("--output", arguments.output);
  if (arguments.anml) words.emplace_back("--anml");
  words.insert(words.end(), {"--", arguments.goal, arguments.file});
  return words;
}

/// Becomes the process that plans. Only returns if that is impossible.
int runPlan(const PlanArguments& arguments) {
  if (disk::replaces(arguments.output, arguments.file))
    return fail("`-o` names the file that is read");
  if (arguments.goal.find_first_not_of(" \t\n") == std::string::npos)
    return fail("the goal is empty; write a condition, such as `(door Open)`");
  auto words = commandOf(arguments);
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers.front(), pointers.data());
  return fail(fmt::format("cannot start `{}`: {}", arguments.python, std::strerror(errno)));
}

} // namespace

void addPlan(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<PlanArguments>();
  auto* command = app.add_subcommand("plan", "Write a mission by a planner, and verify it");
  command->add_option("goal", arguments->goal, "Condition that the mission makes true")->required();
  command->add_option("file", arguments->file, "Root file of the program")->required();
  show(command->add_option("-o,--output", arguments->output,
                           "Write to this file instead of standard output"),
       group::kOutput, "FILE");
  show(command->add_option("--name", arguments->name, "Name of the mission (default plan)"),
       group::kOutput, "NAME");
  show(command->add_flag("--anml", arguments->anml,
                         "Write the planning problem in ANML instead of a plan"),
       group::kOutput);
  addChoice<std::string>(*command, "--planner", arguments->planner,
                         {{"aries", "aries"},
                          {"tamer", "tamer"},
                          {"enhsp", "enhsp"},
                          {"fast-downward", "fast-downward"}},
                         "Planner to use (default: the first that is installed and finds a plan)");
  addChoice<Outcomes>(*command, "--outcomes", arguments->outcomes,
                      {{"best", Outcomes::Best}, {"all", Outcomes::All}},
                      "best: skills succeed; all: the planner may choose failures, too");
  show(command
           ->add_option("--time-limit", arguments->timeLimit,
                        "Time limit of each call of a planner, in seconds (default 60)")
           ->check(integerBetween(1, 86'400)),
       group::kAdvanced, "SECONDS");
  show(command
           ->add_option("--memory-limit", arguments->memoryLimit,
                        "Memory limit of a planner, in MiB (default 4096)")
           ->check(integerBetween(64, 1U << 20)),
       group::kAdvanced, "MIB");
  show(command->add_option("--python", arguments->python,
                           "Python with the package unified-planning (default python3)"),
       group::kAdvanced, "PROGRAM");
  showBelow(*command, {"proskill plan '(area Photographed)' survey.proskill -o mission.proskill"},
            {{kDone, "a verified plan was written, or the problem"},
             {kFound, "the goal is impossible: no order of skills reaches it"},
             {kFailed, "the goal, the program or the command line is wrong"},
             {kInconclusive, "no plan was found, or none was verified, within the limits"}});
  command->callback([arguments, &exitCode] { exitCode = runPlan(*arguments); });
}

} // namespace proskill::cli
