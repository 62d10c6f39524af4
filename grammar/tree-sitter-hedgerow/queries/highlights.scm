; What is coloured how. Of two patterns for one node the later wins.

(comment) @comment
(doc) @comment.documentation
(file_doc) @comment.documentation

[ "use" "private" "attr" "fn" "op" "script" "test" "rule" ] @keyword
[ "keeps" "require" "guard" "alias" "steps" "else" ] @keyword
[ "before" "after" ] @keyword
[ "face" "hole" "loop" "edge" "vertex" "each" ] @keyword
[ "new" "keep" "erase" ] @keyword
[ "let" "var" "update" "drain" "by" "where" "in" "print" "assert" "must" "can" "why" ] @keyword
[ "if" ] @keyword.conditional
[ "repeat" "parallel" "for" "while" (break) (continue) ] @keyword.repeat
[ "return" ] @keyword.return
[ "and" "or" "not" "div" "mod" ] @keyword.operator

[ "+" "-" "*" "/" "==" "!=" "<" "<=" ">" ">=" "=" "|" "->" "=>" ".." ] @operator
[ "(" ")" "[" "]" "{" "}" ] @punctuation.bracket
[ "," "." ":" ] @punctuation.delimiter

(int) @number
(real) @number.float
(true) @boolean
(false) @boolean
[(text) (text_with_values)] @string
(type) @type
(property) @constant
(guard level: (identifier) @constant)

(name (identifier) @variable)
(index (identifier) @variable.parameter)
(parameter name: (name (identifier) @variable.parameter))
(binding name: (identifier) @variable)
(if name: (identifier) @variable)
(for variable: (identifier) @variable)
(update variable: (identifier) @variable)
(drain variable: (identifier) @variable)
(operation result: (identifier) @variable)
(field field: (word) @property)
(change field: (word) @property)
(attribute name: (identifier) @property)

; What is drawn: halfedges and paths are the arrows of the picture.
(halfedge "-" @operator (name (identifier) @label) "->" @operator)
(path (name (identifier) @label))
(fan "*" @operator (identifier) @label)

(operation name: (identifier) @function)
(function name: (identifier) @function)
(script name: (identifier) @function)
(rule name: (identifier) @function)
(call function: (identifier) @function.call)
(qualified file: (identifier) @module "::" @punctuation.delimiter name: (identifier) @function.call)
