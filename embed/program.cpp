#include "embed/program.h"

#include "disk/disk.h"
#include "syntax/text/position.h"

#include <fmt/format.h>

namespace proskill::embed {

namespace {

std::string errorsOf(const analysis::Program& program) {
  std::string lines;
  for (const auto& found : analysis::check(program)) {
    if (found.severity != syntax::Severity::Error) continue;
    if (!lines.empty()) lines += '\n';
    lines += errorAt(program, found.location,
                     fmt::format("{} [{}]", found.message, syntax::info(found.code).id));
  }
  return lines;
}

} // namespace

std::expected<proskill_program, Failure> loadProgram(const char* file) {
  const disk::DiskFileSystem disk;
  auto document = disk.document(file);
  if (!document)
    return failed(PROSKILL_UNREADABLE, fmt::format("cannot read `{}`: {}", file, document.error()));
  auto program =
      std::make_shared<const analysis::Program>(analysis::load(disk, file, std::move(*document)));
  auto errors = errorsOf(*program);
  if (!errors.empty()) return failed(PROSKILL_INVALID_PROGRAM, std::move(errors));
  return proskill_program{std::move(program)};
}

Place placeOf(const analysis::Program& program, const analysis::Location& location) {
  const auto& document = program.files[location.file].document;
  const auto at = syntax::toEditor(document.text(), document.lines(), location.range.begin,
                                   syntax::Encoding::Utf32);
  return {at.line + 1, at.character + 1};
}

std::string errorAt(const analysis::Program& program, const analysis::Location& location,
                    std::string_view message) {
  const auto [line, column] = placeOf(program, location);
  return fmt::format("{}:{}:{}: error: {}", program.files[location.file].path.generic_string(),
                     line, column, message);
}

} // namespace proskill::embed
