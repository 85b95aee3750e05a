import type { Trace } from '../api.ts';

/** A recorded run shows what should not have happened by these remarks. */
const kBad = new Set(['undershoot', 'overshoot', 'alarm', 'fault', 'violated']);

/** A section of the time of a run, in seconds. */
export interface Section {
  from: number;
  to: number;
}

/** The times at which something went wrong, in order. */
export function badTimes(trace: Trace): number[] {
  return trace.steps.filter(({ remark }) => remark !== undefined && kBad.has(remark)).map(({ date }) => date.seconds);
}

/** Fractions of a section, at most `most` of them, for marks on a bar. */
export function fractions(times: readonly number[], { from, to }: Section, most: number): number[] {
  const parts = times.map((time) => Math.round(((time - from) / (to - from || 1)) * most));
  return [...new Set(parts)].map((part) => part / most);
}

/**
 * The position in `steps`, which are ordered by date, of the last step that has happened at a time; before all of them, of the first. -1: there is none.
 */
export function positionAt(trace: Trace, steps: readonly number[], time: number): number {
  let [low, high] = [0, steps.length]; // all before `low` have happened, none from `high` on has
  while (low < high) {
    const middle = (low + high) >> 1;
    if (trace.steps[steps[middle]!]!.date.seconds <= time) low = middle + 1;
    else high = middle;
  }
  return steps.length === 0 ? -1 : Math.max(low - 1, 0);
}

/** A time of a run to read: `12.345 s`, `12:34.5`, `1:02:03`. */
export function clockTime(seconds: number): string {
  if (seconds < 100) return `${Number(seconds.toFixed(3))} s`;
  const two = (value: number, digits = 0): string => value.toFixed(digits).padStart(digits ? 3 + digits : 2, '0');
  const tenths = Math.floor(seconds * 10) / 10;
  if (seconds < 3600) return `${Math.floor(tenths / 60)}:${two(tenths % 60, 1)}`;
  const whole = Math.floor(seconds);
  return `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
}
