import * as vscode from 'vscode';
import type { CodeLensProviderShape, Middleware } from 'vscode-languageclient/node';

/**
 * Milliseconds until a request that was not made counts as dropped; doubled by each attempt. VS Code waits for at least 250 before a request, and each
 * event makes it wait again.
 */
const kPatience = 1000;
const kMostAttempts = 5;

/** Requests for the lenses of a visible text since they may have changed. */
interface Text {
  /** number of changes so far */
  change: number;
  /** number of answers since the last of them */
  answers: number;
  /** number of attempts since then to have dropped requests made */
  attempts: number;
}

/**
 * VS Code drops a due request for lenses when the text loses the focus, and makes it only when the text has the focus again. Until then, the lenses
 * shown are outdated or missing, or even those of another file, from VS Code's cache. So an event has the request made after all.
 */
export class LensRequests implements vscode.Disposable {
  private texts = new Map<string, Text>();
  private running = 0;
  private due: NodeJS.Timeout | undefined;
  private providerOf: (document: vscode.TextDocument) => CodeLensProviderShape | undefined = () => undefined;
  private providers = new Set<CodeLensProviderShape>();
  private refreshes: vscode.Disposable[] = [];
  private isOurs = false;
  private readonly subscriptions = [
    vscode.window.onDidChangeVisibleTextEditors(() => this.see()),
    vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => contentChanges.length && this.change(document.uri.toString())),
  ];

  readonly middleware: NonNullable<Middleware['provideCodeLenses']> = async (document, token, next) => {
    const uri = document.uri.toString();
    const change = this.texts.get(uri)?.change;
    ++this.running;
    try {
      return await next(document, token);
    } finally {
      --this.running;
      const text = this.texts.get(uri);
      if (text && text.change === change && !token.isCancellationRequested) ++text.answers;
    }
  };

  /** Call this whenever a server has started. */
  watch(providerOf: (document: vscode.TextDocument) => CodeLensProviderShape | undefined): void {
    this.providerOf = providerOf;
    this.see();
  }

  dispose(): void {
    clearTimeout(this.due);
    vscode.Disposable.from(...this.subscriptions, ...this.refreshes).dispose();
  }

  /** Other texts are visible, or texts in other editors, or another server answers. */
  private see(): void {
    const documents = vscode.window.visibleTextEditors.map(({ document }) => document);
    this.providers = new Set(documents.flatMap((document) => this.providerOf(document) ?? []));
    vscode.Disposable.from(...this.refreshes).dispose();
    this.refreshes = [...this.providers].map(({ onDidChangeCodeLensEmitter }) =>
      onDidChangeCodeLensEmitter.event(() => this.isOurs || this.changeAll()));
    const uris = documents.filter((document) => this.providerOf(document)).map(({ uri }) => uri.toString());
    this.texts = new Map(uris.map((uri) => [uri, { change: this.texts.get(uri)?.change ?? 0, answers: 0, attempts: 0 }]));
    this.changeAll();
  }

  private changeAll(): void {
    for (const uri of this.texts.keys()) this.change(uri);
  }

  private change(uri: string): void {
    const text = this.texts.get(uri);
    if (!text) return;
    const hasGivenUp = text.attempts === kMostAttempts; // for example, a side of a comparison has no lenses
    this.texts.set(uri, { change: text.change + 1, answers: 0, attempts: hasGivenUp ? kMostAttempts : 0 });
    this.checkAfter(kPatience);
  }

  private checkAfter(milliseconds: number): void {
    clearTimeout(this.due);
    this.due = setTimeout(() => this.check(), milliseconds);
  }

  private check(): void {
    if (this.running) return this.checkAfter(kPatience);
    const dropped = [...this.texts].filter(([uri, { answers, attempts }]) => answers < editorsOf(uri) && attempts < kMostAttempts);
    if (!dropped.length) return;
    const attempts = dropped.map(([, text]) => ++text.attempts);
    this.isOurs = true;
    for (const { onDidChangeCodeLensEmitter } of this.providers) onDidChangeCodeLensEmitter.fire();
    this.isOurs = false;
    this.checkAfter(kPatience * 2 ** Math.max(...attempts));
  }
}

/** The number of editors that show a text with lenses. Each makes its own requests. */
function editorsOf(uri: string): number {
  return vscode.window.visibleTextEditors.filter(({ document }) =>
    document.uri.toString() === uri && vscode.workspace.getConfiguration('editor', document).get('codeLens', true)).length;
}
