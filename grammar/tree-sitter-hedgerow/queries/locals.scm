; Where names are defined and used. The names of an op hold in all of it: `before` and `after`
; of one rule speak of the same elements.

(operation) @local.scope
(rule) @local.scope
(function) @local.scope
(script) @local.scope
(test) @local.scope
(block) @local.scope
(for) @local.scope
(update) @local.scope
(drain) @local.scope

(parameter name: (name (identifier) @local.definition.parameter))
(binding name: (identifier) @local.definition.var)
(if name: (identifier) @local.definition.var)
(for variable: (identifier) @local.definition.var)
(update variable: (identifier) @local.definition.var)
(drain variable: (identifier) @local.definition.var)
(before (ring name: (name (identifier) @local.definition.var)))
(before (edge name: (name (identifier) @local.definition.var)))
(before (star name: (name (identifier) @local.definition.var)))
(names what: "new" (name (identifier) @local.definition.var))
(operation name: (identifier) @local.definition.function)
(function name: (identifier) @local.definition.function)
(script name: (identifier) @local.definition.function)
(attribute name: (identifier) @local.definition.field)

(name (identifier) @local.reference)
(call function: (identifier) @local.reference)
(qualified name: (identifier) @local.reference)
