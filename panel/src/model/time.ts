import type { Moment, Seconds, Step } from '../api.ts';

/** For reading: a decimal number, to the millisecond; a time below half of one keeps a digit. */
export function decimal({ exact, seconds }: Seconds): string {
  if (/^-?\d+(\.\d{1,3})?$/.test(exact)) return exact;
  const rounded = Number(seconds.toFixed(3));
  return String(rounded || Number(seconds.toPrecision(1)));
}

/** `1`, `[1, 2]`, `]1, 2[`, `[1, …[`: the dates at which a step can happen, over all runs with the same steps. */
export function windowOf(step: Step): string {
  const { earliest, latest } = step;
  if (latest && !earliest.strict && !latest.strict && earliest.exact === latest.exact) return decimal(earliest);
  const left = earliest.strict ? ']' : '[';
  return latest
    ? `${left}${decimal(earliest)}, ${decimal(latest)}${latest.strict ? '[' : ']'}`
    : `${left}${decimal(earliest)}, …[`;
}

/** Exact dates as text, for tooltips and screen readers. */
export function windowWords(step: Step): string {
  const { earliest, latest } = step;
  const at = `at ${step.date.exact} s in this run`;
  if (latest && earliest.exact === latest.exact && !earliest.strict && !latest.strict) return `at ${earliest.exact} s`;
  const from = `${earliest.strict ? 'after' : 'from'} ${earliest.exact} s`;
  const to = latest ? `${latest.strict ? 'before' : 'to'} ${latest.exact} s` : 'as late as one likes';
  return `${at}; possible ${from}, ${to}`;
}

export const sameMoment = (a: Moment | null, b: Moment | null): boolean =>
  a === b || (a !== null && b !== null && a.exact === b.exact && a.strict === b.strict);

/** Round distances between marks on an axis of this length. */
export function ticks(from: number, to: number, most: number): number[] {
  const span = to - from;
  if (!(span > 0) || most < 1) return [];
  const raw = span / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((it) => it >= raw) ?? 10 * power;
  const out: number[] = [];
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + step * 1e-9; ++i)
    out.push(Number((i * step).toPrecision(12)));
  return out;
}
