import * as vscode from 'vscode';

/** Milliseconds after a key for which a person counts as typing. */
const kQuiet = 2000;

/** Whether somebody types: nothing moves in the editor then. */
export class Typing implements vscode.Disposable {
  private last = -Infinity;
  private readonly subscription = vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
    if (contentChanges.length && document === vscode.window.activeTextEditor?.document) this.last = this.now();
  });

  constructor(private readonly now: () => number = Date.now) {}

  get goesOn(): boolean {
    return this.now() - this.last < kQuiet;
  }

  dispose(): void {
    this.subscription.dispose();
  }
}
