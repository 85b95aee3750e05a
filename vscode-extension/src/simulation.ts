import * as vscode from 'vscode';
import { runOf } from '../../panel/src/model/chosen_run';
import type { Client } from './client';
import { PanelHost, savedPanel } from './panel_host';
import { currentText } from './writing/current_text';
import { isVerified } from './places';
import type { Programs } from './programs';
import type { panel } from './protocol';
import { Edits } from './writing/edits';
import type { Typing } from './writing/typing';

/** Milliseconds between an edit and the replay of the run. */
const kTyping = 300;

/** "Simulate": a run whose steps the user chooses; one panel per window. */
export class Simulations implements vscode.Disposable {
  private host: PanelHost | undefined;
  private editing: NodeJS.Timeout | undefined;
  /** since the last replay of the run, which is older while the text has errors */
  private readonly edits = new Edits();
  private readonly subscription = vscode.workspace.onDidChangeTextDocument((change) => {
    if (!this.host || change.document.languageId !== 'proskill' || !change.contentChanges.length) return;
    this.edits.note(change);
    this.edited();
  });

  constructor(
    private readonly client: Client,
    private readonly programs: Programs,
    private readonly typing: Typing,
    private readonly context: vscode.ExtensionContext,
  ) {}

  dispose(): void {
    this.host?.dispose();
    clearTimeout(this.editing);
    this.subscription.dispose();
  }

  /** A new run of the program; if the panel is open, its current run. */
  async open(uri?: vscode.Uri, run?: panel.ChosenRun): Promise<void> {
    const text = uri ?? currentText().uri;
    if (this.host?.uri.toString() === text.toString()) {
      if (run) this.host.showIt({ run });
      return this.host.reveal(true);
    }
    this.host?.dispose();
    this.take(new PanelHost(this.client, this.programs, this.typing, this.context, 'simulation', text, run && { run }));
  }

  /** Replays the run of a file; returns false if the file has none. */
  async openFile(file: vscode.Uri): Promise<boolean> {
    const run = runOf(Buffer.from(await vscode.workspace.fs.readFile(file)).toString('utf8'));
    if (!run) return false;
    const open = this.host?.uri ?? vscode.window.visibleTextEditors.map(({ document }) => document).find(isVerified)?.uri;
    await this.open(open, run);
    return true;
  }

  async deserializeWebviewPanel(view: vscode.WebviewPanel): Promise<void> {
    const saved = savedPanel(this.context.workspaceState, 'simulation');
    if (!saved) return view.dispose();
    await this.client.whenRunning();
    this.take(new PanelHost(this.client, this.programs, this.typing, this.context, 'simulation', vscode.Uri.parse(saved.uri), undefined, view, saved.remembered));
  }

  private take(host: PanelHost): void {
    this.edits.clear();
    host.edits = this.edits;
    host.onEnd(() => {
      if (this.host === host) this.host = undefined;
    });
    this.host = host;
  }

  private edited(): void {
    clearTimeout(this.editing);
    this.editing = setTimeout(() => this.host?.tell('edited', {}), kTyping);
  }
}
