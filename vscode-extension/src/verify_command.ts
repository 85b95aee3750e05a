import * as vscode from 'vscode';
import type { Subject } from './arguments';
import type { Client } from './client';
import { currentText } from './writing/current_text';
import { count, inWords } from './findings';
import * as protocol from './protocol';

/** `proskill.verify`: verifies a program, or some of its properties, with progress that can be cancelled. */
export async function verify(client: Client, { uri, names }: Subject): Promise<void> {
  const program = uri ?? currentText().uri;
  if (!vscode.workspace.isTrusted)
    throw new Error('Programs are not verified in an untrusted workspace. Trust it first: "Workspaces: Manage Workspace Trust".');
  const title = `ProSkill: verifying ${names?.join(', ') ?? vscode.workspace.asRelativePath(program)}`;
  const result = await vscode.window.withProgress(
    { location: vscode.ProgressLocation.Notification, title, cancellable: true },
    (progress, token) => request(client, program, names ?? [], progress, token));
  if (result) await tell(program, result);
}

interface WorkDone {
  kind: string;
  /** number of decided properties, states, rate, memory and time */
  message?: string;
}

let asked = 0;

async function request(client: Client, program: vscode.Uri, names: string[],
                       progress: vscode.Progress<{ message?: string }>, token: vscode.CancellationToken):
                       Promise<protocol.VerifyResult | undefined> {
  const workDoneToken = `proskill.verify.${++asked}`;
  const reports = (await client.whenRunning(token)).onProgress(
    { is: (value: unknown): value is WorkDone => typeof value === 'object' } as never, workDoneToken, (value: WorkDone) => {
      if (value.message) progress.report({ message: value.message });
    });
  try {
    return await client.ask(
      protocol.verify, { textDocument: { uri: program.toString() }, names, workDoneToken }, token);
  } catch (error) {
    if (token.isCancellationRequested) return undefined;
    throw error;
  } finally {
    reports.dispose();
  }
}

async function tell(program: vscode.Uri, { verdicts, exploration }: protocol.VerifyResult): Promise<void> {
  const bad = verdicts.filter(({ good }) => !good);
  const seconds = `${exploration.classes.toLocaleString()} states in ${exploration.seconds.toFixed(2)} s`;
  const worst = bad.find(({ severity }) => severity === 'error') ?? bad[0];
  if (!worst) {
    void vscode.window.showInformationMessage(`ProSkill: ${verdicts.length} of ${verdicts.length} good (${seconds}).`);
    return;
  }
  const traced = worst.steps !== null ? worst : bad.find(({ steps }) => steps !== null);
  const open = 'Open a trace';
  const chosen = await vscode.window.showWarningMessage(
    `ProSkill: ${inWords(count(verdicts))}, of ${verdicts.length}. ${worst.description.replaceAll('`', '')}: ${worst.verdict} (${seconds}).`,
    ...(traced ? [open] : []));
  if (chosen === open && traced)
    await vscode.commands.executeCommand('proskill.openTrace', { program: program.toString(), name: traced.name });
}
