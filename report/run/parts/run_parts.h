#pragma once

#include "report/ordered_json.h"
#include "report/run/mcap.h"

#include <expected>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::report {

/// Where the steps of a recording are, so that a part of it can be read.
class RunParts {
public:
  RunParts() = default;
  RunParts(const RunParts&) = delete;
  RunParts& operator=(const RunParts&) = delete;
  virtual ~RunParts() = default;

  /// The trace without its steps.
  [[nodiscard]] const OrderedJson& head() const { return trace; }
  /// In the order of the file.
  [[nodiscard]] const std::vector<mcap::Stretch>& stretches() const { return all; }
  /// The steps in the bytes of consecutive stretches, as JSON. The error is a message.
  [[nodiscard]] virtual std::expected<std::vector<std::string_view>, std::string>
  steps(std::string_view bytes) const = 0;
  /// The values of variables at the start of a stretch. \param bytes from there on
  [[nodiscard]] virtual std::map<std::string, std::string>
  valuesAt(std::size_t stretch, std::string_view bytes) const = 0;

protected:
  OrderedJson trace;
  std::vector<mcap::Stretch> all;
};

using FoundParts = std::expected<std::unique_ptr<const RunParts>, std::string>;

/// Those of an MCAP file: its chunks. The error is a message.
[[nodiscard]] FoundParts partsOfMcap(const mcap::File& file);
/// Those of a trace in JSON with a step in each line. It is read once, from its beginning to its
/// end, or to a last line that was cut off. The error is a message.
[[nodiscard]] FoundParts partsOfTrace(const mcap::File& file);

} // namespace proskill::report
