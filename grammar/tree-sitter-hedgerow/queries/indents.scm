; How lines are indented.

[
  (operation)
  (rule)
  (before)
  (after)
  (block)
  (period)
  (parameters)
] @indent.begin

[ "}" ")" ] @indent.end @indent.branch

[ (comment) (doc) (file_doc) ] @indent.ignore
