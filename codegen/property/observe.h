#pragma once

#include "codegen/process/component.h"

#include <set>
#include <utility>

namespace proskill::codegen {

/// Observables of the model for its properties.
class Observer {
public:
  Observer(Context& context, const fiacre::Program& program);

  [[nodiscard]] fiacre::Observable state(std::string_view process, std::string_view state) const;
  /// The initial values have been chosen; nullopt: there are none to choose.
  [[nodiscard]] std::optional<fiacre::Observable> begun() const;
  /// A tag of any process. A tag that no process has never occurs.
  [[nodiscard]] fiacre::Observable tag(const std::string& tag) const;
  [[nodiscard]] static fiacre::Observable value(fiacre::Expr condition);
  /// A condition of a property, including atoms.
  [[nodiscard]] fiacre::Observable condition(const syntax::Expr& expr);
  /// Whether a condition since the last call is about a body that the model does not contain.
  [[nodiscard]] bool takeMissing() { return std::exchange(isMissing, false); }
  [[nodiscard]] bool hasTag(const std::string& tag) const { return tags.contains(tag); }

private:
  [[nodiscard]] fiacre::Observable bothWays(const syntax::Expr& equivalence);
  [[nodiscard]] fiacre::Observable compound(fiacre::ObservableKind kind, const syntax::Expr& expr);
  [[nodiscard]] fiacre::Observable event(std::string_view name) const;
  [[nodiscard]] fiacre::Observable running(std::string_view skill) const;
  [[nodiscard]] fiacre::Observable called(std::string_view skill) const;
  [[nodiscard]] fiacre::Observable ended(const syntax::Expr& expr) const;
  [[nodiscard]] fiacre::Observable atLabel(std::string_view label);
  void addStatesAt(std::vector<fiacre::Observable>& found, const BodyAutomaton& thread,
                   std::string_view process, std::string_view label);

  Context& context;
  Places places;
  bool isMissing = false;
  /// The positions of the processes with each tag.
  std::map<std::string, std::set<std::uint32_t>, std::less<>> tags;
};

} // namespace proskill::codegen
