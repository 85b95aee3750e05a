; Definitions and statements indent their contents by one step.
[
  (state_variable)
  (event)
  (skill)
  (resource)
  (property)
  (environment)
  (if)
  (while)
  (do)
  (do_until)
  (wait)
] @indent.begin

; What is a list aligns with its first element.
[
  (block)
  (parallel)
  (choose)
  (name_list)
  (transition_list)
  (input_list)
  (precondition_list)
  (invariant_list)
  (outcome_list)
  (outcome_clause)
  (invariant_clause)
  (interrupt_clause)
  (effect_list)
  (conjunction)
  (disjunction)
  (comparison)
  (call)
  (list)
] @indent.align

((block) @indent.align (#set! indent.open_delimiter "(") (#set! indent.close_delimiter ")"))
((parallel) @indent.align (#set! indent.open_delimiter "(") (#set! indent.close_delimiter ")"))

(else_clause "else" @indent.branch)
(elseif_clause "elseif" @indent.branch)
(until_clause "until" @indent.branch)

(")" @indent.end)
(comment) @indent.ignore
