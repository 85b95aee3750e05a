import * as vscode from 'vscode';
import type { Client } from './client';
import { currentText } from './writing/current_text';
import { besideText } from './places';
import * as protocol from './protocol';
import type { panel } from './protocol';

const kScheme = 'proskill-model';

/** The Fiacre text of a program, beside it; the transition of a trace's current step is marked. Go to Definition leads to the line of the program. */
export class FiacreView implements vscode.TextDocumentContentProvider, vscode.DefinitionProvider, vscode.Disposable {
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
      vscode.languages.registerDefinitionProvider({ scheme: kScheme }, this),
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
    const cursor = vscode.window.activeTextEditor;
    const line = cursor?.document.uri.toString() === program.toString() ? cursor.selection.active.line : undefined;
    const name = program.path.split('/').pop()?.replace(/\.proskill$/, '') ?? 'model';
    const model = vscode.Uri.from({ scheme: kScheme, path: `/${name}.fcr`, query: program.toString() });
    const document = await vscode.workspace.openTextDocument(model);
    const editor = await vscode.window.showTextDocument(
      document, { viewColumn: besideText(program), preserveFocus: true, preview: true });
    this.draw(true);
    const made = line === undefined ? undefined : this.madeFrom(model, program, line);
    if (made && this.origins.length === 0)
      editor.revealRange(new vscode.Range(made.firstLine, 0, made.lastLine, 0), vscode.TextEditorRevealType.InCenter);
  }

  /** The innermost part of the program that a line of its model comes from. */
  provideDefinition(document: vscode.TextDocument, { line }: vscode.Position): vscode.Location | undefined {
    const parts = this.models.get(document.uri.toString())?.ranges
      .filter(({ firstLine, lastLine, location }) => location && firstLine <= line && line <= lastLine) ?? [];
    const place = smallest(parts, ({ firstLine, lastLine }) => lastLine - firstLine)?.location;
    if (!place) return undefined;
    const { start, end } = place.range;
    return new vscode.Location(
      vscode.Uri.parse(place.uri), new vscode.Range(start.line, start.character, end.line, end.character));
  }

  /** The part of a model that comes from a line of the program, or from as little around it as possible. */
  private madeFrom(model: vscode.Uri, program: vscode.Uri, line: number): protocol.Model['ranges'][number] | undefined {
    const around = this.models.get(model.toString())?.ranges.filter(({ location }) =>
      location?.uri && vscode.Uri.parse(location.uri).toString() === program.toString()
      && location.range.start.line <= line && line <= location.range.end.line) ?? [];
    return smallest(around, ({ location }) => location!.range.end.line - location!.range.start.line);
  }

  async provideTextDocumentContent(uri: vscode.Uri): Promise<string> {
    const model = await this.client.running.sendRequest(
      protocol.model, { textDocument: { uri: uri.query }, edition: 'compact' });
    this.models.set(uri.toString(), model);
    return model.text;
  }

  follow(current: panel.CurrentStep | null): void {
    this.origins = current?.step.origins ?? [];
    this.draw(current?.byUser ?? false);
  }

  private refresh(): void {
    for (const { uri } of vscode.workspace.textDocuments) if (uri.scheme === kScheme) this.changes.fire(uri);
  }

  private draw(scroll = false): void {
    for (const editor of vscode.window.visibleTextEditors) {
      const model = this.models.get(editor.document.uri.toString());
      if (!model) continue;
      const ranges = innermost(model.ranges.filter(({ origin }) => this.origins.includes(origin)))
        .map(({ firstLine, lastLine }) => new vscode.Range(firstLine, 0, lastLine, 0));
      editor.setDecorations(this.mark, ranges);
      if (scroll && ranges[0]) editor.revealRange(ranges[0], vscode.TextEditorRevealType.InCenterIfOutsideViewport);
    }
  }
}

/** The first of those of which none is smaller. */
function smallest<T>(all: T[], size: (one: T) => number): T | undefined {
  return all.reduce<T | undefined>((best, one) => (best === undefined || size(one) < size(best) ? one : best), undefined);
}

/** Without those that contain others: a transition instead of its process. */
function innermost<Lines extends { firstLine: number; lastLine: number }>(all: Lines[]): Lines[] {
  const holds = (outer: Lines, inner: Lines): boolean =>
    outer.firstLine <= inner.firstLine && inner.lastLine <= outer.lastLine && outer.lastLine - outer.firstLine > inner.lastLine - inner.firstLine;
  return all.filter((it) => !all.some((other) => holds(it, other)));
}
