#include "tests/bridge/verdicts.h"

#include "analysis/program/program.h"
#include "codegen/model.h"
#include "tests/support/memory_files.h"
#include "verify/verify.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

namespace proskill::test {
namespace {

/// That one of the copies runs.
std::string running(const std::vector<std::string>& copies) {
  if (copies.size() == 1) return fmt::format("(running {})", copies.front());
  std::string text = "(or";
  for (const auto& copy : copies) text += fmt::format(" (running {})", copy);
  return text + ")";
}

void note(const std::string& question, Observed& observed) {
  const auto rest = question.substr(2);
  const auto bar = rest.find('_');
  if (rest == "success")
    observed.success = true;
  else if (rest == "failure")
    observed.failure = true;
  else if (rest == "skipped")
    observed.skipped = true;
  else if (bar == std::string::npos)
    observed.started.insert(rest);
  else
    observed.together.emplace(rest.substr(0, bar), rest.substr(bar + 1));
}

} // namespace

std::string questions(const Copies& actions, bool maySkip) {
  std::string text = "(defproperty q_success (reachable (ended Main success)))\n";
  if (maySkip)
    text += "(defproperty q_failure (reachable (and (ended Main failure) "
            "(/= Main.res skipped))))\n"
            "(defproperty q_skipped (reachable (and (ended Main failure) (= Main.res skipped))))\n";
  else
    text += "(defproperty q_failure (reachable (ended Main failure)))\n";
  for (const auto& [a, ofA] : actions) {
    text += fmt::format("(defproperty q_{} (reachable {}))\n", a, running(ofA));
    for (const auto& [b, ofB] : actions)
      if (a < b)
        text += fmt::format("(defproperty q_{}_{} (reachable (and {} {})))\n", a, b, running(ofA),
                            running(ofB));
  }
  return text;
}

std::optional<Observed> verified(const std::string& text) {
  const MemoryFiles files({{"main.proskill", text}});
  const auto program = analysis::load(files, "main.proskill");
  for (const auto& finding : analysis::check(program))
    if (finding.severity == syntax::Severity::Error) FAIL(finding.message << "\n" << text);
  const auto model = codegen::generate(program, {.mainSkill = "Main"});
  REQUIRE(model);
  std::vector<const codegen::Check*> checks;
  std::vector<verify::Question> asked;
  for (const auto& check : model->checks)
    if (check.name.starts_with("q_")) {
      checks.push_back(&check);
      asked.push_back({check.property, check.fair, check.exempt, check.rests});
    }
  const auto result =
      verify::verify(model->fiacre, model->provenance, asked, {.limits = {.classes = 10'000}});
  REQUIRE(result);
  Observed observed;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    if (result->answers[i].truth == verify::Truth::Unknown) return std::nullopt;
    if (result->answers[i].truth == verify::Truth::False) note(checks[i]->name, observed);
  }
  return observed;
}

} // namespace proskill::test
