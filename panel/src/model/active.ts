import type { Location, Run, Trace } from '../api.ts';

/** An actor that runs, and where it is. */
export interface Active {
  actor: string;
  /** the action of a basic skill */
  performs: boolean;
  location: Location;
}

/** Where all actors of a watched run are after a step; -1: at the start. */
export function activeAt({ processes }: Run, trace: Trace, index: number): Active[] {
  const at = new Map(processes.map(({ start }, process) => [process, start]));
  for (let i = 0; i <= index; ++i) for (const [process, place] of trace.steps[i]?.moves ?? []) at.set(process, place);
  return processes.flatMap(({ actor, performs, places }, process) => {
    const location = places[at.get(process)!];
    return location ? [{ actor, performs, location }] : [];
  });
}

/** The last message of each `printf` up to a step. */
export function messagesAt(trace: Trace, index: number): { location: Location; text: string; count: number }[] {
  const found = new Map<string, { location: Location; text: string; count: number }>();
  for (const { description, message, location } of trace.steps.slice(0, index + 1)) {
    const text = message ?? /^prints "(.*)"$/s.exec(description)?.[1];
    if (text === undefined || !location) continue;
    const key = `${location.uri} ${location.range.start.line}`;
    found.set(key, { location, text, count: (found.get(key)?.count ?? 0) + 1 });
  }
  return [...found.values()];
}
