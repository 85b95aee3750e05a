// Executes docs/tour/dock.proskill until its end. Driving has a thread of its own, as a driver of a
// robot may have.
//
//     dock_cpp docs/tour/dock.proskill             in simulated time
//     dock_cpp --real docs/tour/dock.proskill      ten times as fast as in reality

#include <chrono>
#include <iostream>
#include <proskill/executor.hpp>
#include <string>
#include <thread>

namespace {

constexpr double kSpeed = 10;

struct Driver {
  ~Driver() { join(); }
  void join() {
    if (thread.joinable()) thread.join();
  }
  std::thread thread;
};

// Drives for three seconds, unless it is to stop.
void drive(proskill::Start start) {
  for (int i = 0; i < 30; ++i) {
    if (start.stopRequested()) return start.stopped();
    std::this_thread::sleep_for(std::chrono::duration<double>(0.1 / kSpeed));
  }
  start.finish("docked");
}

void show(const proskill_entry& entry) {
  std::cout << entry.time << " s  " << entry.subject << ": " << entry.text << '\n';
}

int run(const std::string& file, bool isReal) {
  auto options = proskill::defaultOptions();
  options.clock = isReal ? PROSKILL_REAL_TIME : PROSKILL_SIMULATED_TIME;
  options.speed = kSpeed;
  proskill::Executor executor(proskill::Program(file), options);
  Driver driver; // ends before the executor
  executor.perform("drive_onto_dock", [&](proskill::Start start, proskill::Arguments arguments) {
    std::cout << "the robot drives to the " << arguments[0].string << '\n';
    if (!isReal) return start.finishAfter(3, "docked");
    driver.join(); // an earlier start has ended
    driver.thread = std::thread(drive, start);
  });
  executor.perform(
      "charge", [](proskill::Start start, proskill::Arguments) { start.finishAfter(15, "full"); },
      [](proskill::Start start) { start.stopped(); });
  executor.observe(show);
  executor.run();
  std::cout << "the mission ends with " << executor.outcome() << "; the robot is on the "
            << executor.value("place") << '\n';
  return executor.outcome() == "success" ? 0 : 1;
}

} // namespace

int main(int count, char** arguments) {
  const std::string first = count > 1 ? arguments[1] : "";
  try {
    return run(arguments[count - 1], first == "--real");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
