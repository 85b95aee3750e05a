#include "runtime/stubs/library_stubs.h"

#include "runtime/stubs/platform_header.h"

#include <fmt/format.h>

#include <ranges>

namespace proskill::runtime {

namespace {

/// The keywords of both languages, and what the generated text uses itself.
constexpr std::string_view kReservedInC =
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
    "char32_t char8_t class co_await co_return co_yield compl concept const const_cast "
    "consteval constexpr constinit continue decltype default delete do double dynamic_cast "
    "else enum explicit export extern false float for friend goto if inline int long mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
    "register reinterpret_cast requires restrict return short signed sizeof static "
    "static_assert static_cast struct switch template this thread_local throw true try "
    "typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while "
    "xor xor_eq "
    "linux unix run report interrupt errno assert Actions Event Skill actions suits log "
    "EOF NULL Robot offsetof stderr stdin stdout";

constexpr std::string_view kLibraryPlatform =
    "{\n  \"kind\": \"library\",\n  \"library\": \"librobot.so\"\n}\n";

} // namespace

std::span<const std::string_view> reservedInC() {
  static const auto words = [] {
    std::vector<std::string_view> all;
    for (const auto word : std::views::split(kReservedInC, ' ')) all.emplace_back(word);
    return all;
  }();
  return words;
}

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
