; Later patterns win where several match.

(comment) @comment @spell
(string) @string
(escape_sequence) @string.escape
(number) @number
(unbounded) @constant.builtin
(boolean) @boolean
(parameter) @variable.parameter
(keyword) @property
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
"include" @keyword.import

(constant name: (symbol) @constant)
(state_variable name: (symbol) @variable)
(event name: (symbol) @type)
(skill name: (symbol) @function)
(resource name: (symbol) @variable)
(property name: (symbol) @label)
(environment name: (symbol) @type)

; The keyword of every field.
(init_field keyword: _ @property)
(min_field keyword: _ @property)
(max_field keyword: _ @property)
(states_field keyword: _ @property)
(transitions_field keyword: _ @property)
(every_field keyword: _ @property)
(capacity_field keyword: _ @property)
(input_field keyword: _ @property)
(precondition_field keyword: _ @property)
(start_field keyword: _ @property)
(invariant_field keyword: _ @property)
(guard_field keyword: _ @property)
(time_interval_field keyword: _ @property)
(action_field keyword: _ @property)
(interrupt_field keyword: _ @property)
(interruptible_field keyword: _ @property)
(success_field keyword: _ @property)
(failure_field keyword: _ @property)
(postcondition_field keyword: _ @property)
(effects_field keyword: _ @property)
(timeout_field keyword: _ @property)
(resources_field keyword: _ @property)
(monitor_field keyword: _ @property)
(body_field keyword: _ @property)
(after_field keyword: _ @property)
(before_field keyword: _ @property)
(within_field keyword: _ @property)
(for_field keyword: _ @property)
(lasting_field keyword: _ @property)
(fair_field keyword: _ @property)

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
(monitor_field value: (symbol) @boolean)
(interruptible_field value: (symbol) @boolean)
(fair_field value: (symbol) @boolean)
(input type: (symbol) @type)
(access object: (symbol) @function)
(access member: (symbol) @variable.member)

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
["if" "elseif" "else" "case"] @keyword.conditional
(case_arm pattern: (symbol) @constant.builtin)
(case_pattern status: (symbol) @constant.builtin)
["while" "do" "do-until" "until" "break"] @keyword.repeat
(until operator: _ @operator)
["success" "failure"] @keyword.return
["//" "race" "choose" "^"] @keyword.coroutine
["set" "label" "goto" "emit"] @keyword
"printf" @function.builtin

(call skill: (symbol) @function.call)
(argument name: (symbol) @variable.parameter)
(interrupt target: (access object: (symbol) @function member: (symbol) @keyword))
(emit name: (symbol) @type)
(command name: (symbol) @function.call)
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
