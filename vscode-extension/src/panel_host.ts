import * as vscode from 'vscode';
import { positionAt } from '../../panel/src/model/seek';
import { changesSince } from '../../panel/src/model/verdict_changes';
import type { Client } from './client';
import { Latest } from './latest';
import { page } from './page';
import { besideText, bringIntoView, goTo, presentOf, renamed } from './places';
import type { Programs } from './programs';
import * as protocol from './protocol';
import { save } from './save';
import { withCells } from './trace/cells';
import { readPart } from './trace/trace_file';
import type { panel } from './protocol';
import { Edits } from './writing/edits';
import type { Typing } from './writing/typing';

export type Layout = 'trace' | 'automaton' | 'simulation';

/** The state with which a panel is restored after a reload of the window. */
export interface SavedPanel {
  uri: string;
  remembered?: panel.Remembered;
  /** of the trace, and the time of its part */
  file?: string;
  from?: number;
}
export const savedPanel = (memory: vscode.Memento, layout: Layout): SavedPanel | undefined => memory.get(`panel.${layout}`);

/** Milliseconds within which VS Code reports which panel has the keyboard. */
const kLate = 300;

const kTitles: Record<Layout, string> = { trace: 'ProSkill trace', automaton: 'ProSkill automaton', simulation: 'ProSkill simulation' };

/** The host of one panel: answers its requests (panel/src/api.ts) and sends notifications. */
export class PanelHost implements vscode.Disposable {
  private readonly view: vscode.WebviewPanel;
  private readonly subscriptions: vscode.Disposable[] = [];
  private readonly steps = new vscode.EventEmitter<panel.CurrentStep | null>();
  readonly onStep = this.steps.event;
  private readonly ends = new vscode.EventEmitter<void>();
  readonly onEnd = this.ends.event;
  private readonly drawn = new vscode.EventEmitter<protocol.Automaton>();
  readonly onPicture = this.drawn.event;
  private readonly following = new Latest();
  private listening = false;
  /** a command has asked for what is shown next */
  private isAsked = true;
  /** that the page has */
  private toldVerdicts: panel.Verdict[] | undefined;
  private pictures: panel.PictureName[] = [];
  /** where the trace comes from that is shown, unless from the program */
  private file: vscode.Uri | undefined;
  private from: number | undefined;
  private askedParts = 0;
  /** since what is shown was computed */
  edits = new Edits();

  /** `uri`: any file of the program, by its present name; `show` may become known while the page loads. */
  constructor(
    private readonly client: Client,
    private readonly programs: Programs,
    private readonly typing: Typing,
    private readonly context: vscode.ExtensionContext,
    readonly layout: Layout,
    public uri: vscode.Uri,
    private show: panel.Show | undefined | Promise<panel.Show>,
    restored?: vscode.WebviewPanel,
    private remembered?: panel.Remembered,
  ) {
    const extension = context.extensionUri;
    this.view = restored ?? vscode.window.createWebviewPanel(
      `proskill.${layout}`, kTitles[layout],
      { viewColumn: besideText(uri), preserveFocus: layout === 'automaton' }, { retainContextWhenHidden: true });
    this.view.webview.options = { enableScripts: true, localResourceRoots: [] };
    this.view.iconPath = vscode.Uri.joinPath(extension, 'media', 'icon.svg');
    this.view.webview.onDidReceiveMessage((message: panel.Message) => void this.receive(message), null, this.subscriptions);
    this.view.onDidDispose(() => this.end(), null, this.subscriptions);
    programs.onChange(() => void this.tellProgram(), null, this.subscriptions);
    vscode.workspace.onDidRenameFiles(({ files }) => this.renamed(files), null, this.subscriptions);
    client.onLife((life) => {
      if (life === 'running') this.tell('edited', {});
    }, null, this.subscriptions);
    this.view.webview.html = page(extension);
  }

  dispose(): void {
    this.view.dispose();
  }

  reveal(focus: boolean): void {
    this.view.reveal(undefined, !focus);
  }

  /** Shows something else; before the panel is ready, it becomes what is shown first. */
  showIt(show: panel.Show, file?: vscode.Uri): void {
    if (file || show.trace) this.comesFrom(file);
    this.isAsked = true;
    this.show = show;
    this.tell('show', show);
  }

  /** The file of the trace that is shown: it is read again after a reload of the window. */
  comesFrom(file: vscode.Uri | undefined, from?: number): void {
    [this.file, this.from] = [file, from];
    this.save();
  }

  /** The panel stays with the program. What it shows is requested again when the program is verified by its new name. */
  private renamed(files: readonly { oldUri: vscode.Uri; newUri: vscode.Uri }[]): void {
    this.uri = renamed(this.uri, files);
    this.file &&= renamed(this.file, files);
    this.save();
    this.tell('edited', {});
  }

  private save(): void {
    const { file, from, remembered } = this;
    void this.context.workspaceState.update(`panel.${this.layout}`, { uri: this.uri.toString(), ...(remembered && { remembered }), ...(file && { file: file.toString() }), ...(from !== undefined && { from }) } satisfies SavedPanel);
  }

  tell<M extends keyof panel.News>(method: M, params: panel.News[M]): void {
    if (this.listening) void this.view.webview.postMessage({ type: 'news', method, params } satisfies panel.Message);
  }

  private end(): void {
    this.ends.fire();
    vscode.Disposable.from(...this.subscriptions).dispose();
    this.steps.dispose();
    this.drawn.dispose();
    this.ends.dispose();
  }

  private async receive(message: panel.Message): Promise<void> {
    if (message.type === 'told') return this.told(message.method, message.params);
    if (message.type !== 'request') return;
    const { id, method, params } = message;
    const reply = (answer: { result?: unknown; error?: string }): void =>
      void this.view.webview.postMessage({ type: 'reply', id, ...answer } satisfies panel.Message);
    try {
      reply({ result: (await this.answer(method, params as never)) ?? null });
    } catch (error) {
      reply({ error: error instanceof Error ? error.message : String(error) });
    }
  }

  private told(method: keyof panel.Told, params: unknown): void {
    if (method === 'reveal')
      this.following.take(() => this.follow(params as panel.Told['reveal'])).catch((error) => this.client.output.warn(`a step's text cannot be shown: ${String(error)}`));
    if (method === 'step') this.steps.fire(params as panel.Told['step']);
    if (method === 'remember') {
      this.remembered = params as panel.Remembered;
      this.save();
    }
  }

  /** The editor follows a trace's steps by scrolling only, and not while the user types in it or has turned to it. */
  private async follow({ location, focus }: panel.Told['reveal']): Promise<void> {
    const { viewColumn } = this.view;
    const place = (): panel.Location => presentOf(location, this.edits);
    if (focus || this.layout === 'automaton') await goTo(place(), focus, viewColumn);
    else if ((await this.isFollowed()) && !this.typing.goesOn) await bringIntoView(place(), viewColumn);
  }

  /** A step may arrive late, when the user is in a text again: that text stays as it is. A click in the panel may arrive before the news that the panel has the keyboard. */
  private async isFollowed(): Promise<boolean> {
    if (this.view.active || this.isAsked) {
      this.isAsked = false;
      return true;
    }
    await new Promise<void>((resolve) => {
      const news = this.view.onDidChangeViewState(() => resolve());
      setTimeout(() => (news.dispose(), resolve()), kLate);
    });
    return this.view.active;
  }

  private answer(method: panel.Method, params: never): Promise<unknown> | unknown {
    switch (method) {
      case 'hello': return this.hello();
      case 'trace': return this.trace(params);
      case 'part': return this.part(params);
      case 'picture': return this.picture(params);
      case 'simulate': return this.simulate(params);
      case 'save': return save(params, this.uri);
      case 'open': return vscode.commands.executeCommand('proskill.openTraceFile');
      case 'verify': return vscode.commands.executeCommand('proskill.verify', this.uri.toString());
      default: throw new Error(`VS Code has no ${String(method)}`);
    }
  }

  private async hello(): Promise<panel.Hello> {
    this.listening = true;
    const [program, show] = await Promise.all([this.program(), this.show]);
    this.toldVerdicts = program?.verdicts;
    return {
      contract: 1,
      layout: this.layout,
      can: { source: false, save: true, open: true, verify: vscode.workspace.isTrusted, simulate: this.layout === 'simulation', follow: this.layout === 'automaton' },
      program,
      ...(show && { show }),
      ...(this.remembered && { remembered: this.remembered }),
    };
  }

  private async trace({ name }: { name: string }): Promise<panel.Trace> {
    const trace = await this.client.running.sendRequest(protocol.trace, { textDocument: { uri: this.uri.toString() }, name });
    this.edits.forget(trace.texts);
    return withCells(trace);
  }

  private async simulate(run: panel.ChosenRun): Promise<panel.Simulation> {
    const simulation = await this.client.running.sendRequest(protocol.simulate, { textDocument: { uri: this.uri.toString() }, ...run });
    this.edits.forget(simulation.texts);
    return { ...simulation, trace: withCells(simulation.trace) };
  }

  private async part({ from }: { from?: number }): Promise<panel.Trace> {
    if (!this.file) throw new Error('The recording is not known any more.');
    const request = ++this.askedParts;
    const { trace } = await readPart(this.client, this.file, from);
    if (request !== this.askedParts) return trace; // answers come in any order; the page shows the last request only
    const step = from === undefined ? trace.steps.length - 1 : positionAt(trace, [...trace.steps.keys()], from);
    this.remembered = { ...this.remembered, step }; // saved together with the part, to which it belongs
    this.comesFrom(this.file, from);
    return trace;
  }

  private async picture(params: panel.PictureParams): Promise<protocol.Automaton> {
    const picture = await this.client.running.sendRequest(
      protocol.automaton, { textDocument: { uri: this.uri.toString() }, ...params });
    this.pictures = picture.pictures;
    if (params.format === 'svg') this.drawn.fire(picture);
    return picture;
  }

  private async tellProgram(): Promise<void> {
    const program = this.listening ? await this.program() : null;
    if (!program) return;
    const { verdicts, ...rest } = program;
    const changed = changesSince(this.toldVerdicts, verdicts);
    this.tell('program', changed ? { ...rest, changed } : program);
    this.toldVerdicts = verdicts;
  }

  /** What the panel shows around its views: verdicts of traces to choose from, and pictures. */
  private async program(): Promise<panel.Program | null> {
    if (!this.pictures.length && this.client.ready) await this.list();
    const known = this.programs.of(this.uri)[0];
    const files = (known?.texts ?? []).map(({ uri }) => ({ uri, label: vscode.workspace.asRelativePath(vscode.Uri.parse(uri)) }));
    return known
      ? { ...known, pictures: this.pictures, files }
      : { ...unknown(this.uri), pictures: this.pictures };
  }

  private async list(): Promise<void> {
    try {
      const { pictures } = await this.client.running.sendRequest(
        protocol.automaton, { textDocument: { uri: this.uri.toString() }, kind: 'calls', format: 'json' });
      this.pictures = pictures;
    } catch (error) {
      this.client.output.warn(`no list of pictures: ${String(error)}`);
    }
  }
}

/** A program without a notification of the server, such as one that is not verified. */
function unknown(uri: vscode.Uri): panel.Program {
  return {
    program: uri.toString(), label: vscode.workspace.asRelativePath(uri), main: null, state: 'off', stale: false,
    message: '', progress: null, verdicts: [], exploration: null, pictures: [], files: [],
  };
}
