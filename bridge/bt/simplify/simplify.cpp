#include "bridge/bt/simplify/simplify.h"

#include "bridge/bt/simplify/decided.h"
#include "bridge/bt/simplify/live.h"

#include <algorithm>
#include <map>
#include <set>

namespace proskill::bridge::bt {
namespace {

/// Null if it is not a composite skill, which ends with its body.
const Form* bodyOf(const Form& definition) {
  const auto& parts = definition.parts;
  return parts[parts.size() - 2] == ":body" ? &parts.back() : nullptr;
}

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

/// The outcomes that a body has, as fields of its skill.
Block outcomesOf(const Form& body) {
  Block fields;
  if (contains(body, list("success", "done"))) append(fields, {":success", "done"});
  const bool fails = contains(body, list("failure", "failed"));
  if (contains(body, list("failure", "skipped")))
    append(fields, {":failure", fails ? list("failed", "skipped") : Form("skipped")});
  else if (fails)
    append(fields, {":failure", "failed"});
  return fields;
}

void removeUnreached(Block& program, const std::string& mission) {
  for (auto& definition : program)
    if (const auto* body = bodyOf(definition))
      definition.parts.back() = Form(liveStatements(body->parts));
  removeUnused(program, mission);
  for (auto& definition : program) {
    const auto* body = bodyOf(definition);
    if (!body) continue;
    auto& parts = definition.parts;
    const auto outcomes = outcomesOf(*body);
    const auto isOutcome = [](const Form& part) {
      return part == ":success" || part == ":failure" || part == ":body";
    };
    parts.erase(std::ranges::find_if(parts, isOutcome), parts.end() - 2);
    parts.insert(parts.end() - 2, outcomes.begin(), outcomes.end());
  }
}

} // namespace

Block simplified(Block program, const std::string& mission) {
  do removeUnreached(program, mission);
  while (decideTests(program));
  return program;
}

std::set<std::string> calledIn(const Block& program) {
  std::set<std::string> names;
  for (const auto& definition : program)
    if (const auto* body = bodyOf(definition)) findCalls(*body, names);
  return names;
}

} // namespace proskill::bridge::bt
