import type { Trace } from '../api.ts';
import { difference } from '../model/diff.ts';
import type { Values } from '../model/values.ts';
import { h, prose } from './dom.ts';
import { button, icon, toggle } from './icons.ts';
import { parts } from './step_list.ts';

export interface ValuesEvents {
  pinned(names: string[]): void;
  /** toggle: only steps that change it */
  filter(name: string): void;
  /** add or remove a watch; returns its error */
  watch(text: string): string | null;
  unwatch(text: string): void;
}
export interface ValuesShown {
  trace: Trace;
  values: Values;
  index: number;
  filtered: ReadonlySet<string>;
  /** those of the variables that are watches */
  watches: ReadonlySet<string>;
}

/** The values of all variables and watches after the current step; watches and pinned variables come first. */
export class ValuesView {
  readonly element: HTMLElement;
  private readonly body = h('tbody');
  private readonly note = h('p', { class: 'faint note' });
  private readonly title = h('h3', {}, 'Values');
  private hideUnchanged = true;
  private pins = new Set<string>();
  private moving = new Set<string>();
  private state: ValuesShown | null = null;
  private readonly wrong = h('p', { class: 'wrong note', role: 'alert' });
  private readonly field: HTMLInputElement;

  constructor(private readonly events: ValuesEvents) {
    const hide = toggle({
      icon: 'changes', title: 'Hide variables that never change in this trace', on: true,
      changed: (on) => { this.hideUnchanged = on; this.draw(); },
    });
    this.field = h('input', {
      class: 'watch', placeholder: 'Watch, as (door Open)', spellcheck: 'false', autocomplete: 'off',
      'aria-label': 'Watch: a condition whose value is shown at each step',
      oninput: () => this.complain(null), onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    this.element = h('section', { class: 'values', 'aria-label': 'Values after the step' },
      h('header', { class: 'bar' }, this.title, h('span', { class: 'push' }), hide.element),
      h('div', { class: 'watch-frame' }, this.field, this.wrong),
      h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Table of values' },
        h('table', {}, this.body), this.note));
  }

  pin(names: readonly string[]): void {
    this.pins = new Set(names);
  }

  show(shown: ValuesShown): void {
    if (shown.trace !== this.state?.trace)
      this.moving = new Set(shown.trace.steps.flatMap((step) => step.changes.map((change) => change.variable)));
    this.state = shown;
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    if (event.key === 'Escape') this.field.value = '';
    else if (event.key !== 'Enter' || this.field.value.trim() === '') return;
    const wrong = event.key === 'Enter' ? this.events.watch(this.field.value.trim()) : null;
    if (wrong === null) this.field.value = '';
    this.complain(wrong);
    event.preventDefault();
  }

  private complain(wrong: string | null): void {
    this.field.classList.toggle('fails', wrong !== null);
    this.wrong.replaceChildren(prose(wrong ?? ''));
  }

  private draw(): void {
    if (!this.state) return;
    const { trace, values, index, filtered, watches } = this.state;
    const now = values.at(index);
    const before = values.at(index - 1);
    const isFirst = (name: string): boolean => this.pins.has(name) && !watches.has(name);
    const hidesSome = this.hideUnchanged && trace.steps.length > 0;
    const shown = values.names.filter((name) => !watches.has(name) && (isFirst(name) || !hidesSome || this.moving.has(name)));
    const rows = [...watches, ...shown.filter(isFirst), ...shown.filter((name) => !isFirst(name))];
    this.title.textContent = index < 0 ? 'Values at the start' : `Values after step ${index + 1}`;
    this.body.replaceChildren(...rows.map((name) => this.row(name, before.get(name) ?? '', now.get(name) ?? '', index >= 0, filtered)));
    const hidden = values.names.length - rows.length;
    this.note.textContent = hidden > 0 ? `${hidden} that never change in this trace are hidden` : '';
    this.element.dataset['of'] = trace.name;
  }

  private row(name: string, before: string, now: string, isStep: boolean, filtered: ReadonlySet<string>): HTMLElement {
    const changed = isStep && before !== now;
    const isWatch = this.state!.watches.has(name);
    const pinned = this.pins.has(name);
    const found = difference(before, now);
    return h('tr', { class: `${changed ? 'changed' : ''}${pinned || isWatch ? ' pinned' : ''}` },
      h('th', { scope: 'row' }, h('button', {
        type: 'button', class: `name${filtered.has(name) ? ' on' : ''}`, title: `Only steps that change ${name}, or all again`,
        onclick: () => this.events.filter(name),
      }, name, filtered.has(name) && icon('filter'))),
      h('td', {}, changed && parts('before', found.before), changed && h('span', { class: 'arrow' }, '→'),
        changed ? parts('after', found.after) : h('span', { class: 'after' }, now)),
      h('td', { class: 'pin-cell' }, isWatch
        ? button({ icon: 'close', title: `Watch ${name} no longer`, onclick: () => this.events.unwatch(name) })
        : button({
          icon: 'pin', title: pinned ? `Unpin ${name}` : `Pin ${name} to the top`, pressed: pinned, onclick: () => this.togglePin(name),
        })));
  }

  private togglePin(name: string): void {
    if (!this.pins.delete(name)) this.pins.add(name);
    this.events.pinned([...this.pins]);
    this.draw();
  }
}
