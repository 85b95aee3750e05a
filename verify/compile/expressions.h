#pragma once

#include "verify/compile/types.h"
#include "verify/model/nodes.h"

#include <deque>
#include <map>
#include <string>

namespace proskill::verify {

/// What an expression stands for: a node for each scalar of its type.
struct Value {
  const fiacre::Type* type = nullptr; ///< resolved
  std::vector<NodeId> parts;
};

using Scope = std::map<std::string, Value, std::less<>>;

/// Makes nodes of Fiacre's expressions. Functions are inlined; indices that are no constants become
/// choices between the elements.
class Expressions {
public:
  Expressions(const fiacre::Program& program, const Types& types, System& system);

  /// \param expected the type that the context wants, null where it wants none: it tells apart
  /// constructors that several unions share. \throw CompileError
  [[nodiscard]] Value value(const fiacre::Expr& expr, const Scope& scope,
                            const fiacre::Type* expected = nullptr);
  /// \throw CompileError where the value has several parts
  [[nodiscard]] NodeId scalar(const fiacre::Expr& expr, const Scope& scope,
                              const fiacre::Type* expected = nullptr);
  /// All assignments that write `source` to `target`. \param first from there on they happen at
  /// once: what is written twice is joined \throw CompileError
  void assign(const fiacre::Expr& target, const Value& source, const Scope& scope,
              std::vector<Assignment>& assignments, std::size_t first);
  /// The value where it is one of the type; a fault where a number lies outside.
  Value fitted(Value value, const fiacre::Type& type, const std::string& what);
  /// The condition under which `tested` matches the pattern of a `case`.
  [[nodiscard]] NodeId matches(const fiacre::Expr& pattern, const Value& tested,
                               const Scope& scope);
  /// What such a pattern gives to variables: `frame(x)` gives x the value of a frame.
  struct Binding {
    fiacre::Expr variable;
    Value value;
  };
  [[nodiscard]] std::vector<Binding> bindings(const fiacre::Expr& pattern, const Value& tested,
                                              const Scope& scope);
  /// The type of what can be assigned to. \throw CompileError
  [[nodiscard]] const fiacre::Type& typeOf(const fiacre::Expr& lvalue, const Scope& scope);

  [[nodiscard]] Nodes& nodes() { return maker; }
  [[nodiscard]] bool mayFail(NodeId node) const { return verify::mayFail(system, node); }
  /// The values of a scalar type, from the lowest on. \throw CompileError where there are too many
  [[nodiscard]] Types::Bounds allValues(const fiacre::Type& type) const;
  /// An assignment of a number, which lives as long as this.
  [[nodiscard]] const fiacre::Statement& assignmentOf(const fiacre::Expr& target,
                                                      std::int64_t value);
  /// A value of this type with every part the lowest.
  [[nodiscard]] Value lowest(const fiacre::Type& type);

private:
  using Statements = std::vector<const fiacre::Statement*>; // the last comes first

  Value name(const std::string& name, const Scope& scope, const fiacre::Type* expected);
  Value unary(const fiacre::Expr& expr, const Scope& scope);
  Value binary(const fiacre::Expr& expr, const Scope& scope);
  Value equality(const fiacre::Expr& expr, const Scope& scope);
  Value conditional(const fiacre::Expr& expr, const Scope& scope, const fiacre::Type* expected);
  Value index(const fiacre::Expr& expr, const Scope& scope);
  Value field(const fiacre::Expr& expr, const Scope& scope);
  Value literal(const fiacre::Expr& expr, const Scope& scope, const fiacre::Type* expected);
  Value call(const fiacre::Expr& expr, const Scope& scope);
  // unions.cpp
  Value construct(const fiacre::Expr& expr, const Scope& scope, const fiacre::Type* expected);
  Value bare(const fiacre::Type& type, std::int64_t number);
  Value payloadOf(const Value& tested, const std::string& constructor);
  [[nodiscard]] bool isFunction(const std::string& name) const;
  // queues.cpp
  Value queueLiteral(const fiacre::Expr& expr, const Scope& scope, const fiacre::Type* expected);
  Value queueUnary(const fiacre::Expr& expr, const Scope& scope);
  Value queueBinary(const fiacre::Expr& expr, const Scope& scope, const fiacre::Type* expected);
  Value queue(const fiacre::Expr& expr, const Scope& scope, const fiacre::Type* expected = nullptr);
  Value run(Statements rest, Scope scope, const fiacre::Type& result);
  // functions.cpp
  Value nothing(Value like, const std::string& why);
  Value choose(NodeId condition, const Value& then, const Value& otherwise);
  void assignInFunction(const fiacre::Statement& statement, Scope& scope);
  bool isBareConstructor(const fiacre::Expr& expr, const Scope& scope) const;
  /// An index, and that it lies within its array: a fault where it does not.
  NodeId indexNode(const fiacre::Expr& indexed, const Scope& scope, std::int64_t size);
  /// Where in the root variable's parts an lvalue may stand, and when it stands there.
  struct Target {
    const fiacre::Type* type = nullptr;
    const Value* root = nullptr;
    std::vector<std::pair<NodeId, std::size_t>> offsets;
  };
  Target target(const fiacre::Expr& lvalue, const Scope& scope);
  void write(CellId cell, NodeId old, NodeId condition, NodeId source,
             std::vector<Assignment>& assignments, std::size_t first);

  const fiacre::Program& program;
  const Types& types;
  System& system;
  Nodes maker;
  int depth = 0;                      ///< of calls
  int turns = 0;                      ///< of loops whose end is not known
  std::deque<fiacre::Statement> made; ///< assignments of the turns of a `foreach`
};

} // namespace proskill::verify
