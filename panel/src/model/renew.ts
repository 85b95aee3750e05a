import type { Step, Trace } from '../api.ts';

/** Where to go on in a trace that takes the place of another one. */
export interface Continuation {
  index: number;
  /** The step does what the former one did; else it is the nearest by its number. */
  same: boolean;
}

const deed = (step: Step): string => JSON.stringify([step.actor, step.description, step.changes]);

/** The step of `fresh` that does what the step of `former` does, as often as it was done before; else the nearest. */
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

/** Whether two traces tell the same story, wherever their places have moved to. */
export function tellsTheSame(left: Trace, right: Trace): boolean {
  const story = ({ description, verdict, initial, steps, loop }: Trace): string =>
    JSON.stringify([description, verdict, initial, loop ?? null, steps.map((step) => [deed(step), step.earliest, step.latest])]);
  return story(left) === story(right);
}
