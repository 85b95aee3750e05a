import type { Trace } from '../api.ts';
import { hue, hues, type ActorColours } from '../model/colours.ts';
import { axisOf, drawBars, drawMarks, endOfAxis, lanesOf, nearest, type Drawn, type Lane } from '../model/lanes.ts';
import { ticks, windowOf } from '../model/time.ts';
import { h, isTyping, onceAFrame, s } from './dom.ts';
import { button, toggle } from './icons.ts';

const laneHeight = 24;
const axisHeight = 26;
const widestLabel = 168;
const letter = 6.2; // of a label, on average
const loopLabelWidth = 60;
const room = 14; // space at the right end, so that the last bar and mark are fully visible

export interface LanesEvents {
  select(index: number): void;
}

/** Skills, branches, events and variables over time: one lane each, with a line at the current step. */
export class LanesView {
  readonly element: HTMLElement;
  private readonly axisSvg = s('svg', { class: 'lanes-axis', height: axisHeight, 'aria-hidden': 'true' });
  private readonly lanesSvg = s('svg', { class: 'lanes-rows' });
  private readonly scroller: HTMLElement;
  private readonly byStep;
  private trace: Trace | null = null;
  private lanes: Lane[] = [];
  private hues = new Map<string, number>();
  private hidden: (lane: Lane) => boolean = () => false;
  private axis: Float64Array = new Float64Array();
  private view: [number, number] = [0, 1];
  /** of a run that is watched, in seconds */
  private now: number | null = null;
  private current = -1;
  private readonly cursorTop = s('g');
  private readonly cursorRows = s('g');
  private readonly draw = onceAFrame(() => this.drawNow());
  /** Moves only the line, since lanes have many elements and steps change quickly. */
  private readonly drawLine = onceAFrame(() => this.drawCursor(this.cursorTop, this.cursorRows, this.plotWidth));

  constructor(private readonly events: LanesEvents, private readonly colours: ActorColours) {
    this.byStep = toggle({
      text: 'By step', title: 'Give each step the same room, not each second', on: false,
      changed: () => { this.axis = this.makeAxis(); this.fit(); },
    });
    this.scroller = h('div', { class: 'scroll', tabindex: 0, role: 'group', 'aria-label': 'Lanes: arrows move, plus and minus zoom, 0 shows all', onkeydown: (event: KeyboardEvent) => this.key(event) }, this.lanesSvg);
    this.element = h('section', { class: 'lanes', 'aria-label': 'Lanes in time' },
      h('header', { class: 'bar' }, h('h3', {}, 'Lanes'), h('span', { class: 'push' }), this.byStep.element,
        button({ icon: 'minus', title: 'Zoom out (−)', onclick: () => this.zoom(1 / 1.5) }),
        button({ icon: 'plus', title: 'Zoom in (+)', onclick: () => this.zoom(1.5) }),
        button({ icon: 'fit', title: 'Show all (0)', onclick: () => this.fit() })),
      this.axisSvg, this.scroller);
    new ResizeObserver(() => this.draw()).observe(this.element);
    this.listen();
  }

  show(trace: Trace): void {
    this.take(trace);
    this.fit();
  }

  /** Shows another trace; the visible section stays, unless all of the former was visible. */
  renew(trace: Trace): void {
    const wasFitted = this.isFitted;
    this.take(trace);
    if (wasFitted || this.view[1] > this.end) this.fit();
    else this.draw();
  }

  private take(trace: Trace): void {
    this.trace = trace;
    this.lanes = lanesOf(trace);
    this.hues = this.colours.of(trace);
    const timeless = this.now === null && (trace.steps.at(-1)?.date.seconds ?? 0) === 0;
    this.byStep.set(this.byStep.on || timeless);
    this.axis = this.makeAxis();
  }

  /** The time goes on; `reveal`: it stays visible. */
  tick(now: number, reveal: boolean): void {
    if (now === this.now) return;
    const [from, to] = this.view;
    const wasFitted = this.isFitted;
    this.now = now;
    if (this.byStep.on || !this.trace) return;
    if (wasFitted || to > this.end) this.fit();
    else if (reveal && now > to) this.move(now - to + (to - from) / 10);
    else this.draw();
  }

  /** `reveal`: scrolls to it, too. */
  select(index: number, reveal = true): void {
    this.current = index;
    const at = this.axis[index];
    const [from, to] = this.view;
    if (reveal && at !== undefined && (at < from || at > to)) this.move(at - (to - from) / 2 - from);
    else this.drawLine();
  }

  /** Shows only lanes of these actors and variables; empty sets keep all. */
  filter(actors: ReadonlySet<string>, variables: ReadonlySet<string>): void {
    this.hidden = (lane) => {
      const chosen = lane.kind === 'variable' ? variables : actors;
      return chosen.size > 0 && !chosen.has(lane.name);
    };
    this.draw();
  }

  /** All lanes with their axis, for a file. */
  picture(): { svg: SVGSVGElement; width: number; height: number } {
    const width = Math.max(this.element.clientWidth, 600);
    const rows = this.shownLanes().length * laneHeight;
    const svg = s('svg', { class: 'lanes-picture' });
    const lower = s('g', { transform: `translate(0, ${axisHeight})` });
    const plot = width - this.labelWidth - room;
    this.fill(svg, lower, plot);
    this.drawCursor(svg.appendChild(s('g')), lower.appendChild(s('g')), plot);
    svg.append(lower);
    return { svg, width, height: axisHeight + rows + 8 };
  }

  private makeAxis(): Float64Array {
    return axisOf(this.trace!, this.byStep.on ? 'step' : 'date');
  }

  /** Of a part of a recording, the beginning; otherwise that of the run. */
  private get begin(): number {
    return this.byStep.on ? 0 : (this.trace?.part?.begin ?? 0);
  }

  private get end(): number {
    const end = endOfAxis(this.axis, this.byStep.on ? 'step' : 'date', this.begin);
    return this.byStep.on || this.now === null ? end : Math.max(end, this.now * 1.05, 1);
  }

  /** What still runs lasts until now, or beyond the end of the trace. */
  private get openEnd(): number {
    return this.byStep.on || this.now === null ? Infinity : this.now;
  }

  private fit(): void {
    this.view = [this.begin, this.end];
    this.draw();
  }

  private get isFitted(): boolean {
    return this.view[0] === this.begin && this.view[1] === this.end;
  }

  /** Zooms around the current step, or a position on the axis. */
  private zoom(factor: number, around = this.axis[this.current] ?? (this.view[0] + this.view[1]) / 2): void {
    const [from, to] = this.view;
    const whole = this.end - this.begin;
    const least = whole / Math.max(50, this.axis.length * 2);
    const span = Math.min(Math.max((to - from) / factor, least), whole);
    const left = around - ((around - from) / (to - from)) * span;
    this.view = [left, left + span];
    this.move(0);
  }

  private move(by: number): void {
    const span = this.view[1] - this.view[0];
    const from = Math.min(Math.max(this.view[0] + by, this.begin), this.end - span);
    this.view = [from, from + span];
    this.draw();
  }

  /** In a narrow panel the lanes get most of the width. */
  private get labelWidth(): number {
    return Math.min(widestLabel, Math.round(this.element.clientWidth * 0.34));
  }

  private get plotWidth(): number {
    return Math.max(this.scroller.clientWidth - this.labelWidth - room, 50);
  }

  private shownLanes(): Lane[] {
    return this.lanes.filter((lane) => !this.hidden(lane));
  }

  private drawNow(): void {
    if (!this.trace || this.scroller.clientWidth === 0) return;
    const width = this.scroller.clientWidth;
    this.axisSvg.setAttribute('width', String(width));
    this.lanesSvg.setAttribute('width', String(width));
    this.lanesSvg.setAttribute('height', String(this.shownLanes().length * laneHeight + 4));
    this.axisSvg.replaceChildren();
    this.lanesSvg.replaceChildren();
    this.fill(this.axisSvg, this.lanesSvg, this.plotWidth);
    this.drawCursor(this.cursorTop, this.cursorRows, this.plotWidth);
    this.axisSvg.append(this.cursorTop);
    this.lanesSvg.append(this.cursorRows);
  }

  private fill(top: Element, rows: Element, plot: number): void {
    const lanes = this.shownLanes();
    this.drawAxis(top, rows, plot, lanes.length * laneHeight);
    lanes.forEach((lane, at) => rows.append(this.laneElement(lane, at, plot)));
  }

  private x(at: number, plot: number): number {
    const [from, to] = this.view;
    return this.labelWidth + ((at - from) / (to - from)) * plot;
  }

  private drawAxis(top: Element, rows: Element, plot: number, height: number): void {
    const loop = this.trace?.loop;
    const loopX = typeof loop === 'number' ? Math.max(this.x(this.axis[loop] ?? 0, plot), this.labelWidth) : null;
    // the loop's label is on the right of its beginning, or on the left at the end of the axis
    const loopLabelX = loopX === null ? null : Math.min(loopX + 3, this.labelWidth + plot - loopLabelWidth);
    for (const tick of ticks(this.view[0], this.view[1], plot / 90)) {
      if (this.byStep.on && !Number.isInteger(tick)) continue;
      const x = Math.round(this.x(tick, plot)) + 0.5;
      const label = this.byStep.on ? (tick === 0 ? 'start' : `step ${tick}`) : `${tick} s`;
      top.append(s('line', { class: 'tick', x1: x, x2: x, y1: axisHeight - 5, y2: axisHeight }));
      const hidden = loopLabelX !== null && x > loopLabelX - 28 && x < loopLabelX + loopLabelWidth + 28;
      if (!hidden) top.append(s('text', { class: 'tick-label', x, y: axisHeight - 10, 'text-anchor': 'middle' }, label));
      rows.append(s('line', { class: 'grid', x1: x, x2: x, y1: 0, y2: height }));
    }
    if (loopX === null || loopLabelX === null) return;
    rows.append(s('rect', { class: 'loop', x: loopX, y: 0, width: Math.max(this.labelWidth + plot - loopX, 0), height }));
    top.append(s('text', { class: 'loop-label', x: loopLabelX, y: axisHeight - 10 }, 'repeats ↻'));
  }

  private laneElement(lane: Lane, at: number, plot: number): SVGElement {
    const y = at * laneHeight;
    const group = s('g', { class: `lane ${lane.kind} hue-${this.hues.get(lane.name) ?? hue(lane.name, hues)}`, 'data-lane': lane.name, transform: `translate(0, ${y})` });
    group.append(s('line', { class: 'base', x1: this.labelWidth, x2: this.labelWidth + plot, y1: laneHeight / 2, y2: laneHeight / 2 }));
    for (const drawn of drawBars(lane, this.axis, this.view[0], this.view[1], plot, this.openEnd)) group.append(...this.barElements(lane, drawn));
    group.append(...this.markElements(lane, plot));
    group.append(s('rect', { class: 'label-ground', x: 0, y: 0, width: this.labelWidth - 6, height: laneHeight }),
      s('text', { class: 'label', x: 12, y: 16 }, shorten(lane.name, Math.floor((this.labelWidth - 18) / letter)), s('title', {}, `${lane.name}: ${lane.kind}`)));
    return group;
  }

  /** Diamonds for events, with labels; lines for the steps of other actors, as a single element. */
  private markElements(lane: Lane, plot: number): SVGElement[] {
    if (lane.kind === 'variable') return [];
    const marks = drawMarks(lane, this.axis, this.view[0], this.view[1], plot);
    const isEvent = lane.kind === 'event' || lane.kind === 'environment' || lane.kind === 'property';
    const shape = (x: number): string => (isEvent ? `M${x} 6l5 6-5 6-5-6z` : `M${x} ${laneHeight - 8}v4`);
    const drawn = (some: typeof marks): string => some.map((mark) => shape(Math.round((this.labelWidth + mark.x) * 10) / 10)).join('');
    if (!isEvent || marks.length > 60) return [s('path', { class: isEvent ? 'event-mark' : 'mark', d: drawn(marks) })];
    return marks.map((mark) => s('path', { class: 'event-mark', d: drawn([mark]) },
      s('title', {}, mark.count > 1 ? `${mark.count} steps` : this.stepTip(mark.step))));
  }

  private barElements(lane: Lane, drawn: Drawn): SVGElement[] {
    const x = this.labelWidth + drawn.x;
    const width = Math.max(drawn.width, 2.5);
    const bar = drawn.bar;
    const tone = bar?.tone ?? 'many';
    const hueOf = bar?.tone === 'value' ? ` hue-${hue(bar.label, hues)}` : '';
    const out: SVGElement[] = [s('rect', {
      class: `lane-bar ${tone}${bar?.open ? ' open' : ''}${hueOf}`, x, y: 4, width, height: laneHeight - 8, rx: Math.min(3, width / 2),
    }, width > 3 && s('title', {}, bar ? this.barTip(lane, bar.label, bar.from, bar.open ? null : bar.to, tone) : `${drawn.count} too short to show separately`))];
    const words = bar && (tone === 'value' ? bar.label : tone === 'failure' || tone === 'interrupted' ? tone : '');
    const left = Math.max(x, this.labelWidth);
    if (words && x + width - left > words.length * 6.4 + 10) out.push(s('text', { class: 'bar-label', x: left + 6, y: 16 }, words));
    return out;
  }

  private stepTip(step: number): string {
    const it = this.trace!.steps[step]!;
    return `${step + 1}. ${it.actor}: ${it.description.replaceAll('`', '')}\n${windowOf(it)} s`;
  }

  private barTip(lane: Lane, label: string, from: number, to: number | null, tone: string): string {
    const date = (step: number): string => (step < 0 ? 'the start' : `${this.trace!.steps[step]?.date.exact ?? 0} s`);
    const what = lane.kind === 'variable' ? `${lane.name} = ${label}` : `${lane.name}: ${tone}`;
    return `${what}\nfrom ${date(from)} ${to === null ? 'to the end of the trace' : `to ${date(to)}`}`;
  }

  /** A line at the current step, and a band over its possible dates. */
  private drawCursor(top: Element, rows: Element, plot: number): void {
    const height = this.shownLanes().length * laneHeight;
    const at = this.axis[this.current];
    top.replaceChildren();
    rows.replaceChildren();
    if (at === undefined) return;
    const clamp = (x: number): number => Math.min(Math.max(x, this.labelWidth), this.labelWidth + plot);
    const step = this.trace!.steps[this.current]!;
    if (!this.byStep.on) {
      const left = clamp(this.x(step.earliest.seconds, plot));
      const right = clamp(step.latest ? this.x(step.latest.seconds, plot) : this.labelWidth + plot);
      if (right > left) rows.append(s('rect', { class: 'window', x: left, y: 0, width: right - left, height }));
    }
    const x = this.x(at, plot);
    if (x < this.labelWidth - 1 || x > this.labelWidth + plot + 1) return;
    top.append(s('path', { class: 'cursor-head', d: `M${x - 4} ${axisHeight - 6}h8l-4 6z` }));
    rows.append(s('line', { class: 'cursor', x1: x, x2: x, y1: 0, y2: height }));
  }

  private listen(): void {
    this.scroller.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !event.metaKey && !event.shiftKey && Math.abs(event.deltaY) > Math.abs(event.deltaX)) return;
      event.preventDefault();
      if (event.ctrlKey || event.metaKey) this.zoom(Math.exp(-event.deltaY / 300), this.placeOf(event));
      else this.move(((event.deltaX || event.deltaY) / this.plotWidth) * (this.view[1] - this.view[0]));
    }, { passive: false });
    let from: { x: number; moved: boolean } | null = null;
    this.scroller.addEventListener('pointerdown', (event) => { from = { x: event.clientX, moved: false }; });
    this.scroller.addEventListener('pointermove', (event) => {
      if (!from || event.buttons === 0) return;
      if (Math.abs(event.clientX - from.x) < 4 && !from.moved) return;
      from.moved = true;
      this.move(((from.x - event.clientX) / this.plotWidth) * (this.view[1] - this.view[0]));
      from.x = event.clientX;
    });
    this.scroller.addEventListener('pointerup', (event) => {
      if (from && !from.moved) this.click(event);
      from = null;
    });
  }

  private placeOf(event: MouseEvent): number {
    const x = event.clientX - this.scroller.getBoundingClientRect().left - this.labelWidth;
    return this.view[0] + (x / this.plotWidth) * (this.view[1] - this.view[0]);
  }

  /** The nearest step of the lane under the pointer. */
  private click(event: PointerEvent): void {
    const name = (event.target as Element).closest('[data-lane]')?.getAttribute('data-lane');
    const lane = this.lanes.find((it) => it.name === name);
    const steps = lane?.marks.length ? lane.marks : this.trace!.steps.map((_, index) => index);
    const step = nearest(steps, this.axis, this.placeOf(event));
    if (step !== null) this.events.select(step);
  }

  private key(event: KeyboardEvent): void {
    if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    const part = (this.view[1] - this.view[0]) / 8;
    const keys: { [key: string]: () => void } = {
      '+': () => this.zoom(1.5), '=': () => this.zoom(1.5), '-': () => this.zoom(1 / 1.5), '0': () => this.fit(),
      ArrowLeft: () => this.move(-part), ArrowRight: () => this.move(part),
    };
    const found = keys[event.key];
    if (!found) return;
    found();
    event.preventDefault();
  }
}

const shorten = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most - 1)}…` : text);
