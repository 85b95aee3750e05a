#pragma once

#include "verify/compile/types.h"
#include "verify/model/nodes.h"
#include "verify/model/value_bounds.h"

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <unordered_map>

namespace proskill::verify {

/// The value of an expression: a node for each scalar of its type.
struct Value {
  const fiacre::Type* type = nullptr; ///< resolved
  std::vector<NodeId> parts;
};

using Scope = std::map<std::string, Value, std::less<>>;

/// Turns Fiacre expressions into nodes. Functions are inlined. An index that is not constant
/// becomes a choice between the elements.
class Expressions {
public:
  Expressions(const fiacre::Program& program, const Types& types, System& system);

  /// \param expected the type that the context requires, or null: it distinguishes constructors
  /// that several unions share
  /// \throw CompileError
  [[nodiscard]] Value value(const fiacre::Expr& expr, const Scope& scope,
                            const fiacre::Type* expected = nullptr);
  /// \throw CompileError if the value has several parts
  [[nodiscard]] NodeId scalar(const fiacre::Expr& expr, const Scope& scope,
                              const fiacre::Type* expected = nullptr);
  /// Appends the assignments that write `source` to `target`.
  /// \param first the first of the simultaneous assignments; writes to the same cell are merged
  /// \throw CompileError
  void assign(const fiacre::Expr& target, const Value& source, const Scope& scope,
              std::vector<Assignment>& assignments, std::size_t first);
  /// The value, checked against the type: a number outside the type's range causes a fault.
  Value fitted(Value value, const fiacre::Type& type, const std::string& what);
  /// The condition under which `tested` matches a pattern of `case`.
  [[nodiscard]] NodeId matches(const fiacre::Expr& pattern, const Value& tested,
                               const Scope& scope);
  /// The assignments that a pattern makes: `frame(x)` assigns the value of a frame to x.
  struct Binding {
    fiacre::Expr variable;
    Value value;
  };
  [[nodiscard]] std::vector<Binding> bindings(const fiacre::Expr& pattern, const Value& tested,
                                              const Scope& scope);
  /// The type of an expression that can be assigned to. \throw CompileError
  [[nodiscard]] const fiacre::Type& typeOf(const fiacre::Expr& lvalue, const Scope& scope);

  [[nodiscard]] Nodes& nodes() { return maker; }
  [[nodiscard]] bool mayFail(NodeId node) const { return verify::mayFail(system, node); }
  /// The values of a scalar type. \throw CompileError if there are too many
  [[nodiscard]] Types::Bounds allValues(const fiacre::Type& type) const;
  /// An assignment of a number. This object owns it.
  [[nodiscard]] const fiacre::Statement& assignmentOf(const fiacre::Expr& target,
                                                      std::int64_t value);
  /// The value of this type whose parts all have their lowest value.
  [[nodiscard]] Value lowest(const fiacre::Type& type);

private:
  using Statements = std::vector<const fiacre::Statement*>; // the last one is executed first

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
  /// Call this for each element of an array. \throw LimitMet
  void checkLimits() const;
  /// The element at an index between these two.
  using Elements = std::function<Value(std::int64_t)>;
  Value elementAt(NodeId at, const Elements& elements, std::int64_t low, std::int64_t high);
  /// The index as a node that causes a fault if it is outside the array.
  NodeId indexNode(const fiacre::Expr& indexed, const Scope& scope, std::int64_t size);
  /// The positions in the root variable's parts that an lvalue may refer to, each with its
  /// condition. No position occurs twice.
  struct Target {
    const fiacre::Type* type = nullptr;
    const Value* root = nullptr;
    std::vector<std::pair<NodeId, std::size_t>> offsets;
  };
  Target target(const fiacre::Expr& lvalue, const Scope& scope);
  /// Where a cell is written by assignments before those of the same target.
  using Earlier = std::unordered_map<CellId, std::size_t>;
  void write(CellId cell, NodeId old, NodeId condition, NodeId source,
             std::vector<Assignment>& assignments, const Earlier& earlier);

  const fiacre::Program& program;
  const Types& types;
  System& system;
  Nodes maker;
  int depth = 0;                      ///< nesting depth of calls
  int turns = 0;                      ///< iterations of loops without a known bound
  std::deque<fiacre::Statement> made; ///< assignments to the variable of a `foreach`
};

} // namespace proskill::verify
