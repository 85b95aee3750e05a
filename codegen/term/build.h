#pragma once

#include "fiacre/syntax/tree.h"

#include <string>
#include <string_view>
#include <vector>

/// Builders for Fiacre trees. Conditions are simplified: `true and a` becomes `a`.
namespace proskill::codegen {

using fiacre::OriginId;

[[nodiscard]] fiacre::Expr boolean(bool value);
[[nodiscard]] fiacre::Expr number(std::int64_t value);
[[nodiscard]] fiacre::Expr name(std::string_view text);
[[nodiscard]] fiacre::Expr call(std::string_view function, std::vector<fiacre::Expr> arguments);
[[nodiscard]] fiacre::Expr binary(fiacre::Op op, fiacre::Expr left, fiacre::Expr right);
[[nodiscard]] fiacre::Expr equal(fiacre::Expr left, fiacre::Expr right);
[[nodiscard]] fiacre::Expr negation(fiacre::Expr operand);
[[nodiscard]] fiacre::Expr conjunction(std::vector<fiacre::Expr> operands);
[[nodiscard]] fiacre::Expr disjunction(std::vector<fiacre::Expr> operands);
[[nodiscard]] fiacre::Expr conditional(fiacre::Expr condition, fiacre::Expr then,
                                       fiacre::Expr otherwise);
[[nodiscard]] fiacre::Expr element(fiacre::Expr array, fiacre::Expr index);
[[nodiscard]] fiacre::Expr field(fiacre::Expr record, std::string_view name);
[[nodiscard]] bool isTrue(const fiacre::Expr& expr);
[[nodiscard]] bool isFalse(const fiacre::Expr& expr);

[[nodiscard]] fiacre::Statement assign(fiacre::Expr target, fiacre::Expr value);
/// Passes only if the condition holds; an empty statement for the constant true.
[[nodiscard]] fiacre::Statement on(fiacre::Expr condition);
[[nodiscard]] fiacre::Statement wait(fiacre::Interval interval);
/// `wait [0,0]`
[[nodiscard]] fiacre::Statement atOnce();
[[nodiscard]] fiacre::Statement to(std::string_view state);
[[nodiscard]] fiacre::Statement stay(); ///< `loop`
[[nodiscard]] fiacre::Statement tag(std::string_view name);
[[nodiscard]] fiacre::Statement synchronise(std::string_view port);
[[nodiscard]] fiacre::Statement comment(std::string text);
[[nodiscard]] fiacre::Statement ifThen(fiacre::Expr condition, fiacre::Statement then);
/// If the condition is constant, only the branch that is taken.
[[nodiscard]] fiacre::Statement ifThenElse(fiacre::Expr condition, fiacre::Statement then,
                                           fiacre::Statement otherwise);
/// A single alternative is returned without `select`.
[[nodiscard]] fiacre::Statement select(std::vector<fiacre::Statement> alternatives);
/// Nested sequences are flattened, and empty ones are dropped.
[[nodiscard]] fiacre::Statement sequence(std::vector<fiacre::Statement> statements);

/// The statement with its origin, or with a comment.
[[nodiscard]] fiacre::Statement at(OriginId origin, fiacre::Statement statement);
[[nodiscard]] fiacre::Statement saying(std::string words, fiacre::Statement statement);

[[nodiscard]] fiacre::Type namedType(std::string_view name);
[[nodiscard]] fiacre::Type rangeType(std::int64_t low, std::int64_t high);
[[nodiscard]] fiacre::Type boolType();

} // namespace proskill::codegen
