#pragma once

#include "analysis/program/program.h"
#include "fiacre/provenance.h"

#include <map>
#include <string>
#include <string_view>
#include <tuple>

namespace proskill::codegen {

/// Who acts, and in which file that is written.
struct Actor {
  std::string name; ///< "takeoff", "uav_mission branch 2", "environment"
  syntax::FileId file = 0;
};

/// Collects the provenance of a model. Equal place, actor and description give the same origin.
class Origins {
public:
  explicit Origins(const analysis::Program& program) : program(program) {}

  /// The origin of what happens at a place, with its description in terms of ProSkill.
  fiacre::OriginId of(const Actor& actor, syntax::Range range, std::string_view words);
  /// The origin of a place without a description.
  fiacre::OriginId of(const Actor& actor, syntax::Range range) { return of(actor, range, {}); }

  /// The text of a range on one line, shortened if it is long.
  [[nodiscard]] std::string excerpt(syntax::FileId file, syntax::Range range) const;
  /// Line and column, counted from 1.
  [[nodiscard]] syntax::Position position(syntax::FileId file, syntax::Range range) const;
  /// "line 79: defskill takeoff", with the file's name in front if it is not the root.
  [[nodiscard]] std::string definition(syntax::FileId file, const syntax::Form& form,
                                       std::string_view name) const;
  /// "line 12: (landing)", with the file's name in front if it is not the root.
  [[nodiscard]] std::string reference(syntax::FileId file, syntax::Range range) const;

  fiacre::Provenance provenance;

private:
  [[nodiscard]] std::string line(syntax::FileId file, syntax::Range range) const;

  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::string, std::string>;

  const analysis::Program& program;
  std::map<Key, fiacre::OriginId> known;
};

} // namespace proskill::codegen
