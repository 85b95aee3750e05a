; Helix indents by whole steps and by alignment. The formatter has the last word: :format

[
  (state_variable)
  (event)
  (skill)
  (resource)
  (property)
  (environment)
  (if)
  (case)
  (while)
  (do)
  (do_until)
  (body_field)
] @indent

(elseif_clause "elseif" @outdent)
(else_clause "else" @outdent)
(until_clause "until" @outdent)

; Lists: one column behind the parenthesis, where their first part is.
([
  (block . "(" . (_) @anchor)
  (case_arm . "(" . (_) @anchor)
  (name_list . "(" . (_) @anchor)
  (transition_list . "(" . (_) @anchor)
  (input_list . "(" . (_) @anchor)
  (precondition_list . "(" . (_) @anchor)
  (invariant_list . "(" . (_) @anchor)
  (invariant_clause . "(" . (_) @anchor)
  (interrupt_clause . "(" . (_) @anchor)
  (outcome_list . "(" . (_) @anchor)
  (outcome_clause . "(" . (_) @anchor)
  (effect_list . "(" . (_) @anchor)
] @align (#set! "scope" "tail"))

; What has a head word: below the part behind it.
([
  (parallel . "(" . _ @first . (_) @anchor)
  (race . "(" . _ @first . (_) @anchor)
  (choose . "(" . _ @first . (_) @anchor)
  (call . "(" . (_) @first . (_) @anchor)
  (command . "(" . (_) @first . (_) @anchor)
  (printf . "(" . _ @first . (_) @anchor)
  (wait . "(" . _ @first . (_) @anchor)
  (conjunction . "(" . _ @first . (_) @anchor)
  (disjunction . "(" . _ @first . (_) @anchor)
  (leadsto . "(" . _ @first . (_) @anchor)
  (precedes . "(" . _ @first . (_) @anchor)
] @align
  (#same-line? @first @anchor)
  (#set! "scope" "tail"))
