#include "bridge/bt/simplify/simplify.h"

#include "bridge/bt/simplify/decided.h"
#include "bridge/bt/simplify/live.h"
#include "bridge/bt/simplify/outcomes.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::bridge::bt {
namespace {

void findCalls(const Form& statement, std::set<std::string>& names) {
  if (statement.parts.size() == 1) names.insert(statement.parts.front().word);
  for (const auto& part : statement.parts) findCalls(part, names);
}

using Calls = std::map<std::string, std::set<std::string>>;

void findUsed(const Calls& calls, const std::string& skill, std::set<std::string>& used) {
  const auto known = calls.find(skill);
  if (known == calls.end() || !used.insert(skill).second) return;
  for (const auto& called : known->second) findUsed(calls, called, used);
}

void removeUnused(Block& program, const std::string& mission) {
  Calls calls;
  for (const auto& definition : program)
    if (const auto* body = bodyOf(definition)) findCalls(*body, calls[definition.parts[1].word]);
  std::set<std::string> used;
  findUsed(calls, mission, used);
  std::erase_if(program, [&](const Form& definition) {
    return bodyOf(definition) && !used.contains(definition.parts[1].word);
  });
}

void removeUnreached(Block& program, const std::string& mission) {
  for (auto& definition : program)
    if (const auto* body = bodyOf(definition))
      definition.parts.back() = Form(liveStatements(body->parts));
  removeUnused(program, mission);
}

} // namespace

Block simplified(Block program, const std::string& mission) {
  do removeUnreached(program, mission);
  while (declareOutcomes(program) || decideTests(program));
  return program;
}

std::set<std::string> calledIn(const Block& program) {
  std::set<std::string> names;
  for (const auto& definition : program)
    if (const auto* body = bodyOf(definition)) findCalls(*body, names);
  return names;
}

} // namespace proskill::bridge::bt
