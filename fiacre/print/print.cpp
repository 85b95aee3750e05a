#include "fiacre/print/print.h"
#include "fiacre/print/print_parts.h"

#include <utility>

namespace proskill::fiacre {

Place::Place(Output& output, OriginId origin) : out(output), index(output.ranges.size()) {
  out.ranges.push_back({origin, out.writer.lines(), out.writer.lines()});
}

Place::~Place() {
  auto& range = out.ranges[index];
  if (out.writer.lines() > range.firstLine) range.lastLine = out.writer.lines() - 1;
}

std::string join(const std::vector<std::string>& parts, std::string_view between) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0) out += between;
    out += parts[i];
  }
  return out;
}

namespace {

/// Keeps one range for each origin that wrote something, and removes those without an origin.
void dropEmpty(std::vector<PrintedRange>& ranges) {
  std::erase_if(ranges, [](const PrintedRange& range) { return range.origin == 0; });
}

} // namespace

PrintResult printWithRanges(const Program& program, const PrintOptions& options) {
  Output out;
  out.writer.comment(0, program.comment);
  printDeclarations(out, program);
  for (const auto& function : program.functions) printFunction(out, function);
  for (const auto& process : program.processes) printProcess(out, process);
  for (const auto& component : program.components) printComponent(out, component, program.main);
  if (!program.main.empty()) {
    out.writer.blank();
    out.writer.line(0, program.main);
  }
  printAttachments(out, program);
  for (const auto& property : program.properties)
    printProperty(out, property, program.main, options);
  dropEmpty(out.ranges);
  return {out.writer.take(), std::move(out.ranges)};
}

std::string print(const Program& program, const PrintOptions& options) {
  return printWithRanges(program, options).text;
}

} // namespace proskill::fiacre
