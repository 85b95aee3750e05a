import * as vscode from 'vscode';
import { rangeOf, sameUri } from '../places';
import type { panel } from '../protocol';

/** Lets the editors show a run: the lines at which something runs, and the last message of each `printf`. */
export class RunMarks implements vscode.Disposable {
  private readonly active = vscode.window.createTextEditorDecorationType({
    isWholeLine: true, backgroundColor: new vscode.ThemeColor('editor.focusedStackFrameHighlightBackground'),
    overviewRulerColor: new vscode.ThemeColor('charts.green'), overviewRulerLane: vscode.OverviewRulerLane.Full,
  });
  private readonly messages = vscode.window.createTextEditorDecorationType({
    after: { color: new vscode.ThemeColor('editorCodeLens.foreground'), margin: '0 0 0 2em', fontStyle: 'italic' },
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedOpen,
  });
  private live: panel.Live = { active: [], messages: [] };
  private readonly subscriptions = [vscode.window.onDidChangeVisibleTextEditors(() => this.draw()), this.active, this.messages];

  show(live: panel.Live): void {
    this.live = live;
    this.draw();
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private draw(): void {
    for (const editor of vscode.window.visibleTextEditors) {
      const here = <T>(all: readonly T[], of: (it: T) => panel.Location): T[] => all.filter((it) => sameUri(of(it).uri, editor.document.uri));
      const lines = new Map(here(this.live.active, (it) => it).map(({ range }) => [range.start.line, rangeOf(range)])); // several branches may be in one
      editor.setDecorations(this.active, [...lines.values()]);
      editor.setDecorations(this.messages, here(this.live.messages, (it) => it.location).map((it) => this.message(editor.document, it)));
    }
  }

  private message(document: vscode.TextDocument, { location, text, count }: panel.Live['messages'][number]): vscode.DecorationOptions {
    const { end } = document.lineAt(Math.min(location.range.start.line, document.lineCount - 1)).range;
    return { range: new vscode.Range(end, end), renderOptions: { after: { contentText: count > 1 ? `${text} ×${count}` : text } } };
  }
}
