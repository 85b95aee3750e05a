import * as vscode from 'vscode';
import { chooseTrace } from './choose_trace';
import type { Client } from '../client';
import type { FiacreView } from '../model';
import { PanelHost, savedPanel, type SavedPanel } from '../panel_host';
import { currentText } from '../writing/current_text';
import { isVerified, presentOf, showText } from '../places';
import type { Programs } from '../programs';
import type { panel } from '../protocol';
import { Edits } from '../writing/edits';
import { StepMarks } from './step_marks';
import { readTrace } from './trace_file';
import type { Typing } from '../writing/typing';

/** The trace view: one per window; the editors and the Fiacre text follow its current step. */
export class TraceView implements vscode.Disposable {
  private host: PanelHost | undefined;
  private shown: panel.Show = {};
  private current: panel.CurrentStep | null = null;
  /** since the trace that is shown was computed; it stays while the text has errors */
  private readonly edits = new Edits();
  private readonly marks = new StepMarks((location) => presentOf(location, this.edits));
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly client: Client,
    private readonly programs: Programs,
    private readonly typing: Typing,
    private readonly context: vscode.ExtensionContext,
    private readonly fiacre: FiacreView,
  ) {
    this.subscriptions = [
      vscode.workspace.onDidChangeTextDocument((change) => {
        if (!isVerified(change.document) || !change.contentChanges.length) return;
        this.edits.note(change);
        this.marks.edited();
      }),
      vscode.workspace.onDidCloseTextDocument(({ uri }) => this.edits.forgetAll(uri.toString())),
      programs.onChange(({ state, stale, texts }) => {
        if (!this.host && state === 'done' && !stale) this.edits.forget(texts);
      }),
    ];
  }

  dispose(): void {
    this.host?.dispose();
    this.marks.dispose();
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** The trace of a property; without a name, the user chooses one. */
  async open(uri?: vscode.Uri, name?: string): Promise<void> {
    const text = uri ?? currentText().uri;
    const trace = name ?? (await chooseTrace(this.programs, text, 'The trace of which property?'));
    if (trace) await this.show(text, { trace, step: 0 });
  }

  /** A trace from a file, such as one that the view has saved. */
  async openFile(file: vscode.Uri): Promise<void> {
    const read = await readTrace(this.client, file);
    if (!read) return;
    this.edits.clear();
    await this.show(read.program, { given: read.trace, step: 0 }, file);
  }

  private async show(uri: vscode.Uri, show: panel.Show, file?: vscode.Uri): Promise<void> {
    this.shown = show;
    if (this.host && this.host.uri.toString() === uri.toString()) {
      this.host.showIt(show, file);
      this.host.reveal(true);
      return;
    }
    this.host?.dispose();
    // The view opens beside the program. If no text is visible, the first one would cover it.
    if (!vscode.window.visibleTextEditors.some(({ viewColumn }) => viewColumn)) await showText(await vscode.workspace.openTextDocument(uri));
    const host = new PanelHost(this.client, this.programs, this.typing, this.context, 'trace', uri, show);
    host.comesFrom(file);
    this.take(host);
  }

  /** After a reload of the window: restores the trace and the step as soon as the program is verified. */
  async deserializeWebviewPanel(view: vscode.WebviewPanel): Promise<void> {
    const saved = savedPanel(this.context.workspaceState, 'trace');
    if (!saved) return view.dispose();
    const file = saved.file === undefined ? undefined : vscode.Uri.parse(saved.file);
    const again = file && this.again(file, saved);
    const host = new PanelHost(this.client, this.programs, this.typing, this.context, 'trace', vscode.Uri.parse(saved.uri), again, view, saved.remembered);
    host.comesFrom(file, saved.from);
    this.take(host);
  }

  /** A trace from a file, at its step; nothing if the file is gone. */
  private async again(file: vscode.Uri, { remembered, from }: SavedPanel): Promise<panel.Show> {
    try {
      await this.client.whenRunning();
      const read = await readTrace(this.client, file, remembered?.trace, from);
      if (!read) return {};
      this.shown = { given: read.trace, step: remembered?.step ?? 0 };
      return this.shown;
    } catch (error) {
      this.client.output.warn(`${file.fsPath} cannot be shown again: ${String(error)}`);
      return {};
    }
  }

  private take(host: PanelHost): void {
    host.edits = this.edits;
    host.onStep((step) => this.step(step));
    host.onEnd(() => {
      if (this.host !== host) return;
      this.host = undefined;
      this.step(null);
    });
    this.host = host;
  }

  /** From an editor: the step after or before the current one. */
  go(by: number): void {
    if (!this.host || !this.current) throw new Error('No trace is open.');
    const step = Math.max(0, Math.min(this.current.count - 1, this.current.index + by));
    this.host.showIt({ ...this.shown, step });
  }

  /** The panel scrolls the text, if it follows the steps. */
  private step(current: panel.CurrentStep | null): void {
    this.current = current;
    void vscode.commands.executeCommand('setContext', 'proskill.traceOpen', current !== null);
    this.marks.show(current);
    this.fiacre.follow(current);
  }
}
