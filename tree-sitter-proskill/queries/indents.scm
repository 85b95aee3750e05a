; Where a new line begins. The captures are those that Neovim's tree-sitter plugins share;
; `indent.step` tells by how many columns, counted from the parenthesis (of a field: from its
; keyword). What is aligned begins below the first part behind its head word, and what has no
; head word one column behind its parenthesis.

; Definitions.
([
  (state_variable)
  (event)
  (skill)
  (resource)
  (property)
  (environment)
] @indent.begin (#set! indent.step 2))

; A field whose value does not stand on its line, and a tag with its clause.
([
  (init_field)
  (min_field)
  (max_field)
  (states_field)
  (transitions_field)
  (every_field)
  (capacity_field)
  (input_field)
  (precondition_field)
  (start_field)
  (invariant_field)
  (time_interval_field)
  (action_field)
  (interrupt_field)
  (interruptible_field)
  (success_field)
  (failure_field)
  (resources_field)
  (monitor_field)
  (body_field)
  (guard_field)
  (effects_field)
  (timeout_field)
  (postcondition_field)
  (after_field)
  (before_field)
  (within_field)
  (for_field)
  (lasting_field)
  (fair_field)
  (unknown_field)
  (precondition)
  (invariant)
  (outcome)
] @indent.begin (#set! indent.step 2))

; Statements with statements in them.
([
  (if)
  (case)
  (while)
  (do)
  (do_until)
] @indent.begin (#set! indent.step 3))

(elseif_clause "elseif" @indent.branch (#set! indent.step 1))
(else_clause "else" @indent.branch (#set! indent.step 1))
(until_clause "until" @indent.branch (#set! indent.step 1))

; What begins with a head word.
[
  (call)
  (interrupt)
  (command)
  (wait)
  (parallel)
  (race)
  (choose)
  (set)
  (printf)
  (effect)
  (test)
  (transition)
  (comparison)
  (conjunction)
  (disjunction)
  (negation)
  (implication)
  (equivalence)
  (arithmetic)
  (always)
  (never)
  (reachable)
  (infinitelyoften)
  (leadsto)
  (precedes)
  (present)
  (absent)
  (ltl)
  (globally)
  (finally)
  (next)
  (until)
] @indent.align

; Lists.
([
  (block)
  (case_arm)
  (name_list)
  (transition_list)
  (input_list)
  (precondition_list)
  (invariant_list)
  (invariant_clause)
  (interrupt_clause)
  (outcome_list)
  (outcome_clause)
  (effect_list)
  (list)
] @indent.align
  (#set! indent.open_delimiter "(")
  (#set! indent.close_delimiter ")")
  (#set! indent.step 1))

(comment) @indent.ignore
