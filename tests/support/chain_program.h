#pragma once

#include <fmt/format.h>

#include <string>

namespace proskill::test {

/// A mission that calls skills in a row. The traces of its properties have about as many steps in
/// total as the square of their number.
inline std::string chainProgram(int skills) {
  std::string program;
  std::string calls;
  for (int i = 0; i < skills; ++i) {
    program += fmt::format("(defsv d{0} :states (A B) :init A)\n"
                           "(defskill s{0} :start (d{0} B) :action (a) :success ok\n"
                           "  (:effects (d{0} A)) :failure ko (:effects (d{0} A)))\n",
                           i);
    calls += fmt::format("(s{})", i);
  }
  return program + "(defskill mission :body (" + calls + "))\n";
}

} // namespace proskill::test
