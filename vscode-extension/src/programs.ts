import * as vscode from 'vscode';
import { withChanges } from '../../panel/src/model/verdict_changes';
import type { Client } from './client';
import type * as protocol from './protocol';

/** The latest notification of the server on every program. */
export class Programs implements vscode.Disposable {
  private readonly known = new Map<string, protocol.Verdicts>();
  private readonly changes = new vscode.EventEmitter<protocol.Verdicts>();
  readonly onChange = this.changes.event;
  private readonly subscriptions: vscode.Disposable[];

  constructor(client: Client) {
    this.subscriptions = [
      client.onVerdicts((verdicts) => this.take(verdicts)),
      client.onLife((life) => {
        if (life !== 'running') this.forget();
      }),
      this.changes,
    ];
  }

  all(): protocol.Verdicts[] {
    return [...this.known.values()];
  }

  get(program: string): protocol.Verdicts | undefined {
    return this.known.get(program);
  }

  /** The programs of a file, in the order of the server: open ones first, then by name. Those that are not verified come last. */
  of(uri: vscode.Uri): protocol.Verdicts[] {
    const text = uri.toString();
    const found = this.all().filter((program) =>
      [program.program, ...program.texts.map((it) => it.uri)].some((it) => vscode.Uri.parse(it).toString() === text));
    const rank = (it: protocol.Verdicts): number => (it.state === 'off' ? 2 : isOpen(it.program) ? 0 : 1);
    return found.sort((left, right) => rank(left) - rank(right) || (pathOf(left.program) < pathOf(right.program) ? -1 : 1));
  }

  /** Resolves when no verification of the text's programs is running, or after the time limit. */
  settled(uri: vscode.Uri, token: vscode.CancellationToken, milliseconds: number): Promise<void> {
    const isSettled = (): boolean => {
      const known = this.of(uri);
      return known.length > 0 && known.every(({ state }) => state !== 'waiting' && state !== 'checking');
    };
    if (isSettled()) return Promise.resolve();
    return new Promise((resolve) => {
      const done = (): void => {
        clearTimeout(limit);
        vscode.Disposable.from(...waits).dispose();
        resolve();
      };
      const limit = setTimeout(done, milliseconds);
      const waits = [token.onCancellationRequested(done), this.onChange(() => {
        if (isSettled()) done();
      })];
    });
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private take(news: protocol.Verdicts): void {
    const known = this.known.get(news.program);
    const program = { ...news, verdicts: news.changes && known ? withChanges(known.verdicts, news.verdicts) : news.verdicts };
    this.known.set(news.program, program);
    this.changes.fire(program);
  }

  /** Notifications of a server that has ended are dropped. */
  private forget(): void {
    this.known.clear();
  }
}

const pathOf = (uri: string): string => vscode.Uri.parse(uri).path;

function isOpen(program: string): boolean {
  return vscode.workspace.textDocuments.some(({ uri }) => uri.toString() === vscode.Uri.parse(program).toString());
}
