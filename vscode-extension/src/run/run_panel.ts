import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import * as vscode from 'vscode';
import { Latest } from '../latest';
import { page } from '../page';
import { besideText, bringIntoView, goTo } from '../places';
import { save } from '../save';
import type { panel } from '../protocol';
import { RunMarks } from './run_marks';
import type { RunProcess } from './run_process';

/** The panel of a run. It neither moves the caret nor takes the focus, unless the user clicks in it. */
export class RunPanel implements vscode.Disposable {
  private readonly view: vscode.WebviewPanel;
  private readonly marks = new RunMarks();
  private readonly subscriptions: vscode.Disposable[] = [];
  private readonly following = new Latest();
  private isOver = false;

  /** `cwd`: of the process; its paths are relative to it. */
  constructor(
    private readonly run: RunProcess,
    private readonly cwd: string,
    program: vscode.Uri,
    extension: vscode.Uri,
    label: string,
    private readonly ended: (status: panel.RunStatus) => void,
  ) {
    this.view = vscode.window.createWebviewPanel('proskill.run', `Run ${label}`, { viewColumn: besideText(program), preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] });
    this.view.iconPath = vscode.Uri.joinPath(extension, 'media', 'icon.svg');
    this.view.webview.onDidReceiveMessage((message: panel.Message) => void this.receive(message), null, this.subscriptions);
    this.view.onDidDispose(() => this.close(), null, this.subscriptions);
    this.view.webview.html = page(extension);
    run.onEnd(() => this.tell('gone', {}));
  }

  onClose(closed: () => void): void {
    this.view.onDidDispose(closed);
  }

  dispose(): void {
    this.view.dispose();
  }

  private close(): void {
    this.run.end();
    this.marks.dispose();
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private async receive(message: panel.Message): Promise<void> {
    if (message.type === 'told') return this.told(message.method, message.params);
    if (message.type !== 'request') return;
    const { id, method, params } = message;
    try {
      this.post({ type: 'reply', id, result: (await this.answer(method, params)) ?? null });
      if (method === 'hello') void this.run.listen((news, about) => this.pass(news, about)).catch(() => this.tell('gone', {}));
    } catch (error) {
      this.post({ type: 'reply', id, error: error instanceof Error ? error.message : String(error) });
    }
  }

  private async answer(method: panel.Method, params: unknown): Promise<unknown> {
    if (method === 'save') return save(params as never, vscode.Uri.file(this.cwd));
    const result = this.placed(await this.run.call(method, params));
    if (method !== 'hello') return result;
    const hello = result as panel.Hello;
    return { ...hello, can: { ...hello.can, source: false, save: true } } satisfies panel.Hello;
  }

  private pass(method: string, params: unknown): void {
    if (method === 'run') this.note(params as panel.RunStatus);
    this.post({ type: 'news', method: method as keyof panel.News, params: this.placed(params) });
  }

  private note(status: panel.RunStatus): void {
    if (status.state !== 'ended' || this.isOver) return;
    this.isOver = true;
    this.ended(status);
  }

  private async told(method: keyof panel.Told, params: unknown): Promise<void> {
    if (method === 'shine') this.marks.show(params as panel.Live);
    if (method !== 'reveal' || !this.view.active) return;
    const { location, focus } = params as panel.Told['reveal'];
    const { viewColumn } = this.view;
    await this.following.take(() => (focus ? goTo(location, true, viewColumn) : bringIntoView(location, viewColumn)));
  }

  private tell<M extends keyof panel.News>(method: M, params: panel.News[M]): void {
    this.post({ type: 'news', method, params });
  }

  private post(message: panel.Message): void {
    void this.view.webview.postMessage(message);
  }

  /** The process names files by paths, and the panel by URIs. */
  private placed<T>(value: T): T {
    if (Array.isArray(value)) return value.map((it) => this.placed(it)) as T;
    if (!value || typeof value !== 'object') return value;
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, key === 'uri' && typeof inner === 'string' ? this.uriOf(inner) : this.placed(inner)])) as T;
  }

  private uriOf(place: string): string {
    if (/^[a-z][a-z0-9+.-]+:/i.test(place)) return place;
    const path = resolve(this.cwd, place);
    return existsSync(path) ? vscode.Uri.file(path).toString() : place;
  }
}
