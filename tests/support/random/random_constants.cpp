#include "tests/support/random/random_constants.h"

#include <algorithm>
#include <map>
#include <regex>

namespace proskill::test {

namespace {

class Naming {
public:
  Form named(const Form& form) {
    if (form.isList()) {
      Form result;
      for (const auto& item : form.items) result.add(named(item));
      return result;
    }
    const bool isNumeric = std::regex_match(form.word, kNumber) || isBracket(form.word.front());
    return isNumeric ? Form(inWord(form.word)) : form;
  }

  /// Half of them before the program and half after it.
  void define(std::vector<Form>& program) const {
    std::size_t count = 0;
    for (const auto& [number, name] : names) {
      Form definition{"defconst", name, number};
      program.insert(count++ % 2 == 0 ? program.begin() : program.end(), std::move(definition));
    }
  }

private:
  static inline const std::regex kNumber{"-?[0-9]+(\\.[0-9]+)?"};

  static bool isBracket(char c) { return c == '[' || c == ']'; }

  /// A number, or an interval.
  std::string inWord(const std::string& word) {
    std::string result;
    auto done = word.begin();
    for (std::sregex_iterator it(word.begin(), word.end(), kNumber), end; it != end; ++it) {
      result.append(done, (*it)[0].first).append(nameOf(it->str()));
      done = (*it)[0].second;
    }
    return result.append(done, word.end());
  }

  const std::string& nameOf(const std::string& number) {
    std::string name = "number_" + number;
    std::ranges::replace(name, '.', '_');
    std::ranges::replace(name, '-', 'm');
    return names.try_emplace(number, std::move(name)).first->second;
  }

  std::map<std::string, std::string> names; ///< of numbers as written
};

} // namespace

std::vector<Form> withConstants(const std::vector<Form>& program) {
  Naming naming;
  std::vector<Form> result;
  for (const auto& form : program) result.push_back(naming.named(form));
  naming.define(result);
  return result;
}

} // namespace proskill::test
