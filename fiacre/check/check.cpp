#include "fiacre/check/check.h"

#include "fiacre/check/check_parts.h"

#include <fmt/format.h>

namespace proskill::fiacre {

std::vector<Problem> check(const Program& program) {
  std::vector<Problem> problems;
  const Report report(problems);
  const Declarations known(program);
  checkDeclarations(program, known, report);
  for (const auto& function : program.functions)
    checkFunction(function, known, report.at("function " + function.name));
  for (const auto& process : program.processes)
    checkProcess(process, known, report.at("process " + process.name, process.origin));
  for (const auto& component : program.components)
    checkComponent(component, known, report.at("component " + component.name));
  checkStructure(program, known, report);
  for (const auto& component : program.components)
    for (const auto& port : component.ports)
      checkProbe(port, program, known, report.at("component " + component.name, port.origin));
  if (program.main.empty()) return problems; // paths cannot be resolved without a main component
  for (const auto& property : program.properties)
    checkProperty(property, program, known,
                  report.at("property " + property.name, property.origin));
  return problems;
}

} // namespace proskill::fiacre
