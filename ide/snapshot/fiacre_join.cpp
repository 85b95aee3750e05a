#include "ide/snapshot/fiacre_join.h"

#include <fmt/format.h>

namespace proskill::ide {
namespace {

struct Repeated {
  const fiacre::From* first = nullptr;
  const fiacre::From* second = nullptr;
};

std::optional<Repeated> repeatedFrom(const fiacre::Program& program, fiacre::OriginId second) {
  for (const auto& process : program.processes)
    for (const auto& from : process.transitions) {
      if (from.origin != second) continue;
      for (const auto& earlier : process.transitions)
        if (earlier.state == from.state && &earlier != &from) return Repeated{&earlier, &from};
    }
  return std::nullopt;
}

} // namespace

std::optional<syntax::Fix> joinedFrom(const codegen::Model& model, fiacre::OriginId second,
                                      std::string_view text) {
  if (second == 0) return std::nullopt;
  const auto found = repeatedFrom(model.fiacre, second);
  if (!found) return std::nullopt;
  const auto place = [&](fiacre::OriginId id) { return model.provenance.origins[id]; };
  const auto one = place(found->first->statement.origin);
  const auto whole = place(found->second->origin);
  const auto other = place(found->second->statement.origin);
  const auto cut = [&](auto begin, auto end) { return text.substr(begin, end - begin); };
  return syntax::Fix{fmt::format("one `from {}` for both, with `select`", found->first->state),
                     {0, {one.begin, whole.end}},
                     fmt::format("select\n        {}\n    []  {}\n    end{}",
                                 cut(one.begin, one.end), cut(other.begin, other.end),
                                 cut(one.end, whole.begin))};
}

} // namespace proskill::ide
