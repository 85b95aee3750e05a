import * as vscode from 'vscode';
import type { panel } from './protocol';

type Params = panel.Requests['save'][0];

/** Asks for a file, by default in the workspace folder of the program, and writes a picture or a trace to it. */
export async function save({ name, text, base64 }: Params, program: vscode.Uri): Promise<{ saved: boolean }> {
  const folder = (vscode.workspace.getWorkspaceFolder(program) ?? vscode.workspace.workspaceFolders?.[0])?.uri;
  const extension = name.split('.').pop() ?? '';
  const target = await vscode.window.showSaveDialog({
    ...(folder && { defaultUri: vscode.Uri.joinPath(folder, name) }),
    filters: { [extension.toUpperCase()]: [extension] },
  });
  if (!target) return { saved: false };
  await vscode.workspace.fs.writeFile(target, Buffer.from(base64 ?? text ?? '', base64 === undefined ? 'utf8' : 'base64'));
  return { saved: true };
}
