// How fast the front end reads: parsing and checking by themselves, and the whole command.

#include "bench/measure.h"
#include "bench/programs.h"
#include "tests/support/run.h"
#include "tests/support/texts.h"

#include "codegen/model.h"
#include "tests/where.h"

#include <fmt/format.h>

#include <cstring>

using namespace proskill;
using namespace proskill::bench;

namespace {

/// Each process is handed every state variable, so that models grow with the square of a program.
constexpr std::size_t kGenerated = 10'000;

/// Looks at every byte once: what reading costs at the least.
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
  // A letter is typed in the middle of the text.
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
  measureCommand(10'000); // first: a child of a large process is slow to start
  for (std::size_t lines : {1'000, 10'000, 100'000}) measureStages(lines);
}
