#pragma once

#include "verify/checkpoint_store.h"

#include <random>
#include <string>
#include <vector>

namespace proskill::test {

/// Keeps every state that a verification saves, and gives one of them to another verification.
class CheckpointInMemory : public verify::CheckpointStore {
public:
  /// \param nth one of so many calls of isDue() says that it is, chosen by the seed; 0: none
  explicit CheckpointInMemory(unsigned nth = 0, std::uint64_t seed = 0)
      : oneOf(nth), generator(seed) {}

  [[nodiscard]] bool isDue() override { return oneOf != 0 && generator() % oneOf == 0; }
  void replace(const std::function<void(const Put&)>& write) override {
    std::string state;
    write([&](std::string_view piece) {
      state += piece;
      return true;
    });
    saved.push_back(std::move(state));
  }
  [[nodiscard]] bool hasState() const override { return isGiven; }
  /// In small pieces, so that numbers are cut.
  [[nodiscard]] std::expected<std::string, std::string> next() override {
    constexpr std::size_t kPiece = 7;
    const std::string piece = given.substr(at, kPiece);
    at += piece.size();
    return piece;
  }
  void resumed(std::uint64_t) override { wasUsed = true; }
  void finished() override { isFinished = true; }

  /// Gives a state to the next verification.
  void give(std::string state) {
    given = std::move(state);
    isGiven = true;
    at = 0;
    isFinished = wasUsed = false;
  }

  std::vector<std::string> saved;
  bool isFinished = false;
  bool wasUsed = false;

private:
  unsigned oneOf;
  std::mt19937_64 generator;
  std::string given;
  bool isGiven = false;
  std::size_t at = 0;
};

} // namespace proskill::test
