import * as vscode from 'vscode';
import type { Programs } from '../programs';
import type * as protocol from '../protocol';
import type { panel } from '../protocol';
import type { Typing } from '../writing/typing';

/** Results that are shown at once, and the pause after them, in milliseconds: VS Code draws its tree again for each of them. */
const kAtOnce = 25;
const kPause = 30;
/** Properties of a program up to which each run shows all results: VS Code counts those of the last run above its tree. */
const kWhole = 100;
/** Milliseconds that results may be those of an older text before the view says so: live verification mostly replaces them. */
const kOutdatedAfter = 5000;
/** Milliseconds without an edit after which results are saved. */
const kSavedAfter = 3000;
/** VS Code forgets a run, with its results, after 128 others; before that, results that have not changed are shown again. */
const kRunsKept = 60;

/** What the Testing view does for live results. */
export interface LiveView {
  /** the properties of a program, by name; empty: it is not listed */
  itemsOf(program: string): Map<string, vscode.TestItem>;
  /** shows verdicts of items */
  show(run: vscode.TestRun, items: vscode.TestItem[], verdicts: panel.Verdict[], seconds: number): void;
  save(program: protocol.Verdicts): void;
}

/** A program of the Testing view. */
class Shown {
  /** by name of the property: the verdict that is shown as current */
  readonly verdicts = new Map<string, string>();
  /** number of runs when the first of these verdicts was shown */
  since = 0;
  isOutdated = false;
  isTelling = false;
  aging: NodeJS.Timeout | undefined;
  saving: NodeJS.Timeout | undefined;
  saved: panel.Verdict[] | undefined;

  stopTimers(): void {
    clearTimeout(this.aging);
    clearTimeout(this.saving);
  }
}

const lookOf = ({ verdict, good, severity }: panel.Verdict): string => `${verdict} ${good} ${severity}`;
const pause = (milliseconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, milliseconds));
const isCurrent = ({ state, stale }: protocol.Verdicts): boolean => (state === 'done' || state === 'checking') && !stale;

/**
 * Results in the Testing view that come without a run of the user. A program has thousands of properties, and an edit changes few verdicts: only those
 * are shown, some at a time, so that VS Code can answer keys between them.
 */
export class LiveResults implements vscode.Disposable {
  private readonly shown = new Map<string, Shown>();
  private runs = 0;

  constructor(
    private readonly controller: vscode.TestController,
    private readonly programs: Programs,
    private readonly typing: Pick<Typing, 'rest'>,
    private readonly view: LiveView,
  ) {}

  dispose(): void {
    for (const it of this.shown.values()) it.stopTimers();
  }

  /** Whether results of this session are shown. */
  has(program: string): boolean {
    return !!this.shown.get(program)?.verdicts.size;
  }

  /** A program that does not exist any more. */
  forget(program: string): void {
    this.shown.get(program)?.stopTimers();
    this.shown.delete(program);
  }

  /** The latest verdicts of a program. */
  take(program: protocol.Verdicts): void {
    if (!isCurrent(program) || !program.verdicts.length) return;
    const it = this.of(program.program);
    it.stopTimers();
    if (!it.isTelling && this.due(program.program).length) void this.tell(program.program, it);
    if (program.state === 'done' && it.saved !== program.verdicts) it.saving = setTimeout(() => this.save(program, it), kSavedAfter);
  }

  /** A run of the user, which shows verdicts itself. */
  ran(program: string, verdicts: panel.Verdict[]): void {
    const it = this.of(program);
    if (!it.verdicts.size) it.since = this.runs;
    ++this.runs;
    it.isOutdated = false;
    for (const verdict of verdicts) it.verdicts.set(verdict.name, lookOf(verdict));
  }

  /** The text of a program has changed. If nothing verifies it, its results are outdated at once. */
  edited(item: vscode.TestItem): void {
    const it = this.of(item.id);
    it.stopTimers();
    if (it.isOutdated) return;
    const state = this.programs.get(item.id)?.state ?? 'off';
    if (state === 'off') this.outdate(item, it);
    else it.aging = setTimeout(() => this.outdate(item, it), kOutdatedAfter);
  }

  /**
   * VS Code shows this in the tree; it redraws marks in the gutter only if a verdict changes, and does not reliably remove a mark that is added again
   * at once.
   */
  private outdate(item: vscode.TestItem, it: Shown): void {
    it.isOutdated = true;
    it.verdicts.clear();
    this.controller.invalidateTestResults(item);
  }

  private of(program: string): Shown {
    const known = this.shown.get(program);
    if (known) return known;
    const it = new Shown();
    this.shown.set(program, it);
    return it;
  }

  /** Current verdicts that the view does not show yet, of properties that it lists. */
  private due(name: string): panel.Verdict[] {
    const program = this.programs.get(name);
    if (!program || !isCurrent(program)) return [];
    const { verdicts } = this.of(name);
    const due = program.verdicts.filter((it) => !it.pending && verdicts.get(it.name) !== lookOf(it));
    const items = due.length ? this.view.itemsOf(name) : undefined;
    return due.filter((it) => items?.has(it.name));
  }

  private async tell(name: string, it: Shown): Promise<void> {
    const item = this.controller.items.get(name);
    if (!item) return;
    it.isTelling = true;
    try {
      for (let due = this.due(name); due.length; due = this.due(name)) {
        if (this.waits(due)) await pause(this.typing.rest);
        else await this.tellRun(item, name, it, due);
      }
    } finally {
      it.isTelling = false;
    }
    this.renew();
  }

  /** Many results wait until the user stops typing. */
  private waits(due: readonly panel.Verdict[]): boolean {
    return due.length > kAtOnce && this.typing.rest > 0;
  }

  /** Shows verdicts until none is due, or the user types. */
  private async tellRun(item: vscode.TestItem, name: string, it: Shown, first: readonly panel.Verdict[]): Promise<void> {
    if (!it.verdicts.size) it.since = this.runs;
    ++this.runs;
    const former = new Map(it.verdicts);
    const run = this.controller.createTestRun(new vscode.TestRunRequest([item], undefined, undefined, true, true), 'Live verification', false);
    try {
      for (let due = first; due.length && !this.waits(due); due = this.due(name)) {
        this.tellSome(run, name, it, due.slice(0, kAtOnce));
        if (due.length > kAtOnce) await pause(kPause);
      }
      this.tellUnchanged(run, name, it, former);
    } finally {
      run.end();
    }
  }

  /** Shows the results again that were shown before the run, so that its counts are those of the program. */
  private tellUnchanged(run: vscode.TestRun, name: string, it: Shown, former: ReadonlyMap<string, string>): void {
    const program = this.programs.get(name);
    if (!program || !isCurrent(program) || program.verdicts.length > kWhole) return;
    const items = this.view.itemsOf(name);
    this.tellSome(run, name, it, program.verdicts.filter((verdict) => !verdict.pending && former.get(verdict.name) === lookOf(verdict) && items.has(verdict.name)));
  }

  private tellSome(run: vscode.TestRun, name: string, it: Shown, verdicts: panel.Verdict[]): void {
    const items = this.view.itemsOf(name);
    it.isOutdated = false;
    for (const verdict of verdicts) it.verdicts.set(verdict.name, lookOf(verdict));
    this.view.show(run, verdicts.map((verdict) => items.get(verdict.name)!), verdicts, this.programs.get(name)?.exploration?.seconds ?? 0);
  }

  /** Shows results again that VS Code would soon forget. */
  private renew(): void {
    for (const [name, it] of this.shown) {
      if (it.isTelling || !it.verdicts.size || this.runs - it.since < kRunsKept) continue;
      it.verdicts.clear();
      const program = this.programs.get(name);
      if (program) this.take(program);
    }
  }

  private save(program: protocol.Verdicts, it: Shown): void {
    it.saved = program.verdicts;
    this.view.save(program);
  }
}
