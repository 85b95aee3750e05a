#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>

/// Numbers as values of options.
namespace proskill::cli {

/// An integer in decimal digits, within bounds.
CLI::Validator integerBetween(std::uint64_t least,
                              std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// A port; 0 means any free one.
CLI::Validator portNumber();

/// A positive, finite length of time in seconds; rejects `nan` and `1e999`.
CLI::Validator positiveSeconds();

/// The same, or 0.
CLI::Validator secondsFromZero();

/// At most the largest number: no memory limit is above that.
[[nodiscard]] std::uint64_t bytesOfMiB(std::uint64_t mebibytes);

} // namespace proskill::cli
