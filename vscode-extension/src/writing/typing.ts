import * as vscode from 'vscode';

/** Milliseconds after a key during which the user counts as typing. */
const kQuiet = 2000;

/** Whether the user is typing: the editor does not scroll then. */
export class Typing implements vscode.Disposable {
  private last = -Infinity;
  private readonly subscription = vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
    if (contentChanges.length && document === vscode.window.activeTextEditor?.document) this.last = this.now();
  });

  constructor(private readonly now: () => number = Date.now) {}

  get goesOn(): boolean {
    return this.rest > 0;
  }

  /** Milliseconds until the user no longer counts as typing. */
  get rest(): number {
    return Math.max(this.last + kQuiet - this.now(), 0);
  }

  dispose(): void {
    this.subscription.dispose();
  }
}
