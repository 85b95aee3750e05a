import * as vscode from 'vscode';
import { DidChangeWatchedFilesNotification, FileChangeType, type FileEvent } from 'vscode-languageclient/node';
import type { Client } from './client';

/** Milliseconds in which changes are gathered. */
const kGathered = 100;
/** Of files of which the language client notifies the server. */
const kWatched = /\.(proskill|fcr|json)$/;

/**
 * Files and folders that appear or disappear. VS Code reports a folder that another branch brings, but not the files in it, which the patterns of
 * the server therefore miss. So the server is notified of everything else, and looks into the folders.
 */
export class DiskChanges implements vscode.Disposable {
  private readonly changes = new vscode.EventEmitter<void>();
  /** after the server was notified */
  readonly onChange = this.changes.event;
  private readonly watcher = vscode.workspace.createFileSystemWatcher('**/*', false, true, false);
  private readonly subscriptions = [
    this.watcher, this.changes,
    this.watcher.onDidCreate((uri) => this.gather(uri, FileChangeType.Created)),
    this.watcher.onDidDelete((uri) => this.gather(uri, FileChangeType.Deleted)),
  ];
  private gathered: FileEvent[] = [];
  private due: NodeJS.Timeout | undefined;

  constructor(private readonly client: Client) {}

  dispose(): void {
    clearTimeout(this.due);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private gather(uri: vscode.Uri, type: FileChangeType): void {
    if (!kWatched.test(uri.path)) this.gathered.push({ uri: uri.toString(), type });
    this.due ??= setTimeout(() => this.report().catch((error) => this.client.output.warn(`the server does not know what has changed on disk: ${String(error)}`)), kGathered);
  }

  private async report(): Promise<void> {
    this.due = undefined;
    const changes = this.gathered.splice(0);
    if (!this.client.ready) return; // a server that starts reads all folders
    if (changes.length) await this.client.running.sendNotification(DidChangeWatchedFilesNotification.type, { changes });
    this.changes.fire();
  }
}
