import type { Actor, ActorKind, Trace } from '../api.ts';

const branch = /^(.*) branch [\d.]+$/;
const watchdog = /^watchdog of (.*)$/;

/**
 * Actors of a trace that does not name them: derived from steps and variables. In a Fiacre model an instance of a process is both: it acts, and its
 * value is its state.
 */
function infer(name: string, words: Set<string>, ofProcess: boolean, initial: Trace['initial']): Actor {
  const of = (kind: ActorKind, skill: string | null): Actor => ({ name, kind, skill });
  const parent = branch.exec(name)?.[1];
  if (parent) return of('branch', parent);
  const watched = watchdog.exec(name)?.[1];
  if (watched) return of('watchdog', watched);
  if (name === 'environment') return of('environment', null);
  if ([...words].every((each) => /^(holds|violated): /.test(each))) return of('property', null);
  if (`${name}.status` in initial || words.has('starts')) return of('skill', name);
  if (name in initial) return of(ofProcess ? 'process' : 'variable', null);
  return of(name.split(', ').every((each) => each in initial) ? 'process' : 'event', null);
}

/** The actors of a trace, in the order of their first steps. */
export function actorsOf(trace: Trace): Actor[] {
  const words = new Map<string, Set<string>>();
  for (const step of trace.steps) {
    const known = words.get(step.actor);
    if (known) known.add(step.description);
    else words.set(step.actor, new Set([step.description]));
  }
  const processes = new Set(trace.steps.filter((step) => step.transitions.some((each) => each.startsWith(`${step.actor}_t`)))
    .map((step) => step.actor));
  const given = new Map(trace.actors?.map((actor) => [actor.name, actor]));
  return [...words].map(([name, said]) => {
    const inferred = infer(name, said, processes.has(name), trace.initial);
    return inferred.kind === 'watchdog' || inferred.kind === 'variable' || inferred.kind === 'process' ? inferred : (given.get(name) ?? inferred);
  });
}
