#include "cli/terminal/help.h"

#include "report/ordered_json.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace proskill::cli {

namespace {

constexpr std::size_t kLeft = 30;
constexpr std::size_t kWidth = 100;

std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = indent;
  for (std::string word; words >> word;) {
    const bool first = result.empty();
    if (!first && column + 1 + word.size() > kWidth) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!first) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

class HelpFormat : public CLI::Formatter {
public:
  std::string make_option(const CLI::Option* option, bool positional) const override {
    std::string left =
        "  " + make_option_name(option, positional) + (positional ? "" : make_option_opts(option));
    const bool fits = left.size() + 2 <= kLeft;
    left += fits ? std::string(kLeft - left.size(), ' ') : "\n" + std::string(kLeft, ' ');
    return left + wrapped(option->get_description(), kLeft) + "\n";
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const auto& value = option->get_option_text();
    return value.empty() ? "" : " " + value;
  }
};

OrderedJson optionJson(const CLI::Option& option) {
  return {{"long", option.get_lnames()},
          {"short", option.get_snames()},
          {"positional", option.get_positional() ? option.get_name(true) : ""},
          {"value", option.get_option_text()},
          {"group", option.get_group()},
          {"many", option.get_expected_max() > 1},
          {"required", option.get_required()},
          {"sentence", option.get_description()}};
}

OrderedJson commandJson(const CLI::App& command) {
  OrderedJson options = OrderedJson::array();
  for (const auto* option : command.get_options()) options.push_back(optionJson(*option));
  return {{"name", command.get_name()},
          {"sentence", command.get_description()},
          {"options", std::move(options)},
          {"below", command.get_footer()}};
}

void printData(const CLI::App& app) {
  OrderedJson commands = OrderedJson::array();
  for (const auto* command :
       app.get_subcommands([](const CLI::App* it) { return !it->get_group().empty(); }))
    commands.push_back(commandJson(*command));
  std::cout << OrderedJson{{"version", PROSKILL_VERSION},
                           {"commands", commands},
                           {"below", app.get_footer()}}
                   .dump(1)
            << '\n';
}

} // namespace

CLI::Option* show(CLI::Option* option, const char* inGroup, const std::string& value) {
  return option->group(inGroup)->option_text(value);
}

void addMainSkill(CLI::App& command, std::string& mainSkill) {
  show(command.add_option("--main", mainSkill,
                          "Skill to use as the mission, if several are possible"),
       group::kSubject, "SKILL");
}

void showBelow(CLI::App& command, const std::vector<std::string>& examples,
               const std::vector<ExitMeaning>& exits) {
  std::string text = "Examples:\n";
  for (const auto& example : examples) text += "  " + example + "\n";
  text += "\nExit code:\n";
  constexpr std::size_t kIndent = 5;
  for (const auto& [code, meaning] : exits)
    text += "  " + std::to_string(code) +
            std::string(kIndent - 2 - std::to_string(code).size(), ' ') +
            wrapped(meaning, kIndent) + "\n";
  text += "  70 a bug in proskill\n  71 out of memory";
  command.footer(text);
}

void useHelpFormat(CLI::App& app) { app.formatter(std::make_shared<HelpFormat>()); }

void addHelpData(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("help-data")->group("");
  command->callback([&app, &exitCode] {
    printData(app);
    exitCode = 0;
  });
}

} // namespace proskill::cli
