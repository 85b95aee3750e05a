; Made by make_queries.py of the grammar's own; do not edit.
; Later patterns win where several match.

(comment) @comment
(string) @string
(escape_sequence) @constant.character.escape
(number) @constant.numeric
(unbounded) @constant.builtin
(boolean) @constant.builtin.boolean
(parameter) @variable.parameter
(keyword) @attribute
(all) @constant.builtin
(malformed_name) @error
(unexpected) @error
(surplus_close) @error

["(" ")"] @punctuation.bracket
["[" "]"] @punctuation.bracket
["," "."] @punctuation.delimiter

; Definitions.
[
  "defconst"
  "defsv"
  "defevent"
  "defskill"
  "defresource"
  "defproperty"
  "defenvironment"
  "defplatform"
] @keyword
"include" @keyword.control.import

(constant name: (symbol) @constant)
(state_variable name: (symbol) @variable)
(event name: (symbol) @type)
(skill name: (symbol) @function)
(resource name: (symbol) @variable)
(property name: (symbol) @label)
(environment name: (symbol) @type)

; The keyword of every field.
(init_field keyword: _ @attribute)
(min_field keyword: _ @attribute)
(max_field keyword: _ @attribute)
(states_field keyword: _ @attribute)
(transitions_field keyword: _ @attribute)
(every_field keyword: _ @attribute)
(capacity_field keyword: _ @attribute)
(input_field keyword: _ @attribute)
(precondition_field keyword: _ @attribute)
(start_field keyword: _ @attribute)
(invariant_field keyword: _ @attribute)
(guard_field keyword: _ @attribute)
(time_interval_field keyword: _ @attribute)
(action_field keyword: _ @attribute)
(interrupt_field keyword: _ @attribute)
(interruptible_field keyword: _ @attribute)
(success_field keyword: _ @attribute)
(failure_field keyword: _ @attribute)
(postcondition_field keyword: _ @attribute)
(effects_field keyword: _ @attribute)
(timeout_field keyword: _ @attribute)
(resources_field keyword: _ @attribute)
(monitor_field keyword: _ @attribute)
(body_field keyword: _ @attribute)
(after_field keyword: _ @attribute)
(before_field keyword: _ @attribute)
(within_field keyword: _ @attribute)
(for_field keyword: _ @attribute)
(lasting_field keyword: _ @attribute)
(fair_field keyword: _ @attribute)

; Values.
(states_field value: (name_list (symbol) @constant))
(init_field value: (symbol) @constant)
(init_field value: (name_list (symbol) @constant))
(min_field value: (symbol) @constant)
(max_field value: (symbol) @constant)
(capacity_field value: (symbol) @constant)
(lasting_field value: (symbol) @constant)
(timeout_field value: (symbol) @constant)
(wait condition: (symbol) @constant)
(interval lower: (symbol) @constant)
(interval upper: (symbol) @constant)
(transition from: (symbol) @constant)
(transition to: (symbol) @constant)
(effect variable: (symbol) @variable)
(effect value: (symbol) @constant)
(test variable: (symbol) @variable)
(test value: (symbol) @constant)
(value variable: (symbol) @variable)
(value value: (symbol) @constant)
(comparison (symbol) @variable)
(arithmetic (symbol) @variable)
(printf (symbol) @variable)
(argument value: (symbol) @constant)
(command (symbol) @constant)
(monitor_field value: (symbol) @constant.builtin.boolean)
(interruptible_field value: (symbol) @constant.builtin.boolean)
(fair_field value: (symbol) @constant.builtin.boolean)
(input type: (symbol) @type)
(access object: (symbol) @function)
(access member: (symbol) @variable.other.member)

; Tags.
(precondition tag: (symbol) @label)
(invariant tag: (symbol) @label)
(outcome tag: (symbol) @label)
(success name: (symbol) @label)
(failure name: (symbol) @label)
(label name: (symbol) @label)
(goto name: (symbol) @label)
(at label: (symbol) @label)
(case_pattern (symbol) @label)

; Statements.
["if" "elseif" "else" "case"] @keyword.control.conditional
(case_arm pattern: (symbol) @constant.builtin)
(case_pattern status: (symbol) @constant.builtin)
["while" "do" "do-until" "until" "break"] @keyword.control.repeat
(until operator: _ @operator)
["success" "failure"] @keyword.control.return
["//" "race" "choose" "^"] @keyword.control
["set" "label" "goto" "emit"] @keyword
"printf" @function.builtin

(call skill: (symbol) @function)
(argument name: (symbol) @variable.parameter)
(interrupt target: (access object: (symbol) @function member: (symbol) @keyword))
(emit name: (symbol) @type)
(command name: (symbol) @function)
(resources_field value: (name_list (symbol) @variable))

; Conditions and properties.
(comparison operator: _ @operator)
(arithmetic operator: _ @operator)
(conjunction operator: _ @keyword.operator)
(disjunction operator: _ @keyword.operator)
(negation operator: _ @keyword.operator)
(implication operator: _ @keyword.operator)
(equivalence operator: _ @keyword.operator)
(globally operator: _ @operator)
(finally operator: _ @operator)
(next operator: _ @operator)
(weak_until operator: _ @operator)
(release operator: _ @operator)
(strong_release operator: _ @operator)
(running operator: _ @function.builtin skill: (symbol) @function)
(called operator: _ @function.builtin skill: (symbol) @function)
(ended operator: _ @function.builtin skill: (symbol) @function)
(ended status: (symbol) @constant.builtin)
(occurs operator: _ @function.builtin event: (symbol) @type)
(at operator: _ @function.builtin)
(value operator: _ @function.builtin)
; Patterns.
[
  "always"
  "never"
  "reachable"
  "always_reachable"
  "deadlockfree"
  "infinitelyoften"
  "leadsto"
  "precedes"
  "present"
  "absent"
  "longest"
  "shortest"
  "ltl"
] @keyword.operator

(comparison (symbol) @constant.builtin
  (#any-of? @constant.builtin "no_status" "success" "failure" "failed_inv" "interrupted"))

(ERROR) @error
