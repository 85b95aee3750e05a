#include "cli/terminal/usage.h"

#include "syntax/diagnostics/suggest.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::cli {

namespace {

const CLI::App& givenCommand(const CLI::App& app) {
  const auto* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command :
       app.get_subcommands([](const CLI::App* it) { return !it->get_group().empty(); }))
    names.push_back(command->get_name());
  return names;
}

/// The long names of all options, with their dashes.
std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The first word of CLI11's message: the option or argument that it is about.
std::string subjectOf(std::string_view message) {
  return std::string(message.substr(0, message.find_first_of(": ")));
}

std::string lastWordOf(std::string_view message) {
  return std::string(message.substr(message.rfind(' ') + 1));
}

std::string unknownOption(const CLI::App& command, std::string_view word) {
  const auto name = word.substr(0, word.find('='));
  const bool isLong = name.starts_with("--"); // any letter would resemble a single one
  return fmt::format("there is no option `{}`{}", name,
                     isLong ? didYouMean(name, optionNames(command)) : "");
}

/// About words that nothing takes. Options go first: the value of an unknown one displaces
/// arguments.
std::string unexpectedWords(const CLI::App& app, const std::vector<std::string>& words) {
  const auto& command = givenCommand(app);
  const auto option = std::ranges::find_if(words, [](auto& word) { return word.starts_with('-'); });
  if (option != words.end()) return unknownOption(command, *option);
  if (&command == &app)
    return fmt::format("there is no command `{}`{}", words.front(),
                       didYouMean(words.front(), commandNames(app)));
  return fmt::format("unexpected argument `{}`", words.front());
}

/// What an option or argument takes.
std::string expected(const CLI::Option* option) {
  if (!option) return "";
  const auto& value = option->get_option_text();
  return ": " + (value.empty() ? option->get_description() : value);
}

std::string missingArgument(const CLI::App& app, const std::string& name) {
  const auto& command = givenCommand(app);
  if (&command == &app) return "a command is missing";
  return fmt::format("`{}` is missing{}", name, expected(command.get_option_no_throw(name)));
}

std::string wrongNumberOfValues(const CLI::App& app, const CLI::Error& error) {
  const auto name = subjectOf(error.what());
  if (std::string_view(error.what()).find("At Most") != std::string_view::npos)
    return fmt::format("`{}` may be given only once", name);
  return fmt::format("`{}` needs a value{}", name,
                     expected(givenCommand(app).get_option_no_throw(name)));
}

/// CLI11's message is `Could not convert: --flag = value`. Only flags convert by themselves: other
/// options have validators.
std::string unwantedValue(std::string_view message) {
  return fmt::format("`{}` takes no value", subjectOf(message.substr(message.find(": ") + 2)));
}

std::string usageSentence(const CLI::App& app, const CLI::Error& error) {
  const std::string_view said = error.what();
  const auto is = [&](std::string_view name) { return error.get_name() == name; };
  if (const auto words = app.remaining(true); !words.empty()) return unexpectedWords(app, words);
  if (is("RequiredError")) return missingArgument(app, subjectOf(said));
  if (is("ArgumentMismatch")) return wrongNumberOfValues(app, error);
  if (is("ConversionError")) return unwantedValue(said);
  if (is("RequiresError")) return fmt::format("`{}` needs `{}`", subjectOf(said), lastWordOf(said));
  if (is("ExcludesError"))
    return fmt::format("`{}` and `{}` exclude each other", subjectOf(said), lastWordOf(said));
  return std::string(said);
}

} // namespace

std::string didYouMean(std::string_view misspelt, const std::vector<std::string>& words) {
  const auto meant = syntax::nearest(misspelt, words);
  return meant.empty() ? "" : fmt::format("; did you mean `{}`?", meant);
}

std::string notOneOf(std::string_view word, const std::vector<std::string>& words) {
  return fmt::format("`{}` is not one of {}{}", word, fmt::join(words, ", "),
                     didYouMean(word, words));
}

std::string usageMessage(const CLI::App& app, const CLI::Error& error) {
  const auto& command = givenCommand(app);
  const auto name = &command == &app ? "" : " " + command.get_name();
  return fmt::format("error: {}\nrun `proskill{} --help` for more\n",
                     syntax::printable(usageSentence(app, error), "\n\t"), name);
}

} // namespace proskill::cli
