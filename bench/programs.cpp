#include "bench/programs.h"

#include "tests/where.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace proskill::bench {

namespace {

constexpr std::size_t kSkillsPerTask = 5;

std::string device(std::size_t i) {
  return fmt::format(R"((defsv device_{0}
  :states (Off Ready Busy Broken)
  :init Off
  :transitions ((Off Ready) (Ready Busy) (Busy Ready)
                (Ready Off) (Busy Broken) (Ready Broken)))

(defevent device_{0}_breaks
  :effects (device_{0} Broken))

; Device {0} does its work.
(defskill use_{0}
  :input ($speed float $times int)
  :precondition (ready (device_{0} Ready))
  :start (device_{0} Busy)
  :invariant (works (:guard (not (device_{0} Broken))))
  :time_interval [1,3]
  :action (use_device_{0} $speed $times)
  :interrupt (:effects (device_{0} Ready))
  :success finished
    (:effects (device_{0} Ready)
     :postcondition (device_{0} Ready))
  :failure (slipped (:effects (device_{0} Ready))
            jammed (:effects (device_{0} Broken))))

)",
                     i);
}

/// A skill that calls a handful of skills and tests each outcome.
std::string task(std::size_t number, std::size_t first, std::size_t count) {
  std::string body;
  for (std::size_t i = first; i < first + count; ++i)
    body += fmt::format("    (^ (device_{0} Ready))\n"
                        "    (use_{0} speed 1.5 times {1})\n"
                        "    (if (/= use_{0}.status success)\n"
                        "      (printf \"device {0} has failed\")\n"
                        "      (failure given_up))\n",
                        i, i % 7);
  return fmt::format("(defskill task_{}\n  :success done\n  :failure given_up\n  :body (\n{}    "
                     "(success done)))\n\n",
                     number, body);
}

} // namespace

std::string drone() {
  const std::string path = PROSKILL_SOURCE_DIR "/examples/drone/drone.proskill";
  std::ostringstream text;
  if (text << std::ifstream(path).rdbuf()) return text.str();
  fmt::print(stderr, "bench: {} cannot be read\n", path);
  std::exit(1);
}

std::size_t lineCount(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

std::string programOfLines(std::size_t lines) {
  std::size_t perDevice =
      lineCount(device(0)) + lineCount(task(0, 0, kSkillsPerTask)) / kSkillsPerTask;
  std::size_t tasks = std::max<std::size_t>(1, lines / (perDevice * kSkillsPerTask));
  std::string text;
  for (std::size_t i = 0; i < tasks * kSkillsPerTask; ++i) text += device(i);
  std::string body;
  for (std::size_t i = 0; i < tasks; ++i) {
    text += task(i, i * kSkillsPerTask, kSkillsPerTask);
    body += fmt::format("    (task_{})\n", i);
  }
  return text + "(defskill mission\n  :body (\n" + body + "  ))\n";
}

std::string parallelFamily(std::size_t branches, std::size_t skills) {
  std::string text;
  std::string body;
  for (std::size_t b = 0; b < branches; ++b) {
    text += fmt::format("(defsv lane_{0} :states (Clear Spoilt) :init Clear)\n"
                        "(defevent spoil_{0} :effects (lane_{0} Spoilt))\n",
                        b);
    std::string branch;
    for (std::size_t s = 0; s < skills; ++s) {
      text += fmt::format("(defskill step_{0}_{1}\n"
                          "  :invariant (clear (:guard (lane_{0} Clear)))\n"
                          "  :time_interval [{2},{3}]\n"
                          "  :action (step)\n"
                          "  :success done :failure lost)\n",
                          b, s, 1 + (b + s) % 3, 4 + (b * s) % 5);
      branch += fmt::format(" (step_{}_{})", b, s);
    }
    body += "\n      (" + branch + ")";
  }
  return text + "(defskill mission\n  :body (\n    (//" + body + ")))\n";
}

} // namespace proskill::bench
