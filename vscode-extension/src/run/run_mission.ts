import { mkdirSync, readdirSync, rmSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import * as vscode from 'vscode';
import type { Client } from '../client';
import { currentText } from '../writing/current_text';
import { RunPanel } from './run_panel';
import { RunProcess } from './run_process';
import type { panel } from '../protocol';

/** Recordings that are kept. */
const kKept = 20;

/** "Run Mission": executes a program on its platform, and shows it while it happens; one run per window. */
export class Missions implements vscode.Disposable {
  private current: RunPanel | undefined;

  constructor(private readonly client: Client, private readonly context: vscode.ExtensionContext) {}

  dispose(): void {
    this.current?.dispose();
  }

  async run(uri?: vscode.Uri): Promise<void> {
    const program = uri ?? currentText().uri;
    if (!vscode.workspace.isTrusted)
      throw new Error('Programs are not run in an untrusted workspace. Trust it first: "Workspaces: Manage Workspace Trust".');
    await vscode.workspace.textDocuments.find((it) => it.uri.toString() === program.toString() && it.isDirty)?.save();
    await this.client.whenRunning();
    const server = this.client.server;
    if (!server) throw new Error('The ProSkill server is not running. See the output "ProSkill".');
    this.current?.dispose();
    const cwd = dirname(program.fsPath);
    const recording = this.recordingOf(program);
    const label = basename(program.fsPath);
    const process = await RunProcess.start(server, [...optionsFor(program), '--record', recording, program.fsPath], cwd);
    const panel = new RunPanel(process, cwd, program, this.context.extensionUri, label, (status) => void tell(label, status, recording));
    panel.onClose(() => {
      if (this.current === panel) this.current = undefined;
    });
    this.current = panel;
  }

  /** A new file, and room for it. Of a long run in this format a part can be read. */
  private recordingOf(program: vscode.Uri): string {
    const folder = join((this.context.storageUri ?? this.context.globalStorageUri).fsPath, 'runs');
    mkdirSync(folder, { recursive: true });
    for (const old of readdirSync(folder).sort().slice(0, -kKept + 1)) rmSync(join(folder, old), { force: true });
    const date = new Date().toISOString().replace(/[:.]/g, '-');
    return join(folder, `${date}-${basename(program.fsPath, '.proskill')}.mcap`);
  }
}

/** The settings that say who performs the actions, and how fast. */
function optionsFor(program: vscode.Uri): string[] {
  const settings = vscode.workspace.getConfiguration('proskill.run', program);
  const platform = settings.get<string>('platform', '').trim();
  const folder = vscode.workspace.getWorkspaceFolder(program)?.uri.fsPath ?? dirname(program.fsPath);
  return [...(platform ? ['--platform', resolve(folder, platform)] : []), '--clock', settings.get<string>('clock', 'real')];
}

async function tell(label: string, { end }: panel.RunStatus, recording: string): Promise<void> {
  if (!end) return;
  const open = 'Open as a Trace';
  const mission = end.mission ? `, ${end.mission}` : '';
  const words = `ProSkill: ${label}: ${end.why}${mission}${end.bad > 0 ? `; ${end.bad} thing${end.bad === 1 ? '' : 's'} should not have happened` : ''}.`;
  const chosen = await (end.bad > 0 ? vscode.window.showWarningMessage(words, open) : vscode.window.showInformationMessage(words, open));
  if (chosen === open) await vscode.commands.executeCommand('proskill.openTraceFile', vscode.Uri.file(recording));
}
