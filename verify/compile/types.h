#pragma once

#include "fiacre/syntax/tree.h"
#include "verify/limits.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proskill::verify {

/// The types of a program: names looked up, sizes and bounds of values.
class Types {
public:
  /// \param limits looked at while long types are walked through; may be null
  explicit Types(const fiacre::Program& program, LimitWatch* limits = nullptr);
  /// \throw LimitMet
  void checkLimits() const {
    if (limits) limits->check();
  }

  /// The type behind the names.
  [[nodiscard]] const fiacre::Type& resolve(const fiacre::Type& type) const;
  /// How many scalars a value has. A queue is its length and
  /// its places, the first one first; a union with values which constructor it is, then a place
  /// for the value of each.
  [[nodiscard]] std::size_t scalars(const fiacre::Type& type) const;
  /// The types of these scalars, in order; appended to `all`.
  void flatten(const fiacre::Type& type, std::vector<const fiacre::Type*>& all) const;
  /// A constructor's number within its union.
  [[nodiscard]] std::optional<std::int64_t> constructor(const fiacre::Type& type,
                                                        std::string_view name) const;
  /// Where the value of a constructor stands within that of its union, and its type; null where it
  /// has none.
  [[nodiscard]] std::pair<std::size_t, const fiacre::Type*> payload(const fiacre::Type& type,
                                                                    std::int64_t number) const;
  /// The union that has a constructor of this name; nothing where none has. \throw CompileError
  /// where several have it, with different numbers
  [[nodiscard]] const fiacre::Type* unionWith(std::string_view name) const;

  struct Bounds {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };
  /// Of a scalar type. `nat` and `int` are taken as 31 bits; a value beyond is an error of the
  /// model.
  [[nodiscard]] Bounds bounds(const fiacre::Type& scalar) const;

private:
  LimitWatch* limits;
  std::map<std::string, const fiacre::Type*, std::less<>> declared;
  mutable std::map<std::int64_t, fiacre::Type> lengths; ///< types of the lengths of queues
};

} // namespace proskill::verify
