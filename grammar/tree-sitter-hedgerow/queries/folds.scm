; What can be folded.

[
  (operation)
  (rule)
  (before)
  (after)
  (block)
  (comment)+
  (doc)+
] @fold
