import type { Step, Trace } from '../api.ts';

/** Two lists side by side, such as the steps of traces: an element of one, of the other, or of both. */
export interface Pair {
  left: number | null;
  right: number | null;
}

const key = (step: Step): string => `${step.actor}\u0000${step.description}`;

/** Beyond this many differences, the rest counts as different: nobody would read it. */
const mostDifferences = 2000;

/** Aligns the steps of two traces. Steps are equal if their actors and descriptions are. */
export const compare = (left: Trace, right: Trace): Pair[] => align(left.steps.map(key), right.steps.map(key));

/** Where the lines of an older text are in a newer one; those that are missing were removed or changed. */
export const movedLines = (older: string, newer: string): Map<number, number> =>
  new Map(align(older.split('\n'), newer.split('\n')).flatMap(({ left, right }) => (left === null || right === null ? [] : [[left, right]])));

/** Aligns two lists with as few differences as possible (Myers, "An O(ND) difference algorithm and its variations", 1986). */
function align(a: string[], b: string[]): Pair[] {
  let begin = 0;
  while (begin < a.length && begin < b.length && a[begin] === b[begin]) ++begin;
  let tail = 0;
  while (tail < a.length - begin && tail < b.length - begin && a[a.length - 1 - tail] === b[b.length - 1 - tail]) ++tail;
  const out: Pair[] = [];
  for (let i = 0; i < begin; ++i) out.push({ left: i, right: i });
  out.push(...middle(a, b, begin, a.length - tail, b.length - tail));
  for (let i = tail; i > 0; --i) out.push({ left: a.length - i, right: b.length - i });
  return out;
}

function middle(a: string[], b: string[], begin: number, endA: number, endB: number): Pair[] {
  const n = endA - begin;
  const m = endB - begin;
  const most = Math.min(n + m, mostDifferences);
  const reached = new Int32Array(2 * most + 2).fill(-1);
  const at = (k: number): number => k + most;
  const history: Int32Array[] = [];
  reached[at(1)] = 0;
  for (let d = 0; d <= most; ++d) {
    for (let k = -d; k <= d; k += 2) {
      const down = k === -d || (k !== d && reached[at(k - 1)]! < reached[at(k + 1)]!);
      let x = down ? reached[at(k + 1)]! : reached[at(k - 1)]! + 1;
      while (x < n && x - k < m && a[begin + x] === b[begin + x - k]) ++x;
      reached[at(k)] = x;
      if (x >= n && x - k >= m) return walkBack(history, d, n, m, begin);
    }
    history.push(reached.slice(at(-d), at(d) + 1));
  }
  const rest: Pair[] = [];
  for (let i = 0; i < n; ++i) rest.push({ left: begin + i, right: null });
  for (let i = 0; i < m; ++i) rest.push({ left: null, right: begin + i });
  return rest;
}

/** `history[d]`: how far each diagonal reaches with d differences. */
function walkBack(history: Int32Array[], differences: number, n: number, m: number, begin: number): Pair[] {
  const out: Pair[] = [];
  let x = n;
  let y = m;
  const both = (): void => void out.push({ left: begin + --x, right: begin + --y });
  for (let d = differences; d > 0; --d) {
    const former = history[d - 1]!;
    const of = (k: number): number => former[k + d - 1] ?? -1;
    const k = x - y;
    const down = k === -d || (k !== d && of(k - 1) < of(k + 1));
    const toX = down ? of(k + 1) : of(k - 1);
    const toY = toX - (down ? k + 1 : k - 1);
    while (x > toX && y > toY) both();
    if (down) out.push({ left: null, right: begin + --y });
    else out.push({ left: begin + --x, right: null });
  }
  while (x > 0 && y > 0) both();
  return out.reverse();
}

export const isDifferent = (pair: Pair): boolean => pair.left === null || pair.right === null;
