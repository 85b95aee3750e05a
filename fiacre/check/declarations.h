#pragma once

#include "fiacre/check/check.h"
#include "fiacre/syntax/tree.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::fiacre {

/// Collects problems, each with the place being checked.
class Report {
public:
  explicit Report(std::vector<Problem>& list) : problems(&list) {}

  /// The same report for another place.
  [[nodiscard]] Report at(std::string where, OriginId from = 0) const;
  [[nodiscard]] Report from(OriginId id) const;
  void operator()(std::string message) const;

private:
  std::vector<Problem>* problems;
  std::string place;
  OriginId origin = 0;
};

/// A constructor and its union.
struct Constructor {
  const TypeDeclaration* type = nullptr;
  const Member* member = nullptr;
};

/// The declarations of a program by name; for duplicates the first. Valid as long as the program.
struct Declarations {
  std::map<std::string_view, const TypeDeclaration*> types;
  std::map<std::string_view, const Constant*> constants;
  std::map<std::string_view, Constructor> constructors;
  std::map<std::string_view, const Function*> functions;
  std::map<std::string_view, const Extern*> externs;
  std::map<std::string_view, const Task*> tasks;
  std::map<std::string_view, const EventPort*> eventPorts;
  std::map<std::string_view, const Process*> processes;
  std::map<std::string_view, const Component*> components;

  explicit Declarations(const Program& program);
};

template <class Table> const auto* lookUp(const Table& table, std::string_view name) {
  const auto found = table.find(name);
  return found == table.end() ? nullptr : &found->second;
}

/// Checks names of one kind: each is an identifier, not reserved, and unique.
class Names {
public:
  explicit Names(Report to) : report(std::move(to)) {}
  /// \param what the kind, for messages: "the state", "the constant"
  void add(std::string_view name, std::string_view what);

private:
  Report report;
  std::map<std::string_view, std::string_view> seen;
};

} // namespace proskill::fiacre
