#pragma once

#include "report/run/run_report.h"

#include <string>
#include <vector>

namespace proskill::report {

/// Where the processes of a run are in the program: at a statement of a body, or in the action of a
/// basic skill.
class RunPlaces {
public:
  explicit RunPlaces(RunSubject subject);

  /// All processes with their places: `{actor, performs, start, places: [location or null]}`. A
  /// process that does not run is at none.
  [[nodiscard]] const OrderedJson& json() const { return table; }
  /// Appends the processes that have moved, as `[[process, place], …]`; both are indices.
  void addMoves(std::string& to, const std::vector<verify::Word>& before,
                const std::vector<verify::Word>& after) const;

private:
  void add(RunSubject subject, const verify::Instance& instance, OrderedJson entry);

  const verify::System& system;
  std::vector<verify::CellId> cells; ///< by process
  OrderedJson table = OrderedJson::array();
};

} // namespace proskill::report
