#include "runtime/stubs/library_stubs.h"

#include "runtime/stubs/platform_header.h"

#include <fmt/format.h>

namespace proskill::runtime {

namespace {

constexpr std::string_view kLibraryPlatform =
    "{\n  \"kind\": \"library\",\n  \"library\": \"librobot.so\"\n}\n";

} // namespace

std::string argumentText(const StubProgram& program, const StubType& type, std::size_t place,
                         const std::function<std::string(std::size_t)>& reader) {
  const auto argument = fmt::format("arguments[{}].", place);
  const ArgumentTexts fields{argument + "integer", argument + "number", argument + "integer != 0",
                             argument + "string"};
  return textFor(program, type, fields, [&](std::size_t variable) {
    return fmt::format("{}({}string)", reader(variable), argument);
  });
}

std::vector<StubFile> libraryFiles(std::string_view compiler,
                                   const std::vector<std::string>& sources,
                                   const std::string& header) {
  const bool isC = compiler == "CC";
  std::vector<StubFile> all{
      {"proskill/platform.h", withStubMark("//", header::platformH), false},
      {"platform.json", std::string(kLibraryPlatform), true},
      {"Makefile",
       fmt::format(
           "# This file is yours: `proskill stubs` does not write it again.\n"
           "{0}FLAGS ?= -O2 -Wall\n\n"
           "librobot.so: {1} {2}\n"
           "\t$({3}) $({0}FLAGS) -std={4} -fPIC -shared -pthread -I. -Wl,-z,defs -o $@ {1}\n",
           isC ? "C" : "CXX", fmt::join(sources, " "), header, compiler, isC ? "c11" : "c++17"),
       true}};
  if (!isC)
    all.push_back({"proskill/platform.hpp", withStubMark("//", header::platformHpp), false});
  return all;
}

} // namespace proskill::runtime
