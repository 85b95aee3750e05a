import type { Change, Step, Trace } from '../src/api.ts';

const seconds = (value: number) => ({ exact: String(value), seconds: value });

/** `actor: description @date variable=before>after …`, one step per line; its only possible date is the given one. */
export function step(line: string): Step {
  const found = /^(.*?): (.*?) @([\d.]+)(.*)$/.exec(line);
  if (!found) throw new Error(line);
  const [, actor, words, date, rest] = found as unknown as [string, string, string, string, string];
  const changes: Change[] = [...rest.matchAll(/(\S+)=(\S*)>(\S*)/g)].map((it) => ({
    variable: it[1]!, before: it[2]!, after: it[3]!,
  }));
  const at = { ...seconds(Number(date)), strict: false };
  return { actor, description: words, location: null, date: seconds(Number(date)), delay: seconds(0), earliest: at, latest: at, changes, transitions: [] };
}

export function trace(initial: Trace['initial'], lines: string[]): Trace {
  return { name: 'p', description: 'never P', verdict: 'violated', initial, steps: lines.map(step) };
}

/** A mission that takes off while the battery changes. */
export const flight = trace({ battery: 'Good', level: '4', idle: 'x', 'takeoff.status': 'no_status' }, [
  'mission: starts @0',
  'mission: calls `takeoff` @0',
  'takeoff: starts @0 level=4>3',
  'battery_low: occurs @2 battery=Good>Low',
  'takeoff: finds its invariant `power` violated @2',
  'takeoff: fails with `grounded` @2.5 takeoff.status=no_status>failed_inv',
  'mission: continues after `takeoff` @2.5',
  'mission branch 1: starts @2.5',
  'watchdog of mission: starts measuring @2.5',
  'mission branch 1: ends @3',
]);
