import type { Step, Trace } from '../api.ts';

/** Where to continue in a trace that replaces another one. */
export interface Continuation {
  index: number;
  /** The step equals the former one; otherwise it is the nearest by number. */
  same: boolean;
}

const deed = (step: Step): string => JSON.stringify([step.actor, step.description, step.changes]);

/** The step of `fresh` that equals that of `former`, with the same count among equal steps; otherwise the nearest. */
export function continuation(former: Trace, index: number, fresh: Trace): Continuation {
  const step = former.steps[index];
  const nearest = { index: Math.min(Math.max(index, 0), fresh.steps.length - 1), same: false };
  if (!step) return nearest;
  const wanted = deed(step);
  const times = former.steps.slice(0, index).filter((it) => deed(it) === wanted).length;
  const alike = fresh.steps.flatMap((it, at) => (deed(it) === wanted ? [at] : []));
  const found = alike[times] ?? alike.at(-1);
  return found === undefined ? nearest : { index: found, same: true };
}

/** The message about it. `former`: the index of the former step. */
export function notice({ index, same }: Continuation, former: number, fresh: Trace): string {
  if (same) return `verified again: the same step, ${index + 1} now`;
  return `verified again: step ${former + 1} is gone, ${fresh.steps.length > 0 ? 'this is the nearest' : 'there are no steps'}`;
}

/** Whether two traces have the same steps, apart from their places. */
export function tellsTheSame(left: Trace, right: Trace): boolean {
  const story = ({ description, verdict, initial, steps, loop }: Trace): string =>
    JSON.stringify([description, verdict, initial, loop ?? null, steps.map((step) => [deed(step), step.earliest, step.latest])]);
  return story(left) === story(right);
}
