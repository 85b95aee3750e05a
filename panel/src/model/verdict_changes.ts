import type { Verdict } from '../api.ts';

/** The verdicts after a change of some; the same array if nothing has changed, so that users can compare references. */
export function withChanges(known: Verdict[], changed: readonly Verdict[]): Verdict[] {
  if (!changed.length) return known;
  const news = new Map(changed.map((verdict) => [verdict.name, verdict]));
  return known.map((verdict) => news.get(verdict.name) ?? verdict);
}

/** The verdicts that differ from known ones, by reference; null if they are of other properties, or in another order. */
export function changesSince(known: readonly Verdict[] | undefined, now: readonly Verdict[]): Verdict[] | null {
  if (known?.length !== now.length || now.some(({ name }, at) => name !== known[at]!.name)) return null;
  return now.filter((verdict, at) => verdict !== known[at]);
}
