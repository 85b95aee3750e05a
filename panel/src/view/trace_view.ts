import type { Host, Trace, Verdict } from '../api.ts';
import type { ActorColours } from '../model/colours.ts';
import { search, select, marksRelevance } from '../model/filter.ts';
import { positionAt } from '../model/seek.ts';
import { continuation, notice, tellsTheSame } from '../model/renew.ts';
import { Values } from '../model/values.ts';
import { watched, WatchError, watchOf, type Watch } from '../model/watch.ts';
import { ComparisonBar } from './comparison_bar.ts';
import { h, isTyping, plural, prose } from './dom.ts';
import { filterSections, noFilter } from './filter_menu.ts';
import { button, enable, icon, toggle } from './icons.ts';
import { LanesView } from './lanes_view.ts';
import { menu, type Section } from './menu.ts';
import type { Saver } from './save.ts';
import { SeekBar } from './seek_bar.ts';
import { splitter } from './splitter.ts';
import { StepList } from './step_list.ts';
import { exportSections } from './trace_export.ts';
import { TraceHead } from './trace_head.ts';
import { ValuesView } from './values_view.ts';

export interface TraceEvents {
  /** The current step or trace changed; `byUser`: by an action of the user. */
  stepped(byUser: boolean): void;
  openFile(): void;
  pinned(names: string[]): void;
  watches(texts: string[]): void;
}

/** A trace as a list of steps, values and lanes, synchronised with each other and the source. */
export class TraceView {
  readonly element: HTMLElement;
  readonly list: StepList;
  private readonly values: ValuesView;
  private readonly lanes: LanesView;
  private readonly head = new TraceHead();
  private readonly body: HTMLElement;
  private readonly empty: HTMLElement;
  private readonly count = h('span', { class: 'count', 'aria-live': 'polite' });
  private readonly field: HTMLInputElement;
  private readonly nothing = h('p', { class: 'nothing', hidden: true });
  private readonly comparison: ComparisonBar;
  private readonly seek: SeekBar;
  private readonly follow;
  private readonly grouped;
  private readonly relevant;
  private readonly buttons: { previous: HTMLButtonElement; next: HTMLButtonElement };
  private filter = noFilter();
  private shown: number[] = [];
  private found: number[] = [];
  private valuesOf = new Values({ name: '', description: '', verdict: '', initial: {}, steps: [] });
  /** the original, and the same with all watches that it supports */
  private given: Trace | null = null;
  trace: Trace | null = null;
  private watches: Watch[] = [];
  private watchTexts: string[] = [];
  /** what was shown of the property before it lost its trace */
  private former: { trace: Trace; index: number } | null = null;
  private gone = false;
  /** counts requested parts of recordings: only the last one is shown */
  private askedParts = 0;
  private readonly nothingOpen: Node[];
  /** the current property, with or without a trace; null: none was chosen yet */
  name: string | null = null;
  current = -1;

  constructor(private readonly host: Host, private readonly saver: Saver, private readonly events: TraceEvents, private readonly colours: ActorColours, ids = 'step') {
    this.list = new StepList({ select: (index) => this.goTo(index), enter: (index) => this.reveal(index, true) }, ids, colours);
    this.values = new ValuesView({
      pinned: (names) => events.pinned(names), filter: (name) => this.toggleVariable(name),
      watch: (text) => this.watch(text), unwatch: (text) => this.setWatches(this.watchTexts.filter((it) => it !== text)),
    });
    this.lanes = new LanesView({ select: (index) => this.goTo(index) }, colours);
    this.seek = new SeekBar({ select: (index) => this.goTo(index), move: (by) => this.list.move(by), load: (time) => void this.loadPart(time) });
    this.comparison = new ComparisonBar({ changed: () => this.refresh(), move: (by) => this.toDifference(by), fetch: (name) => host.request('trace', { name }) });
    this.field = h('input', {
      type: 'search', class: 'search', placeholder: 'Search steps', 'aria-label': 'Search steps: actors, words and values',
      oninput: () => this.searchFor(this.field.value), onkeydown: (event: KeyboardEvent) => this.searchKey(event),
    });
    this.follow = toggle({ icon: 'follow', title: 'Follow: the source goes with the steps', on: true, changed: (on) => on && this.reveal(this.current, false) });
    this.grouped = toggle({ text: 'By actor', title: 'Steps in a row by the same actor under its name', on: true, changed: () => this.refresh() });
    this.relevant = toggle({ text: 'Relevant steps', title: 'Only the steps that are relevant to what the trace shows (m)', on: false, changed: (on) => { this.filter.relevant = on; this.refresh(); } });
    this.buttons = {
      previous: button({ icon: 'previous', title: 'Previous step (↑)', onclick: () => this.list.move(-1) }),
      next: button({ icon: 'next', title: 'Next step (↓)', onclick: () => this.list.move(1) }),
    };
    const upper = h('div', { class: 'trace-upper' }, h('div', { class: 'steps-frame' }, this.nothing, this.list.element), this.values.element);
    upper.insertBefore(splitter('vertical', this.values.element, 'values'), this.values.element);
    this.body = h('div', { class: 'trace-body', hidden: true }, ...this.head.elements, this.toolbar(), this.seek.element, this.comparison.element, upper,
      splitter('horizontal', this.lanes.element, 'lanes'), this.lanes.element);
    this.nothingOpen = [h('p', {}, 'No trace is open.'),
      h('p', { class: 'faint' }, 'Choose a property that has one, or open a file with a trace.'),
      button({ icon: 'open', text: 'Open a file…', title: 'A trace or a report, as JSON', onclick: () => events.openFile() })];
    this.empty = h('div', { class: 'empty', role: 'status' });
    this.empty.append(...this.nothingOpen);
    this.element = h('div', { class: 'trace-view', onkeydown: (event: KeyboardEvent) => this.key(event) }, this.empty, this.body);
  }

  /** Traces to compare with. */
  setOthers(verdicts: Verdict[]): void {
    this.comparison.setOthers(verdicts);
  }

  pin(names: readonly string[]): void {
    this.values.pin(names);
  }

  /** Watches of earlier sessions, before a trace is shown. */
  remember(watches: readonly string[]): void {
    this.watchTexts = [...watches];
  }

  /** Adds a watch, or returns its error. */
  private watch(text: string): string | null {
    try {
      watchOf(text, this.given!);
    } catch (error) {
      if (error instanceof WatchError) return error.message;
      throw error;
    }
    if (!this.watchTexts.includes(text) && !(text in this.given!.initial)) this.setWatches([...this.watchTexts, text]);
    return null;
  }

  private setWatches(texts: string[]): void {
    this.watchTexts = texts;
    this.filter.variables = new Set([...this.filter.variables].filter((name) => texts.includes(name) || name in this.given!.initial));
    this.events.watches(texts);
    this.ask();
    this.lanes.renew(this.trace!);
    this.refresh(this.current);
    this.moveTo(this.current, false);
  }

  /** A watch that this trace does not support is kept for others. */
  private ask(): void {
    this.watches = this.watchTexts.flatMap((text) => {
      try {
        return [watchOf(text, this.given!)];
      } catch {
        return [];
      }
    });
    this.trace = watched(this.given!, this.watches);
    this.valuesOf = new Values(this.trace);
  }

  /** Opens a trace at a step; by default at the last, which shows what the property is about. */
  show(trace: Trace, step = trace.steps.length - 1, byUser = true): void {
    this.name = trace.name;
    this.given = trace;
    this.former = null;
    this.gone = false;
    this.ask();
    this.filter = noFilter();
    this.relevant.set(false);
    this.comparison.end();
    this.field.value = '';
    this.found = [];
    this.current = Math.min(Math.max(step, 0), trace.steps.length - 1);
    this.empty.hidden = true;
    this.body.hidden = false;
    this.drawHead();
    this.lanes.show(this.trace!);
    this.refresh();
    this.list.select(this.current);
    this.head.say('');
    this.moveTo(this.current, byUser);
    if (byUser) this.list.bringIntoView();
  }

  /** Shows another part of the recording, at a time; by default at its end. Filter and search stay. */
  private async loadPart(time?: number): Promise<void> {
    const former = this.given!;
    const request = ++this.askedParts;
    try {
      const part = await this.host.request('part', { name: former.name, ...(time !== undefined && { from: time }) });
      if (this.given !== former || request !== this.askedParts) return; // something else is to be shown by now
      this.given = part;
      this.ask();
      this.found = search(part, this.field.value);
      this.drawHead();
      this.lanes.show(this.trace!);
      const all = part.steps.map((_, index) => index);
      const step = time === undefined ? all.length - 1 : time === 0 ? 0 : positionAt(part, all, time);
      this.refresh(step);
      this.goTo(step);
    } catch (error) {
      this.head.say((error as Error).message);
    }
  }

  /**
   * Shows another trace of the same property, after another verification. The current step becomes the equal one, else the nearest. The visible part
   * stays; the source does not move.
   */
  renew(trace: Trace, tells = true, stale = false): void {
    const former = this.given ? { trace: this.given, index: this.current } : this.former;
    if (!former) return this.show(trace);
    const found = continuation(former.trace, former.index, trace);
    const isNew = !this.given || !tellsTheSame(former.trace, trace);
    this.given = trace;
    this.former = null;
    this.gone = false;
    this.ask();
    const names = new Set([...this.watches.map(({ text }) => text), ...Object.keys(trace.initial)]);
    this.filter.variables = new Set([...this.filter.variables].filter((name) => names.has(name)));
    this.comparison.renew(trace);
    this.found = search(trace, this.field.value);
    this.empty.hidden = true;
    this.body.hidden = false;
    this.drawHead();
    this.markStale(stale);
    this.lanes.renew(this.trace!);
    this.refresh(found.index);
    this.moveTo(found.index, false);
    if (isNew && tells && !stale) this.head.say(notice(found, former.index, trace));
  }

  /** The same trace with more steps. `toLast`: its last step becomes the current one, and the source follows; otherwise nothing moves. */
  grow(trace: Trace, toLast: boolean): void {
    if (!this.given) return this.show(trace, trace.steps.length - 1, false);
    this.given = trace;
    this.ask();
    if (this.field.value !== '') this.found = search(trace, this.field.value);
    this.drawHead();
    this.lanes.renew(this.trace!);
    if (toLast) this.current = trace.steps.length - 1;
    else if (this.current < 0) this.current = 0;
    this.refresh('grown');
    if (toLast) this.list.select(this.current);
    this.moveTo(this.current, false);
    if (toLast && this.follow.on) this.reveal(trace.steps.findLastIndex(({ location }) => location), false);
  }

  /** The time of a run that is watched. `reveal`: the lanes go with it. */
  tick(now: number, reveal: boolean): void {
    this.lanes.tick(now, reveal);
    this.seek.tick(now);
  }

  /** The property now has a verdict without a trace: shows the former trace as outdated. */
  showVerdict(verdict: Verdict): void {
    if (this.given) this.former = { trace: this.given, index: this.current };
    this.given = null;
    this.trace = null;
    this.body.hidden = true;
    this.empty.hidden = false;
    this.empty.replaceChildren(h('p', {}, h('span', { class: `badge ${verdict.verdict}` }, verdict.verdict)),
      h('p', {}, prose(verdict.description)), h('p', { class: 'faint' }, prose(verdict.reason || 'After the last change there is no trace of it any more.')));
    this.host.tell('step', null);
  }

  /** The program no longer has such a property. */
  markGone(): void {
    this.gone = true;
    this.markStale(true);
  }

  focus(): void {
    this.list.element.focus({ preventScroll: true });
  }

  /** What was said about the latest verification is over when the text changes. */
  markStale(stale: boolean): void {
    if (this.body.classList.toggle('stale', stale || this.gone)) this.head.say('');
  }

  private drawHead(): void {
    const trace = this.trace!;
    this.head.draw(trace);
    const count = trace.steps.filter((step) => step.relevant !== false).length;
    enable(this.relevant.element, marksRelevance(trace) ? null : 'Every step is relevant', `Only the ${plural(count, 'step')} relevant to what the trace shows (m)`);
  }

  private toolbar(): HTMLElement {
    return h('div', { class: 'bar toolbar', role: 'toolbar', 'aria-label': 'Trace' },
      this.buttons.previous, this.buttons.next, this.count, this.follow.element, h('span', { class: 'divider' }),
      h('label', { class: 'search-frame' }, icon('search'), this.field),
      menu({ icon: 'filter', title: 'Filter', content: () => this.filterSections() }), this.relevant.element, this.grouped.element,
      h('span', { class: 'push' }),
      menu({ icon: 'compare', title: 'Compare with another trace', content: () => this.comparison.sections(this.given!) }),
      menu({ icon: 'download', title: 'Export', content: () => exportSections(this.given!, this.lanes, this.element, this.saver) }),
      button({ icon: 'open', title: 'Open a trace from a file', onclick: () => this.events.openFile() }));
  }

  private filterSections(): Section[] {
    return filterSections(this.trace!, this.filter, this.colours.of(this.trace!), () => this.refresh(), () => this.showAll());
  }

  private showAll(): void {
    this.filter = noFilter();
    this.relevant.set(false);
    this.refresh();
  }

  private toDifference(direction: 1 | -1): void {
    const to = this.comparison.difference(this.current, direction);
    if (to !== undefined) this.goTo(to);
  }

  /** `renewed`: in another trace, in which this step takes the position of the current one; or the trace has grown. */
  private refresh(renewed?: number | 'grown'): void {
    const trace = this.trace!;
    this.shown = select(trace, this.filter);
    this.nothing.hidden = this.shown.length > 0;
    this.nothing.textContent = trace.steps.length > 0 ? 'No step passes the filter.' : 'There are no steps: it is so from the start.';
    const list = { trace, steps: this.shown, grouped: this.grouped.on, found: new Set(this.found), ...(this.comparison.compared && { compared: this.comparison.compared }) };
    if (renewed === undefined) this.list.show(list);
    else if (renewed === 'grown') this.list.grow(list);
    else this.list.renew(list, renewed);
    this.lanes.filter(this.filter.actors, this.filter.variables);
    this.seek.show(trace, this.shown, this.current);
    this.update();
  }

  private update(): void {
    const trace = this.trace!;
    const at = this.shown.indexOf(this.current);
    const filtered = this.shown.length < trace.steps.length ? ` (${this.shown.length} shown)` : '';
    this.count.textContent = trace.steps.length === 0 ? 'no steps' : `${this.current + 1} of ${trace.steps.length}${filtered}`;
    enable(this.buttons.previous, at === 0 ? 'This is the first step' : null, 'Previous step (↑)');
    enable(this.buttons.next, at === this.shown.length - 1 ? 'This is the last step' : null, 'Next step (↓)');
    this.values.show({
      trace, values: this.valuesOf, index: this.current, filtered: this.filter.variables, watches: new Set(this.watches.map((it) => it.text)),
    });
  }

  /** The user selects a step: the source follows. */
  goTo(index: number): void {
    this.list.select(index);
    this.head.say('');
    this.moveTo(index, true);
  }

  private moveTo(index: number, byUser: boolean): void {
    const trace = this.given!;
    const step = trace.steps[index];
    this.current = index;
    this.lanes.select(index, byUser);
    this.seek.select(index);
    this.update();
    if (!step) return this.host.tell('step', null);
    this.host.tell('step', { trace: trace.name, index, count: trace.steps.length, step, values: this.valuesNow(), byUser });
    if (this.follow.on && byUser) this.reveal(index, false);
    this.events.stepped(byUser);
  }

  /** The values of the program's variables after the current step; watches are not among them. */
  valuesNow(): { [variable: string]: string } {
    const values = this.valuesOf.at(this.current);
    for (const { text } of this.watches) values.delete(text);
    return Object.fromEntries(values);
  }

  private reveal(index: number, focus: boolean): void {
    const location = this.trace?.steps[index]?.location;
    if (location) this.host.tell('reveal', { location, focus });
  }

  private toggleVariable(name: string): void {
    if (!this.filter.variables.delete(name)) this.filter.variables.add(name);
    this.refresh();
  }

  private searchFor(needle: string): void {
    this.found = search(this.trace!, needle);
    this.field.classList.toggle('fails', needle.trim() !== '' && this.found.length === 0);
    this.refresh();
    const first = this.found.find((index) => index >= this.current) ?? this.found[0];
    if (first !== undefined) this.goTo(first);
  }

  private toFound(direction: 1 | -1): void {
    const to = direction > 0 ? (this.found.find((index) => index > this.current) ?? this.found[0])
      : (this.found.findLast((index) => index < this.current) ?? this.found.at(-1));
    if (to !== undefined) this.goTo(to);
  }

  private searchKey(event: KeyboardEvent): void {
    if (event.key === 'Enter') this.toFound(event.shiftKey ? -1 : 1);
    else if (event.key === 'Escape') {
      this.field.value = '';
      this.searchFor('');
      this.focus();
    } else return;
    event.preventDefault();
  }

  private key(event: KeyboardEvent): void {
    if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey || !this.trace) return;
    if (event.key === '/') this.field.focus();
    else if (event.key === 'n') this.comparison.compared ? this.toDifference(1) : this.toFound(1);
    else if (event.key === 'N') this.comparison.compared ? this.toDifference(-1) : this.toFound(-1);
    else if (event.key === 'f') this.follow.element.click();
    else if (event.key === 'm') this.relevant.element.click();
    else return;
    event.preventDefault();
  }
}
