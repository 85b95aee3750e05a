#include "bridge/bt/program/vocabulary.h"

#include <fmt/format.h>

namespace proskill::bridge::bt {
namespace {

std::string keyOf(const Node& node) {
  auto key = node.id;
  for (const auto& [port, value] : node.ports) key += "\n" + port + "\n" + value;
  return key;
}

} // namespace

Form Turn::isReached() const { return list("=", reached, std::to_string(child)); }

Form Turn::isHalted() const {
  Form any = list("or");
  for (std::size_t i = 0; i + 1 < child; ++i) any.parts.push_back(list("=", runs[i], "1"));
  return any.parts.size() == 2 ? any.parts.back() : any;
}

Form Vocabulary::marksBecome(const char* value) const {
  Form effects(std::vector<Form>{});
  for (const auto& mark : marks) effects.parts.push_back(list(mark, value));
  return effects.parts.size() == 1 ? effects.parts.front() : effects;
}

Form Vocabulary::outcome(const char* tag, bool isMarked) const {
  return isMarked ? list(tag, list(":effects", marksBecome("0"))) : Form(tag);
}

Form Vocabulary::command(const Node& node) {
  const auto [known, isNew] = commands.try_emplace(node.id);
  if (isNew) known->second = commandNames.take(node.id);
  Form command(std::vector<Form>{known->second});
  for (const auto& [port, value] : node.ports)
    if (!port.starts_with('_')) command.parts.emplace_back(asString(value));
  return command;
}

std::string Vocabulary::condition(const Node& node) {
  const auto [known, isNew] = conditions.try_emplace(keyOf(node));
  if (isNew) known->second = declareCondition(node);
  return known->second;
}

std::string Vocabulary::watched(const Node& node) {
  return leaves.of(node.name, node.id).changes ? declareCondition(node) : condition(node);
}

std::string Vocabulary::declareCondition(const Node& node) {
  if (leaves.of(node.name, node.id).changes)
    return anyOf(wordOf(node), {"Yes", "No"}, comment(node));
  auto name = names.take(wordOf(node));
  Form variable = list("defsv", name, ":states", list("Yes", "No"), ":init", list("Yes", "No"));
  variable.comment = comment(node);
  variables.push_back(variable);
  return name;
}

std::string Vocabulary::anyOf(const std::string& wish, const std::vector<std::string>& values,
                              const std::string& comment) {
  auto name = names.take(wish);
  Form states(std::vector<Form>(values.begin(), values.end()));
  Form variable = list("defsv", name, ":states", states, ":init", values.front());
  variable.comment = comment;
  variables.push_back(variable);
  for (const auto& value : values) {
    Form event =
        list("defevent", names.take(name + "_becomes_" + value), ":effects", list(name, value));
    event.comment = comment;
    variables.push_back(event);
  }
  return name;
}

std::string Vocabulary::counter(const Node& node, const std::string& suffix, std::int64_t most,
                                std::int64_t init) {
  auto name = names.take(wordOf(node) + suffix);
  Form variable =
      list("defsv", name, ":init", std::to_string(init), ":min", "0", ":max", std::to_string(most));
  variable.comment = comment(node);
  variables.push_back(variable);
  return name;
}

std::string Vocabulary::action(const Node& node) {
  auto name = names.take(wordOf(node));
  actions[name] = node.place;
  const auto& leaf = leaves.of(node.name, node.id);
  Form skill = list("defskill", name);
  skill.comment = comment(node);
  if (const auto interval = leaf.interval(); !interval.empty())
    append(skill.parts, {":time_interval", interval});
  const bool isMarked = !marks.empty() && !leaf.isInstant();
  if (isMarked) append(skill.parts, {":start", marksBecome("1")});
  if (isMarked && turn && !turn->halted.empty())
    append(skill.parts,
           {":invariant", list("not_halted", list(":guard", list("not", turn->isHalted()),
                                                  ":effects", marksBecome("0")))});
  append(skill.parts, {":action", command(node), ":success"});
  const auto tagged = [&](const char* tag) {
    const auto form = outcome(tag, isMarked);
    append(skill.parts, form.word.empty() ? form.parts : Block{form});
  };
  tagged(leaf.succeeds ? "done" : "failed");
  if (leaf.succeeds && leaf.fails) {
    skill.parts.emplace_back(":failure");
    skill.parts.push_back(isMarked ? outcome("failed", true) : Form("failed"));
  }
  skills.push_back(skill);
  return name;
}

void Vocabulary::composite(const std::string& name, const std::string& comment, Block body,
                           const std::optional<Form>& guard) {
  Form skill = list("defskill", name);
  skill.comment = comment;
  if (guard) append(skill.parts, {":invariant", list("watched", list(":guard", *guard))});
  append(skill.parts, {":body", Form(std::move(body))});
  skills.push_back(skill);
}

std::string Vocabulary::comment(const Node& node) const {
  auto what = node.id;
  if (!node.name.empty()) what += " \"" + node.name + "\"";
  return asComment(node.place, what, folder);
}

void Vocabulary::approximate(const Node& node, std::string message) {
  notes.push_back({node.place, std::move(message)});
}

void Vocabulary::fail(const Node& node, std::string message) {
  errors.push_back({node.place, std::move(message)});
}

Block Vocabulary::program() const {
  Block program = variables;
  append(program, skills);
  append(program, properties);
  return program;
}

} // namespace proskill::bridge::bt
