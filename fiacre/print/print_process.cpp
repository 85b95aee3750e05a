#include "fiacre/print/print_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::fiacre {
namespace {

constexpr std::string_view kVar = "var ";

std::string printPorts(const std::vector<Port>& ports) {
  std::vector<std::string> parts;
  for (const auto& port : ports) parts.push_back(printPort(port));
  return join(parts, ", ");
}

/// Prints the comments of ports, which have no line of their own in a head.
void printPortComments(Output& out, const std::vector<Port>& ports) {
  for (const auto& port : ports)
    if (!port.comment.empty()) out.writer.comment(0, port.name + ": " + port.comment);
}

/// `process NAME [ports] (parameters) is`, on one line or on one for each part.
/// \return whether it took several
bool printHead(Output& out, std::string_view keyword, const std::string& name,
               const std::vector<Port>& ports, const std::vector<Parameter>& parameters) {
  const auto first = fmt::format("{} {}", keyword, name);
  std::vector<std::string> parts;
  if (!ports.empty()) parts.push_back("[" + printPorts(ports) + "]");
  if (!parameters.empty()) parts.push_back("(" + printParameters(parameters) + ")");
  const auto whole = fmt::format("{}{}{} is", first, parts.empty() ? "" : " ", join(parts, " "));
  if (parts.empty() || whole.size() <= Writer::kWidth) {
    out.writer.line(0, whole);
    return false;
  }
  parts.back() += " is";
  out.writer.line(0, first);
  for (const auto& part : parts) out.writer.line(Writer::kStep, part, {}, 1);
  return true;
}

/// `keyword item, item, …`: one item per line if one has a comment, otherwise as many as fit.
template <class Item, class Print>
void printItems(Output& out, std::size_t indent, std::string_view keyword,
                const std::vector<Item>& items, Print print) {
  if (items.empty()) return;
  const bool commented =
      std::ranges::any_of(items, [](auto& item) { return !item.comment.empty(); });
  if (!commented) {
    std::vector<std::string> parts;
    for (const auto& item : items) parts.push_back(print(item));
    return out.writer.line(indent, std::string(keyword) + join(parts, ", "), {}, keyword.size());
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto text = print(items[i]) + (i + 1 < items.size() ? "," : "");
    if (i == 0)
      out.writer.line(indent, std::string(keyword) + text, items[i].comment);
    else
      out.writer.line(indent + keyword.size(), text, items[i].comment);
  }
}

void printInit(Output& out, const std::optional<Statement>& init) {
  if (!init) return;
  out.writer.line(0, "init");
  printStatement(out, *init, Writer::kStep);
}

OriginId originOf(const Process& process, const std::string& state) {
  const auto found = std::ranges::find(process.states, state, &State::name);
  return found == process.states.end() ? 0 : found->origin;
}

void printFrom(Output& out, const From& from, OriginId origin) {
  out.writer.blank();
  Place place(out, origin);
  out.writer.comment(0, from.comment);
  out.writer.line(0, "from " + from.state);
  printStatement(out, from.statement, Writer::kStep);
}

std::string printInstance(const Instance& instance) {
  auto out = instance.process;
  if (!instance.ports.empty()) out += " [" + join(instance.ports, ", ") + "]";
  std::vector<std::string> arguments;
  for (std::size_t i = 0; i < instance.arguments.size(); ++i) {
    const bool reference = i < instance.references.size() && instance.references[i];
    arguments.push_back((reference ? "&" : "") + printExpr(instance.arguments[i]));
  }
  if (!arguments.empty()) out += " (" + join(arguments, ", ") + ")";
  return out;
}

bool synchronisesOnAll(const Instance& instance) { return !instance.synchronised; }

/// `a, b -> ` before an instance; empty if it synchronises on nothing.
std::string printSynchronised(const Instance& instance) {
  if (!instance.synchronised) return "* -> ";
  return instance.synchronised->empty() ? "" : join(*instance.synchronised, ", ") + " -> ";
}

/// Prints a composition, with `par * in` if all instances synchronise on all ports. \param lead
/// text before it on its line
void printComposition(Output& out, const std::vector<Instance>& parts, const std::string& lead,
                      std::size_t indent) {
  const bool onAll = std::ranges::all_of(parts, synchronisesOnAll);
  const std::size_t inner = lead.empty() ? indent : indent + 4;
  out.writer.line(indent, lead + (onAll ? "par * in" : "par"));
  for (const auto& part : parts) {
    const auto before = std::string(&part == parts.data() ? "    " : "||  ") +
                        (onAll ? "" : printSynchronised(part));
    if (part.parts.empty())
      out.writer.line(inner, before + printInstance(part), {}, 8);
    else
      printComposition(out, part.parts, before, inner);
  }
  out.writer.line(inner, "end");
}

void printPriorities(Output& out, const std::vector<Priority>& priorities) {
  if (priorities.empty()) return;
  std::vector<std::string> parts;
  for (const auto& priority : priorities)
    parts.push_back(join(priority.higher, " | ") + " > " + join(priority.lower, " | "));
  constexpr std::string_view keyword = "priority ";
  out.writer.line(0, std::string(keyword) + join(parts, ", "), {}, keyword.size());
}

} // namespace

void printVariables(Output& out, const std::vector<Variable>& variables, std::size_t indent) {
  printItems(out, indent, kVar, variables, [](const Variable& v) { return printVariable(v); });
}

std::string printVariable(const Variable& variable) {
  const auto init = variable.init ? " := " + printExpr(*variable.init) : std::string();
  return fmt::format("{}: {}{}", variable.name, printType(variable.type), init);
}

void printFunction(Output& out, const Function& function) {
  auto& writer = out.writer;
  writer.blank();
  writer.comment(0, function.comment);
  writer.line(0, fmt::format("function {} ({}): {} is", function.name,
                             printParameters(function.parameters), printType(function.result)));
  printVariables(out, function.variables, Writer::kStep);
  writer.line(0, "begin");
  printStatement(out, function.body, Writer::kStep);
  writer.line(0, "end");
}

void printProcess(Output& out, const Process& process) {
  auto& writer = out.writer;
  writer.blank();
  Place place(out, process.origin);
  writer.comment(0, process.comment);
  printPortComments(out, process.ports);
  if (printHead(out, "process", process.name, process.ports, process.parameters)) writer.blank();
  std::vector<std::string> states;
  for (const auto& state : process.states) states.push_back(state.name);
  writer.line(0, "states " + join(states, ", "));
  printVariables(out, process.variables, 0);
  printInit(out, process.init);
  for (const auto& from : process.transitions) printFrom(out, from, originOf(process, from.state));
}

void printComponent(Output& out, const Component& component, const std::string& main) {
  auto& writer = out.writer;
  writer.blank();
  writer.comment(0, component.comment);
  printPortComments(out, component.interfacePorts);
  if (printHead(out, "component", component.name, component.interfacePorts, component.parameters))
    writer.blank();
  printVariables(out, component.variables, 0);
  printItems(out, 0, "port ", component.ports, [&](const Port& port) {
    return printPort(port) + (port.probe ? " is " + printObservable(*port.probe, main) : "");
  });
  printPriorities(out, component.priorities);
  printInit(out, component.init);
  printComposition(out, component.instances, "", 0);
}

void printAttachments(Output& out, const Program& program) {
  if (!program.observers.empty()) out.writer.blank();
  for (const auto& [observer, model, origin] : program.observers) {
    Place place(out, origin);
    out.writer.line(0, fmt::format("{} > {}", observer, model));
  }
}

} // namespace proskill::fiacre
