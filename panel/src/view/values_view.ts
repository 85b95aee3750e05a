import type { Trace } from '../api.ts';
import { difference } from '../model/diff.ts';
import type { Values } from '../model/values.ts';
import { h } from './dom.ts';
import { button, icon, toggle } from './icons.ts';
import { parts } from './step_list.ts';

export interface ValuesEvents {
  pinned(names: string[]): void;
  /** only steps that change it, or no longer */
  filter(name: string): void;
}

/** What every variable is after the current step; the pinned ones first. */
export class ValuesView {
  readonly element: HTMLElement;
  private readonly body = h('tbody');
  private readonly note = h('p', { class: 'faint note' });
  private readonly title = h('h3', {}, 'Values');
  private hideUnchanged = true;
  private pins = new Set<string>();
  private moving = new Set<string>();
  private state: { trace: Trace; values: Values; index: number; filtered: ReadonlySet<string> } | null = null;

  constructor(private readonly events: ValuesEvents) {
    const hide = toggle({
      icon: 'changes', title: 'Hide variables that never change in this trace', on: true,
      changed: (on) => { this.hideUnchanged = on; this.draw(); },
    });
    this.element = h('section', { class: 'values', 'aria-label': 'Values after the step' },
      h('header', { class: 'bar' }, this.title, h('span', { class: 'push' }), hide.element),
      h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Table of values' },
        h('table', {}, this.body), this.note));
  }

  pin(names: readonly string[]): void {
    this.pins = new Set(names);
  }

  show(trace: Trace, values: Values, index: number, filtered: ReadonlySet<string>): void {
    if (trace !== this.state?.trace)
      this.moving = new Set(trace.steps.flatMap((step) => step.changes.map((change) => change.variable)));
    this.state = { trace, values, index, filtered };
    this.draw();
  }

  private draw(): void {
    if (!this.state) return;
    const { trace, values, index, filtered } = this.state;
    const now = values.at(index);
    const before = values.at(index - 1);
    const shown = values.names.filter((name) => this.pins.has(name) || !this.hideUnchanged || this.moving.has(name));
    const rows = [...shown.filter((name) => this.pins.has(name)), ...shown.filter((name) => !this.pins.has(name))];
    this.title.textContent = index < 0 ? 'Values at the start' : `Values after step ${index + 1}`;
    this.body.replaceChildren(...rows.map((name) => this.row(name, before.get(name) ?? '', now.get(name) ?? '', index >= 0, filtered)));
    const hidden = values.names.length - rows.length;
    this.note.textContent = hidden > 0 ? `${hidden} that never change in this trace are hidden` : '';
    this.element.dataset['of'] = trace.name;
  }

  private row(name: string, before: string, now: string, isStep: boolean, filtered: ReadonlySet<string>): HTMLElement {
    const changed = isStep && before !== now;
    const pinned = this.pins.has(name);
    const found = difference(before, now);
    return h('tr', { class: `${changed ? 'changed' : ''}${pinned ? ' pinned' : ''}` },
      h('th', { scope: 'row' }, h('button', {
        type: 'button', class: `name${filtered.has(name) ? ' on' : ''}`, title: `Only steps that change ${name}, or all again`,
        onclick: () => this.events.filter(name),
      }, name, filtered.has(name) && icon('filter'))),
      h('td', {}, changed && parts('before', found.before), changed && h('span', { class: 'arrow' }, '→'),
        changed ? parts('after', found.after) : h('span', { class: 'after' }, now)),
      h('td', { class: 'pin-cell' }, button({
        icon: 'pin', title: pinned ? `Unpin ${name}` : `Pin ${name} to the top`, pressed: pinned, onclick: () => this.togglePin(name),
      })));
  }

  private togglePin(name: string): void {
    if (!this.pins.delete(name)) this.pins.add(name);
    this.events.pinned([...this.pins]);
    this.draw();
  }
}
