import type { Hello, Host, News, NewsOf, Program, Remembered, Show, Told, Trace, Verdict } from '../api.ts';
import { ActorColours } from '../model/colours.ts';
import { runOf } from '../model/chosen_run.ts';
import { open } from '../model/parse.ts';
import { withChanges } from '../model/verdict_changes.ts';
import { AutomatonView } from './automaton_view.ts';
import { h } from './dom.ts';
import { EarlyKeys } from './early_keys.ts';
import { button, enable } from './icons.ts';
import { RunView } from './run_view.ts';
import { Saver } from './save.ts';
import { SimulationView } from './simulation_view.ts';
import { SourceView } from './source_view.ts';
import { splitter } from './splitter.ts';
import { stateWords } from './state_words.ts';
import { followTheme, inVsCode, switchTheme } from './theme.ts';
import { TraceView } from './trace_view.ts';
import { markOf, VerdictsView } from './verdicts_view.ts';

type Tab = 'trace' | 'automaton' | 'simulation';

/** Requests programs from the host, and shows them. */
export async function start(root: HTMLElement, host: Host): Promise<void> {
  const keys = new EarlyKeys(root);
  try {
    new App(root, host, keys, await host.request('hello', {}));
  } catch (error) {
    root.replaceChildren(h('div', { class: 'empty' }, h('p', {}, 'The panel could not be opened.'), h('p', { class: 'faint' }, (error as Error).message)));
  }
}

class App {
  private readonly root: HTMLElement;
  private readonly host: Host;
  /** in the layout that shows them */
  private readonly verdicts: VerdictsView | null;
  private readonly source: SourceView | null;
  private readonly trace: TraceView;
  private readonly automaton: AutomatonView;
  private readonly simulation: SimulationView | null;
  private readonly run: RunView | null;
  private readonly tabs = new Map<Tab, { tab: HTMLButtonElement; panel: HTMLElement }>();
  private readonly title = h('h1', {}, 'ProSkill');
  private readonly state = h('span', { class: 'state', role: 'status' });
  private readonly toast = h('div', { class: 'toast', role: 'status', hidden: true });
  private readonly again: HTMLButtonElement;
  private readonly remembered: Remembered;
  private readonly colours = new ActorColours();
  private readonly opened = new Map<string, Trace>();
  private program: Program | null = null;
  private toastTimer = 0;
  /** what was shown last and has to be verified again first */
  private wanted: { trace: string; step?: number } | null = null;
  /** counts requested traces, so that a late answer does not replace a newer one */
  private asked = 0;
  /** the number of a requested trace that has not come yet, or 0 */
  private pending = 0;
  /** the program before a verification that ended while a trace was requested */
  private unrenewed: Program | null = null;

  constructor(root: HTMLElement, host: Host, private readonly keys: EarlyKeys, private readonly hello: Hello) {
    this.root = root;
    // the last picture and simulation without errors are shown until there are others
    this.host = this.watched(host, () => this.program?.state === 'errors');
    this.remembered = { ...hello.remembered };
    const saver = new Saver(this.host, hello.can.save, (words) => this.say(words));
    this.verdicts = hello.layout === 'all' && !hello.run ? new VerdictsView((verdict, focus) => void this.choose(verdict, focus)) : null;
    this.source = hello.can.source ? new SourceView(this.host, (location) => this.automaton.follows(location)) : null;
    this.automaton = new AutomatonView(this.host, saver, (picture) => this.remember({ picture }), this.colours);
    this.trace = new TraceView(this.watched(host, () => true), saver, {
      stepped: (byUser) => this.stepped(byUser), openFile: () => this.openFile(), pinned: (pinned) => this.remember({ pinned }),
      watches: (watches) => this.remember({ watches }),
    }, this.colours);
    this.simulation = hello.can.simulate && (hello.layout === 'all' || hello.layout === 'simulation')
      ? new SimulationView(this.host, saver, { openFile: () => this.openFile(), remember: (run) => this.remember({ run }), stepped: () => undefined }, this.colours) : null;
    this.run = hello.run ? new RunView(this.host, hello.run, { show: (...it) => this.showRun(...it), tick: (...it) => this.trace.tick(...it), say: (words) => this.say(words), goTo: (step) => this.trace.goTo(step) }) : null;
    this.trace.pin(this.remembered.pinned ?? []);
    this.trace.remember(this.remembered.watches ?? []);
    this.again = button({ icon: 'again', title: 'Verify again', onclick: () => void this.host.request('verify', {}).catch((error: Error) => this.say(error.message)) });
    followTheme(() => { void this.automaton.load(true); this.simulation?.redraw(); });
    this.draw();
    this.host.onNews((...news) => this.news(news));
    void this.begin();
  }

  /** The host, with calls to show places passed on to the source view, if there is one. `isOld`: they are places in the text that was verified. */
  private watched(host: Host, isOld: () => boolean): Host {
    return {
      request: (method, params) => host.request(method, params),
      onNews: (listener) => host.onNews(listener),
      tell: (method, params) => {
        host.tell(method, params);
        if (method === 'step' && params === null) this.source?.mark(null);
        if (method === 'reveal') void this.source?.reveal(params as Told['reveal'], isOld());
      },
    };
  }

  private draw(): void {
    const { layout } = this.hello;
    document.body.classList.add(`layout-${layout}`);
    if (layout === 'trace') {
      // the keyboard moves through steps
      window.addEventListener('focus', () => document.activeElement === document.body && this.focusTrace());
      return this.root.replaceChildren(this.trace.element, this.toast);
    }
    if (layout === 'automaton') return this.root.replaceChildren(this.automaton.element, this.toast);
    if (layout === 'simulation') return this.root.replaceChildren(this.simulation?.element ?? h('div', { class: 'empty' }, 'This cannot be simulated.'), this.toast);
    if (this.run) return this.drawRun(this.run);
    const main = h('main', {}, this.tabList());
    for (const { panel } of this.tabs.values()) main.append(panel);
    const body = h('div', { class: 'app-body' }, this.verdicts?.element ?? '', main);
    if (this.source) body.append(splitter('vertical', this.source.element, 'source'), this.source.element);
    this.root.replaceChildren(this.head(this.hello.can.verify && this.again,
      button({ icon: 'open', title: 'Open a trace or a report from a file', onclick: () => this.openFile() })), body, this.toast);
    this.select('trace');
  }

  private head(...buttons: (HTMLElement | false)[]): HTMLElement {
    return h('header', { class: 'app-head' }, this.title, this.state, h('span', { class: 'push' }), ...buttons,
      !inVsCode() && button({ icon: 'theme', title: 'Light or dark', onclick: () => switchTheme() }));
  }

  /** The steps and an automaton side by side, since both show what happens now. */
  private drawRun({ bar, side }: RunView): void {
    const main = h('main', { class: 'run-main' }, this.trace.element, splitter('vertical', this.automaton.element, 'automaton'), this.automaton.element);
    const body = h('div', { class: 'app-body' }, side, main);
    if (this.source) body.append(splitter('vertical', this.source.element, 'source'), this.source.element);
    this.root.replaceChildren(this.head(), bar, body, this.toast);
  }

  private showRun(trace: Trace, isSame: boolean, toLast: boolean): void {
    isSame ? this.trace.grow(trace, toLast) : this.trace.show(trace, undefined, false);
    const location = trace.steps.findLast((step) => step.location)?.location;
    if (toLast && location) this.automaton.follows(location);
    this.shine();
  }

  /** The states of the run after the current step. */
  private shine(): void {
    if (!this.run) return;
    const { active, live } = this.run.at(this.trace.current);
    this.automaton.shine(active, this.trace.valuesNow());
    this.source?.shine(live);
    this.host.tell('shine', live);
  }

  private tabList(): HTMLElement {
    const list = h('div', { class: 'tabs', role: 'tablist', 'aria-label': 'Views', onkeydown: (event: KeyboardEvent) => this.tabKey(event) });
    const add = (name: Tab, words: string, content: HTMLElement): void => {
      const tab = h('button', { type: 'button', role: 'tab', id: `tab-${name}`, class: 'tab', 'aria-controls': `panel-${name}`, onclick: () => this.select(name) }, words);
      this.tabs.set(name, { tab, panel: h('div', { class: 'tab-panel', role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}` }, content) });
      list.append(tab);
    };
    add('trace', 'Trace', this.trace.element);
    add('automaton', 'Automata', this.automaton.element);
    if (this.simulation) add('simulation', 'Simulation', h('div', { class: 'empty' }));
    return list;
  }

  /** The list of steps takes keys, those included that were pressed while the trace was read. */
  private focusTrace(): void {
    this.trace.focus();
    const list = document.activeElement;
    if (this.trace.trace && list && this.trace.element.contains(list)) this.keys.pass(list);
  }

  private tabKey(event: KeyboardEvent): void {
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    const names = [...this.tabs.keys()];
    const at = names.findIndex((name) => !this.tabs.get(name)!.panel.hidden);
    const other = names[(at + (event.key === 'ArrowRight' ? 1 : names.length - 1)) % names.length]!;
    this.select(other);
    this.tabs.get(other)!.tab.focus();
  }

  private select(name: Tab): void {
    for (const [key, { tab, panel }] of this.tabs) {
      tab.setAttribute('aria-selected', String(key === name));
      tab.tabIndex = key === name ? 0 : -1;
      panel.hidden = key !== name;
    }
    if (name !== 'simulation' || !this.simulation) return;
    const { panel } = this.tabs.get(name) ?? {};
    if (panel && !panel.contains(this.simulation.element)) panel.replaceChildren(this.simulation.element);
    void this.simulation.begin(this.remembered.run);
  }

  /** Shows what the host requests, else what was shown last, else the first finding. */
  private async begin(): Promise<void> {
    const { picture, trace, step, run } = this.remembered; // later actions also need to be remembered
    const first = this.hello.show?.picture ?? picture;
    if (first) this.automaton.expect(first);
    if (this.hello.program) this.take(this.hello.program);
    if (this.run) return this.run.begin();
    if (this.hello.show) await this.show(this.hello.show);
    else {
      if (picture) await this.show({ picture });
      if (trace && !(await this.reopen(trace, step))) this.wanted = { trace, ...(step !== undefined && { step }) };
    }
    if (this.hello.layout === 'simulation') await this.simulation?.begin(run);
    if (this.hello.layout === 'trace' && document.hasFocus() && document.activeElement === document.body) this.focusTrace();
    await this.showFirst();
  }

  /** The first choice of a trace: the only one, or the first violated property; those of the program come first. */
  private async showFirst(): Promise<void> {
    const verdicts = this.program?.verdicts ?? [];
    const violated = verdicts.filter((verdict) => markOf(verdict) === 'error' && verdict.steps !== null);
    const only = verdicts.length === 1 && verdicts[0]!.steps !== null ? verdicts[0] : undefined;
    const first = violated.find(({ kind }) => kind === 'property') ?? violated[0] ?? only;
    if (this.hello.layout === 'all' && this.trace.name === null && first && !this.tabs.get('trace')?.panel.hidden) await this.choose(first, true, document.body);
  }

  private async show(show: Show): Promise<void> {
    if (show.picture) {
      this.select('automaton');
      await this.automaton.show(show.picture.kind, show.picture.name);
    }
    if (show.run) {
      this.select('simulation');
      await this.simulation?.open(show.run);
    }
    if (show.at) this.automaton.goTo(show.at);
    if (show.given) {
      this.opened.set(show.given.name, show.given);
      this.openTrace(show.given, show.step);
    } else if (show.trace && show.trace !== this.trace.trace?.name) await this.fetchTrace(show.trace, show.step);
    else if (show.step !== undefined && this.trace.trace) this.trace.goTo(show.step);
  }

  /** Restores what was shown last, without moving other views. */
  private reopen(trace: string, step?: number): Promise<boolean> {
    return this.fetchTrace(trace, step, false);
  }

  /** Whether it is still to be shown: something else may have been requested meanwhile. */
  private async fetchTrace(name: string, step?: number, byUser = true): Promise<boolean> {
    const request = (this.pending = ++this.asked);
    if (byUser) this.wanted = null;
    if (byUser) this.trace.list.holdKeys();
    try {
      const trace = this.opened.get(name) ?? (await this.host.request('trace', { name }));
      if (request !== this.asked) return false;
      this.openTrace(trace, step, byUser);
      return true;
    } catch (error) {
      if (request === this.asked && byUser) this.say((error as Error).message);
      return false;
    } finally {
      if (request === this.pending) this.endRequest();
    }
  }

  /** Catches up on the keys and on the renewal that a requested trace has delayed. */
  private endRequest(): void {
    this.trace.list.releaseKeys();
    const former = this.unrenewed;
    this.pending = 0;
    this.unrenewed = null;
    if (former) void this.renewTrace(former);
  }

  private openTrace(trace: Trace, step?: number, byUser = true): void {
    this.wanted = null;
    this.select('trace');
    this.trace.show(trace, step, byUser);
    this.trace.markStale(this.isStale(trace));
    this.verdicts?.select(trace.name);
  }

  /** The text may have changed since the trace was requested. One from a file does not depend on the program. */
  private isStale(trace?: Trace): boolean {
    return trace?.stale === true || (this.program?.stale === true && !this.opened.has(this.trace.name ?? ''));
  }

  /** `keyboard`: what had the focus when the user chose it, or the page if nobody did. A user who has moved the focus elsewhere keeps it. */
  private async choose(verdict: Verdict, focus: boolean, keyboard = document.activeElement): Promise<void> {
    if (verdict.steps !== null) {
      const isShown = await this.fetchTrace(verdict.name);
      if (isShown && focus && (document.activeElement === keyboard || document.activeElement === document.body)) this.focusTrace();
    } else {
      this.say(verdict.reason || `${verdict.verdict}: there is no trace for this verdict`);
      if (verdict.location) this.host.tell('reveal', { location: verdict.location, focus: false });
    }
  }

  private stepped(byUser: boolean): void {
    const { trace, current } = this.trace;
    if (byUser) this.run?.chosen(current);
    this.shine();
    this.remember({ trace: trace!.name, step: current });
    const location = trace!.steps[current]?.location ?? null;
    if (!byUser) this.source?.mark(location);
    else if (location && this.source) this.automaton.follows(location);
  }

  private remember(more: Remembered): void {
    Object.assign(this.remembered, more);
    this.host.tell('remember', { ...this.remembered });
  }

  private takeNews({ verdicts, changed = [], ...rest }: News['program']): void {
    this.take({ ...rest, verdicts: verdicts ?? withChanges(this.program?.verdicts ?? [], changed) });
  }

  private take(program: Program): void {
    const former = this.program;
    this.program = program;
    this.colours.setProgram(program);
    document.title = `${program.label} – ProSkill`;
    this.title.textContent = program.label;
    this.state.textContent = stateWords(program);
    this.state.className = `state ${program.state}${program.stale ? ' stale' : ''}`;
    enable(this.again, program.state === 'checking' ? 'It is being verified' : null, 'Verify again');
    this.verdicts?.show(program);
    if (program.verdicts !== former?.verdicts) this.trace.setOthers(program.verdicts);
    this.trace.markStale(this.isStale());
    if (program.pictures.length > 0 && this.hello.layout !== 'trace') this.automaton.setProgram(program);
    this.simulation?.setProgram(program);
    void this.source?.setProgram(program);
    if (program.state === 'done' && !program.stale) {
      if (this.wanted) void this.reopen(this.wanted.trace, this.wanted.step);
      else if (former) void this.renewTrace(former);
    }
    if (former && this.trace.name === null) void this.showFirst();
  }

  /** After another verification there may be another trace, or none. The step remains current, and nothing else moves. */
  private async renewTrace(former: Program): Promise<void> {
    if (this.pending !== 0) {
      this.unrenewed ??= former; // the requested trace takes precedence over the one that is shown
      return;
    }
    const { name } = this.trace;
    if (name === null || this.opened.has(name)) return;
    const verdictOf = (program: Program): Verdict | undefined => program.verdicts.find((it) => it.name === name);
    const verdict = verdictOf(this.program!);
    if (former.state === 'done' && !former.stale && JSON.stringify(verdictOf(former)) === JSON.stringify(verdict)) return;
    if (!verdict) return this.trace.markGone();
    const request = ++this.asked;
    if (verdict.steps === null) return this.trace.showVerdict(verdict);
    try {
      const trace = await this.host.request('trace', { name });
      if (request === this.asked) this.trace.renew(trace, true, this.isStale(trace));
    } catch (error) {
      if (request === this.asked) this.trace.markGone();
    }
  }

  private news(news: NewsOf): void {
    switch (news[0]) {
      case 'program': return this.takeNews(news[1]);
      case 'show': return void this.show(news[1]);
      case 'caret': return this.automaton.follows(news[1]);
      case 'edited':
        void this.automaton.load(true);
        return void this.simulation?.replay();
      case 'run': return this.run?.take(news[1]);
      case 'gone':
        this.run?.gone();
        this.state.textContent = 'proskill has ended; this page keeps its last state';
        this.state.className = 'state failed';
    }
  }

  private openFile(): void {
    if (this.run) return this.say('This page shows a run: `proskill view` opens files');
    if (this.hello.can.open) return void this.host.request('open', {}).catch((error: Error) => this.say(error.message));
    const input = h('input', { type: 'file', accept: '.json,application/json', onchange: () => void this.read(input.files?.[0]) });
    input.click();
  }

  private async read(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      const text = await file.text();
      const run = this.simulation && runOf(text);
      if (run) return await this.show({ run });
      const { traces, program } = open(text);
      for (const trace of traces) this.opened.set(trace.name, trace);
      const isThere = ({ name }: Verdict): boolean => traces.some((trace) => trace.name === name);
      const verdicts = program?.verdicts.map((verdict) => (isThere(verdict) ? verdict : { ...verdict, steps: null })) ?? [];
      if (program) this.take({ ...program, verdicts, pictures: this.program?.pictures ?? [], files: this.program?.files ?? [] });
      const first = program?.verdicts.find((it) => !it.good && it.steps !== null)?.name;
      const trace = traces.find((it) => it.name === first) ?? traces[0];
      if (!trace) throw new Error('there is no trace in it');
      this.openTrace(trace);
    } catch (error) {
      this.say(`${file.name}: ${(error as Error).message}`);
    }
  }

  private say(words: string): void {
    this.toast.textContent = words;
    this.toast.hidden = false;
    clearTimeout(this.toastTimer);
    this.toastTimer = window.setTimeout(() => { this.toast.hidden = true; }, 6000);
  }
}
