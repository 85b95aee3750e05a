#include "syntax/tree/shift.h"

#include "syntax/tree/parts.h"

namespace proskill::syntax {
namespace {

struct Shift {
  Offset by;

  void operator()(Range& range) const {
    range.begin += by;
    range.end += by;
  }
};

} // namespace

void shift(Range& range, Offset by) { Shift{by}(range); }
void shift(FormNode& node, Offset by) { forEachPart(node, Shift{by}); }
void shift(ReadForm& form, Offset by) { forEachPart(form, Shift{by}); }

void shift(Diagnostic& diagnostic, Offset by) {
  const Shift move{by};
  move(diagnostic.location.range);
  for (Related& related : diagnostic.related) move(related.location.range);
  for (Fix& fix : diagnostic.fixes) move(fix.location.range);
}

} // namespace proskill::syntax
