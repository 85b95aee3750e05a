#pragma once

#include "analysis/program/program.h"
#include "fiacre/provenance.h"

#include <map>
#include <string>
#include <string_view>
#include <tuple>

namespace proskill::codegen {

/// Who does something, and in which file that is written.
struct Actor {
  std::string name; ///< "takeoff", "uav_mission branch 2", "environment"
  syntax::FileId file = 0;
};

/// Collects the provenance of a model. The same place, actor and words have one origin.
class Origins {
public:
  explicit Origins(const analysis::Program& program) : program(program) {}

  /// What happens at a place, in words of ProSkill.
  fiacre::OriginId of(const Actor& actor, syntax::Range range, std::string_view words);
  /// A bare place.
  fiacre::OriginId of(const Actor& actor, syntax::Range range) { return of(actor, range, {}); }

  /// The text of a range in one line, shortened where it is long.
  [[nodiscard]] std::string excerpt(syntax::FileId file, syntax::Range range) const;
  /// Counted from 1.
  [[nodiscard]] syntax::Position position(syntax::FileId file, syntax::Range range) const;
  /// "line 79: defskill takeoff", likewise.
  [[nodiscard]] std::string definition(syntax::FileId file, const syntax::Form& form,
                                       std::string_view name) const;
  /// "line 12: (landing)", with the file's name in front where it is not the root.
  [[nodiscard]] std::string reference(syntax::FileId file, syntax::Range range) const;

  fiacre::Provenance provenance;

private:
  [[nodiscard]] std::string line(syntax::FileId file, syntax::Range range) const;

  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string, std::string>;

  const analysis::Program& program;
  std::map<Key, fiacre::OriginId> known;
};

} // namespace proskill::codegen
