import type { Change, Trace } from '../api.ts';

type Tree = string | Tree[];
type ValuesNow = ReadonlyMap<string, string>;

/** A condition or expression of ProSkill (docs/language.md), evaluated after each step. */
export interface Watch {
  text: string;
  /** its value for these variables: `true`, `false`, or a value */
  at(values: ValuesNow): string;
}

/** An error in a watch, as a message for users. */
export class WatchError extends Error {}

function read(text: string): Tree {
  const open: Tree[][] = [[]];
  for (const token of text.match(/[()]|[^\s()]+/g) ?? []) {
    if (token === '(') open.push([]);
    else if (token !== ')') open.at(-1)!.push(token);
    else if (open.length === 1) throw new WatchError('a `(` is missing');
    else {
      const list = open.pop()!;
      open.at(-1)!.push(list);
    }
  }
  if (open.length > 1) throw new WatchError('a `)` is missing');
  const [tree, ...more] = open[0]!;
  if (tree === undefined || more.length > 0) throw new WatchError('one condition is expected, as `(door Open)`');
  return tree;
}

const written = (tree: Tree): string => (typeof tree === 'string' ? tree : `(${tree.map(written).join(' ')})`);

function numberOf(tree: Tree, values: ValuesNow): number {
  const value = operand(tree, values);
  if (!/^-?\d+(\.\d+)?$/.test(value)) throw new WatchError(`\`${written(tree)}\` is not a number`);
  return Number(value);
}

/** The value of a variable, a sum or a difference; any other word is a constant. */
function operand(tree: Tree, values: ValuesNow): string {
  if (typeof tree === 'string') return values.get(tree) ?? tree;
  const [operator, ...operands] = tree;
  if ((operator !== '+' && operator !== '-') || operands.length === 0) return String(condition(tree, values));
  const [first, ...rest] = operands.map((it) => numberOf(it, values)) as [number, ...number[]];
  if (rest.length === 0) return String(operator === '-' ? -first : first);
  return String(rest.reduce((sum, it) => (operator === '+' ? sum + it : sum - it), first));
}

const all = (operands: boolean[]): boolean => operands.every(Boolean);
const any = (operands: boolean[]): boolean => operands.some(Boolean);
const none = (operands: boolean[]): boolean => !any(operands);
const logic = new Map([['and', all], ['&', all], ['or', any], ['|', any], ['not', none], ['~', none]]);
const order = new Map<string, (a: number, b: number) => boolean>([
  ['<', (a, b) => a < b], ['<=', (a, b) => a <= b], ['>', (a, b) => a > b], ['>=', (a, b) => a >= b],
]);

/** Checks all parts, even if one decides the result, so that misspelt names are always reported. */
function condition(tree: Tree, values: ValuesNow): boolean {
  if (typeof tree === 'string') {
    if (tree !== 'true' && tree !== 'false') throw new WatchError(`\`${tree}\` is not a condition`);
    return tree === 'true';
  }
  const [operator, ...operands] = tree;
  if (typeof operator !== 'string') throw new WatchError(`\`${written(tree)}\` is not a condition`);
  const connect = logic.get(operator);
  const less = order.get(operator);
  if (!connect && !less && operator !== '=' && operator !== '/=') throw new WatchError(`there is no variable \`${operator}\` in this trace`);
  const expected = connect === none ? 1 : 2;
  if (operands.length < expected || (operands.length > expected && (!connect || connect === none)))
    throw new WatchError(`\`${operator}\` takes ${expected === 1 ? 'one operand' : 'two operands'}`);
  if (connect) return connect(operands.map((it) => condition(it, values)));
  const [left, right] = operands as [Tree, Tree];
  if (less) return less(numberOf(left, values), numberOf(right, values));
  if (typeof left === 'string' && typeof right === 'string' && !values.has(left) && !values.has(right))
    throw new WatchError(`there is no variable \`${left}\` in this trace`);
  return (operand(left, values) === operand(right, values)) === (operator === '=');
}

/** `(door Open)` is `(= door Open)`, at any depth. */
function spelledOut(tree: Tree, values: ValuesNow): Tree {
  if (typeof tree === 'string') return tree;
  const [head, ...rest] = tree;
  if (typeof head === 'string' && values.has(head) && rest.length === 1) return ['=', ...tree];
  return tree.map((it) => spelledOut(it, values));
}

/** \throws WatchError if the trace lacks a variable */
export function watchOf(text: string, trace: Trace): Watch {
  const initial = new Map(Object.entries(trace.initial));
  const tree = spelledOut(read(text), initial);
  if (typeof tree === 'string' && !initial.has(tree)) throw new WatchError(`there is no variable \`${tree}\` in this trace`);
  operand(tree, initial); // throws the error
  const at = (values: ValuesNow): string => {
    try {
      return operand(tree, values);
    } catch {
      return '?'; // the value was a number at first and no longer is
    }
  };
  return { text: text.trim(), at };
}

/** The trace with watches as additional variables: they have a lane, and can be filtered and searched. */
export function watched(trace: Trace, watches: readonly Watch[]): Trace {
  if (watches.length === 0) return trace;
  const now = new Map(Object.entries(trace.initial));
  const values = watches.map((watch) => watch.at(now));
  const initial = { ...trace.initial };
  watches.forEach((watch, i) => { initial[watch.text] = values[i]!; });
  const steps = trace.steps.map((step) => {
    for (const change of step.changes) now.set(change.variable, change.after);
    const changes: Change[] = [];
    watches.forEach((watch, i) => {
      const before = values[i]!;
      const after = (values[i] = watch.at(now));
      if (before !== after) changes.push({ variable: watch.text, before, after });
    });
    return changes.length > 0 ? { ...step, changes: [...step.changes, ...changes] } : step;
  });
  return { ...trace, initial, steps };
}
