(
  (comment)* @doc
  .
  (skill name: (symbol) @name) @definition.function
  (#strip! @doc "^;+\\s*")
  (#select-adjacent! @doc @definition.function)
)
(constant name: (symbol) @name) @definition.constant
(state_variable name: (symbol) @name) @definition.variable
(event name: (symbol) @name) @definition.type
(resource name: (symbol) @name) @definition.variable
(property name: (symbol) @name) @definition.constant
(environment name: (symbol) @name) @definition.module

(call skill: (symbol) @name) @reference.call
(interrupt target: (access object: (symbol) @name)) @reference.call
(emit name: (symbol) @name) @reference.type
