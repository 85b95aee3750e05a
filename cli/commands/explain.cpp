#include "cli/commands/commands.h"

#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/paint.h"
#include "ide/description/explanation.h"
#include "report/text/render.h"
#include "report/text/text_width.h"
#include "syntax/diagnostics/suggest.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <ranges>
#include <unistd.h>

namespace proskill::cli {

namespace {

using ide::paragraphOf;
using ide::titleOf;

struct ExplainArguments {
  std::string code;
  bool list = false;
  bool markdown = false;
  ColourChoice colour = ColourChoice::Auto;
};

/// Maximum width of text, however wide the terminal is.
constexpr std::size_t kWidest = 100;
constexpr std::size_t kNarrowest = 30;

std::string wrapped(std::string_view paragraph, std::size_t width) {
  std::string text;
  std::size_t column = 0;
  for (std::size_t at = 0; at < paragraph.size();) {
    const std::size_t end = std::min(paragraph.find(' ', at), paragraph.size());
    const std::string_view word = paragraph.substr(at, end - at);
    const std::size_t length = report::DisplayedLine(word).column(word.size());
    if (column > 0 && column + 1 + length > width) {
      text += '\n';
      column = 0;
    }
    if (column > 0) {
      text += ' ';
      ++column;
    }
    text += word;
    column += length;
    at = end + 1;
  }
  return text;
}

/// The example line by line; characters that a terminal does not show become `�`.
std::string shownExample(const syntax::CodeInfo& code, std::string_view indent) {
  std::string text;
  std::string_view rest = code.example;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text += std::string(indent) + report::DisplayedLine(rest.substr(0, end)).text() + '\n';
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return text;
}

std::string headOf(const syntax::CodeInfo& code) {
  return std::string(report::words(code.severity)) + "[" + std::string(code.id) + "]";
}

void printOne(const syntax::CodeInfo& code, const report::Paint& paint) {
  const std::size_t width =
      std::clamp(report::terminalWidth(STDOUT_FILENO, 80), kNarrowest, kWidest);
  std::cout << wrapped(paint(report::Colour::Bold, headOf(code) + ": " + titleOf(code)), width)
            << "\n\n"
            << wrapped(paragraphOf(code), width) << '\n';
  if (!code.example.empty())
    std::cout << "\nFor example:\n\n" << paint(report::Colour::Dim, shownExample(code, "    "));
}

void printList() {
  for (const syntax::CodeInfo& code : syntax::allCodes())
    std::cout << code.id << "  " << report::words(code.severity)
              << std::string(9 - report::words(code.severity).size(), ' ') << titleOf(code) << '\n';
}

/// Prints the page of the manual.
void printMarkdown() {
  std::cout
      << "# Diagnostics\n\n"
         "<!-- Made by `proskill explain --markdown` from the table in "
         "syntax/diagnostics/diagnostics.def;"
         " a test compares. -->\n\n"
         "What `proskill check` and the editors report, by code. `proskill explain CODE` "
         "prints one of these.\n"
         "Each program below raises its code. A program with errors has no model and no verdict. A "
         "warning reports\nsomething that is probably not intended. A hint does not count as a "
         "finding.\n";
  for (const syntax::CodeInfo& code : syntax::allCodes()) {
    std::cout << "\n## " << code.id << ": " << titleOf(code) << "\n\n"
              << "*" << report::words(code.severity) << "* — " << paragraphOf(code) << '\n';
    if (!code.example.empty()) std::cout << "\n```proskill\n" << shownExample(code, "") << "```\n";
  }
}

int failUnknownCode(const std::string& code) {
  const auto ids = syntax::allCodes() | std::views::transform(&syntax::CodeInfo::id);
  const auto meant = syntax::nearest(code, ids);
  std::string message = "there is no code `" + code + "`";
  if (!meant.empty()) message += "; did you mean " + std::string(meant) + "?";
  return fail(message + " (`proskill explain --list` shows all)");
}

int runExplain(const ExplainArguments& arguments) {
  if (arguments.markdown) return printMarkdown(), kDone;
  if (arguments.list) return printList(), kDone;
  if (arguments.code.empty()) return fail("which code? `proskill explain --list` shows all");
  const syntax::CodeInfo* code = syntax::findCode(arguments.code);
  if (!code) return failUnknownCode(arguments.code);
  printOne(*code, report::Paint{wantsColour(arguments.colour, STDOUT_FILENO)});
  return kDone;
}

} // namespace

void addExplain(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<ExplainArguments>();
  auto* command = app.add_subcommand("explain", "Explain a diagnostic, with an example");
  command->add_option("code", arguments->code, "The code that check prints, such as PS0201");
  show(command->add_flag("--list", arguments->list, "List all codes, one line each"),
       group::kOutput);
  show(command->add_flag("--markdown", arguments->markdown, "Print all of them as a manual page"),
       group::kOutput);
  addColour(*command, arguments->colour);
  showBelow(
      *command, {"proskill explain PS0201", "proskill explain --list"},
      {{kDone, "explained"}, {kFailed, "there is no such code, or the command line is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runExplain(*arguments); });
}

} // namespace proskill::cli
