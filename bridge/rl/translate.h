#pragma once

#include "bridge/rl/read/composite.h"
#include "bridge/rl/scope.h"

#include <expected>
#include <map>
#include <set>

namespace proskill::bridge::rl {

/// What a composite can call.
struct Callable {
  std::string name;                ///< in the program
  std::vector<std::string> inputs; ///< in the program
  std::vector<std::string> types;  ///< of the inputs, in the program
};

/// A composite skill that calls a composite with parameters, which nothing else calls: a mission
/// has no inputs. Truth values are any; other values are texts with the names of the parameters, or
/// 0.
[[nodiscard]] std::expected<Block, std::string> startOf(const Callable& composite, NamePool& names);

/// The type of an input in ProSkill. Other types are passed on as texts.
[[nodiscard]] std::string_view typeOf(std::string type);

/// Skillsets as one program: resources become state variables, events and skills keep their parts.
class Translation {
public:
  /// \param several skillsets are to be added, so their names become part of all others
  Translation(std::filesystem::path folder, bool several)
      : folder(std::move(folder)), several(several) {}

  void add(const Skillset& skillset);
  /// All definitions: state variables, events, skills.
  [[nodiscard]] Block program() const;
  /// What has no equivalent and does not matter to verdicts, as lines for people.
  [[nodiscard]] std::vector<std::string> omitted() const;

  /// By skillset and skill.
  std::map<std::pair<std::string, std::string>, Callable> callable;
  NamePool names;
  Block skills;
  Block variables;
  [[nodiscard]] std::string comment(const Word& word, const char* kind) const;

  Errors errors;
  std::vector<Note> notes;      ///< what was approximated
  std::vector<Note> unverified; ///< what the program does not state
  std::size_t interrupts = 0;   ///< skills that may be interrupted

private:
  /// Reports names that two of a list have.
  void checkNames(const auto& all, const char* kind);
  void variable(const Skillset& skillset, const Resource& resource, Scope& scope);
  void event(const Skillset& skillset, const Event& event, Scope& scope);
  void skill(const Skillset& skillset, const Skill& skill, Scope& scope);
  void inputs(const Skill& skill, Form& form);
  void outcomes(const std::vector<Outcome>& all, const char* keyword, NamePool& tags, Scope& scope,
                Form& form);
  void interrupt(const Skill& skill, Scope& scope, Form& form);
  void approximate(const Skill& skill);
  std::string nameOf(const Skillset& skillset, const Word& word);

  const std::filesystem::path folder;
  const bool several;
  std::set<std::string> skillsets; ///< added so far
  Block events;
  std::size_t data = 0;
  std::size_t outputs = 0;
  std::size_t progresses = 0;
};

} // namespace proskill::bridge::rl
