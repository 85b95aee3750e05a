; A skill is the scope of its parameters and of its tags; a block is that of its labels.
(source_file) @local.scope
(skill) @local.scope
(environment) @local.scope

(state_variable name: (symbol) @local.definition.var)
(event name: (symbol) @local.definition.type)
(skill name: (symbol) @local.definition.function)
(resource name: (symbol) @local.definition.var)
(property name: (symbol) @local.definition.var)
(environment name: (symbol) @local.definition.type)
(states_field value: (name_list (symbol) @local.definition.enum))
(input name: (parameter) @local.definition.parameter)
(outcome tag: (symbol) @local.definition.constant)
(label name: (symbol) @local.definition.label)

(parameter) @local.reference
(call skill: (symbol) @local.reference)
(interrupt target: (access object: (symbol) @local.reference))
(access object: (symbol) @local.reference)
(test variable: (symbol) @local.reference)
(test value: (symbol) @local.reference)
(effect variable: (symbol) @local.reference)
(effect value: (symbol) @local.reference)
(transition from: (symbol) @local.reference)
(transition to: (symbol) @local.reference)
(init_field value: (symbol) @local.reference)
(comparison (symbol) @local.reference)
(success name: (symbol) @local.reference)
(failure name: (symbol) @local.reference)
(goto name: (symbol) @local.reference)
(emit name: (symbol) @local.reference)
(running skill: (symbol) @local.reference)
(called skill: (symbol) @local.reference)
(ended skill: (symbol) @local.reference)
(occurs event: (symbol) @local.reference)
(value variable: (symbol) @local.reference)
(at label: (symbol) @local.reference)
(resources_field value: (name_list (symbol) @local.reference))
