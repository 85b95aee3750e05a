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

/// The types of a program: resolves names, and computes the sizes and bounds of values.
class Types {
public:
  /// \param limits checked while long types are traversed; may be null
  explicit Types(const fiacre::Program& program, LimitWatch* limits = nullptr);
  /// \throw LimitMet
  void checkLimits() const {
    if (limits) limits->check();
  }

  /// Call this before adding to a vector that may be large. \throw LimitMet
  template <class T> void checkGrowth(const std::vector<T>& all, std::size_t more) const {
    if (limits) limits->checkGrowth(all, more);
  }
  /// Call this before allocating so many bytes at once, which may be many. \throw LimitMet
  void checkGrowth(std::uint64_t bytes) const {
    if (limits) limits->checkLargeGrowth(bytes);
  }

  /// The type that a type name stands for; any other type itself.
  [[nodiscard]] const fiacre::Type& resolve(const fiacre::Type& type) const;
  /// The number of scalars of a value. A queue consists of its length and its elements, the first
  /// element first. A union with values consists of the constructor's number and a place for each
  /// constructor's value.
  [[nodiscard]] std::size_t scalars(const fiacre::Type& type) const;
  /// Appends the types of these scalars to `all`, in order.
  void flatten(const fiacre::Type& type, std::vector<const fiacre::Type*>& all) const;
  /// A constructor's number within its union.
  [[nodiscard]] std::optional<std::int64_t> constructor(const fiacre::Type& type,
                                                        std::string_view name) const;
  /// The offset of a constructor's value within a value of its union, and its type; null if it has
  /// no value.
  [[nodiscard]] std::pair<std::size_t, const fiacre::Type*> payload(const fiacre::Type& type,
                                                                    std::int64_t number) const;
  /// The union with a constructor of this name; null if there is none.
  /// \throw CompileError if several unions give this constructor different numbers
  [[nodiscard]] const fiacre::Type* unionWith(std::string_view name) const;

  struct Bounds {
    std::int64_t low = 0;
    std::int64_t high = 0;
  };
  /// The bounds of a scalar type. `nat` and `int` have 31 bits; a value outside is an error of the
  /// model.
  [[nodiscard]] Bounds bounds(const fiacre::Type& scalar) const;

private:
  LimitWatch* limits;
  std::map<std::string, const fiacre::Type*, std::less<>> declared;
  mutable std::map<std::int64_t, fiacre::Type> lengths; ///< types of queue lengths
};

} // namespace proskill::verify
