import type { Program, Step, Trace } from '../api.ts';

/** Number of colours in base.css, which colour-blind users can distinguish. */
export const hues = 10;

/**
 * The colours of actors, the same in steps, lanes and automata. The skills of the program get theirs first, so that a skill has the same colour in
 * every trace, and in views that show none.
 */
export class ActorColours {
  private skills = new Map<string, number>();

  setProgram({ pictures }: Pick<Program, 'pictures'>): void {
    if (pictures.length > 0) this.skills = distribute(pictures.flatMap(({ kind, name }) => (kind === 'skill' || kind === 'body' ? [name] : [])));
  }

  /** A colour for each actor of a trace and of possible further steps. Those that are not skills of the program get colours that are not used yet. */
  of(trace: Trace, further: readonly Step[] = []): Map<string, number> {
    const names = new Set([...(trace.actors?.map(({ name }) => name) ?? []), ...trace.steps.map(({ actor }) => actor)]);
    const more = further.map(({ actor }) => actor);
    const skills = [...this.skills].filter(([name]) => names.has(name) || more.includes(name));
    return distribute(more, distribute([...names], new Map(skills)));
  }

  ofSkill(name: string): number | undefined {
    return this.skills.get(name);
  }
}

/** Adds a colour for each name: all are different while there are enough, and mostly the same with other names. */
function distribute(names: readonly string[], given: ReadonlyMap<string, number> = new Map()): Map<string, number> {
  const out = new Map(given);
  const taken = new Set(given.values());
  for (const name of [...new Set(names)].sort()) {
    if (out.has(name)) continue;
    if (taken.size === hues) taken.clear();
    let at = hue(name, hues);
    while (taken.has(at)) at = (at + 1) % hues;
    taken.add(at);
    out.set(name, at);
  }
  return out;
}

/** A number from 0 to `count` - 1 that is constant for a name. */
export function hue(name: string, count: number): number {
  let hash = 2166136261;
  for (let i = 0; i < name.length; ++i) hash = Math.imul(hash ^ name.charCodeAt(i), 16777619);
  return (hash >>> 0) % count;
}
