#pragma once

#include "bridge/gen/read/component.h"
#include "bridge/text/form.h"
#include "bridge/text/leaves.h"
#include "bridge/text/names.h"

namespace proskill::bridge::gen {

/// Components as one program: each service becomes a basic skill. A service that others interrupt
/// has a variable, which they set when they start and its guard watches.
class Translation {
public:
  /// \param several components are to be added, so their names become part of all others
  Translation(const Leaves& leaves, std::filesystem::path folder, bool several)
      : leaves(leaves), folder(std::move(folder)), several(several) {}

  void add(const Component& component);
  /// All definitions: state variables, skills.
  [[nodiscard]] Block program() const;
  /// What has no equivalent and does not matter to verdicts, as lines for people.
  [[nodiscard]] std::vector<std::string> omitted() const;

  std::vector<Note> notes; ///< what was approximated

private:
  /// The variables that say whether a service was replaced, and whether it has been done, if
  /// something depends on it.
  struct Flags {
    std::string replaced;
    std::string done;
  };

  void addFlags(const Component& component);
  std::string addFlag(const Component& component, const Service& service, const char* suffix);
  void skill(const Service& service);
  void preconditions(const Service& service, Form& form) const;
  void start(const Service& service, Form& form) const;
  void outcomes(const Service& service, Form& form) const;
  void approximate(const Service& service);
  [[nodiscard]] std::string nameOf(const Component& component, const std::string& word) const;
  /// Empty: the service has no such flag.
  [[nodiscard]] const std::string& flagOf(const Word& service, std::string Flags::*which) const;

  const Leaves& leaves;
  const std::filesystem::path folder;
  const bool several;
  NamePool names;
  Block variables;
  Block skills;
  // of the component that is being added, by service:
  std::map<std::string, std::string> skillNames;
  std::map<std::string, Flags, std::less<>> flags;
  std::size_t ports = 0;
  std::size_t tasks = 0;
  std::size_t codels = 0;
  std::size_t outputs = 0;
};

} // namespace proskill::bridge::gen
