#include "fiacre/print/print.h"
#include "fiacre/print/print_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace proskill::fiacre {
namespace {

bool hasComments(const std::vector<Member>& members) {
  return std::ranges::any_of(members, [](const Member& m) { return !m.comment.empty(); });
}

std::string printMember(const Member& member, bool isUnion) {
  if (member.type.empty()) return member.name;
  return fmt::format("{}{}{}", member.name, isUnion ? " of " : ": ", printType(member.type[0]));
}

std::string printMembers(const Type& type) {
  const bool isUnion = type.kind == TypeKind::Union;
  std::vector<std::string> parts;
  for (const auto& member : type.members) parts.push_back(printMember(member, isUnion));
  return join(parts, isUnion ? " | " : ", ");
}

std::string printTypes(const std::vector<Type>& types) {
  std::string out;
  for (const auto& type : types) out += (out.empty() ? "" : ", ") + printType(type);
  return out;
}

/// Prints a record or a union over several lines, one member per line if one has a comment.
void printLongType(Output& out, const TypeDeclaration& declaration) {
  const auto& type = declaration.type;
  const bool isUnion = type.kind == TypeKind::Union;
  out.writer.line(0, fmt::format("type {} is {}", declaration.name, isUnion ? "union" : "record"),
                  declaration.comment);
  if (hasComments(type.members)) {
    for (std::size_t i = 0; i < type.members.size(); ++i) {
      const bool last = i + 1 == type.members.size();
      const auto text = printMember(type.members[i], isUnion) + (last ? "" : isUnion ? " |" : ",");
      out.writer.line(Writer::kStep, text, type.members[i].comment);
    }
  } else {
    out.writer.line(Writer::kStep, printMembers(type), {}, 0);
  }
  out.writer.line(0, "end");
}

void printTypeDeclaration(Output& out, const TypeDeclaration& declaration) {
  const auto& type = declaration.type;
  const bool structured = type.kind == TypeKind::Record || type.kind == TypeKind::Union;
  const auto text = fmt::format("type {} is {}", declaration.name, printType(type));
  if (structured && (text.size() > Writer::kWidth || hasComments(type.members)))
    printLongType(out, declaration);
  else
    out.writer.line(0, text, declaration.comment);
}

} // namespace

std::string printType(const Type& type) {
  switch (type.kind) {
  case TypeKind::Bool: return "bool";
  case TypeKind::Nat: return "nat";
  case TypeKind::Int: return "int";
  case TypeKind::Range: return fmt::format("{}..{}", type.low, type.high);
  case TypeKind::Record: return fmt::format("record {} end", printMembers(type));
  case TypeKind::Union: return fmt::format("union {} end", printMembers(type));
  case TypeKind::Array: return fmt::format("array {} of {}", type.size, printType(type.element[0]));
  case TypeKind::Queue: return fmt::format("queue {} of {}", type.size, printType(type.element[0]));
  case TypeKind::Named: return type.name;
  }
  assert(false);
  return {};
}

std::string printInterval(const Interval& interval) {
  const auto upper = interval.upper
                         ? fmt::format("{}{}", *interval.upper, interval.upperOpen ? '[' : ']')
                         : std::string("...[");
  return fmt::format("{}{},{}", interval.lowerOpen ? ']' : '[', interval.lower, upper);
}

std::string printPort(const Port& port) {
  auto out = port.name + ": ";
  if (port.in) out += "in ";
  if (port.out) out += "out ";
  std::vector<std::string> values;
  for (const auto& value : port.values) values.push_back(printType(value));
  out += values.empty() ? "sync" : join(values, " # ");
  if (port.interval) out += " in " + printInterval(*port.interval);
  return out;
}

std::string printParameters(const std::vector<Parameter>& parameters) {
  std::vector<std::string> parts;
  for (const auto& parameter : parameters)
    parts.push_back(fmt::format("{}{}: {}", parameter.reference ? "&" : "", parameter.name,
                                printType(parameter.type)));
  return join(parts, ", ");
}

void printDeclarations(Output& out, const Program& program) {
  auto& writer = out.writer;
  const auto newGroup = [&](const auto& group) {
    if (!group.empty()) writer.blank();
  };
  newGroup(program.constants);
  for (const auto& constant : program.constants)
    writer.line(0, fmt::format("const {}: {} is {}", constant.name, printType(constant.type),
                               printExpr(constant.value)));
  newGroup(program.types);
  for (const auto& declaration : program.types) printTypeDeclaration(out, declaration);
  newGroup(program.eventPorts);
  for (const auto& event : program.eventPorts)
    writer.line(0, fmt::format("event {} is {}", printPort(event.port), event.function),
                event.port.comment);
  newGroup(program.tasks);
  for (const auto& task : program.tasks)
    writer.line(0, fmt::format("task {} ({}): {} is {}", task.name, printTypes(task.parameters),
                               printType(task.result), task.function));
  newGroup(program.externs);
  for (const auto& external : program.externs)
    writer.line(0, fmt::format("extern {} ({}): {} is {}", external.name,
                               printTypes(external.parameters), printType(external.result),
                               external.function));
}

} // namespace proskill::fiacre
