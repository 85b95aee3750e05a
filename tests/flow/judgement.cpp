#include "tests/flow/flow_claims.h"

#include "codegen/term/build.h"
#include "syntax/diagnostics/codes.h"
#include "verify/verify.h"

#include <fmt/format.h>

namespace proskill::test {

namespace {

constexpr std::uint64_t kMostClasses = 30'000;

} // namespace

Judged Judgement::result() {
  if (!valid) return {};
  System system(program);
  Solver solver(system);
  analysis::Findings findings;
  Report made{program, solver, index.index, findings};
  report = &made;
  found = checkFlow(program, index.index);
  for (const Diagnostic& each : found) ++judged.codes[std::string(syntax::info(each.code).id)];
  queries = questionsOf(made, found);
  if (!decide(textWithQueries())) return {};
  judged.decided = true;
  for (const Verdict& verdict : verdicts) judge(verdict);
  for (const Diagnostic& each : found) judgeCertain(each);
  judgeFixed();
  return std::move(judged);
}

std::string Judgement::textWithQueries() const {
  std::string asked = text;
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (queries[i].variable.empty())
      asked += fmt::format("\n(defproperty query_{} (reachable {}))", i, queries[i].condition);
  return asked;
}

bool Judgement::decide(const std::string& source) {
  verdicts.clear();
  analysis::Program asked = programOfText(source);
  auto model = codegen::generate(asked);
  if (!model) return false;
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (!queries[i].variable.empty()) askOfModel(*model, i);
  std::vector<verify::Question> questions;
  for (const auto& check : model->checks) questions.push_back({check.property});
  verify::Options options;
  options.limits.classes = kMostClasses;
  auto result = verify::verify(model->fiacre, model->provenance, questions, options);
  if (!result || !result->exploration.complete) return false;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (result->answers[i].truth == verify::Truth::Unknown) continue;
    const auto& origin = model->provenance.origins[model->checks[i].origin];
    verdicts.push_back({model->checks[i],
                        {origin.file, {origin.begin, origin.end}},
                        result->answers[i].truth == verify::Truth::False});
  }
  return true;
}

std::string Judgement::nameIn(const codegen::Model& model, const std::string& variable) {
  std::string found = variable;
  for (const fiacre::Variable& each : model.fiacre.components.back().variables)
    if (each.name.starts_with(variable) &&
        each.name.find_first_not_of('_', variable.size()) == std::string::npos)
      found = each.name; // resources come last
  return found;
}

void Judgement::askOfModel(codegen::Model& model, std::size_t query) const {
  const std::string name = nameIn(model, queries[query].variable);
  fiacre::Observable seen{
      .kind = fiacre::ObservableKind::Value,
      .value = codegen::equal(codegen::name(name), codegen::number(queries[query].value))};
  fiacre::Property property{.name = fmt::format("query_{}", query)};
  property.pattern.operands.push_back(std::move(seen));
  model.checks.push_back({.name = queries[query].condition,
                          .kind = "property",
                          .subject = property.name,
                          .property = model.fiacre.properties.size()});
  model.fiacre.properties.push_back(std::move(property));
}

const Verdict* Judgement::find(std::string_view kind, Location place) const {
  auto here = std::ranges::find_if(verdicts, [&](const Verdict& each) {
    return each.check.kind == kind && each.place == place;
  });
  return here == verdicts.end() ? nullptr : &*here;
}

const Verdict* Judgement::findOf(std::string_view kind, std::string_view subject) const {
  auto here = std::ranges::find_if(verdicts, [&](const Verdict& each) {
    return each.check.kind == kind && each.check.subject == subject;
  });
  return here == verdicts.end() ? nullptr : &*here;
}

bool Judgement::within(Location inner, Location outer) {
  return inner.file == outer.file && outer.range.begin <= inner.range.begin &&
         inner.range.end <= outer.range.end;
}

const Verdict* Judgement::enclosing(Location place,
                                    std::initializer_list<std::string_view> kinds) const {
  const Verdict* innermost = nullptr; // a wait contains the statements after its timeout
  for (const Verdict& each : verdicts)
    if (std::ranges::find(kinds, each.check.kind) != kinds.end() && within(place, each.place) &&
        (!innermost || within(each.place, innermost->place)))
      innermost = &each;
  return innermost;
}

Judged judge(const std::string& program) { return Judgement(program).result(); }

} // namespace proskill::test
