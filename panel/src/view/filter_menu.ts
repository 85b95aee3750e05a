import type { Trace } from '../api.ts';
import { actorsOf } from '../model/actors.ts';
import type { Section } from './menu.ts';

export interface Filter {
  actors: Set<string>;
  variables: Set<string>;
  changing: boolean;
  relevant: boolean;
}
export const noFilter = (): Filter => ({ actors: new Set(), variables: new Set(), changing: false, relevant: false });

/** What steps may be filtered by. `refresh`: the filter has changed. */
export function filterSections(trace: Trace, filter: Filter, colours: ReadonlyMap<string, number>, refresh: () => void, showAll: () => void): Section[] {
  const flip = (set: Set<string>, name: string) => (): void => {
    if (!set.delete(name)) set.add(name);
    refresh();
  };
  const changed = [...new Set(trace.steps.flatMap((step) => step.changes.map((change) => change.variable)))];
  return [
    { title: '', items: [
      { label: 'Only steps that change something', checked: filter.changing, choose: () => { filter.changing = !filter.changing; refresh(); } },
      { label: 'All steps', choose: showAll }] },
    { title: 'Only steps by', items: actorsOf(trace).map((actor) => ({
      label: actor.name, hint: actor.kind, mark: `hue-${colours.get(actor.name)}`, checked: filter.actors.has(actor.name), choose: flip(filter.actors, actor.name) })) },
    { title: 'Only steps that change', items: changed.map((name) => ({ label: name, checked: filter.variables.has(name), choose: flip(filter.variables, name) })) },
  ];
}
