#include "tina/versions.h"

#include "process/run.h"

namespace proskill::tina {

namespace {

std::string firstLine(const std::string& text) {
  const auto start = text.find_first_not_of(" \t\r\n");
  return start == std::string::npos ? "" : text.substr(start, text.find('\n', start) - start);
}

std::string version(const std::filesystem::path& tool, const std::string& option) {
  constexpr double kPatience = 5; // in seconds
  const auto said = process::run({.command = {tool, option},
                                  .directory = std::filesystem::temp_directory_path(),
                                  .seconds = kPatience});
  const auto line = said ? firstLine(said->out.empty() ? said->err : said->out) : "";
  return tool.string() + (line.empty() ? "" : ": " + line);
}

} // namespace

std::vector<std::string> versions(const Tools& tools) {
  return {version(tools.frac, "-help"),   version(tools.builder, "-help"),
          version(tools.selt, "-help"),   version(tools.ktzio, "-help"),
          version(tools.cc, "--version"), "FRACLIB: " + tools.fraclib.string()};
}

} // namespace proskill::tina
