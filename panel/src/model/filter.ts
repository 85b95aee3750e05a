import type { Step, Trace } from '../api.ts';

/** Filters steps of a trace. Empty sets and texts keep everything. */
export interface Filter {
  actors: ReadonlySet<string>;
  /** Only steps that change one of these variables. */
  variables: ReadonlySet<string>;
  /** Only steps that change a variable. */
  changing: boolean;
  /** Only relevant steps. */
  relevant: boolean;
}
export const everything: Filter = { actors: new Set(), variables: new Set(), changing: false, relevant: false };

export const isFiltering = (filter: Filter): boolean =>
  filter.actors.size > 0 || filter.variables.size > 0 || filter.changing || filter.relevant;

export const isRelevant = (step: Step): boolean => step.relevant !== false;
/** Whether some steps of a trace are relevant and others are not. */
export const marksRelevance = (trace: Trace): boolean => trace.steps.some((step) => !isRelevant(step));

export function passes(step: Step, filter: Filter): boolean {
  if (filter.actors.size > 0 && !filter.actors.has(step.actor)) return false;
  if (filter.relevant && !isRelevant(step)) return false;
  if (filter.changing && step.changes.length === 0) return false;
  return filter.variables.size === 0 || step.changes.some((change) => filter.variables.has(change.variable));
}

/** The indices of the steps that are shown. */
export function select(trace: Trace, filter: Filter): number[] {
  const out: number[] = [];
  trace.steps.forEach((step, index) => passes(step, filter) && out.push(index));
  return out;
}

const plain = (text: string): string => text.replaceAll('`', '').toLowerCase();

/** Whether a step matches the search: its description, its actor, or a value that changes. */
export function matches(step: Step, needle: string): boolean {
  const text = [
    step.actor,
    step.description,
    step.why ?? '',
    ...step.changes.map((change) => `${change.variable} ${change.before} ${change.after}`),
  ].join('\n');
  return plain(text).includes(plain(needle));
}

export function search(trace: Trace, needle: string): number[] {
  if (needle.trim() === '') return [];
  const out: number[] = [];
  trace.steps.forEach((step, index) => matches(step, needle.trim()) && out.push(index));
  return out;
}

/** Consecutive steps of the same actor. */
export interface Group {
  actor: string;
  steps: number[];
}
export function groups(trace: Trace, shown: readonly number[]): Group[] {
  const out: Group[] = [];
  for (const index of shown) {
    const actor = trace.steps[index]!.actor;
    const last = out.at(-1);
    if (last?.actor === actor) last.steps.push(index);
    else out.push({ actor, steps: [index] });
  }
  return out;
}
