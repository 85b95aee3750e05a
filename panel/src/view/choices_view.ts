import type { Step, Trace } from '../api.ts';
import type { ActorColours } from '../model/colours.ts';
import { decimal, windowOf, windowWords } from '../model/time.ts';
import { h } from './dom.ts';
import { wordsOf } from './step_list.ts';

export interface ChoicesEvents {
  take(index: number, late: boolean): void;
  /** the focus or the pointer is on it */
  look(index: number | null): void;
}

/** The possible next steps of a simulation. */
export class ChoicesView {
  readonly element: HTMLElement;
  private readonly list: HTMLElement;
  private readonly title = h('h2', {}, 'What may happen next');
  private choices: Step[] = [];
  private rows: HTMLElement[] = [];
  private at = 0;
  private enabled = true;

  constructor(private readonly events: ChoicesEvents, private readonly colours: ActorColours) {
    this.list = h('div', {
      class: 'choice-list', role: 'listbox', tabindex: 0, 'aria-label': 'Steps to choose from: Enter takes one, Shift+Enter takes it as late as possible',
      onkeydown: (event: KeyboardEvent) => this.key(event), onpointerleave: () => this.events.look(null),
    });
    this.element = h('section', { class: 'choices', 'aria-label': 'What may happen next' }, this.title, this.list);
  }

  show(choices: Step[], trace: Trace, enabled: boolean): void {
    this.choices = choices;
    this.enabled = enabled;
    this.at = 0;
    const hues = this.colours.of(trace, choices);
    this.rows = choices.map((step, index) => this.row(step, index, hues.get(step.actor) ?? 0));
    this.list.replaceChildren(...(this.rows.length > 0 ? this.rows
      : [h('p', { class: 'nothing' }, 'Nothing more can happen: this is the end of the run.')]));
    this.list.classList.toggle('disabled', !enabled);
    this.mark();
  }

  /** A menu for a part of a picture that represents several steps. */
  offer(indices: readonly number[]): void {
    this.rows.forEach((row, index) => row.classList.toggle('offered', indices.includes(index)));
    if (indices[0] !== undefined) this.move(indices[0]);
    this.focus();
  }

  focus(): void {
    this.list.focus({ preventScroll: true });
  }

  private row(step: Step, index: number, hue: number): HTMLElement {
    const { latest, earliest } = step;
    const isLater = latest !== null && latest.exact !== earliest.exact;
    return h('div', { class: `choice hue-${hue}`, role: 'option', id: `choice-${index}`, 'aria-selected': 'false',
      onclick: () => this.take(index, false), onpointerenter: () => this.events.look(index) },
    h('kbd', { class: 'faint' }, index < 9 ? String(index + 1) : ''), h('span', { class: 'date', title: windowWords(step) }, `${windowOf(step)} s`),
    h('span', { class: 'dot' }), h('span', { class: 'actor', title: step.actor }, step.actor), ...wordsOf(step.description),
    ...step.changes.map((change) => h('span', { class: 'effect' }, `${change.variable}: ${change.before} → ${change.after}`)),
    isLater && h('button', { type: 'button', class: 'button late', tabindex: -1, title: 'As late as possible (Shift+Enter)',
      onclick: (event: MouseEvent) => { event.stopPropagation(); this.take(index, true); } },
    `${latest.strict ? 'just before' : 'at'} ${decimal(latest)} s`));
  }

  private take(index: number, late: boolean): void {
    if (this.enabled && this.choices[index]) this.events.take(index, late);
  }

  private move(to: number): void {
    this.at = Math.min(Math.max(to, 0), this.rows.length - 1);
    this.mark();
    this.rows[this.at]?.scrollIntoView({ block: 'nearest' });
    this.events.look(this.rows[this.at] ? this.at : null);
  }

  private mark(): void {
    this.rows.forEach((row, index) => row.setAttribute('aria-selected', String(index === this.at)));
    if (this.rows[this.at]) this.list.setAttribute('aria-activedescendant', `choice-${this.at}`);
    else this.list.removeAttribute('aria-activedescendant');
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const digit = /^[1-9]$/.test(event.key) ? Number(event.key) - 1 : -1;
    if (event.key === 'ArrowDown') this.move(this.at + 1);
    else if (event.key === 'ArrowUp') this.move(this.at - 1);
    else if (event.key === 'Enter') this.take(this.at, event.shiftKey);
    else if (digit >= 0) this.take(digit, false);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
