import type { Host, Live, Run, RunControl, RunProperty, RunSignal, RunStatus, Trace } from '../api.ts';
import { activeAt, messagesAt, type Active } from '../model/active.ts';
import { skillOf } from '../model/picture.ts';
import { Running } from '../model/running.ts';
import { h, plural, prose } from './dom.ts';
import { button, enable, icon, toggle } from './icons.ts';

export interface RunEvents {
  /** Shows the trace: it has more steps, or is another one. `toLast`: the newest step becomes the current one. */
  show(trace: Trace, isSame: boolean, toLast: boolean): void;
  /** The time of the run, in seconds. */
  tick(now: number, following: boolean): void;
  say(words: string): void;
  goTo(step: number): void;
}

/** Milliseconds between two pictures of the time. */
const frame = 150;

/** A run while it happens: its steps arrive by themselves, and people may pause it, and send it events and interrupts. */
export class RunView {
  readonly bar: HTMLElement;
  readonly side: HTMLElement;
  private readonly running: Running;
  private readonly state = h('span', { class: 'run-state', role: 'status' });
  private readonly clock = h('span', { class: 'run-clock' });
  private readonly buttons: { pause: HTMLButtonElement; step: HTMLButtonElement; go: HTMLButtonElement; end: HTMLButtonElement };
  private readonly follow;
  private readonly signals: { signal: RunSignal; button: HTMLButtonElement }[];
  private readonly properties = new Map<string, HTMLButtonElement>();
  private readonly waiting = h('p', { class: 'run-waiting faint', role: 'status', hidden: true });
  private fetching = false;

  constructor(private readonly host: Host, private readonly run: Run, private readonly events: RunEvents) {
    this.running = new Running(run);
    const control = (what: RunControl['do']) => (): void => void this.control({ do: what });
    this.buttons = {
      go: button({ icon: 'go', text: 'Continue', title: 'Continue', onclick: control('continue') }),
      pause: button({ icon: 'pause', text: 'Pause', title: 'Pause', onclick: control('pause') }),
      step: button({ icon: 'next', text: 'Step', title: 'One step', onclick: control('step') }),
      end: button({ icon: 'stop', text: 'End', title: 'End', onclick: () => void this.control({ do: this.running.status.state === 'ended' ? 'close' : 'end' }) }),
    };
    this.follow = toggle({ icon: 'last', text: 'Follow the run', title: 'The newest step is the current one; a step back ends this', on: true, changed: (on) => on && this.show(true) });
    this.follow.element.classList.add('follow-run');
    this.bar = h('div', { class: 'bar toolbar run-bar', role: 'toolbar', 'aria-label': 'Run' }, this.state, this.clock,
      this.buttons.pause, this.buttons.go, this.buttons.step, h('span', { class: 'divider' }), this.follow.element, h('span', { class: 'push' }), this.buttons.end);
    this.signals = run.signals.map((signal) => ({ signal, button: this.signalButton(signal) }));
    this.side = h('aside', { class: 'run-side', 'aria-label': 'Send to the run' },
      ...this.propertySection(), ...this.section('Events', false), ...this.section('Interrupt', true), this.waiting);
    window.setInterval(() => this.tick(), frame);
  }

  /** The first steps, and those to come. */
  begin(): void {
    this.tick();
    this.events.show(this.running.trace, false, true);
    this.take(this.run.status);
  }

  take(status: RunStatus): void {
    this.running.take(status);
    this.draw();
    this.tick();
    void this.fetch();
  }

  /** A current step that the user has chosen ends the following, unless it is the newest. */
  chosen(index: number): void {
    if (index !== this.running.trace.steps.length - 1) this.follow.set(false);
  }

  /** The host has ended. */
  gone(): void {
    for (const it of [...Object.values(this.buttons), ...this.signals.map(({ button }) => button)]) enable(it, 'proskill has ended', '');
  }

  /** What the run does after a step; -1: at the start. */
  at(index: number): { active: Active[]; live: Live } {
    const { trace, status } = this.running;
    const isOver = status.state === 'ended' && index === trace.steps.length - 1;
    const active = isOver ? [] : activeAt(this.run, trace, index);
    return { active, live: { active: active.map(({ location }) => location), messages: messagesAt(trace, index) } };
  }

  private signalButton(signal: RunSignal): HTMLButtonElement {
    const { name, interrupts } = signal;
    return h('button', { type: 'button', class: 'signal', 'data-signal': name, onclick: () => void this.control({ do: 'send', signal: name }) },
      icon(interrupts ? 'interrupt' : 'event'), h('span', { class: 'words' }, name));
  }

  private propertySection(): HTMLElement[] {
    const { properties } = this.run;
    for (const it of properties)
      this.properties.set(it.name, h('button', { type: 'button', class: 'signal property', 'data-property': it.name, onclick: () => this.showProperty(it) }));
    return properties.length === 0 ? [] : [h('h3', {}, 'Properties'), ...this.properties.values()];
  }

  /** The remark that decides a property; -1: none so far. */
  private decidedBy(name: string): number {
    return this.running.trace.steps.findLastIndex(({ actor, remark }) => actor === name && (remark === 'holds' || remark === 'violated'));
  }

  /** Shows its place, and the step that decides it, if any. */
  private showProperty({ name, location }: RunProperty): void {
    const step = this.decidedBy(name);
    if (step >= 0) this.events.goTo(step);
    if (location) this.host.tell('reveal', { location, focus: false });
  }

  private drawProperty({ name, description, verdict, whyNot }: RunProperty, it: HTMLButtonElement): void {
    const decision = this.running.verdictOf(name) ?? verdict;
    if (it.dataset['verdict'] === decision) return;
    it.dataset['verdict'] = decision;
    it.title = `${description}: ${decision}${whyNot ? `, ${whyNot}` : ''}`;
    it.replaceChildren(icon(decision === 'true' ? 'good' : decision === 'false' ? 'bad' : 'open_question'), h('span', { class: 'words' }, name),
      h('span', { class: 'verdict-word' }, whyNot ? 'not monitored' : decision));
  }

  private section(title: string, interrupts: boolean): HTMLElement[] {
    const some = this.signals.filter(({ signal }) => signal.interrupts === interrupts);
    return some.length === 0 ? [] : [h('h3', {}, title), ...some.map((it) => it.button)];
  }

  private async control(params: RunControl): Promise<void> {
    try {
      this.take(await this.host.request('control', params));
    } catch (error) {
      this.events.say((error as Error).message);
    }
  }

  /** Requests what is missing, and then rests for longer than it took to show it. */
  private async fetch(): Promise<void> {
    if (this.fetching) return;
    this.fetching = true;
    try {
      while (!this.running.isComplete) {
        const answer = await this.host.request('steps', { from: this.running.next });
        if (answer.steps.length === 0) break;
        const began = performance.now();
        const isSame = this.running.add(answer);
        this.show(this.follow.on, isSame);
        await new Promise((done) => setTimeout(done, 2 * (performance.now() - began)));
      }
    } catch (error) {
      this.events.say((error as Error).message);
    } finally {
      this.fetching = false;
    }
  }

  private show(toLast: boolean, isSame = true): void {
    this.events.show(this.running.trace, isSame, toLast);
    this.draw();
    this.tick();
  }

  private tick(): void {
    const { now, status } = this.running;
    this.clock.textContent = `${now.toFixed(1)} s`;
    if (!document.hidden) this.events.tick(status.state === 'ended' ? status.date : now, this.follow.on);
  }

  private draw(): void {
    const { status } = this.running;
    const { state } = status;
    this.bar.dataset['state'] = state;
    this.state.replaceChildren(h('span', { class: `run-light ${state}` }), h('span', { class: 'words' }, prose(this.words())));
    const isOver = state === 'ended' ? 'The run has ended' : null;
    const none = isOver ?? this.run.whyNoControl;
    const noPause = none ?? this.run.whyNoPause;
    this.buttons.pause.hidden = state === 'paused';
    this.buttons.go.hidden = state !== 'paused';
    enable(this.buttons.pause, noPause, 'Pause: the time of the run stands still');
    enable(this.buttons.go, noPause, 'Continue');
    enable(this.buttons.step, noPause ?? (state === 'paused' ? null : 'Pause it first'), 'The next step, at once');
    enable(this.buttons.end, isOver ? null : this.run.whyNoControl, isOver ? 'End proskill: this page keeps what it shows' : 'End the run: its actions are asked to stop');
    const { active } = this.at(this.running.trace.steps.length - 1);
    const running = new Set(active.map(({ actor }) => skillOf(actor)));
    for (const { signal, button: it } of this.signals) this.drawSignal(signal, it, none, running.has(signal.name));
    for (const it of this.run.properties) this.drawProperty(it, this.properties.get(it.name)!);
    this.waiting.hidden = status.waiting === 0;
    this.waiting.textContent = `${plural(status.waiting, 'signal waits', 'signals wait')} until the run goes on`;
  }

  private drawSignal({ name, interrupts, whyNot }: RunSignal, it: HTMLButtonElement, none: string | null, runs: boolean): void {
    it.classList.toggle('runs', interrupts && runs);
    enable(it, none ?? whyNot ?? (runs || !interrupts ? null : `${name} is not running`), `${interrupts ? 'Interrupt' : 'Send'} ${name}`);
  }

  private words(): string {
    const { state, end, lost } = this.running.status;
    const missing = [lost > 0 && `${plural(lost, 'step')} came too fast to be shown`,
      this.running.skipped > 0 && `the first ${plural(this.running.skipped, 'step')} are no longer kept`].filter(Boolean).map((it) => `; ${it}`).join('');
    if (state !== 'ended' || !end) return `${state}, ${this.run.clock}${missing}`;
    const bad = end.bad > 0 ? `; ${plural(end.bad, 'thing')} should not have happened` : '';
    return `${end.why}${end.mission ? `: ${end.mission}` : ''}${end.failure ? ` (${end.failure})` : ''}${bad}${missing}`;
  }
}
