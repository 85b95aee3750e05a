import type { Picture } from '../api.ts';
import { locationOf } from '../model/parse.ts';

/** A picture whose places are in the form of docs/verify.schema.json. */
export function pictureOf(picture: Picture): Picture {
  const placed = <T extends { location: unknown }>(list: T[]): T[] =>
    list.map((it) => ({ ...it, location: locationOf(it.location) }));
  return { ...picture, nodes: placed(picture.nodes), edges: placed(picture.edges), clusters: placed(picture.clusters) };
}
