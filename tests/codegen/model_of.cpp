#include "tests/codegen/model_of.h"

#include "fiacre/check/check.h"
#include "fiacre/print/print.h"
#include "tests/support/texts.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>

namespace proskill::test {
namespace {

/// A line without its comment and trailing blanks.
std::string withoutComment(const std::string& line) {
  auto text = line.substr(0, line.find("//"));
  text.erase(text.find_last_not_of(" \t") + 1);
  return text;
}

/// From the line that starts with `begin` up to the next that starts with one of `ends`.
std::string part(const std::string& text, const std::string& begin,
                 const std::vector<std::string>& ends) {
  std::istringstream lines(text);
  std::string found;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    const auto starts = [&](const std::string& word) {
      return line.starts_with(word) &&
             (line.size() == word.size() || word.ends_with(' ') || line[word.size()] == ' ');
    };
    if (inside && std::ranges::any_of(ends, starts)) break;
    if (starts(begin)) inside = true;
    if (inside) found += line + "\n";
  }
  return found;
}

std::string verdict(const codegen::Check& check, verify::Truth truth) {
  if (truth == verify::Truth::Unknown) return "inconclusive";
  const bool isTrue = truth == verify::Truth::True;
  if (check.good == codegen::Expectation::Reachable) return isTrue ? "unreachable" : "reachable";
  return isTrue ? "holds" : "violated";
}

} // namespace

codegen::Model modelOf(const std::string& text, const codegen::Options& options) {
  const auto program = programOfText(text);
  for (const auto& diagnostic : analysis::check(program))
    if (diagnostic.severity == syntax::Severity::Error) FAIL(diagnostic.message << "\n" << text);
  auto model = codegen::generate(program, options);
  if (!model) FAIL(model.error().message << "\n" << text);
  for (const auto& problem : fiacre::check(model->fiacre))
    FAIL_CHECK(problem.place << ": " << problem.message);
  return std::move(*model);
}

codegen::GenerationError errorOf(const std::string& text, const codegen::Options& options) {
  const auto model = codegen::generate(programOfText(text), options);
  REQUIRE_FALSE(model.has_value());
  return model.error();
}

std::string printed(const codegen::Model& model) {
  std::istringstream lines(fiacre::print(model.fiacre));
  std::string text;
  for (std::string line; std::getline(lines, line);)
    if (auto rest = withoutComment(line); !rest.empty()) text += rest + "\n";
  return text;
}

std::string printedProcess(const codegen::Model& model, std::string_view process) {
  return part(printed(model), "process " + std::string(process), {"process ", "component "});
}

std::string printedState(const codegen::Model& model, std::string_view process,
                         std::string_view state) {
  return part(printedProcess(model, process), "from " + std::string(state), {"from "});
}

const fiacre::Process& processOf(const codegen::Model& model, std::string_view name) {
  const auto found = std::ranges::find(model.fiacre.processes, name, &fiacre::Process::name);
  INFO("no process " << name);
  REQUIRE(found != model.fiacre.processes.end());
  return *found;
}

bool hasState(const fiacre::Process& process, std::string_view state) {
  return std::ranges::find(process.states, state, &fiacre::State::name) != process.states.end();
}

std::map<std::string, std::string> verdictsOf(const std::string& text,
                                              const codegen::Options& options) {
  const auto model = modelOf(text, options);
  std::vector<verify::Question> questions;
  for (const auto& check : model.checks) questions.push_back({check.property});
  const auto result = verify::verify(model.fiacre, model.provenance, questions);
  if (!result) FAIL(result.error().message);
  std::map<std::string, std::string> verdicts;
  for (std::size_t i = 0; i < questions.size(); ++i)
    verdicts[model.checks[i].name] = verdict(model.checks[i], result->answers[i].truth);
  return verdicts;
}

} // namespace proskill::test
