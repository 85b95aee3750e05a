import * as vscode from 'vscode';
import type { Client } from '../client';
import type { DiskChanges } from '../disk_changes';
import { LiveResults } from './live_results';
import { locationOf, rangeOf } from '../places';
import { byName } from '../../../panel/src/model/natural';
import type { Programs } from '../programs';
import * as protocol from '../protocol';
import type { panel } from '../protocol';
import { Results } from './results';
import { kStatements, marksStatements } from '../settings';
import { Edits } from '../writing/edits';
import type { Typing } from '../writing/typing';

type Node =
  | { kind: 'program'; program: string }
  | { kind: 'subject'; program: string; properties: string[] }
  | { kind: 'property'; program: string; name: string };

/** Milliseconds until the list of properties is read again, also after the last edit or change on disk: VS Code moves its marks with the text meanwhile. */
const kRefresh = 400;
const kRefreshEdited = 2000;

/** The Testing view: program, skill, property. */
export class Testing implements vscode.Disposable {
  private readonly controller = vscode.tests.createTestController('proskill', 'ProSkill');
  private readonly nodes = new WeakMap<vscode.TestItem, Node>();
  private readonly live: LiveResults;
  private readonly subscriptions: vscode.Disposable[];
  private due: NodeJS.Timeout | undefined;
  private asked = 0;
  private readonly results: Results;
  /** since the properties were listed */
  private readonly edits = new Edits();
  /** whose results of the previous session are shown */
  private readonly restored = new Set<string>();

  constructor(private readonly client: Client, private readonly programs: Programs, typing: Typing, disk: DiskChanges, memory: vscode.Memento) {
    this.results = new Results(memory);
    this.live = new LiveResults(this.controller, programs, typing, {
      itemsOf: (program) => this.itemsOf(program),
      show: (run, items, verdicts, seconds) => this.tell(run, items, verdicts, seconds, false),
      save: ({ program, verdicts, texts, exploration }) => void this.results.save(program, verdicts, texts, exploration?.seconds ?? 0),
    });
    this.controller.createRunProfile(
      'Verify', vscode.TestRunProfileKind.Run, (request, token) => this.run(request, token), true);
    this.controller.refreshHandler = () => this.refresh();
    this.controller.resolveHandler = async (item) => {
      if (item) await this.list(item);
      else await this.refresh();
    };
    this.subscriptions = [
      this.controller, this.live,
      client.onLife((life) => {
        if (life === 'running') this.soon();
      }),
      programs.onChange((program) => this.news(program)),
      disk.onChange(() => this.soon(kRefreshEdited)),
      vscode.workspace.onDidChangeWorkspaceFolders(() => this.soon()),
      vscode.workspace.onDidOpenTextDocument((document) => {
        // the server receives the text at the same time, and soon reports verdicts for it
        if (document.languageId === 'proskill') this.soon();
      }),
      vscode.workspace.onDidCloseTextDocument((document) => {
        // its file may have been deleted while it was open
        if (document.languageId === 'proskill') this.soon();
      }),
      vscode.workspace.onDidChangeTextDocument((change) => {
        if (change.document.languageId !== 'proskill' || !change.contentChanges.length) return;
        this.edits.note(change);
        this.edited(change.document.uri);
      }),
      vscode.workspace.onDidChangeConfiguration((change) => {
        if (change.affectsConfiguration(kStatements)) void this.refresh();
      }),
    ];
    this.soon();
  }

  dispose(): void {
    clearTimeout(this.due);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  // ---- the tree ---------------------------------------------------------------------------------

  private soon(delay = kRefresh): void {
    clearTimeout(this.due);
    this.due = setTimeout(() => void this.refresh(), delay);
  }

  private edited(uri: vscode.Uri): void {
    this.soon(kRefreshEdited);
    const programs = new Set([uri.toString(), ...this.programs.of(uri).map(({ program }) => program)]);
    for (const [, item] of this.controller.items)
      if (programs.has(item.id) || item.uri?.toString() === uri.toString()) this.live.edited(item);
  }

  private async refresh(): Promise<void> {
    if (!this.client.ready) return;
    const asked = ++this.asked;
    try {
      const { programs } = await this.client.running.sendRequest(protocol.tests, { workspace: true });
      if (asked !== this.asked) return;
      const moved = new Set<string>();
      const items = programs.map((program) => this.programItem(program, labelOf(program, programs), moved));
      [...items].sort((a, b) => byName(a.label, b.label)).forEach((item, index) => (item.sortText = orderText(index)));
      for (const [id, item] of this.controller.items) if (!items.some((it) => it.id === id)) void this.gone(item);
      this.controller.items.replace(items);
      this.edits.forget(programs.flatMap(({ texts }) => texts));
      for (const uri of moved) this.edits.forgetAll(uri);
      for (const program of this.programs.all()) this.news(program);
      await this.restore();
    } catch (error) {
      this.client.output.warn(`no list of properties: ${String(error)}`);
    }
  }

  /** A program is not listed any more. If its file was deleted, VS Code would still show its results, as current, beside a new file of this name. */
  private async gone(program: vscode.TestItem): Promise<void> {
    if (await exists(program.uri!)) return;
    this.controller.invalidateTestResults(program);
    this.live.forget(program.id);
    this.restored.delete(program.id);
  }

  /** Without descriptions, which screen readers would read instead of labels. Existing items are kept, with their results. */
  private item(within: vscode.TestItemCollection, id: string, label: string, location: panel.Location | null, uri?: vscode.Uri): vscode.TestItem {
    const place = location && locationOf(location);
    const known = within.get(id);
    const item = known && known.uri?.toString() === (place?.uri ?? uri)?.toString()
      ? known : this.controller.createTestItem(id, label, place?.uri ?? uri);
    item.label = label;
    item.range = place?.range;
    return item;
  }

  /** While a program has errors, its properties stay: the tree is the same, and the marks are where the text has gone. */
  private programItem(program: protocol.TestedProgram, label: string, moved = new Set<string>()): vscode.TestItem {
    const item = this.item(this.controller.items, program.uri, label, null, vscode.Uri.parse(program.uri));
    item.error = program.error ?? undefined;
    item.canResolveChildren = !program.listed;
    this.nodes.set(item, { kind: 'program', program: program.uri });
    if (program.error !== null && item.children.size) item.children.forEach((subject) => this.move(subject, moved));
    else if (program.listed) item.children.replace(program.subjects.map((subject, index) => this.subjectItem(item, program.uri, subject, index)));
    return item;
  }

  /** Moves a mark with its text, and those of its properties likewise. `moved`: gets the texts */
  private move(item: vscode.TestItem, moved: Set<string>): void {
    const uri = item.uri?.toString() ?? '';
    moved.add(uri);
    if (item.range) item.range = rangeOf({ start: this.edits.now(uri, item.range.start), end: this.edits.now(uri, item.range.end) });
    item.children.forEach((property) => this.move(property, moved));
  }

  /** The properties of a program without an open file, requested when the item is expanded. */
  private async list(item: vscode.TestItem): Promise<void> {
    const node = this.nodes.get(item);
    if (node?.kind !== 'program' || item.children.size) return;
    item.busy = true;
    try {
      const { programs } = await this.client.ask(protocol.tests, { textDocument: { uri: node.program } });
      const program = programs.find(({ uri }) => uri === node.program);
      if (program) this.programItem(program, item.label);
    } finally {
      item.busy = false;
    }
  }

  /** Restores results of the previous session, if the texts are unchanged. */
  private async restore(): Promise<void> {
    for (const program of this.results.programs()) {
      const item = this.controller.items.get(program);
      if (!item || this.restored.has(program)) continue;
      this.restored.add(program);
      const saved = await this.results.of(program);
      if (!saved || this.live.has(program)) continue;
      await this.list(item);
      this.tellSaved(item, saved.verdicts as panel.Verdict[], saved.seconds);
    }
  }

  private subjectItem(parent: vscode.TestItem, program: string, subject: protocol.TestedSubject, index: number): vscode.TestItem {
    const item = this.item(parent.children, `${program}#${subject.id}`, subject.label, subject.location, parent.uri);
    item.sortText = orderText(index);
    this.nodes.set(item, { kind: 'subject', program, properties: subject.properties.map(({ id }) => id) });
    // by default at the definition: a mark beside each line would not help
    const placeOf = (property: protocol.TestedSubject['properties'][number]): panel.Location | null =>
      marksStatements() ? (property.location ?? subject.location) : (subject.location ?? property.location);
    item.children.replace(subject.properties.map((property, place) => {
      const child = this.item(item.children, `${program}##${property.id}`, shortLabel(subject.label, property.label), placeOf(property), parent.uri);
      child.sortText = orderText(place);
      this.nodes.set(child, { kind: 'property', program, name: property.id });
      return child;
    }));
    return item;
  }

  // ---- running ----------------------------------------------------------------------------------

  /** The programs of a request, each with its properties. */
  private selected(request: vscode.TestRunRequest): Map<string, vscode.TestItem[]> {
    const excluded = new Set(request.exclude ?? []);
    const result = new Map<string, vscode.TestItem[]>();
    const walk = (item: vscode.TestItem): void => {
      if (excluded.has(item)) return;
      const node = this.nodes.get(item);
      if (node?.kind === 'property') {
        const items = result.get(node.program);
        if (items) items.push(item);
        else result.set(node.program, [item]);
      }
      item.children.forEach(walk);
    };
    if (request.include) request.include.forEach(walk);
    else this.controller.items.forEach(walk);
    return result;
  }

  private async run(request: vscode.TestRunRequest, token: vscode.CancellationToken): Promise<void> {
    if (!vscode.workspace.isTrusted) {
      void vscode.window.showWarningMessage('ProSkill does not verify programs in an untrusted workspace.');
      return;
    }
    const run = this.controller.createTestRun(request, 'Verification');
    try {
      for (const item of request.include ?? [...this.controller.items].map(([, it]) => it)) await this.list(item);
      for (const [program, items] of this.selected(request)) await this.verify(run, program, items, token);
    } finally {
      run.end();
    }
  }

  /** All properties of a program together: one exploration decides them. */
  private async verify(run: vscode.TestRun, program: string, items: vscode.TestItem[], token: vscode.CancellationToken): Promise<void> {
    if (token.isCancellationRequested || !items.length) return;
    for (const item of items) run.started(item);
    const cancelled = new vscode.CancellationTokenSource();
    const stop = vscode.Disposable.from(
      token.onCancellationRequested(() => cancelled.cancel()),
      run.token.onCancellationRequested(() => cancelled.cancel()));
    try {
      const names = this.isAll(program, items) ? [] : items.map((item) => this.nameOf(item));
      const result = await this.client.ask(
        protocol.verify, { textDocument: { uri: program }, names }, cancelled.token);
      this.live.ran(program, result.verdicts);
      this.tell(run, items, result.verdicts, result.exploration.seconds);
      void this.results.save(result.program, result.verdicts, result.texts, result.exploration.seconds);
      run.appendOutput(summary(program, result).replace(/\n/g, '\r\n'));
    } catch (error) {
      for (const item of items) {
        if (cancelled.token.isCancellationRequested) run.skipped(item);
        else run.errored(item, new vscode.TestMessage(error instanceof Error ? error.message : String(error)));
      }
    } finally {
      stop.dispose();
      cancelled.dispose();
    }
  }

  private nameOf(item: vscode.TestItem): string {
    const node = this.nodes.get(item);
    return node?.kind === 'property' ? node.name : item.id;
  }

  private isAll(program: string, items: vscode.TestItem[]): boolean {
    let count = 0;
    this.controller.items.get(program)?.children.forEach((subject) => (count += subject.children.size));
    return count === items.length;
  }

  /**
   * One exploration decides all: each item gets a share of the time, and its parent all of it. Warnings are not failures: they are skipped and
   * described in the output, so that a program without errors is green.
   */
  private tell(run: vscode.TestRun, items: vscode.TestItem[], verdicts: panel.Verdict[], seconds: number, messages = true): void {
    const byName = new Map(verdicts.map((verdict) => [verdict.name, verdict]));
    const share = seconds * 1000 / Math.max(verdicts.length, 1);
    for (const item of items) {
      const verdict = byName.get(this.nameOf(item));
      const message = (): vscode.TestMessage | [] => (verdict && messages ? messageOf(item, verdict) : []);
      if (verdict?.good) run.passed(item, share);
      else if (verdict?.verdict === 'inconclusive') run.errored(item, message(), share);
      else if (verdict?.severity === 'error') run.failed(item, message(), share);
      else run.skipped(item);
    }
  }

  // ---- what is verified without a run: live, or by the command -------------------------------------

  /** Shows no messages and opens nothing, since the text and the status bar already report everything. */
  private news(program: protocol.Verdicts): void {
    if (this.controller.items.get(program.program)) this.live.take(program);
    else this.soon();
  }

  /** The properties of a program by name. */
  private itemsOf(program: string): Map<string, vscode.TestItem> {
    const items = new Map<string, vscode.TestItem>();
    this.controller.items.get(program)?.children.forEach((subject) => subject.children.forEach((item) => items.set(this.nameOf(item), item)));
    return items;
  }

  private tellSaved(item: vscode.TestItem, verdicts: panel.Verdict[], seconds: number): void {
    const request = new vscode.TestRunRequest([item], undefined, undefined, true, true);
    const run = this.controller.createTestRun(request, 'Earlier verification', false);
    const decided = new Set(verdicts.map(({ name }) => name));
    const items = [...this.selected(request).values()].flat().filter((it) => decided.has(this.nameOf(it)));
    this.tell(run, items, verdicts, seconds, false);
    run.end();
  }
}

/** Its name; if several have it, with the folders that distinguish them. */
function labelOf(program: protocol.TestedProgram, all: protocol.TestedProgram[]): string {
  const isAlone = all.filter(({ label }) => label === program.label).length === 1;
  return isAlone ? program.label : vscode.workspace.asRelativePath(vscode.Uri.parse(program.uri));
}

async function exists(uri: vscode.Uri): Promise<boolean> {
  try {
    await vscode.workspace.fs.stat(uri);
    return true;
  } catch {
    return false;
  }
}

/** VS Code sorts items as texts. */
const orderText = (index: number): string => String(index).padStart(5, '0');

/** Without backquotes, which would be shown literally. */
const plain = (words: string): string => words.replaceAll('`', '');

/** Without the name of its subject, which is shown above. */
function shortLabel(subject: string, label: string): string {
  const start = `\`${subject}\` `;
  return plain(label.startsWith(start) ? label.slice(start.length) : label);
}

function messageOf(item: vscode.TestItem, verdict: panel.Verdict): vscode.TestMessage {
  const text = new vscode.MarkdownString();
  text.appendText(`${plain(verdict.description)}: ${verdict.verdict}`);
  if (verdict.reason) text.appendText(`\n${verdict.reason}`);
  if (verdict.summary) text.appendText(`\n\n${plain(verdict.summary)}`);
  if (verdict.steps !== null) {
    const node = encodeURIComponent(JSON.stringify([{ program: item.id.split('##')[0], name: verdict.name }]));
    text.isTrusted = { enabledCommands: ['proskill.openTrace', 'proskill.debugTrace'] };
    text.appendMarkdown(`\n\n[Open the trace](command:proskill.openTrace?${node}) of ${verdict.steps} steps, `
      + `or [step through it in the debugger](command:proskill.debugTrace?${node})`);
  }
  const message = new vscode.TestMessage(text);
  if (verdict.location) message.location = locationOf(verdict.location);
  message.contextValue = verdict.steps === null ? 'verdict' : 'trace';
  return message;
}

function summary(program: string, { verdicts, exploration }: protocol.VerifyResult): string {
  const lines = verdicts.filter(({ good }) => !good).map(({ name, verdict, reason }) => `  ${name}: ${verdict}${reason ? ` (${reason})` : ''}`);
  return [`${vscode.workspace.asRelativePath(vscode.Uri.parse(program))}: ${verdicts.filter(({ good }) => good).length} of ${verdicts.length} good`, ...lines,
    `  ${exploration.classes} states in ${exploration.seconds.toFixed(2)} s` + (exploration.stopped ? `; ${exploration.stopped}` : ''), ''].join('\n');
}
