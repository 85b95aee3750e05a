import * as vscode from 'vscode';
import type { Client } from './client';
import { currentText } from './places';
import * as protocol from './protocol';
import type { panel } from './protocol';

const kScheme = 'proskill-model';

/** The Fiacre text of a program, beside it; the transition of a trace's current step is marked. */
export class FiacreView implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<vscode.Uri>();
  readonly onDidChange = this.changes.event;
  private readonly models = new Map<string, protocol.Model>();
  private readonly mark = vscode.window.createTextEditorDecorationType({
    isWholeLine: true, backgroundColor: new vscode.ThemeColor('editor.stackFrameHighlightBackground'),
    overviewRulerColor: new vscode.ThemeColor('focusBorder'), overviewRulerLane: vscode.OverviewRulerLane.Full,
  });
  private origins: number[] = [];
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly client: Client) {
    this.subscriptions = [
      vscode.workspace.registerTextDocumentContentProvider(kScheme, this),
      vscode.workspace.onDidSaveTextDocument(() => this.refresh()),
      vscode.window.onDidChangeVisibleTextEditors(() => this.draw()),
      this.mark, this.changes,
    ];
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  async open(uri?: vscode.Uri): Promise<void> {
    const program = uri ?? currentText().uri;
    const name = program.path.split('/').pop()?.replace(/\.proskill$/, '') ?? 'model';
    const model = vscode.Uri.from({ scheme: kScheme, path: `/${name}.fcr`, query: program.toString() });
    const document = await vscode.workspace.openTextDocument(model);
    await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true, preview: true });
    this.draw(true);
  }

  async provideTextDocumentContent(uri: vscode.Uri): Promise<string> {
    const model = await this.client.running.sendRequest(
      protocol.model, { textDocument: { uri: uri.query }, edition: 'compact' });
    this.models.set(uri.toString(), model);
    return model.text;
  }

  follow(step: panel.Step | null): void {
    this.origins = step?.origins ?? [];
    this.draw(true);
  }

  private refresh(): void {
    for (const { uri } of vscode.workspace.textDocuments) if (uri.scheme === kScheme) this.changes.fire(uri);
  }

  private draw(scroll = false): void {
    for (const editor of vscode.window.visibleTextEditors) {
      const model = this.models.get(editor.document.uri.toString());
      if (!model) continue;
      const ranges = model.ranges
        .filter(({ origin }) => this.origins.includes(origin))
        .map(({ firstLine, lastLine }) => new vscode.Range(firstLine, 0, lastLine, 0));
      editor.setDecorations(this.mark, ranges);
      if (scroll && ranges[0]) editor.revealRange(ranges[0], vscode.TextEditorRevealType.InCenterIfOutsideViewport);
    }
  }
}
