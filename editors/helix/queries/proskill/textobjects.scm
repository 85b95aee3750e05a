; mif, maf: a skill's body and the skill; mit, mat: what is defined otherwise; mia: an argument.
(skill (body_field value: (_) @function.inside)) @function.around
(environment (body_field value: (_) @function.inside)) @function.around

[
  (state_variable)
  (event)
  (resource)
  (property)
] @class.around

(argument value: (_) @parameter.inside) @parameter.around
(input) @parameter.around

(comment) @comment.inside
(comment)+ @comment.around

(transition_list (transition) @entry.around)
(name_list (symbol) @entry.around)
