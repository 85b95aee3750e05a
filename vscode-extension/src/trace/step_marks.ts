import * as vscode from 'vscode';
import { decimal } from '../../../panel/src/model/time';
import { rangeOf, sameUri } from '../places';
import type { panel } from '../protocol';

/** Marks the current step of a trace in the editors: its range, and the values after it. */
export class StepMarks implements vscode.Disposable {
  private readonly step = vscode.window.createTextEditorDecorationType({
    backgroundColor: new vscode.ThemeColor('editor.stackFrameHighlightBackground'),
    border: '1px solid', borderColor: new vscode.ThemeColor('focusBorder'),
    overviewRulerColor: new vscode.ThemeColor('focusBorder'), overviewRulerLane: vscode.OverviewRulerLane.Full,
  });
  private readonly values = vscode.window.createTextEditorDecorationType({
    after: { color: new vscode.ThemeColor('editorCodeLens.foreground'), margin: '0 0 0 2em', fontStyle: 'italic' },
    rangeBehavior: vscode.DecorationRangeBehavior.ClosedOpen,
  });
  private current: panel.CurrentStep | null = null;
  private isShown = false;
  private readonly subscriptions = [
    vscode.window.onDidChangeVisibleTextEditors(() => this.draw()),
    this.step, this.values,
  ];

  /** `presentOf`: where a place of the step's text is now */
  constructor(private readonly presentOf: (location: panel.Location) => panel.Location) {}

  show(current: panel.CurrentStep | null): void {
    this.current = current;
    this.draw();
  }

  /** Marks follow edits, but the editor keeps an empty one where the text of the step was removed. */
  edited(): void {
    if (this.isShown && !this.place()) this.draw();
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private draw(): void {
    const location = this.place();
    this.isShown = location !== undefined;
    for (const editor of vscode.window.visibleTextEditors) {
      const here = location && sameUri(location.uri, editor.document.uri) ? rangeOf(location.range) : undefined;
      editor.setDecorations(this.step, here ? [here] : []);
      editor.setDecorations(this.values, here && this.current ? this.valuesAt(editor.document, here, this.current) : []);
    }
  }

  /** The present place of the step, unless its text was removed. */
  private place(): panel.Location | undefined {
    const location = this.current?.step.location;
    const now = location && this.presentOf(location);
    const isEmpty = ({ range }: panel.Location): boolean => rangeOf(range).isEmpty;
    return now && (isEmpty(location) || !isEmpty(now)) ? now : undefined;
  }

  /** After the step's first line: its changes, then the values of the variables that the line names. */
  private valuesAt(document: vscode.TextDocument, range: vscode.Range, current: panel.CurrentStep): vscode.DecorationOptions[] {
    const line = document.lineAt(Math.min(range.start.line, document.lineCount - 1));
    const text = [words(current), ...named(line.text, current)].join('   ');
    return [{ range: new vscode.Range(line.range.end, line.range.end), renderOptions: { after: { contentText: text } } }];
  }
}

function words({ step, index, count }: panel.CurrentStep): string {
  const changes = step.changes.map(({ variable, before, after }) => `${variable}: ${before} → ${after}`);
  const why = step.why ? [`why: ${step.why.replaceAll('`', '')}`] : [];
  return [`step ${index + 1} of ${count}, ${decimal(step.date)} s`, ...changes, ...why].join('   ');
}

function named(line: string, { values, step }: panel.CurrentStep): string[] {
  const changed = new Set(step.changes.map(({ variable }) => variable));
  const mentioned = new Set(line.replace(/;.*/, '').match(/[A-Za-z_][A-Za-z0-9_]*(\.[A-Za-z_]+)?/g) ?? []);
  return Object.entries(values)
    .filter(([variable]) => mentioned.has(variable) && !changed.has(variable))
    .map(([variable, value]) => `${variable} = ${value}`);
}
