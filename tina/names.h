#pragma once

#include "verify/model/system.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::tina {

/// Maps names in Tina's output to a model. Accepts both spellings of process names, because it is
/// not certain whether frac doubles their underscores.
class Names {
public:
  /// \pre `system` outlives this \param main the name of the main component
  Names(const verify::System& system, const std::string& main);

  /// The part of an instance in a transition: `J` of `PROCESS_K_tJ`.
  struct Part {
    verify::InstanceId instance = 0;
    std::uint32_t leaf = 0;
    friend auto operator<=>(const Part&, const Part&) = default;
  };
  /// The parts of a transition, by instance; nothing if it is not a transition of the model.
  [[nodiscard]] std::optional<std::vector<Part>> transition(std::string_view name) const;

  /// The parts that belong to the model, by instance: frac adds processes that observe timed
  /// properties. Empty if none belong to the model.
  [[nodiscard]] std::vector<Part> partsWithin(std::string_view name) const;

  struct Place {
    verify::InstanceId instance = 0;
    std::uint32_t location = 0;
  };
  [[nodiscard]] std::optional<Place> place(std::string_view name) const;
  [[nodiscard]] std::optional<verify::CellId> variable(std::string_view name) const;

private:
  template <class Thing> using Table = std::map<std::string, std::optional<Thing>, std::less<>>;

  bool parts(std::string_view name, std::vector<Part>& found) const;
  struct Prefix {
    Part part;
    std::size_t length = 0;
  };
  [[nodiscard]] std::optional<Prefix> partAt(std::string_view name, std::size_t mark) const;

  Table<verify::InstanceId> instances; ///< nullopt: the spelling is ambiguous
  Table<Place> places;
  Table<verify::CellId> variables;
};

} // namespace proskill::tina
