import * as vscode from 'vscode';
import { CloseAction, ErrorAction, LanguageClient, State, type LanguageClientOptions, type RequestType } from 'vscode-languageclient/node';
import { findServer, type Server } from './find_server';
import { LensCommands } from './lens_commands';
import { LensRequests } from './lens_requests';
import * as protocol from './protocol';
import { Restarts } from './restarts';
import { initializationOptions } from './settings';
import { TypedLines } from './writing/typed_lines';

/** Milliseconds that a server may take to start before a request fails. */
const kMostToStart = 30_000;

export type Life = 'starting' | 'running' | 'crashed' | 'missing' | 'stopped';

/** Writes errors only to the output; `Client` shows them to the user once, with advice. */
class QuietClient extends LanguageClient {
  override error(message: string, data?: unknown): void {
    super.error(message, data, false);
  }
}

/** The server's life cycle: found, started, restarted. */
export class Client implements vscode.Disposable {
  readonly output = vscode.window.createOutputChannel('ProSkill', { log: true });
  private readonly lives = new vscode.EventEmitter<Life>();
  readonly onLife = this.lives.event;
  private readonly news = new vscode.EventEmitter<protocol.Verdicts>();
  readonly onVerdicts = this.news.event;
  life: Life = 'starting';
  /** explains a code of a diagnostic */
  explaining: (code: string) => Promise<void> = async () => undefined;
  server: Server | undefined;
  private current: LanguageClient | undefined;
  private begun: Promise<void> | undefined;
  private readonly restarts = new Restarts();
  private readonly lensRequests = new LensRequests();
  private readonly lensCommands = new LensCommands(this.lensRequests.middleware);
  private readonly typedLines = new TypedLines(() => (this.ready ? this.current : undefined));
  /** whether the server was started for a trusted workspace */
  private trusted = false;

  constructor(private readonly extensionPath: string) {}

  /** The client, if the server runs; otherwise an error for users. */
  get running(): LanguageClient {
    if (this.current?.state === State.Running) return this.current;
    throw new Error('The ProSkill server is not running. See the output "ProSkill".');
  }

  get ready(): boolean {
    return this.current?.state === State.Running;
  }

  /** Sends a request as soon as the server runs; repeats it if the server was restarted meanwhile. */
  async ask<P, R>(type: RequestType<P, R, void>, params: P, token?: vscode.CancellationToken): Promise<R> {
    const client = await this.whenRunning(token);
    try {
      return await client.sendRequest(type, params, token);
    } catch (error) {
      if (client === this.current || token?.isCancellationRequested) throw error;
      return (await this.whenRunning(token)).sendRequest(type, params, token);
    }
  }

  /** The client, once a server that is starting runs: after a crash, on request, or with new trust. */
  async whenRunning(token?: vscode.CancellationToken): Promise<LanguageClient> {
    const isDue = (): boolean =>
      (!this.ready || this.trusted !== vscode.workspace.isTrusted) && this.life !== 'crashed' && this.life !== 'missing';
    if (isDue())
      await new Promise<void>((resolve) => {
        const done = (): void => {
          clearTimeout(limit);
          vscode.Disposable.from(...waits).dispose();
          resolve();
        };
        const limit = setTimeout(done, kMostToStart);
        const waits = [this.onLife(() => !isDue() && done()), ...(token ? [token.onCancellationRequested(done)] : [])];
      });
    return this.running;
  }

  async start(): Promise<void> {
    this.trusted = vscode.workspace.isTrusted;
    this.live('starting');
    try {
      this.server = await findServer(this.extensionPath);
    } catch (error) {
      this.live('missing');
      return this.reportMissing(error instanceof Error ? error.message : String(error));
    }
    this.output.info(`${this.server.command} (${this.server.version})`);
    const client = this.make(this.server);
    this.current = client;
    this.begun = client.start();
    try {
      await this.begun;
      this.lensRequests.watch((document) => client.getFeature('textDocument/codeLens').getProvider(document));
    } catch (error) {
      this.output.error(`the server could not be started: ${String(error)}`);
      this.ended(client);
    }
  }

  /**
   * A server has ended by itself. The next one needs a new client: one that lost its server during the start cannot be used again. Both the
   * connection and the start report the loss.
   */
  private ended(client: LanguageClient): void {
    if (client !== this.current) return;
    this.current = undefined;
    if (this.restarts.again()) {
      this.output.warn('the server has ended; restarting it');
      void this.start();
    } else void this.giveUp();
  }

  private make({ command, env }: Server): LanguageClient {
    const options: LanguageClientOptions = {
      documentSelector: [
        { language: 'proskill', scheme: 'file' },
        { language: 'proskill', scheme: 'untitled' },
        { language: 'proskill', notebook: '*' },
        { language: 'fiacre', scheme: 'file' },
      ],
      synchronize: { configurationSection: 'proskill' },
      initializationOptions,
      outputChannel: this.output,
      middleware: {
        ...this.lensCommands.middleware,
        provideOnTypeFormattingEdits: this.typedLines.middleware,
        // otherwise the server would show the whole explanation in a message
        executeCommand: (command, args, next) => (command === 'proskill.explain' ? this.explaining(String(args[0])) : next(command, args)),
      },
      errorHandler: {
        error: () => ({ action: ErrorAction.Continue, handled: true }),
        closed: () => {
          this.ended(client);
          return { action: CloseAction.DoNotRestart, handled: true };
        },
      },
      initializationFailedHandler: () => false,
      markdown: { isTrusted: false, supportHtml: false },
    };
    const run = { command, args: ['lsp'], options: { env: { ...process.env, ...env } } };
    const client = new QuietClient('proskill', 'ProSkill', { run, debug: run }, options);
    client.registerFeature({
      fillClientCapabilities: (capabilities) => {
        capabilities.experimental = { ...(capabilities.experimental as object | undefined), verdicts: 'changes' };
      },
      initialize: () => undefined,
      getState: () => ({ kind: 'static' }),
      clear: () => undefined,
    });
    client.onNotification(protocol.verdicts, (verdicts) => this.news.fire(verdicts));
    client.onDidChangeState(({ newState }) => {
      if (client !== this.current) return;
      if (newState === State.Running) this.live('running');
      else if (this.life !== 'crashed') this.live(newState === State.Starting ? 'starting' : 'stopped');
    });
    return client;
  }

  /** On request of the user, or when trust was granted: earlier crashes do not count. */
  async restart(): Promise<void> {
    this.restarts.forget();
    await this.stop();
    await this.start();
  }

  async stop(): Promise<void> {
    const client = this.current;
    this.current = undefined;
    if (!client) return;
    try {
      await this.begun; // it cannot be stopped before
      await client.dispose(2000);
    } catch {
      // it has ended by itself
    }
  }

  dispose(): void {
    void this.stop();
    this.lensCommands.dispose();
    this.lensRequests.dispose();
    this.typedLines.dispose();
    this.output.dispose();
  }

  private live(life: Life): void {
    this.life = life;
    this.lives.fire(life);
  }

  private async giveUp(): Promise<void> {
    this.live('crashed');
    const restart = 'Start it again';
    const show = 'Show its output';
    const chosen = await vscode.window.showErrorMessage(
      'The ProSkill server has crashed more than five times in three minutes and was not restarted. ' +
        'Please report the output and the program that was open.',
      restart, show);
    if (chosen === restart) await this.restart();
    if (chosen === show) this.output.show();
  }

  private async reportMissing(why: string): Promise<void> {
    this.output.error(`cannot start the server:\n${why}`);
    const settings = 'Open the setting';
    const again = 'Try again';
    const chosen = await vscode.window.showErrorMessage(
      `ProSkill: cannot start the server. Install the Debian package of ProSkill, or set "proskill.server.path". (${why.split('\n')[0]})`,
      settings, again);
    if (chosen === settings)
      await vscode.commands.executeCommand('workbench.action.openSettings', 'proskill.server.path');
    if (chosen === again) await this.start();
  }
}
