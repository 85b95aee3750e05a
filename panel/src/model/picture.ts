import type { Location, Picture, Position } from '../api.ts';
import type { Active } from './active.ts';

/** A node, edge or cluster of a picture. */
export interface Part {
  id: string;
  type: 'node' | 'edge' | 'cluster';
  label: string;
  role: string;
  location: Location | null;
}

export function partsOf(picture: Picture): Map<string, Part> {
  const out = new Map<string, Part>();
  for (const it of picture.clusters) out.set(it.id, { id: it.id, type: 'cluster', label: it.label, role: 'group', location: it.location });
  for (const it of picture.edges) out.set(it.id, { id: it.id, type: 'edge', label: it.label, role: it.role, location: it.location });
  for (const it of picture.nodes)
    out.set(it.id, { id: it.id, type: 'node', label: [it.label, ...it.details].filter(Boolean).join(', '), role: it.role, location: it.location });
  return out;
}

/** The skill whose colour a node has: one that is called, and at its start the one that the picture shows. Watchdogs start in clusters. */
export function skillAt({ kind, name }: Picture, { role, label, cluster }: Picture['nodes'][number]): string | null {
  if (kind === 'calls' || role === 'call') return label;
  return role === 'start' && cluster === null ? name : null;
}

const before = (a: Position, b: Position): boolean => a.line < b.line || (a.line === b.line && a.character < b.character);

const holds = (outer: Location, inner: Location): boolean =>
  outer.uri === inner.uri && !before(inner.range.start, outer.range.start) && !before(outer.range.end, inner.range.end);

const rank = { node: 0, edge: 1, cluster: 2 };

/**
 * The innermost part at a place: among nodes, then edges, then clusters. Otherwise the largest node within the place, or the nearest one that begins
 * on its line, as for a caret on the `if` of a test.
 */
export function partAt(picture: Picture, place: Location): Part | null {
  let best: Part | null = null;
  for (const part of partsOf(picture).values()) {
    if (!part.location || !holds(part.location, place)) continue;
    const inner = best?.location && holds(best.location, part.location);
    const equal = inner && holds(part.location, best!.location!);
    if (!best || (inner && !equal) || (!!equal && rank[part.type] < rank[best.type])) best = part;
  }
  if (best) return best;
  for (const part of partsOf(picture).values())
    if (part.type === 'node' && part.location && holds(place, part.location) && (!best || holds(part.location, best.location!))) best = part;
  return best ?? onLine(picture, place);
}

function onLine(picture: Picture, place: Location): Part | null {
  const { line, character } = place.range.start;
  let best: Part | null = null;
  const away = (part: Part): number => Math.abs(part.location!.range.start.character - character);
  for (const part of partsOf(picture).values()) {
    if (part.type !== 'node' || part.location?.uri !== place.uri || part.location.range.start.line !== line) continue;
    if (!best || away(part) < away(best)) best = part;
  }
  return best;
}

/** The nodes that show the current states of a run: statements of a body, the action of a skill, the value of a state variable. */
export function activeParts(picture: Picture, places: readonly Active[], values: { [variable: string]: string }): Set<string> {
  const { kind, name, nodes } = picture;
  const ids = (some: (node: Picture['nodes'][number]) => boolean): string[] => nodes.filter(some).map(({ id }) => id);
  switch (kind) {
    case 'sv': return new Set(ids(({ role, label }) => role === 'state' && label === values[name]));
    case 'calls': return new Set(ids(({ label }) => places.some(({ actor }) => skillOf(actor) === label)));
    case 'skill': return new Set(places.some((it) => it.performs && it.actor === name) ? ids(({ role }) => role === 'action') : []);
    case 'body': {
      const mine = places.filter((it) => !it.performs && skillOf(it.actor) === name);
      return new Set(mine.flatMap(({ location }) => { const part = partAt(picture, location); return part?.type === 'node' ? [part.id] : []; }));
    }
  }
}

/** A branch is part of its skill's body. */
export const skillOf = (actor: string): string => actor.replace(/ branch [\d.]+$/, '').replace(/^watchdog of /, '');

/** The ids of nodes and clusters whose text matches the search. */
export function find(picture: Picture, needle: string): string[] {
  const words = needle.trim().toLowerCase();
  if (words === '') return [];
  return [...partsOf(picture).values()].filter((part) => part.type !== 'edge' && part.label.toLowerCase().includes(words)).map((part) => part.id);
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The nearest box in a direction, for the arrow keys; prefers what is straight ahead. */
export function neighbour(boxes: ReadonlyMap<string, Box>, from: string, key: 'ArrowUp' | 'ArrowDown' | 'ArrowLeft' | 'ArrowRight'): string | null {
  const here = boxes.get(from);
  if (!here) return null;
  const middle = (box: Box): [number, number] => [box.x + box.width / 2, box.y + box.height / 2];
  const [x, y] = middle(here);
  let best: [string, number] | null = null;
  for (const [id, box] of boxes) {
    if (id === from) continue;
    const [dx, dy] = [middle(box)[0] - x, middle(box)[1] - y];
    const vertical = key === 'ArrowUp' || key === 'ArrowDown';
    const ahead = (vertical ? dy : dx) * (key === 'ArrowDown' || key === 'ArrowRight' ? 1 : -1);
    const aside = Math.abs(vertical ? dx : dy);
    if (ahead < 2 || aside > ahead * 3 + 40) continue;
    const cost = ahead + aside * 2;
    if (!best || cost < best[1]) best = [id, cost];
  }
  return best?.[0] ?? null;
}
