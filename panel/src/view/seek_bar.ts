import type { Trace } from '../api.ts';
import { badTimes, clockTime, fractions, positionAt, type Section } from '../model/seek.ts';
import { h, s } from './dom.ts';

/** Most marks on the bar, and the part of it that a page key moves. */
const kMarks = 400;
const kPage = 1 / 20;
const kWidth = 1000;

export interface SeekEvents {
  select(step: number): void;
  /** to the next or previous step that is shown */
  move(by: 1 | -1): void;
  /** The user goes to a time of a recording whose steps there are not loaded; undefined: to its end. */
  load(time: number | undefined): void;
}

/** A slider over the time of a run, or over the steps of a trace that takes no time. */
export class SeekBar {
  readonly element: HTMLElement;
  private readonly slider: HTMLInputElement;
  private readonly now = h('span', { class: 'seek-time' });
  private readonly whole = h('span', { class: 'seek-time faint' });
  private readonly marks = s('svg', { class: 'seek-marks', viewBox: `0 0 ${kWidth} 10`, preserveAspectRatio: 'none', 'aria-hidden': 'true' });
  private trace: Trace | null = null;
  private steps: readonly number[] = [];
  /** times at which something went wrong */
  private bad: number[] = [];
  private section: Section = { from: 0, to: 0 };
  private current = -1;
  /** of a run that is watched, in seconds */
  private time = 0;

  constructor(private readonly events: SeekEvents) {
    this.slider = h('input', {
      type: 'range', class: 'seek-slider', step: 'any', 'aria-label': 'Time of the run', oninput: () => this.seek(), onchange: () => this.loadIfMissing(),
      onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    this.element = h('div', { class: 'seek', hidden: true }, this.now, h('div', { class: 'seek-track' }, this.marks, this.slider), this.whole);
  }

  /** `steps`: those that the filter shows. */
  show(trace: Trace, steps: readonly number[], current: number): void {
    [this.trace, this.steps] = [trace, steps];
    this.bad = badTimes(trace);
    this.element.hidden = trace.steps.length < 2 && !trace.part;
    this.fit();
    this.drawMarks();
    this.select(current);
  }

  select(index: number): void {
    this.current = index;
    const step = this.trace?.steps[index];
    if (step) this.moveTo(this.isTimeless ? index + 1 : step.date.seconds);
  }

  /** The time of a run that is watched goes on. */
  tick(now: number): void {
    if (now <= this.time) return;
    this.time = now;
    this.fit();
    this.drawMarks();
    this.select(this.current);
  }

  private get isTimeless(): boolean {
    return !this.trace?.part && Math.max(this.trace?.steps.at(-1)?.date.seconds ?? 0, this.time) === 0;
  }

  private fit(): void {
    const { steps, part } = this.trace ?? { steps: [] };
    this.section = this.isTimeless ? { from: 1, to: steps.length } : { from: 0, to: Math.max(steps.at(-1)?.date.seconds ?? 0, this.time, part?.length ?? 0) };
    this.slider.min = String(this.section.from);
    this.slider.max = String(this.section.to);
    this.whole.textContent = this.words(this.section.to);
  }

  private words(position: number): string {
    return this.isTimeless ? `step ${Math.round(position)}` : clockTime(position);
  }

  private moveTo(position: number): void {
    this.slider.value = String(position);
    this.now.textContent = this.words(position);
    const { from, to } = this.section;
    this.element.style.setProperty('--seek', String((position - from) / (to - from || 1)));
    const count = this.trace?.steps.length ?? 0;
    this.slider.setAttribute('aria-valuetext', this.isTimeless ? `step ${this.current + 1} of ${count}` : `${this.words(position)} of ${this.words(this.section.to)}, step ${this.current + 1} of ${count}`);
  }

  /** The loaded part of a longer recording, and what went wrong. */
  private drawMarks(): void {
    this.marks.replaceChildren();
    if (!this.trace || this.isTimeless) return;
    const { from, to } = this.section;
    const x = (time: number): number => ((time - from) / (to - from || 1)) * kWidth;
    const { part } = this.trace;
    if (part) this.marks.append(s('rect', { class: 'seek-part', x: x(part.begin), y: 0, width: Math.max(x(part.end) - x(part.begin), 3), height: 10 }));
    const bad = fractions(this.bad, this.section, kMarks);
    if (bad.length > 0) this.marks.append(s('path', { class: 'seek-bad', d: bad.map((at) => `M${at * kWidth} 0v10`).join('') }));
  }

  /** Whether the steps at a time are not loaded. */
  private isMissing(time: number): boolean {
    const part = this.trace?.part;
    return !!part && (time < part.begin || time > part.end);
  }

  /** The user moves the slider. */
  private seek(): void {
    if (!this.trace) return;
    const position = Number(this.slider.value);
    if (this.isMissing(position)) return this.moveTo(position);
    const at = this.isTimeless ? this.nearestShown(Math.round(position) - 1) : positionAt(this.trace, this.steps, position);
    const step = this.steps[at];
    if (step === undefined) return this.select(this.current);
    if (step !== this.current) this.events.select(step);
    this.moveTo(position);
  }

  private nearestShown(index: number): number {
    return Math.max(this.steps.findLastIndex((step) => step <= index), 0);
  }

  private loadIfMissing(): void {
    const time = Number(this.slider.value);
    if (this.isMissing(time)) this.events.load(time);
    else this.select(this.current);
  }

  private goTo(position: number): void {
    const { from, to } = this.section;
    this.slider.value = String(Math.min(Math.max(position, from), to));
    this.seek();
    this.loadIfMissing();
  }

  /** Arrows go from step to step, since many can have the same time. */
  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const page = (this.section.to - this.section.from) * kPage;
    const at = Number(this.slider.value);
    const keys: { [key: string]: () => void } = {
      ArrowRight: () => this.events.move(1), ArrowUp: () => this.events.move(1), ArrowLeft: () => this.events.move(-1), ArrowDown: () => this.events.move(-1),
      PageUp: () => this.goTo(at + page), PageDown: () => this.goTo(at - page), Home: () => this.first(), End: () => this.last(),
    };
    const found = keys[event.key];
    if (!found) return;
    found();
    event.preventDefault();
    event.stopPropagation();
  }

  private first(): void {
    if (this.isMissing(0) && this.trace?.part?.begin !== 0) this.events.load(0);
    else if (this.steps[0] !== undefined) this.events.select(this.steps[0]);
  }

  private last(): void {
    const last = this.steps.at(-1);
    if (this.isMissing(this.section.to)) this.events.load(undefined);
    else if (last !== undefined) this.events.select(last);
  }
}
