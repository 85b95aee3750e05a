#pragma once

#include "tests/support/random/random_words.h"

namespace proskill::test {

/// Generates bodies of composite skills and of environments.
class Bodies {
public:
  Bodies(RandomSource& source, Words& words, Phrases& phrases, const ProgramSize& bounds)
      : random(source), vocabulary(words), phrase(phrases), size(bounds) {}

  /// The body of the composite `skill`, an index into the words. \param mustCall skills that it
  /// calls at the end
  [[nodiscard]] Form ofSkill(std::size_t skill);
  [[nodiscard]] Form ofEnvironment();
  /// Composites that no body calls yet, except monitors and the first one.
  [[nodiscard]] std::vector<std::size_t> uncalled() const;
  /// A call by the skill `caller`, whose own inputs may be passed on.
  [[nodiscard]] Form call(std::size_t skill, std::size_t caller);

private:
  /// The context of a statement.
  struct Place {
    std::size_t skill = 0;
    std::size_t depth = 0;
    bool environment = false;
    bool inLoop = false;
    std::vector<std::string>* labels = nullptr; ///< of the body or branch
  };

  [[nodiscard]] std::vector<Form> block(Place place);
  [[nodiscard]] static bool looks(const Form& statement);
  [[nodiscard]] std::string newLabel();
  void topLevel(Place place, Form& body);
  [[nodiscard]] Form statement(Place place);
  [[nodiscard]] Form simple(Place place);
  [[nodiscard]] Form compound(Place place);
  [[nodiscard]] Form wait(Place place);
  void addTimeout(Place place, Form& wait);
  [[nodiscard]] Form callOrInterrupt(Place place);
  [[nodiscard]] Form cases(std::size_t callee, Place place);
  [[nodiscard]] std::vector<Form> outcomesOf(const SkillWords& skill);
  [[nodiscard]] Form outcome(Place place);
  [[nodiscard]] Form print();
  [[nodiscard]] Form choice(Place place);
  [[nodiscard]] Form loop(Place place);
  [[nodiscard]] const char* fork(Place place);
  [[nodiscard]] Form branches(Place place, const char* head);
  [[nodiscard]] Form interruptOf(Place place);

  RandomSource& random;
  Words& vocabulary;
  Phrases& phrase;
  const ProgramSize& size;
  std::vector<std::size_t> called;
};

} // namespace proskill::test
