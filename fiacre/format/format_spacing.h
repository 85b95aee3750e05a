#pragma once

#include "fiacre/syntax/lexer.h"

#include <vector>

namespace proskill::fiacre {

/// What a line of a model is, as far as its spaces depend on that.
enum class LineKind : std::uint8_t {
  Plain,    ///< statements, variables, types
  Head,     ///< names stand apart from the `[` and `(` behind them: heads and instances
  Ports,    ///< likewise, in probes
  Property, ///< `/` joins the parts of a path
};

/// Where a space belongs between the tokens of one line, which are given one after the other.
class Spacing {
public:
  explicit Spacing(LineKind lineKind) : kind(lineKind) {}

  /// Whether a space is before `token`; `next` is behind it.
  bool before(const Token& token, const Token& next);

private:
  enum class Role : std::uint8_t {
    Other,
    Operand, ///< ends an expression
    Prefix,  ///< touches what follows
    Open,    ///< a parenthesis, whose contents touch it
    Joint,   ///< touches what is on both sides: a `/` of a path, the `=` of a field
  };

  [[nodiscard]] Role roleOf(const Token& token, const Token& next);
  [[nodiscard]] bool opensInterval(const Token& token) const;
  [[nodiscard]] bool spaced(const Token& token, Role role);
  [[nodiscard]] bool touches(const Token& token, Role role) const;
  bool closesInterval(const Token& token);
  void follow(const Token& token, Role role);

  LineKind kind;
  bool first = true;
  Token previous;
  Role previousRole = Role::Other;
  std::size_t conditionals = 0; ///< `?` whose `:` is to come
  /// Brackets of an interval of time: before its comma, behind it, or outside.
  enum class Interval : std::uint8_t { Outside, Lower, Upper } interval = Interval::Outside;
  std::size_t inner = 0; ///< parentheses and brackets open within the interval
  bool inProbe = false;  ///< behind the `is` of a port
  bool inPath = false;   ///< a name that begins a path was seen
  bool inValue = false;  ///< behind `value`, where `/` divides
  /// Of each parenthesis that is open: whether the name of a record's field is next, or its value.
  enum class Group : std::uint8_t { Other, Field, FieldValue };
  std::vector<Group> groups;
};

} // namespace proskill::fiacre
