#pragma once

#include "fiacre/syntax/lexer.h"

#include <vector>

namespace proskill::fiacre {

/// The kind of a line, as far as spacing depends on it.
enum class LineKind : std::uint8_t {
  Plain,    ///< statements, variables, types
  Head,     ///< heads and instances: space between a name and the `[` or `(` after it
  Ports,    ///< the same, in probes
  Property, ///< `/` joins the parts of a path
};

/// Decides where spaces belong between the tokens of a line, in order.
class Spacing {
public:
  explicit Spacing(LineKind lineKind) : kind(lineKind) {}

  /// Whether there is a space before `token`. \param next the token after it
  bool before(const Token& token, const Token& next);

private:
  enum class Role : std::uint8_t {
    Other,
    Operand, ///< ends an expression
    Prefix,  ///< no space after it
    Open,    ///< a parenthesis; no space inside
    Joint,   ///< no space around it: a `/` of a path, the `=` of a field
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
  std::size_t conditionals = 0; ///< number of `?` whose `:` is still to come
  /// The position within the brackets of an interval: before its comma, after it, or outside.
  enum class Interval : std::uint8_t { Outside, Lower, Upper } interval = Interval::Outside;
  std::size_t inner = 0; ///< number of open parentheses and brackets within the interval
  bool inProbe = false;  ///< after the `is` of a port
  bool inPath = false;   ///< after a name that begins a path
  bool inValue = false;  ///< after `value`, where `/` divides
  /// For each open parenthesis: whether the name or the value of a record's field is next.
  enum class Group : std::uint8_t { Other, Field, FieldValue };
  std::vector<Group> groups;
};

} // namespace proskill::fiacre
