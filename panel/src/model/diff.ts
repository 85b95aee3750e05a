/** The difference between two values, to show exactly what is new. */
export interface Difference {
  kind: 'same' | 'added' | 'removed' | 'number' | 'replaced' | 'within';
  /** `number`: the difference with its sign, as `+1` */
  delta?: string;
  before: Part[];
  after: Part[];
}
export interface Part {
  text: string;
  changed: boolean;
}

const tokens = (value: string): string[] => value.match(/[A-Za-z0-9_.]+|\s+|[^A-Za-z0-9_.\s]/g) ?? [];
const isNumber = (value: string): boolean => /^-?\d+(\.\d+)?$/.test(value);
const whole = (text: string, changed: boolean): Part[] => (text === '' ? [] : [{ text, changed }]);

/** Joins equal neighbours. */
function join(list: Part[]): Part[] {
  const out: Part[] = [];
  for (const part of list) {
    const last = out.at(-1);
    if (last && last.changed === part.changed) last.text += part.text;
    else out.push({ ...part });
  }
  return out;
}

/** For each of two lists, which of its tokens are in a longest common subsequence. */
function common(a: string[], b: string[]): [boolean[], boolean[]] {
  const width = b.length + 1;
  const length = new Uint16Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; --i)
    for (let j = b.length - 1; j >= 0; --j)
      length[i * width + j] =
        a[i] === b[j]
          ? length[(i + 1) * width + j + 1]! + 1
          : Math.max(length[(i + 1) * width + j]!, length[i * width + j + 1]!);
  const inA = a.map(() => false);
  const inB = b.map(() => false);
  for (let i = 0, j = 0; i < a.length && j < b.length; ) {
    if (a[i] === b[j]) (inA[i++] = true), (inB[j++] = true);
    else if (length[(i + 1) * width + j]! >= length[i * width + j + 1]!) ++i;
    else ++j;
  }
  return [inA, inB];
}

/** With more tokens, a value is shown as replaced: nobody would read its differences. */
const longest = 400;

export function difference(before: string, after: string): Difference {
  if (before === after) return { kind: 'same', before: whole(before, false), after: whole(after, false) };
  if (before === '') return { kind: 'added', before: [], after: whole(after, true) };
  if (after === '') return { kind: 'removed', before: whole(before, true), after: [] };
  const replaced = { before: whole(before, true), after: whole(after, true) };
  if (isNumber(before) && isNumber(after)) {
    const delta = Number((Number(after) - Number(before)).toPrecision(12));
    return { kind: 'number', delta: (delta > 0 ? '+' : '') + String(delta).replace('-', '−'), ...replaced };
  }
  const a = tokens(before);
  const b = tokens(after);
  if (a.length < 3 || b.length < 3 || a.length > longest || b.length > longest)
    return { kind: 'replaced', ...replaced };
  const [inA, inB] = common(a, b);
  if (!inA.some(Boolean)) return { kind: 'replaced', ...replaced };
  return {
    kind: 'within',
    before: join(a.map((text, i) => ({ text, changed: !inA[i] }))),
    after: join(b.map((text, i) => ({ text, changed: !inB[i] }))),
  };
}
