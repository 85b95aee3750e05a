import type { Change, Location, Trace } from '../api.ts';
import { actorsOf } from '../model/actors.ts';
import { hue, hues, type ActorColours } from '../model/colours.ts';
import { isDifferent, type Pair } from '../model/compare.ts';
import { difference, type Part } from '../model/diff.ts';
import { groups, isRelevant } from '../model/filter.ts';
import { sameMoment, windowOf, windowWords } from '../model/time.ts';
import { Rows } from '../model/virtual.ts';
import { h, onceAFrame, prose } from './dom.ts';
import { kOldest } from './early_keys.ts';
import { icon } from './icons.ts';

const heights = { head: 30, step: 26, why: 20, change: 22, other: 26 };
const margin = 300; // pixels drawn above and below the visible part

type Row =
  | { type: 'head'; actor: string; group: number; count: number }
  | { type: 'step'; index: number }
  | { type: 'why'; index: number; why: string }
  | { type: 'change'; index: number; change: Change }
  | { type: 'other'; index: number }; // of the trace to compare with

export interface StepListEvents {
  select(index: number): void;
  /** go to its source */
  enter(index: number): void;
}
export interface Shown {
  trace: Trace;
  steps: readonly number[];
  grouped: boolean;
  found: ReadonlySet<number>;
  /** undefined: no comparison */
  compared?: { other: Trace; pairs: Pair[] };
}

const whoElement = (actor: string): HTMLElement => h('span', { class: 'actor', title: actor }, h('span', { class: 'dot' }), actor);

/** The steps of a trace; only visible ones are elements. */
export class StepList {
  readonly element: HTMLElement;
  private readonly space = h('div', { class: 'steps-space' });
  private rows: Row[] = [];
  private layout = new Rows([]);
  private rowOf = new Map<number, number>();
  private positions = new Map<number, number>();
  private onlyLeft = new Set<number>();
  private shown: Shown | null = null;
  private kinds = new Map<string, string>();
  private hues = new Map<string, number>();
  /** all rows are drawn, one below the other */
  private printing = false;
  private readonly folded = new Set<number>();
  private current = -1;
  private heldKeys: string[] | null = null;
  private heldUntil = 0;
  private readonly draw = onceAFrame(() => this.drawNow());

  /** `prefix` of the steps' ids, for pages with several lists. */
  constructor(private readonly events: StepListEvents, private readonly prefix: string, private readonly colours: ActorColours) {
    this.element = h('div', {
      class: 'steps', tabindex: 0, role: 'listbox', 'aria-label': 'Steps of the trace', onscroll: () => this.draw(),
      onkeydown: (event: KeyboardEvent) => this.key(event),
    }, this.space);
    new ResizeObserver(() => this.draw()).observe(this.element);
    window.addEventListener('beforeprint', () => this.print(true));
    window.addEventListener('afterprint', () => this.print(false));
  }

  show(shown: Shown): void {
    if (shown.trace !== this.shown?.trace) {
      this.begin(shown.trace);
      this.element.scrollTop = 0;
    }
    this.shown = shown;
    this.arrange();
  }

  /** Shows another trace; its step `index` becomes current, at the position of the former one. */
  renew(shown: Shown, index: number): void {
    const before = this.rowOf.get(this.current);
    const offset = before === undefined ? 0 : this.layout.top(before) - this.element.scrollTop;
    this.begin(shown.trace);
    this.shown = shown;
    this.current = index;
    this.arrange();
    const row = this.rowOf.get(index);
    if (row !== undefined) this.element.scrollTop = Math.max(0, this.layout.top(row) - offset);
    this.drawNow();
  }

  /** The same trace with more steps at its end. */
  grow(shown: Shown): void {
    this.learn(shown.trace);
    this.shown = shown;
    this.arrange();
  }

  private begin(trace: Trace): void {
    this.learn(trace);
    this.folded.clear();
  }

  private learn(trace: Trace): void {
    this.kinds = new Map(actorsOf(trace).map((actor) => [actor.name, actor.kind]));
    this.hues = this.colours.of(trace);
  }

  /** An actor that only the other trace has. */
  private hueOf(actor: string): number {
    return this.hues.get(actor) ?? hue(actor, hues);
  }

  /** Makes a step current and scrolls to it. */
  select(index: number): void {
    this.current = index;
    this.unfold(index);
    const row = this.rowOf.get(index);
    if (row !== undefined) {
      const top = this.layout.reveal(row, this.element.scrollTop, this.element.clientHeight, 48);
      if (top !== this.element.scrollTop) this.element.scrollTop = top;
    }
    this.drawNow();
  }

  /** Scrolls what is around the list, where that hides the current step. */
  bringIntoView(): void {
    this.space.querySelector('.step.current')?.scrollIntoView({ block: 'nearest' });
  }

  private arrange(): void {
    const { trace, steps, grouped, compared } = this.shown!;
    this.rows = [];
    const add = (index: number): void => {
      this.rows.push({ type: 'step', index });
      const why = trace.steps[index]!.why;
      if (why) this.rows.push({ type: 'why', index, why });
      for (const change of trace.steps[index]!.changes) this.rows.push({ type: 'change', index, change });
    };
    if (compared) this.arrangePairs(compared.pairs, new Set(steps), add);
    else if (grouped)
      groups(trace, steps).forEach((group) => {
        const first = group.steps[0]!;
        this.rows.push({ type: 'head', actor: group.actor, group: first, count: group.steps.length });
        if (!this.folded.has(first)) group.steps.forEach(add);
      });
    else steps.forEach(add);
    this.positions = new Map(steps.map((index, at) => [index, at + 1]));
    this.onlyLeft = new Set(compared?.pairs.flatMap((pair) => (isDifferent(pair) ? (pair.left ?? []) : [])));
    this.rowOf = new Map();
    this.rows.forEach((row, at) => row.type === 'step' && this.rowOf.set(row.index, at));
    this.layout = new Rows(this.rows.map((row) => heights[row.type]));
    this.space.style.height = `${this.layout.height}px`;
    this.drawNow();
  }

  private arrangePairs(pairs: Pair[], shown: ReadonlySet<number>, add: (index: number) => void): void {
    for (const pair of pairs) {
      if (pair.left !== null && shown.has(pair.left)) add(pair.left);
      else if (pair.left === null && pair.right !== null) this.rows.push({ type: 'other', index: pair.right });
    }
  }

  private print(on: boolean): void {
    this.printing = on;
    this.drawNow();
  }

  private drawNow(): void {
    if (!this.shown) return;
    const [first, last] = this.printing ? [0, this.rows.length] : this.layout.visible(this.element.scrollTop, this.element.clientHeight || 600, margin);
    const out: HTMLElement[] = [];
    for (let at = first; at < last; ++at) {
      const row = this.rows[at];
      if (!row) continue;
      const element = this.rowElement(row, at);
      element.style.transform = `translateY(${this.layout.top(at)}px)`;
      element.style.height = `${heights[row.type]}px`;
      out.push(element);
    }
    this.space.replaceChildren(...out);
    const active = this.rowOf.has(this.current) ? `${this.prefix}-${this.current}` : null;
    if (active && document.getElementById(active)) this.element.setAttribute('aria-activedescendant', active);
    else this.element.removeAttribute('aria-activedescendant');
  }

  private rowElement(row: Row, at: number): HTMLElement {
    if (row.type === 'head') return this.headElement(row);
    if (row.type === 'why') return this.whyElement(row.index, row.why);
    if (row.type === 'change') return this.changeElement(row.index, row.change);
    if (row.type === 'other') return this.otherElement(row.index);
    return this.stepElement(row.index, at);
  }

  private headElement(row: Row & { type: 'head' }): HTMLElement {
    const isFolded = this.folded.has(row.group);
    return h('div', {
      class: `row head hue-${this.hueOf(row.actor)}`, role: 'presentation', title: isFolded ? 'Show its steps' : 'Hide its steps',
      onclick: () => this.fold(row.group),
    }, h('span', { class: `chevron${isFolded ? ' shut' : ''}` }, icon('down')), h('span', { class: 'dot' }),
    h('span', { class: 'actor' }, row.actor), h('span', { class: 'faint' }, this.kinds.get(row.actor) ?? ''),
    isFolded && h('span', { class: 'faint push' }, `${row.count} hidden`));
  }

  /** A step in a folded group would not be visible. */
  private unfold(index: number): void {
    if (!this.shown || this.rowOf.has(index)) return;
    const group = groups(this.shown.trace, this.shown.steps).find(({ steps }) => steps.includes(index));
    if (group && this.folded.delete(group.steps[0]!)) this.arrange();
  }

  private fold(group: number): void {
    if (!this.folded.delete(group)) this.folded.add(group);
    this.arrange();
  }

  private stepElement(index: number, at: number): HTMLElement {
    const { trace, steps, found, compared, grouped } = this.shown!;
    const step = trace.steps[index]!;
    const before = trace.steps[index - 1];
    const sameDate = before && at > 0 && sameMoment(before.earliest, step.earliest) && sameMoment(before.latest, step.latest);
    const only = this.onlyLeft.has(index);
    const classes = ['row', 'step', !isRelevant(step) && 'aside', index === this.current && 'current', found.has(index) && 'found', only && 'only-left',
      this.inLoop(index) && 'in-loop', trace.loop === index && 'loop-start', `hue-${this.hueOf(step.actor)}`];
    return h('div', {
      class: classes.filter(Boolean).join(' '), id: `${this.prefix}-${index}`, role: 'option', 'aria-selected': String(index === this.current),
      'aria-posinset': this.positions.get(index) ?? 1, 'aria-setsize': steps.length,
      'aria-label': `Step ${index + 1}, ${windowWords(step)}: ${step.actor} ${step.description}${step.why ? `, why: ${step.why}` : ''}${isRelevant(step) ? '' : '; not relevant here'}`,
      onclick: () => this.choose(index), ondblclick: () => this.events.enter(index),
    }, h('span', { class: 'number' }, String(index + 1)),
    h('span', { class: `date${sameDate ? ' same' : ''}`, title: windowWords(step) }, `${windowOf(step)} s`),
    (!grouped || compared) && whoElement(step.actor),
    ...wordsOf(step.description),
    trace.loop === index && h('span', { class: 'tag' }, 'from here on for ever'),
    only && h('span', { class: 'tag' }, 'only here'),
    step.location && h('span', { class: 'place' }, placeOf(step.location)));
  }

  private whyElement(index: number, why: string): HTMLElement {
    return h('div', {
      class: `row why${this.sideClasses(index)}`, role: 'presentation', title: why.replaceAll('`', ''), onclick: () => this.choose(index),
    }, h('span', { class: 'because' }, 'why'), h('span', { class: 'words' }, prose(why)));
  }

  private sideClasses(index: number): string {
    return `${index === this.current ? ' of-current' : ''}${this.inLoop(index) ? ' in-loop' : ''}${isRelevant(this.shown!.trace.steps[index]!) ? '' : ' aside'}`;
  }

  private changeElement(index: number, change: Change): HTMLElement {
    const found = difference(change.before, change.after);
    return h('div', {
      class: `row change${this.sideClasses(index)} ${found.kind}`,
      role: 'presentation', onclick: () => this.choose(index),
    }, h('span', { class: 'variable' }, change.variable), parts('before', found.before), h('span', { class: 'arrow' }, '→'),
    parts('after', found.after), found.delta && h('span', { class: 'faint' }, found.delta));
  }

  private otherElement(index: number): HTMLElement {
    const step = this.shown!.compared!.other.steps[index]!;
    return h('div', { class: `row step only-right hue-${this.hueOf(step.actor)}`, role: 'presentation' },
      h('span', { class: 'number' }, String(index + 1)), h('span', { class: 'date', title: windowWords(step) }, `${windowOf(step)} s`),
      whoElement(step.actor), h('span', { class: 'words' }, prose(step.description)),
      h('span', { class: 'tag' }, 'only in the other'));
  }

  private inLoop(index: number): boolean {
    const loop = this.shown!.trace.loop;
    return typeof loop === 'number' && index >= loop;
  }

  private choose(index: number): void {
    this.element.focus({ preventScroll: true });
    this.go(index);
  }

  /** Keys wait until `releaseKeys`, if that comes soon: they are meant for a trace that is not here yet. */
  holdKeys(): void {
    this.heldKeys ??= [];
    this.heldUntil = performance.now() + kOldest;
  }

  releaseKeys(): void {
    const keys = this.heldKeys ?? [];
    this.heldKeys = null;
    for (const key of keys) this.take(key);
  }

  private key(event: KeyboardEvent): void {
    const { key } = event;
    if (event.ctrlKey || event.metaKey || event.altKey || (key !== 'Enter' && this.wayOf(key) === undefined)) return;
    if (performance.now() > this.heldUntil) this.releaseKeys();
    this.heldKeys ? this.heldKeys.push(key) : this.take(key);
    event.preventDefault();
  }

  private take(key: string): void {
    const by = this.wayOf(key);
    if (by !== undefined) this.move(by);
    else if (this.current >= 0) this.events.enter(this.current);
  }

  /** By how many of the visible steps a key moves. */
  private wayOf(key: string): number | undefined {
    const page = Math.max(1, Math.floor(this.element.clientHeight / heights.step) - 2);
    return { ArrowDown: 1, j: 1, ArrowUp: -1, k: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity }[key];
  }

  /** Moves by this many of the visible steps. */
  move(by: number): void {
    const steps = this.shown?.steps ?? [];
    if (steps.length === 0) return;
    // if the current step is hidden, from where it would be
    const after = steps.findIndex((index) => index >= this.current);
    const at = after < 0 ? steps.length : after;
    const from = steps[at] === this.current || by < 0 ? at : at - 1;
    this.go(steps[Math.min(Math.max(from + by, 0), steps.length - 1)]!);
  }

  private go(index: number): void {
    this.events.select(index);
    this.bringIntoView();
  }
}

/** Shows the result of a test, however long its condition is. */
export function wordsOf(words: string): HTMLElement[] {
  const [, before, result] = /^(.*): (true|false)$/.exec(words) ?? [null, words, null];
  const whole = h('span', { class: 'words', title: words.replaceAll('`', '') }, prose(before));
  return result === null ? [whole] : [whole, h('span', { class: 'result' }, `: ${result}`)];
}

export const placeOf = (location: Location): string =>
  `${location.label ?? decodeURIComponent(location.uri.split('/').at(-1) ?? '')}:${location.range.start.line + 1}`;

export function parts(className: string, list: Part[]): HTMLElement {
  return h('span', { class: className },
    ...(list.length === 0 ? [h('span', { class: 'faint' }, '—')] : list.map((part) => (part.changed ? h('b', {}, part.text) : part.text))));
}
