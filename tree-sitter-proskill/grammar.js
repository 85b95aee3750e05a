/**
 * ProSkill: robot skills in a Lisp-like notation.
 *
 * Every rule is lenient. What stands in a pair of parentheses is read by the context that it stands
 * in (a condition, a statement, effects, …); each context takes any word anywhere, and a form that
 * it does not know is a plain `list`. So a half-typed program gives a clean tree; what is missing,
 * or too much, is for those who read the tree to say.
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

const NAME = /[A-Za-z_][A-Za-z0-9_]*/;

/** A form in parentheses. It also ends where the next definition starts a line: src/scanner.c. */
const form = ($, ...contents) => seq('(', ...contents, $._close);

/** Words that have their own field each, in this order, then anything of `words` and `rest`. */
const leading = ($, [name, ...others], rest, words = $._word, otherWords = $._word_but_symbol) =>
  name === undefined
    ? repeat(choice(words, rest))
    : optional(
        choice(
          seq(field(name, $.symbol), leading($, others, rest, words, otherWords)),
          seq(choice(otherWords, rest), repeat(choice(words, rest))),
        ),
      );

/** A keyword and all that follows it up to the next one. */
const keyed = ($, keyword, value) =>
  seq(field('keyword', keyword), repeat(field('value', choice(value, $._loose))));

const keyedFields = ($, ...known) => repeat(choice(...known, $.unknown_field));

/** A definition: its name (and whatever else was typed there), then its fields. */
const definition = ($, head, ...fields) =>
  form(
    $,
    field('head', head),
    leading($, ['name'], $.list, $._loose, $._loose_but_symbol),
    keyedFields($, ...fields),
  );

/** A part of a definition that has keywords of its own. */
const clause = ($, ...fields) =>
  form($, repeat(choice($._loose, $.list)), keyedFields($, ...fields));

/** A tag with what it names. */
const tagged = ($, name, value) =>
  prec.right(seq(field('tag', $.symbol), optional(field(name, value))));

const outcomes = ($, keyword) =>
  seq(
    field('keyword', keyword),
    repeat(field('value', choice($.outcome, $.outcome_list, $._loose_but_symbol))),
  );

/** A condition, then statements. */
const guarded = $ =>
  optional(seq(field('condition', choice($._condition, $.keyword)), repeat($._statement)));

/** A form that names a file. */
const naming = ($, head) =>
  form(
    $,
    field('head', head),
    repeat(
      choice(
        field('path', $.string),
        $.symbol,
        $.access,
        $.parameter,
        $.keyword,
        $._sign,
        $.list,
      ),
    ),
  );

/** A statement about one name. */
const named = ($, head) => form($, field('head', head), leading($, ['name'], $.list));

const branches = ($, head) =>
  form($, field('head', head), repeat(choice(field('branch', $.block), $._word)));

/** The forms of a condition, whose operands are `operand`; `prefix` tells the contexts apart. */
const connectives = (prefix, operand) => ({
  [`${prefix}comparison`]: $ =>
    form($, field('operator', choice('=', '/=', '<', '<=', '>', '>=')), repeat($[operand])),
  [`${prefix}conjunction`]: $ => form($, field('operator', choice('and', '&')), repeat($[operand])),
  [`${prefix}disjunction`]: $ => form($, field('operator', choice('or', '|')), repeat($[operand])),
  [`${prefix}negation`]: $ => form($, field('operator', choice('not', '~')), repeat($[operand])),
  [`${prefix}implication`]: $ => form($, field('operator', '=>'), repeat($[operand])),
  [`${prefix}equivalence`]: $ => form($, field('operator', '<=>'), repeat($[operand])),
  [`${prefix}arithmetic`]: $ => form($, field('operator', choice('+', '-')), repeat($[operand])),
  [`${prefix}test`]: $ => form($, field('variable', $.symbol), repeat(field('value', $[operand]))),
});

/** Properties over one skill, event, or label: `(running takeoff)`. */
const observation = ($, head, ...names) =>
  form($, field('operator', head), leading($, names, $.list));

/** Operators of LTL that are written as one letter, and their names here. */
const LETTERS = {
  G: 'globally',
  F: 'finally',
  X: 'next',
  U: 'until',
  W: 'weak_until',
  R: 'release',
  M: 'strong_release',
};

/** A letter is an operator only before a formula. Before a value it is a variable: `(F On)`. */
const byLetter = ($, letter) =>
  seq(field('operator', letter), choice($._proposition_form, $.boolean));

const temporal = ($, name, ...words) => {
  const [letter] = Object.entries(LETTERS).find(([_, of]) => of === name);
  const heads = [...words.map(word => field('operator', word)), byLetter($, letter)];
  return form($, choice(...heads), repeat($._property_operand));
};

/** A test whose variable may be called like an operator. */
const propertyTest = $ =>
  form(
    $,
    choice(
      seq(field('variable', $.symbol), repeat(field('value', $._property_operand))),
      seq(
        field('variable', choice(...Object.keys(LETTERS).map(letter => alias(letter, $.symbol)))),
        optional(
          seq(
            field('value', choice($._loose, $.keyword)),
            repeat(field('value', $._property_operand)),
          ),
        ),
      ),
    ),
  );

const pattern = ($, head) =>
  form(
    $,
    field('head', head),
    repeat($._proposition),
    keyedFields(
      $,
      $.after_field,
      $.before_field,
      $.within_field,
      $.for_field,
      $.lasting_field,
      $.fair_field,
    ),
  );

const PATTERNS = [
  'always',
  'never',
  'reachable',
  'always_reachable',
  'deadlockfree',
  'infinitelyoften',
  'leadsto',
  'precedes',
  'present',
  'absent',
  'longest',
  'shortest',
  'ltl',
];

module.exports = grammar({
  name: 'proskill',

  extras: $ => [/\s/, $.comment],

  externals: $ => [$._implicit_close, $._error_sentinel],

  word: $ => $.symbol,

  inline: $ => [
    $._close,
    $._definition,
    $._statement,
    $._statement_form,
    $._condition,
    $._proposition,
  ],

  rules: {
    source_file: $ => repeat(choice($._definition, $._word, $.surplus_close)),

    surplus_close: _ => ')',

    _close: $ => choice(')', $._implicit_close),

    // Words.

    comment: _ => token(seq(';', /([^\r\n]|\r+[^\r\n])*/)),

    symbol: _ => NAME,
    parameter: _ => /\$[A-Za-z_][A-Za-z0-9_]*/,
    keyword: _ => /:[A-Za-z_][A-Za-z0-9_]*/,
    number: _ => /-?[0-9]+(\.[0-9]+)?/,
    operator: _ => /[=<>\/&|~^+*!-]+/,
    /** What looks like a name but is none: `take-off`, `3d`, `élan`. */
    malformed_name: _ =>
      token(
        choice(
          /[A-Za-z_][A-Za-z0-9_]*([-]|[^\x00-\x7f\s])([A-Za-z0-9_-]|[^\x00-\x7f\s])*/,
          /[0-9]+([A-Za-z_]|[^\x00-\x7f\s])([A-Za-z0-9_-]|[^\x00-\x7f\s])*/,
          /[^\x00-\x7f\s]([A-Za-z0-9_-]|[^\x00-\x7f\s])*/,
        ),
      ),
    unexpected: _ => token(prec(-10, choice('...', /[^\s();"]/))),

    /** `skill.status`; the second half is missing while it is typed. */
    access: $ =>
      prec.right(
        seq(
          field('object', $.symbol),
          token.immediate('.'),
          optional(field('member', alias($._member, $.symbol))),
        ),
      ),
    _member: _ => token.immediate(NAME),

    /** Ends with its line at the latest, so that a missing quote damages one line. */
    string: $ =>
      prec.right(
        seq(
          '"',
          repeat(choice($.string_content, $.escape_sequence)),
          optional(token.immediate(prec(2, '"'))),
        ),
      ),
    string_content: _ => token.immediate(prec(1, /[^"\\\r\n]+/)),
    escape_sequence: _ => token.immediate(prec(1, /\\[^\r\n]?/)),

    /** `[1,3]`, `]0,1]`, `[1,...[`, `[SHORT,LONG]`. */
    interval: $ =>
      prec.right(
        seq(
          field('left', choice('[', ']')),
          optional(field('lower', choice($.number, $.symbol))),
          optional(seq(',', optional(field('upper', choice($.number, $.symbol, $.unbounded))))),
          optional(field('right', choice('[', ']'))),
        ),
      ),
    unbounded: _ => '...',

    _word: $ => choice($._loose, $.keyword),
    _word_but_symbol: $ => choice($._loose_but_symbol, $.keyword),
    _loose: $ => choice($.symbol, $._loose_but_symbol),
    _loose_but_symbol: $ => choice($.access, $._literal),
    _literal: $ => choice($.parameter, $.string, $._sign),
    _sign: $ => choice($.number, $.interval, $.operator, $.malformed_name, $.unexpected),

    /** Any form that its context does not know. */
    list: $ => form($, leading($, ['head'], $.list)),
    name_list: $ => form($, repeat(choice($._word, $.list))),

    unknown_field: $ => keyed($, $.keyword, $.list),

    // Definitions.

    _definition: $ =>
      choice(
        $.include,
        $.platform,
        $.constant,
        $.state_variable,
        $.event,
        $.skill,
        $.resource,
        $.property,
        $.environment,
        $.list,
      ),

    include: $ => naming($, 'include'),

    platform: $ => naming($, 'defplatform'),

    constant: $ => named($, 'defconst'),

    state_variable: $ =>
      definition(
        $,
        'defsv',
        $.init_field,
        $.min_field,
        $.max_field,
        $.states_field,
        $.transitions_field,
      ),
    init_field: $ => keyed($, ':init', $.name_list),
    min_field: $ => keyed($, ':min', $.list),
    max_field: $ => keyed($, ':max', $.list),
    states_field: $ => keyed($, ':states', $.name_list),
    transitions_field: $ => keyed($, ':transitions', choice($.all, $.transition_list)),
    all: _ => ':all',
    transition_list: $ => form($, repeat(choice($._word, $.transition))),
    transition: $ => form($, leading($, ['from', 'to'], $.list)),

    event: $ => definition($, 'defevent', $.every_field, $.guard_field, $.effects_field),
    every_field: $ => keyed($, ':every', $.list),

    resource: $ => definition($, 'defresource', $.capacity_field),
    capacity_field: $ => keyed($, ':capacity', $.list),

    environment: $ => definition($, 'defenvironment', $.body_field),

    skill: $ =>
      definition(
        $,
        'defskill',
        $.input_field,
        $.precondition_field,
        $.start_field,
        $.invariant_field,
        $.time_interval_field,
        $.action_field,
        $.interrupt_field,
        $.interruptible_field,
        $.success_field,
        $.failure_field,
        $.resources_field,
        $.monitor_field,
        $.body_field,
      ),

    input_field: $ => keyed($, ':input', $.input_list),
    input_list: $ => form($, repeat(choice($.input, $._input_word, $.list))),
    input: $ =>
      prec.right(seq(field('name', $.parameter), optional(field('type', $.symbol)))),
    _input_word: $ => choice($.symbol, $.access, $.keyword, $.string, $._sign),

    precondition_field: $ => keyed($, ':precondition', $.precondition_list),
    precondition_list: $ =>
      form($, repeat(choice($.precondition, $._word_but_symbol, $._condition_form))),
    precondition: $ =>
      tagged($, 'condition', choice($._condition_form, $.boolean, $.parameter)),

    start_field: $ => keyed($, ':start', $._effects),

    invariant_field: $ => keyed($, ':invariant', $.invariant_list),
    invariant_list: $ =>
      form($, repeat(choice($.invariant, $._word_but_symbol, $.invariant_clause))),
    invariant: $ => tagged($, 'clause', $.invariant_clause),
    invariant_clause: $ => clause($, $.guard_field, $.effects_field),
    guard_field: $ => keyed($, ':guard', choice($._condition_form, $.boolean)),

    time_interval_field: $ => keyed($, ':time_interval', $.list),

    action_field: $ => keyed($, ':action', $.command),
    command: $ => form($, leading($, ['name'], $.list)),

    interrupt_field: $ => keyed($, ':interrupt', $.interrupt_clause),
    interrupt_clause: $ => clause($, $.effects_field),

    interruptible_field: $ => keyed($, ':interruptible', $.list),

    success_field: $ => outcomes($, ':success'),
    failure_field: $ => outcomes($, ':failure'),
    outcome_list: $ => form($, repeat(choice($.outcome, $._word_but_symbol, $.outcome_list))),
    outcome: $ => tagged($, 'clause', $.outcome_clause),
    outcome_clause: $ => clause($, $.effects_field, $.postcondition_field),
    postcondition_field: $ => keyed($, ':postcondition', choice($._condition_form, $.boolean)),

    resources_field: $ => keyed($, ':resources', $.name_list),
    monitor_field: $ => keyed($, ':monitor', $.list),
    body_field: $ => keyed($, ':body', $.block),

    // Effects.

    effects_field: $ => keyed($, ':effects', $._effects),
    _effects: $ => choice($.effect, $.effect_list),
    effect: $ => form($, field('variable', $.symbol), repeat(field('value', $._operand))),
    effect_list: $ =>
      form(
        $,
        optional(seq(choice($._word_but_symbol, $._effects), repeat(choice($._word, $._effects)))),
      ),

    // Conditions and values.

    _condition: $ => choice($._loose, $.boolean, $._condition_form),
    _operand: $ => choice($._condition, $.keyword),
    _condition_form: $ =>
      choice(
        $.comparison,
        $.conjunction,
        $.disjunction,
        $.negation,
        $.implication,
        $.equivalence,
        $.arithmetic,
        $.test,
        alias($._condition_list, $.list),
      ),
    _condition_list: $ =>
      form(
        $,
        optional(
          seq(choice($._word_but_symbol, $.boolean, $.list), repeat(choice($._word, $.list))),
        ),
      ),
    boolean: _ => choice('true', 'false'),
    ...connectives('', '_operand'),

    // Statements.

    block: $ => form($, repeat($._statement)),
    _statement: $ => choice($._statement_form, $._word),
    _statement_form: $ =>
      choice(
        $.call,
        $.interrupt,
        $.wait,
        $.if,
        $.case,
        $.while,
        $.do,
        $.do_until,
        $.break,
        $.label,
        $.goto,
        $.parallel,
        $.race,
        $.choose,
        $.set,
        $.printf,
        $.success,
        $.failure,
        $.emit,
        alias($._statement_list, $.list),
      ),
    _statement_list: $ =>
      form(
        $,
        optional(seq(choice($._literal, $.keyword, $.list), repeat(choice($._word, $.list)))),
      ),

    call: $ =>
      form(
        $,
        field('skill', $.symbol),
        repeat(choice($.argument, $._word_but_symbol, $._condition_form)),
      ),
    argument: $ =>
      prec.right(
        seq(
          field('name', $.symbol),
          optional(field('value', choice($._loose, $.boolean, $._condition_form))),
        ),
      ),
    interrupt: $ => form($, field('target', $.access), repeat(choice($._word, $.list))),

    wait: $ =>
      form(
        $,
        field('head', '^'),
        repeat(field('condition', $._condition)),
        keyedFields($, $.effects_field, $.timeout_field),
      ),
    /** How long, then what is done when that time is over. */
    timeout_field: $ => keyed($, ':timeout', $._statement_form),

    if: $ =>
      form($, field('head', 'if'), guarded($), repeat(choice($.elseif_clause, $.else_clause))),
    elseif_clause: $ => prec.right(seq(field('head', 'elseif'), guarded($))),
    else_clause: $ => prec.right(seq(field('head', 'else'), repeat($._statement))),
    /** A call, then what is done after each of its outcomes. */
    case: $ =>
      form(
        $,
        field('head', 'case'),
        repeat($._word),
        optional(
          seq(
            field('call', choice($.call, alias($._statement_list, $.list))),
            repeat(choice($.case_arm, $._word)),
          ),
        ),
      ),
    case_arm: $ =>
      form(
        $,
        optional(
          seq(
            field('pattern', choice($.symbol, $.case_pattern, $._loose_but_symbol, $.keyword)),
            repeat($._statement),
          ),
        ),
      ),
    case_pattern: $ => form($, leading($, ['status'], $.list)),
    while: $ => form($, field('head', 'while'), guarded($)),
    do: $ => form($, field('head', 'do'), repeat($._statement), optional($.until_clause)),
    until_clause: $ => prec.right(seq(field('head', 'until'), guarded($))),
    do_until: $ => form($, field('head', 'do-until'), guarded($)),
    break: $ => choice('break', form($, 'break', repeat(choice($._word, $.list)))),

    label: $ => named($, 'label'),
    goto: $ => named($, 'goto'),
    success: $ => named($, 'success'),
    failure: $ => named($, 'failure'),
    emit: $ => named($, 'emit'),

    parallel: $ => branches($, '//'),
    race: $ => branches($, 'race'),
    choose: $ => branches($, 'choose'),

    set: $ => form($, field('head', 'set'), repeat(choice($._effects, $._word))),
    printf: $ => form($, field('head', 'printf'), repeat($._operand)),

    // Properties.

    property: $ =>
      form($, field('head', 'defproperty'), leading($, ['name'], field('body', $._pattern))),
    _pattern: $ => choice(...PATTERNS.map(name => $[name]), $.list),
    ...Object.fromEntries(PATTERNS.map(name => [name, $ => pattern($, name)])),
    after_field: $ => keyed($, ':after', choice($._proposition_form, $.boolean)),
    before_field: $ => keyed($, ':before', choice($._proposition_form, $.boolean)),
    within_field: $ => keyed($, ':within', $.list),
    for_field: $ => keyed($, ':for', $.list),
    lasting_field: $ => keyed($, ':lasting', $.list),
    fair_field: $ => keyed($, ':fair', $.list),

    _proposition: $ => choice($._loose, $.boolean, $._proposition_form),
    _property_operand: $ => choice($._proposition, $.keyword),
    _proposition_form: $ =>
      choice(
        alias($._property_comparison, $.comparison),
        alias($._property_conjunction, $.conjunction),
        alias($._property_disjunction, $.disjunction),
        alias($._property_negation, $.negation),
        alias($._property_implication, $.implication),
        alias($._property_equivalence, $.equivalence),
        alias($._property_arithmetic, $.arithmetic),
        alias($._property_test, $.test),
        alias($._condition_list, $.list),
        $.running,
        $.called,
        $.ended,
        $.occurs,
        $.at,
        $.value,
        $.globally,
        $.finally,
        $.next,
        $.until,
        $.weak_until,
        $.release,
        $.strong_release,
      ),
    ...connectives('_property_', '_property_operand'),
    _property_test: propertyTest,
    running: $ => observation($, 'running', 'skill'),
    called: $ => observation($, 'called', 'skill'),
    ended: $ => observation($, 'ended', 'skill', 'status'),
    occurs: $ => observation($, 'occurs', 'event'),
    at: $ => observation($, 'at', 'label'),
    value: $ => observation($, 'value', 'variable', 'value'),
    globally: $ => temporal($, 'globally', '[]'),
    finally: $ => temporal($, 'finally', '<>'),
    next: $ => temporal($, 'next', '()'),
    until: $ => temporal($, 'until', 'until'),
    weak_until: $ => temporal($, 'weak_until'),
    release: $ => temporal($, 'release'),
    strong_release: $ => temporal($, 'strong_release'),
  },
});
