import type { Actor, ActorKind, Trace } from '../api.ts';

const branch = /^(.*) branch [\d.]+$/;
const watchdog = /^watchdog of (.*)$/;

/** Where the trace does not say what its actors are, their names and what has a value do. */
function infer(name: string, words: Set<string>, initial: Trace['initial']): Actor {
  const of = (kind: ActorKind, skill: string | null): Actor => ({ name, kind, skill });
  const parent = branch.exec(name)?.[1];
  if (parent) return of('branch', parent);
  const watched = watchdog.exec(name)?.[1];
  if (watched) return of('watchdog', watched);
  if (name === 'environment') return of('environment', null);
  if (`${name}.status` in initial || words.has('starts')) return of('skill', name);
  return name in initial ? of('variable', null) : of('event', null);
}

/** The actors of a trace, in the order in which they first act. */
export function actorsOf(trace: Trace): Actor[] {
  const words = new Map<string, Set<string>>();
  for (const step of trace.steps) {
    const known = words.get(step.actor);
    if (known) known.add(step.words);
    else words.set(step.actor, new Set([step.words]));
  }
  const given = new Map(trace.actors?.map((actor) => [actor.name, actor]));
  return [...words].map(([name, said]) => {
    const inferred = infer(name, said, trace.initial);
    return inferred.kind === 'watchdog' || inferred.kind === 'variable' ? inferred : (given.get(name) ?? inferred);
  });
}

/** A number from 0 to `count` - 1 that stays the same for a name, for its colour. */
export function hue(name: string, count: number): number {
  let hash = 2166136261;
  for (let i = 0; i < name.length; ++i) hash = Math.imul(hash ^ name.charCodeAt(i), 16777619);
  return (hash >>> 0) % count;
}
