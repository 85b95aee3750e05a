#include "lsp/protocol/progress.h"

namespace proskill::lsp {

Progress::~Progress() {
  if (begun) end();
}

void Progress::begin(std::string_view title, bool cancellable) {
  if (!isWatched() || begun) return;
  begun = true;
  send(workDone, {{"kind", "begin"}, {"title", title}, {"cancellable", cancellable}});
}

void Progress::report(std::string_view message, std::optional<unsigned> percentage) {
  if (!begun) return;
  Json value{{"kind", "report"}, {"message", message}};
  if (percentage) value["percentage"] = *percentage;
  send(workDone, value);
}

void Progress::end(std::string_view message) {
  if (!begun) return;
  begun = false;
  Json value{{"kind", "end"}};
  if (!message.empty()) value["message"] = message;
  send(workDone, value);
}

} // namespace proskill::lsp
