#pragma once

#include "tests/support/random/form.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/random_source.h"

#include <optional>

namespace proskill::test {

struct VariableWords {
  std::string name;
  std::vector<std::string> values; ///< empty: a natural
  std::int64_t low = 0;
  std::int64_t high = 0;
};

struct SkillWords {
  std::string name;
  bool composite = false;
  bool monitor = false;
  bool interruptible = false;
  bool unstoppable = false;
  bool refusable = false;              ///< known once it is generated, as are its guards
  std::vector<std::string> invariants; ///< tags
  std::vector<std::string> successes;
  std::vector<std::string> failures;
  std::vector<std::pair<std::string, std::string>> inputs; ///< name and type
};

/// The names of a random program, generated before its definitions.
struct Words {
  std::vector<VariableWords> variables;
  std::vector<std::string> events;
  std::vector<std::string> emitted; ///< without `:every`
  std::vector<std::string> resources;
  std::vector<SkillWords>
      skills; ///< composites first, the main one at the front; a skill calls later ones
  std::vector<std::string> labels; ///< of all bodies, as they are generated
  bool library = false;
};

[[nodiscard]] Words randomWords(RandomSource& random, const ProgramSize& size);

/// Conditions, effects, intervals: parts of definitions and statements.
class Phrases {
public:
  Phrases(RandomSource& source, const Words& words, const ProgramSize& bounds)
      : random(source), vocabulary(words), size(bounds) {}

  [[nodiscard]] Form condition(std::size_t depth = 1);
  /// With `running`, `occurs`, and the other atoms of properties.
  [[nodiscard]] Form proposition(std::size_t depth = 1);
  /// `(sv V)` or `((sv V) (n (+ n 1)))`.
  [[nodiscard]] Form effects();
  [[nodiscard]] std::string duration();
  [[nodiscard]] std::string interval();
  /// An interval in which time can pass.
  [[nodiscard]] std::string every();
  [[nodiscard]] std::string literal(const std::string& type);
  /// From here on, phrases are parts of this skill and may read its inputs; null: of no skill.
  void writeIn(const SkillWords* skill) { writtenIn = skill; }

private:
  [[nodiscard]] std::optional<Form> truth();
  [[nodiscard]] Form comparison();
  [[nodiscard]] Form comparisonOfNaturals(const VariableWords& variable);
  [[nodiscard]] Form comparisonOfOutcomes();
  [[nodiscard]] Form effect(const VariableWords& variable);
  [[nodiscard]] Form observation();
  [[nodiscard]] Form connect(bool widened, std::size_t depth);
  [[nodiscard]] std::string seconds(std::int64_t least);
  [[nodiscard]] std::optional<std::string> inputOf(const VariableWords& variable);

  RandomSource& random;
  const Words& vocabulary;
  const ProgramSize& size;
  const SkillWords* writtenIn = nullptr;
};

} // namespace proskill::test
