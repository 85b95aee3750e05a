import type { ChosenRun, ChosenStep, Host, Program, Simulation } from '../api.ts';
import type { ActorColours } from '../model/colours.ts';
import { chosenStep } from '../model/chosen_run.ts';
import { skillOf } from '../model/picture.ts';
import { testOf } from '../model/saved_run.ts';
import { fileName } from '../model/export.ts';
import { AutomatonView } from './automaton_view.ts';
import { ChoicesView } from './choices_view.ts';
import { foot, h, isTyping, plural, prose } from './dom.ts';
import { button, enable } from './icons.ts';
import type { Saver } from './save.ts';
import { splitter } from './splitter.ts';
import { TraceView } from './trace_view.ts';

export interface SimulationEvents {
  openFile(): void;
  remember(run: ChosenRun): void;
  stepped(byUser: boolean): void;
}

/** A simulation, whose steps the user chooses in a list or in an automaton. After an edit its steps are replayed. */
export class SimulationView {
  readonly element: HTMLElement;
  private readonly choices: ChoicesView;
  private readonly trace: TraceView;
  private readonly automaton: AutomatonView;
  private readonly notice = h('div', { class: 'notice', role: 'status', hidden: true });
  private readonly undoing: HTMLButtonElement;
  private readonly again: HTMLButtonElement;
  private readonly returning: HTMLButtonElement;
  private readonly saving: HTMLButtonElement;
  /** all requested steps, including those that are not possible now */
  private run: ChosenRun = { steps: [] };
  private now: Simulation | null = null;
  private program: Program | null = null;
  private begun = false;
  private asked = 0;

  constructor(private readonly host: Host, private readonly saver: Saver, private readonly events: SimulationEvents, colours: ActorColours) {
    this.choices = new ChoicesView({ take: (index, late) => void this.take(index, late), look: (index) => this.automaton.point(index) }, colours);
    this.automaton = new AutomatonView(host, saver, () => this.offer(), colours);
    this.trace = new TraceView(host, saver, {
      stepped: (byUser) => { this.update(); events.stepped(byUser); }, openFile: () => events.openFile(), pinned: () => undefined, watches: () => undefined,
    }, colours, 'run-step');
    this.undoing = button({ icon: 'previous', text: 'Undo', title: 'Take the last step back (Backspace)', onclick: () => void this.undo() });
    this.again = button({ icon: 'first', text: 'Start', title: 'Back to the start', onclick: () => void this.backTo(0) });
    this.returning = button({ icon: 'again', text: 'Go on from here', title: 'Take back what came after the marked step', onclick: () => void this.backTo(this.trace.current + 1) });
    this.saving = button({ icon: 'download', text: 'Save as a test', title: 'The steps, and the values that they lead to, for `proskill replay`', onclick: () => this.save() });
    const left = h('div', { class: 'simulation-left' }, this.choices.element, this.trace.element);
    const body = h('div', { class: 'simulation-body' }, left, splitter('vertical', this.automaton.element, 'automaton'), this.automaton.element);
    this.element = h('div', { class: 'simulation-view', onkeydown: (event: KeyboardEvent) => this.key(event) },
      h('div', { class: 'bar toolbar', role: 'toolbar', 'aria-label': 'Simulation' }, this.undoing, this.again, this.returning, h('span', { class: 'push' }),
        this.saving, button({ icon: 'open', text: 'Open a run', title: 'Replay a run that was saved', onclick: () => events.openFile() })),
      body, foot(this.notice));
  }

  setProgram(program: Program): void {
    this.program = program;
    this.trace.setOthers(program.verdicts);
    if (this.begun && program.pictures.length > 0) this.automaton.setProgram(program);
  }

  /** Nothing is requested before the view is visible. */
  private start(): void {
    this.begun = true;
    if (this.program) this.setProgram(this.program);
  }

  /** The view becomes visible for the first time. */
  async begin(run?: ChosenRun): Promise<void> {
    if (this.begun) return;
    this.start();
    await this.ask(run ?? { steps: [] }, false);
  }

  /** Replays a run. */
  async open(run: ChosenRun): Promise<void> {
    this.start();
    await this.ask(run, true);
    this.choices.focus();
  }

  /** The text changed: replays the steps. */
  async replay(): Promise<void> {
    if (!this.begun) return;
    await this.automaton.load(true);
    await this.ask(this.run, false);
  }

  focus(): void {
    this.choices.focus();
  }

  /** The theme changed. */
  redraw(): void {
    void this.automaton.load(true);
  }

  private async ask(run: ChosenRun, byUser: boolean): Promise<void> {
    const request = ++this.asked;
    try {
      const now = await this.host.request('simulate', run);
      if (request !== this.asked) return;
      this.run = run;
      this.show(now, byUser);
    } catch (error) {
      if (request === this.asked) this.fail((error as Error).message);
    }
  }

  private fail(why: string): void {
    this.say(this.now ? `${why}. This is the run as it was before.` : why, 'stale');
    this.choices.show(this.now?.choices ?? [], this.now?.trace ?? { name: '', description: '', verdict: '', initial: {}, steps: [] }, false);
    this.automaton.offer([], () => undefined);
  }

  private show(now: Simulation, byUser: boolean): void {
    const former = this.now;
    this.now = now;
    const last = now.trace.steps.length - 1;
    if (!former || byUser) {
      if (former) this.trace.renew(now.trace, false);
      else this.trace.show(now.trace, last, byUser);
      this.trace.goTo(last);
    } else this.trace.renew(now.trace, false);
    this.choices.show(now.choices, now.trace, true);
    this.tell(now);
    this.offer();
    const here = now.trace.steps.at(-1)?.location;
    if (here) this.automaton.follows(here);
    this.update();
    this.events.remember(this.run);
  }

  /** The result of the run as a test. */
  private tell(now: Simulation): void {
    const { steps, expect } = this.run;
    const wanted = now.missing && steps[now.missing.index];
    if (now.missing && wanted)
      return this.say(`Step ${now.missing.index + 1} of ${steps.length} is not possible any more: \`${wanted.actor}\` ${wanted.description}; ${now.missing.why}. ` +
        'The run stops before it, and is tried again after each edit.', 'stale');
    if (now.unmet.length > 0)
      return this.say(`The run ends otherwise than expected: ${now.unmet.map((it) => `\`${it.variable}\` is ${it.actual || 'not there'}, expected ${it.expected}`).join('; ')}.`, 'stale');
    if (expect) return this.say(`The test passes: ${plural(steps.length, 'step')}, ${plural(Object.keys(expect).length, 'value')} as expected.`, 'passed');
    this.say('', '');
  }

  private say(words: string, kind: 'stale' | 'passed' | ''): void {
    this.notice.replaceChildren(prose(words));
    this.notice.hidden = words === '';
    this.notice.className = `notice ${kind}`;
  }

  /** Offers the possible steps that the picture shows there. */
  private offer(): void {
    if (!this.now) return;
    const places = this.now.choices.map(({ location }) => location);
    const anyShown = this.automaton.offer(places, (indices) => (indices.length === 1 ? void this.take(indices[0]!, false) : this.choices.offer(indices)));
    const next = this.now.choices[0];
    if (!anyShown && next) this.automaton.showOf(skillOf(next.actor));
  }

  private take(index: number, late: boolean): Promise<void> {
    const choice = this.now?.choices[index];
    if (!choice) return Promise.resolve();
    return this.go([...this.now!.trace.steps.map(chosenStep), chosenStep({ ...choice, late })]);
  }

  private undo(): Promise<void> {
    return this.backTo((this.now?.trace.steps.length ?? 0) - 1);
  }

  private async backTo(count: number): Promise<void> {
    if (this.now && count >= 0 && count <= this.now.trace.steps.length) await this.go(this.now.trace.steps.slice(0, count).map(chosenStep));
  }

  /** With a step of the user it is no longer the run that was opened. */
  private async go(steps: ChosenStep[]): Promise<void> {
    const { main } = this.run;
    await this.ask({ steps, ...(main && { main }) }, true);
    this.choices.focus();
  }

  private save(): void {
    void this.saver.text(fileName(this.now!.main || 'program', 'run.json'), 'application/json', testOf(this.now!, this.program?.program ?? ''));
  }

  private update(): void {
    const count = this.now?.trace.steps.length ?? 0;
    const none = count === 0 ? 'No step was taken yet' : null;
    enable(this.undoing, none, 'Take the last step back (Backspace)');
    enable(this.again, none, 'Back to the start');
    enable(this.saving, none, 'Save the steps, and the values that they lead to, for `proskill replay`');
    enable(this.returning, none ?? (this.trace.current === count - 1 ? 'The marked step is the last one' : null), 'Take back what came after the marked step');
  }

  private key(event: KeyboardEvent): void {
    if (isTyping(event) || event.key !== 'Backspace') return;
    event.preventDefault();
    void this.undo();
  }
}
