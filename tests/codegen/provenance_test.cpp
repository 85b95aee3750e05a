#include "tests/codegen/model_of.h"
#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace proskill::test::provenance_test {

namespace {

const std::string kProgram = R"(
(defsv motion :states (Free Used) :init Free)
(defresource arm)
(defevent gust :effects (motion Used))
(defskill wave
  :precondition (free (motion Free))
  :resources (arm)
  :action (wave)
  :success done)
(defskill mission
  :body ((wave)
         (if (= wave.res done) (printf "bye"))))
)";

struct Told {
  std::string actor;
  std::string words;
  std::string text;
  friend bool operator==(const Told&, const Told&) = default;
};

/// All origins in a process: actor, description, and text.
std::vector<Told> toldIn(const codegen::Model& model, const std::string& program,
                         std::string_view process) {
  std::vector<Told> all;
  const auto visit = [&](const auto& self, const fiacre::Statement& statement) -> void {
    const auto& origin = model.provenance.origins[statement.origin];
    if (!origin.description.empty())
      all.push_back({origin.actor, origin.description,
                     program.substr(origin.begin, origin.end - origin.begin)});
    for (const auto& child : statement.children) self(self, child);
  };
  for (const auto& from : test::processOf(model, process).transitions) visit(visit, from.statement);
  return all;
}

bool tells(const std::vector<Told>& all, const Told& one) {
  return std::ranges::find(all, one) != all.end();
}

/// Calls `visit` for each path through the statement with whether it has an origin.
bool everyPathTells(const fiacre::Statement& statement, const fiacre::Provenance& provenance,
                    bool told) {
  told = told || !provenance.origins[statement.origin].description.empty();
  switch (statement.kind) {
  case fiacre::StatementKind::Select:
    return std::ranges::all_of(statement.children, [&](const auto& child) {
      return everyPathTells(child, provenance, told);
    });
  case fiacre::StatementKind::If:
    return (statement.children.size() == 2 || told) &&
           std::ranges::all_of(statement.children, [&](const auto& child) {
             return everyPathTells(child, provenance, told);
           });
  case fiacre::StatementKind::Sequence: {
    // An origin before or after a branch counts for the branch, too.
    for (const auto& child : statement.children)
      if (child.kind != fiacre::StatementKind::Select && child.kind != fiacre::StatementKind::If)
        told = told || everyPathTells(child, provenance, told);
    for (const auto& child : statement.children)
      told = told || everyPathTells(child, provenance, told);
    return told;
  }
  default: return told;
  }
}

} // namespace

TEST_CASE("steps are told in words of the program, with the place that they come from") {
  const auto model = test::modelOf(kProgram);
  const auto wave = toldIn(model, kProgram, "skill_wave");
  CHECK(tells(wave, {"wave", "starts", "wave"}));
  CHECK(tells(wave, {"wave", "is refused because of its precondition", "free (motion Free)"}));
  CHECK(tells(wave, {"wave", "succeeds with `done`", "done"}));
  const auto mission = toldIn(model, kProgram, "skill_mission");
  CHECK(tells(mission, {"mission", "calls `wave`", "(wave)"}));
  CHECK(tells(mission, {"mission", "continues after `wave`", "(wave)"}));
  CHECK(tells(mission, {"mission", "notices that `wave` was refused", "(wave)"}));
  CHECK(tells(mission, {"mission", "tests `(= wave.res done)`: true", "(= wave.res done)"}));
  CHECK(tells(mission, {"mission", "tests `(= wave.res done)`: false", "(= wave.res done)"}));
  CHECK(tells(mission, {"mission", "prints \"bye\"", "(printf \"bye\")"}));
  CHECK(tells(toldIn(model, kProgram, "event_gust_automata"), {"gust", "occurs", "gust"}));
}

TEST_CASE("a trace shows state variables, statuses, results that are read, and resources") {
  std::vector<std::pair<std::string, std::string>> watched;
  for (const auto& each : test::modelOf(kProgram).provenance.watched)
    watched.emplace_back(each.lvalue, each.display);
  CHECK(watched == std::vector<std::pair<std::string, std::string>>{
                       {"motion", "motion"},
                       {"skill[wave].status", "wave.status"},
                       {"skill[wave].val", "wave.res"},
                       {"skill[mission].status", "mission.status"},
                       {"arm_used", "arm in use"}});
}

TEST_CASE("every process and state of a random program has a place, and every step has words") {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto text = test::textOf(test::randomProgram(seed, test::varied(seed)));
    const auto model = test::modelOf(text);
    INFO(text);
    for (const auto& process : model.fiacre.processes) {
      INFO(process.name);
      CHECK(process.origin != 0);
      for (const auto& state : process.states) CHECK(state.origin != 0);
      if (process.name.starts_with("basic_environment")) continue; // its partner has one
      for (const auto& from : process.transitions) {
        INFO(from.state);
        if (from.state == "before_") continue; // the choice of initial values has one
        if (from.state != "ended") CHECK(everyPathTells(from.statement, model.provenance, false));
      }
    }
  }
}

} // namespace proskill::test::provenance_test
