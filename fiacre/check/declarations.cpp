#include "fiacre/check/declarations.h"

#include "fiacre/syntax/words.h"

#include <fmt/format.h>

namespace proskill::fiacre {

Report Report::at(std::string where, OriginId id) const {
  auto report = from(id);
  report.place = std::move(where);
  return report;
}

Report Report::from(OriginId id) const {
  auto report = *this;
  if (id != 0) report.origin = id;
  return report;
}

void Report::operator()(std::string message) const {
  problems->push_back({place, std::move(message), origin});
}

Declarations::Declarations(const Program& program) {
  for (const auto& type : program.types) {
    types.emplace(type.name, &type);
    if (type.type.kind != TypeKind::Union) continue;
    for (const auto& member : type.type.members)
      constructors.emplace(member.name, Constructor{&type, &member});
  }
  const auto fill = [](auto& table, const auto& nodes) {
    for (const auto& node : nodes) table.emplace(node.name, &node);
  };
  fill(constants, program.constants);
  fill(functions, program.functions);
  fill(externs, program.externs);
  fill(tasks, program.tasks);
  fill(processes, program.processes);
  fill(components, program.components);
  for (const auto& event : program.eventPorts) eventPorts.emplace(event.port.name, &event);
}

void Names::add(std::string_view name, std::string_view what) {
  if (!isIdentifier(name)) return report(fmt::format("{} `{}` is not a name", what, name));
  if (isKeyword(name)) report(fmt::format("{} `{}` is a reserved word", what, name));
  const auto [first, isNew] = seen.emplace(name, what);
  if (!isNew)
    report(fmt::format("{} `{}` is declared twice, first as {}", what, name, first->second));
}

} // namespace proskill::fiacre
