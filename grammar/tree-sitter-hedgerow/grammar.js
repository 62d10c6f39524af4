/**
 * The grammar of hedgerow for tree-sitter. It accepts what the parser of hedgerow reads without
 * a mistake, and nothing else; a test holds the two together. In words: ../hedgerow.ebnf.
 */

// What can never be a name; a word after a dot and a type may be any of them.
const HARD = [
  "use", "attr", "fn", "op", "script",
  "keeps", "rule", "before", "require", "guard", "alias", "after",
  "face", "hole", "loop", "edge", "vertex",
  "each", "new", "keep", "erase",
  "let", "var", "if", "else", "repeat", "for", "in",
  "where", "while", "drain", "update",
  "must", "can", "why", "print", "assert",
  "return", "break", "continue",
  "and", "or", "not", "div", "mod", "true", "false",
];

// Keywords only where no name can stand.
const SOFT = ["private", "test", "by", "steps", "parallel"];

const list = (rule) => seq(rule, repeat(seq(",", rule)));

/**
 * Values from what binds least to what binds most. Every rank stands twice: `start` is a value
 * at the start of a statement, where `if` begins a statement and no value.
 */
const ranks = (start) => {
  const rule = ($, name) => $[`_${name}${start ? "_at_start" : ""}`];
  const chain = (name, next, binds, operators) => [
    `_${name}${start ? "_at_start" : ""}`,
    ($) => choice(rule($, next), alias($[`_${name}_chain${start ? "_at_start" : ""}`], $.binary)),
    `_${name}_chain${start ? "_at_start" : ""}`,
    ($) => prec.left(binds, seq(
      field("left", rule($, name)),
      field("operator", operators.length > 1 ? choice(...operators) : operators[0]),
      field("right", $[`_${next}`]),
    )),
  ];
  const entries = (flat) => {
    const pairs = [];
    for (let at = 0; at < flat.length; at += 2) pairs.push([flat[at], flat[at + 1]]);
    return Object.fromEntries(pairs);
  };
  const end = start ? "_at_start" : "";
  return {
    ...entries(chain("value", "both", 1, ["or"])),
    ...entries(chain("both", "denied", 2, ["and"])),
    [`_denied${end}`]: ($) => choice(rule($, "comparison"), alias($._denial, $.unary)),
    [`_comparison${end}`]: ($) => choice(rule($, "sum"), alias($[`_compared${end}`], $.binary)),
    [`_compared${end}`]: ($) => prec.left(4, seq(
      field("left", rule($, "sum")),
      field("operator", choice("==", "!=", "<", "<=", ">", ">=")),
      field("right", $._sum),
    )),
    ...entries(chain("sum", "product", 5, ["+", "-"])),
    ...entries(chain("product", "signed", 6, ["*", "/", "div", "mod"])),
    [`_signed${end}`]: ($) => choice(rule($, "field"), alias($._negation, $.unary)),
    [`_field${end}`]: ($) => choice(rule($, "atom"), alias($[`_field_of${end}`], $.field)),
    [`_field_of${end}`]: ($) => prec.left(8, seq(
      field("of", rule($, "field")), ".", field("field", $.word),
    )),
  };
};

module.exports = grammar({
  name: "hedgerow",

  word: ($) => $.identifier,

  reserved: {
    global: (_) => HARD,
    none: (_) => [],
  },

  extras: ($) => [/[ \t\r\n\f\uFEFF]/, $.comment, $.doc, $.file_doc],

  // Whether a name goes on a list or begins an assignment shows behind it.
  conflicts: ($) => [[$.names], [$._spokes]],

  inline: ($) => [$._arrow_vertex],

  rules: {
    file: ($) => repeat($._item),

    _item: ($) => choice($.use, $.attribute, $.function, $.operation, $.script, $.test),

    use: ($) => seq("use", field("path", $.text)),

    attribute: ($) => seq(
      optional("private"), "attr", field("name", $.identifier), ":",
      field("of", $.type), field("type", $.type),
      optional(seq("=", field("default", $._value))),
    ),

    function: ($) => seq(
      optional("private"), "fn", field("name", $.identifier),
      field("parameters", $.parameters), optional(seq("->", field("result", $.type))),
      field("body", $.block),
    ),

    script: ($) => seq(
      optional("private"), "script", field("name", $.identifier),
      field("parameters", $.parameters), field("body", $.block),
    ),

    test: ($) => seq("test", field("name", $.text), field("body", $.block)),

    parameters: ($) => seq("(", optional(seq(list($.parameter), optional(","))), ")"),
    parameter: ($) => seq(
      field("name", $.name), ":", field("type", $.type),
      optional(seq("=", field("default", $._value))),
    ),

    // Operations

    operation: ($) => seq(
      optional("private"), "op", field("name", $.identifier), field("parameters", $.parameters),
      optional(seq("->", field("result", choice($.identifier, alias($._element, $.type))))),
      optional(seq("keeps", list(field("keeps", $.property)))),
      "{", optional(choice($._rewrite, $._rules, $._done_in_steps)), "}",
    ),
    _element: (_) => choice("vertex", "edge", "face"),

    _done_in_steps: ($) => seq(repeat($._condition), $.steps),
    steps: ($) => seq("steps", $.block),

    property: ($) => $.identifier,

    _rules: ($) => repeat1($.rule),
    rule: ($) => seq("rule", field("name", $.identifier), "{", optional($._rewrite), "}"),

    // A side that lacks is a mistake of meaning, which is told elsewhere.
    _rewrite: ($) => choice(
      seq($.before, repeat($._condition), optional($.after)),
      seq(repeat1($._condition), optional($.after)),
      $.after,
    ),
    before: ($) => seq("before", "{", repeat($._statement), "}"),
    after: ($) => seq("after", "{", repeat($._statement), "}"),

    _condition: ($) => choice($.require, $.guard, $.alias),
    require: ($) => seq(
      "require", field("condition", $._value), optional(seq("else", field("reason", $.text))),
    ),
    guard: ($) => seq("guard", field("level", $.identifier)),
    alias: ($) => seq("alias", $.name, repeat1(seq(optional(","), $.name))),

    _statement: ($) => choice($.ring, $.edge, $.star, $.names, $.change),

    ring: ($) => seq(
      field("kind", choice("face", "hole", "loop")), field("name", $.name), ":",
      choice(seq($.name, repeat1($._arrow_vertex)), $.period),
    ),
    _arrow_vertex: ($) => seq($._arrow, $.name),
    period: ($) => seq(
      "each", field("index", $.identifier), "{", repeat1(seq($.name, $._arrow)), "}",
    ),
    _arrow: ($) => choice($.halfedge, $.path),
    halfedge: ($) => seq("-", $.name, "->"),
    path: ($) => choice(seq("=", $.name, "=>"), "=>"),

    edge: ($) => seq("edge", field("name", $.name), ":", $.name, "|", $.name),

    star: ($) => seq(
      "vertex", field("name", $.name), ":",
      choice($._spokes, alias($.spokes_of_each, $.period)),
    ),
    spokes_of_each: ($) => seq(
      "each", field("index", $.identifier), "{", $._spokes, "}",
    ),
    _spokes: ($) => seq($._spoke, repeat(seq(optional(","), $._spoke))),
    _spoke: ($) => choice($.name, $.fan),
    // A fan has a name only where the name touches the star.
    fan: ($) => prec.right(seq(
      "*",
      optional(seq(alias($._touching, $.identifier), optional($._subscript))),
    )),

    names: ($) => seq(
      field("what", choice("new", "keep", "erase")),
      $.name, repeat(seq(optional(","), $.name)),
    ),

    change: ($) => seq(
      field("of", $.name), ".", field("field", $.word), "=", field("value", $._value),
    ),

    name: ($) => prec.right(seq(
      choice($.identifier, alias("parallel", $.identifier)), optional($._subscript),
    )),
    _subscript: ($) => seq("[", $.index, "]"),
    index: ($) => choice(
      seq($.identifier, optional(seq(choice("+", "-"), $.int))),
      seq(optional(choice("+", "-")), $.int),
    ),

    // Code

    block: ($) => seq("{", repeat($._action), "}"),

    _action: ($) => choice(
      $.binding, $.assignment, $.if, $.repeat, $.while, $.for, $.update, $.drain,
      $.print, $.assert, $.require, $.return, $.break, $.continue, $.block, $._value_at_start,
    ),

    binding: ($) => seq(
      choice("let", "var"), field("name", $.identifier),
      optional(seq(":", field("type", $.type))), "=", field("value", $._value),
    ),
    assignment: ($) => seq(field("to", $._value_at_start), "=", field("value", $._value)),
    if: ($) => seq(
      "if", optional(seq("let", field("name", $.identifier), "=")),
      field("condition", $._value), field("then", $.block),
      optional(seq("else", field("else", choice($.if, $.block)))),
    ),
    repeat: ($) => seq("repeat", field("count", $._value), field("body", $.block)),
    while: ($) => seq("while", field("condition", $._value), field("body", $.block)),
    for: ($) => seq(optional("parallel"), "for", $._source, field("body", $.block)),
    update: ($) => seq("update", $._source, field("body", $.block)),
    drain: ($) => seq(
      "drain", field("variable", $.identifier), "in", field("in", $._value),
      "by", field("by", $._value),
      optional(seq("while", field("condition", $._value))), field("body", $.block),
    ),
    print: ($) => seq("print", list(choice($._value, $.text_with_values))),
    assert: ($) => seq(
      "assert", field("condition", $._value), optional(seq("else", field("reason", $.text))),
    ),
    return: ($) => prec.right(seq("return", optional($._value))),
    break: (_) => "break",
    continue: (_) => "continue",

    _source: ($) => seq(
      field("variable", $.identifier), "in", field("in", choice($._value, $.range)),
      optional(seq("where", field("where", $._value))),
    ),

    range: ($) => seq(field("first", $._value), "..", field("end", $._value)),

    // Values

    ...ranks(false),
    ...ranks(true),

    _denial: ($) => prec(3, seq("not", $._denied)),
    _negation: ($) => prec(7, seq("-", $._signed)),

    _atom: ($) => choice($._atom_at_start, $.choice),
    _atom_at_start: ($) => choice(
      $.name, $.call, $.must, $.asked, $.parenthesised, $.true, $.false, $.int, $.real, $.text,
      $._no_value,
    ),
    parenthesised: ($) => seq("(", $._value, ")"),
    true: (_) => "true",
    false: (_) => "false",

    must: ($) => prec.right(seq("must", choice($.name, $.call))),
    asked: ($) => prec.right(seq(choice("can", "why"), choice($.name, $.call))),
    call: ($) => prec(9, seq(
      field("function", choice(
        $.identifier, alias("hole", $.identifier), alias("parallel", $.identifier), $.qualified,
      )),
      // On the line of the name; the next statement may begin with one, too.
      alias(token.immediate(prec(1, /[ \t\r\f\uFEFF]*\(/)), "("),
      optional(choice(
        seq(list($._value), optional(",")),
        seq($._value, "for", $._source),
      )),
      ")",
    )),
    qualified: ($) => seq(
      field("file", choice($.identifier, alias("parallel", $.identifier))), "::",
      field("name", $.identifier),
    ),
    choice: ($) => seq(
      "if", field("condition", $._value), field("then", $.block),
      "else", field("else", choice($.block, $.choice)),
    ),

    // What looks like a value and is none: a number grown together with a name, and the call
    // of a subscript. Nothing matches the end of it.
    _no_value: ($) => choice(
      seq($._grown_number, $._never),
      prec(9, seq(
        $.identifier, $._subscript,
        alias(token.immediate(prec(1, /[ \t\r\f\uFEFF]*\(/)), "("), $._never,
      )),
    ),
    _never: (_) => "\u{10FFFF}\u{10FFFE}",

    // Tokens

    type: ($) => $._any_word,
    word: ($) => $._any_word,
    _any_word: ($) => reserved("none", choice($.identifier, ...HARD, ...SOFT)),

    identifier: (_) => /[\p{XID_Start}_]\p{XID_Continue}*'*/,
    _touching: (_) => token.immediate(prec(1, /[\p{XID_Start}_]\p{XID_Continue}*'*/)),
    int: (_) => /[0-9]+/,
    real: (_) => token(choice(
      /[0-9]+\.[0-9]+([eE][+-]?[0-9]+)?/,
      /[0-9]+[eE][+-]?[0-9]+/,
    )),
    // Of equal length the earlier wins: `1e3` is real.
    _grown_number: (_) => token(choice(
      /[0-9]+(\.[0-9]+)?\p{XID_Start}\p{XID_Continue}*/,
      /[0-9]+(\.[0-9]+)?_\p{XID_Continue}*/,
    )),
    text: (_) => /"([^"\\\r\n{]|\\[nt"\\{}])*"/,
    text_with_values: ($) => seq(
      $._text_head, $._value, repeat(seq($._text_middle, $._value)), $._text_tail,
    ),
    _text_head: (_) => /"([^"\\\r\n{]|\\[nt"\\{}])*\{/,
    _text_middle: (_) =>
      /(:[ \t]*(full|\.[0-9]|\.1[0-7])[ \t]*)?\}([^"\\\r\n{]|\\[nt"\\{}])*\{/,
    _text_tail: (_) =>
      /(:[ \t]*(full|\.[0-9]|\.1[0-7])[ \t]*)?\}([^"\\\r\n{]|\\[nt"\\{}])*"/,

    // Exactly one of the three matches a whole line.
    comment: (_) => token(choice(/\/\/([^\/!\n][^\n]*)?/, /\/\/\/\/[^\n]*/)),
    doc: (_) => token(/\/\/\/([^\/\n][^\n]*)?/),
    file_doc: (_) => token(/\/\/![^\n]*/),
  },
});
