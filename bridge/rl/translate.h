#pragma once

#include "bridge/rl/scope.h"

namespace proskill::bridge::rl {

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

  Errors errors;
  std::vector<Note> notes;      ///< what was approximated
  std::vector<Note> unverified; ///< what the program does not state
  std::size_t interrupts = 0;   ///< skills that may be interrupted

private:
  void variable(const Skillset& skillset, const Resource& resource, Scope& scope);
  void event(const Skillset& skillset, const Event& event, Scope& scope);
  void skill(const Skillset& skillset, const Skill& skill, Scope& scope);
  void inputs(const Skill& skill, Form& form);
  void outcomes(const std::vector<Outcome>& all, const char* keyword, NamePool& tags, Scope& scope,
                Form& form);
  void interrupt(const Skill& skill, Scope& scope, Form& form);
  void approximate(const Skill& skill);
  std::string nameOf(const Skillset& skillset, const Word& word);
  [[nodiscard]] std::string comment(const Word& word, const char* kind) const;

  const std::filesystem::path folder;
  const bool several;
  NamePool names;
  Block variables;
  Block events;
  Block skills;
  std::size_t data = 0;
  std::size_t outputs = 0;
  std::size_t progresses = 0;
};

} // namespace proskill::bridge::rl
