// Measures the front end: parsing and checking alone, and the whole command.

#include "bench/measure.h"
#include "bench/programs.h"
#include "tests/support/memory_files.h"
#include "tests/support/run.h"
#include "tests/support/texts.h"

#include "analysis/flow/inspect.h"
#include "codegen/model.h"
#include "tests/where.h"

#include <fmt/format.h>

#include <cstring>

using namespace proskill;
using namespace proskill::bench;

namespace {

/// Every process receives every state variable, so models grow quadratically with the program.
constexpr std::size_t kGenerated = 10'000;

/// Reads every byte once: a lower bound for parsing.
double scanSeconds(const std::string& text) {
  return medianSeconds([&] {
    std::size_t depth = 0;
    for (char byte : text) depth += byte == '(' || byte == '\n';
    keep(depth);
  });
}

double copySeconds(const std::string& text) {
  std::string copy(text.size(), ' ');
  return medianSeconds([&] {
    std::memcpy(copy.data(), text.data(), text.size());
    keep(static_cast<std::size_t>(copy.back()));
  });
}

void measureStages(std::size_t lines) {
  std::string text = programOfLines(lines);
  auto count = static_cast<double>(lineCount(text));
  double copy = copySeconds(text);
  double scan = scanSeconds(text);
  double parse = medianSeconds([&] { keep(syntax::Document::parse(text).forms().size()); });
  syntax::Document document = syntax::Document::parse(text);
  analysis::Program program = test::programOfText(text);
  double check = medianSeconds([&] { keep(analysis::check(program).size()); });
  // a letter is typed in the middle of the text
  auto middle = static_cast<syntax::Offset>(text.find("(defskill", text.size() / 2) + 12);
  double edit = medianSeconds([&] { keep(document.edit({middle, middle}, "x").forms().size()); });

  Table table(fmt::format("A program of {:.0f} lines, {} kB, {} findings", count,
                          text.size() / 1000, analysis::check(program).size()));
  auto against = [&](const char* what, double baseline) {
    return fmt::format("{} {}", what, rate(count / baseline, "lines"));
  };
  table.add({"parse", rate(count / parse, "lines"), against("copy", copy), parse / copy});
  table.add({"", "", against("scan", scan), parse / scan});
  table.add(
      {"index and check", rate(count / check, "lines"), against("parse", parse), check / parse});
  if (lines <= kGenerated) {
    double generate = medianSeconds([&] { keep(codegen::generate(program).has_value()); });
    table.add({"generate Fiacre", rate(count / generate, "lines"), against("parse", parse),
               generate / parse});
  }
  table.add({"one letter typed", duration(edit), "parse " + duration(parse), edit / parse});
}

/// The whole analysis of values, flow and time; and again after an edit in one skill.
void measureFlow(std::size_t lines) {
  std::string text = programOfLines(lines);
  analysis::Program program = test::programOfText(text);
  analysis::Analysis analysis = analysis::analyse(program);
  syntax::Document document = syntax::Document::parse(text);
  auto middle = static_cast<syntax::Offset>(text.find("(printf", text.size() / 2));
  double names =
      medianSeconds([&] { keep(analysis::analyse(test::programOfText(text)).diagnostics.size()); });
  double solve = medianSeconds([&] { keep(analysis::flow::Flow(program).system.size()); });
  double flow =
      medianSeconds([&] { keep(analysis::flow::checkFlow(program, analysis.index).size()); });
  double edit = medianSeconds([&] {
    analysis::Program edited = analysis::load(test::MemoryFiles(), "test.proskill",
                                              document.edit({middle, middle}, "(^ 1) "));
    analysis::Analysis again = analysis::analyse(edited);
    keep(analysis::flow::inspect(edited, again).size());
  });
  Table table(fmt::format("The flow of a program of {} lines", lineCount(text)));
  const std::string baseline = "parse and names " + duration(names);
  table.add({"values at all points", duration(solve), baseline, solve / names});
  table.add({"and all checks", duration(flow), baseline, flow / names});
  table.add({"all again after an edit within a skill", duration(edit), baseline, edit / names});
}

/// A long chain of skills that call each other, each with an outcome that its caller tests.
void measureChain(std::size_t skills) {
  std::string text;
  for (std::size_t i = 0; i < skills; ++i)
    text += i + 1 == skills
                ? fmt::format("(defskill s{} :success done :failure lost :body ((^ 1)))\n", i)
                : fmt::format("(defskill s{0} :success done :failure lost\n  :body ((s{1})\n"
                              "    (if (= s{1}.status failure) (failure lost))\n"
                              "    (success done)))\n",
                              i, i + 1);
  analysis::Program program = test::programOfText(text);
  analysis::Analysis analysis = analysis::analyse(program);
  double names = medianSeconds(
      [&] { keep(analysis::analyse(test::programOfText(text)).diagnostics.size()); }, 1);
  double flow =
      medianSeconds([&] { keep(analysis::flow::checkFlow(program, analysis.index).size()); }, 1);
  Table table(fmt::format("The flow of a chain of {} skills", skills));
  table.add({"values and all checks", duration(flow), "parse and names " + duration(names),
             flow / names});
}

void measureCommand(std::size_t lines) {
  test::TemporaryDirectory directory;
  std::string text = programOfLines(lines);
  std::string path = directory.write("program.proskill", text);
  auto timed = [](const std::vector<std::string>& command) {
    return medianSeconds([&] { keep(test::run(command).out.size()); });
  };
  double check = timed({PROSKILL_PROGRAM, "check", path});
  double cat = timed({"/bin/cat", path});
  double version = timed({PROSKILL_PROGRAM, "--version"});
  test::Finished finished = test::run({PROSKILL_PROGRAM, "check", path});
  Table table(fmt::format("`proskill check` on {} lines, from start to end", lineCount(text)));
  table.add({"check", duration(check), "`cat` " + duration(cat), check / cat});
  table.add({"", "", "`proskill --version` " + duration(version), check / version});
  table.add({"largest resident set", fmt::format("{} MB", finished.peakKiB / 1024),
             fmt::format("the text {} kB", text.size() / 1000),
             static_cast<double>(finished.peakKiB) * 1024 / static_cast<double>(text.size())});
}

} // namespace

int main() {
  measureCommand(10'000); // first, since starting a child of a large process is slow
  for (std::size_t lines : {1'000, 10'000, 100'000}) measureStages(lines);
  for (std::size_t lines : {1'000, 10'000, 100'000}) measureFlow(lines);
  for (std::size_t skills : {1'000, 10'000, 100'000}) measureChain(skills);
}
