#include "tests/support/endless_program.h"

namespace proskill::test {

std::string endlessProgram() {
  std::string states;
  std::string skills;
  for (int i = 5; i < 14; ++i) {
    const auto last = "T" + std::to_string(i);
    states += " " + last;
    skills += "(defskill s" + std::to_string(i) + " :precondition (other (/= last " + last +
              ")) :time_interval [1," + std::to_string(i) +
              "] :action (a) :success ok (:effects (last " + last + ")) :failure bad)\n";
  }
  return "(defsv last :states (" + states + ") :init T5)\n" + skills;
}

} // namespace proskill::test
