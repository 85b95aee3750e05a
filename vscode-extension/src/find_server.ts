import { execFile } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { join } from 'node:path';
import * as vscode from 'vscode';

export interface Server {
  command: string;
  /** what it says of itself, such as `proskill 0.1.0` */
  version: string;
}

/** Where a server may be, best first: what the user says, what the extension carries, the path. */
export function candidates(extensionPath: string): string[] {
  const chosen = vscode.workspace.getConfiguration('proskill').get<string>('server.path', '').trim();
  if (chosen) return [chosen];
  const carried = join(extensionPath, 'server', `${process.platform}-${process.arch}`, 'proskill');
  return isThere(carried) ? [carried, 'proskill'] : ['proskill'];
}

function isThere(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** The version of a program; an error says why it cannot be run, such as a library that is missing. */
function versionOf(command: string): Promise<string> {
  return new Promise((resolve, reject) => {
    execFile(command, ['--version'], { timeout: 10_000 }, (error, stdout, stderr) => {
      if (error) reject(new Error(stderr.trim().split('\n')[0] || error.message));
      else resolve(stdout.trim().split('\n')[0] ?? '');
    });
  });
}

/** The first server that can be run; an error tells of each that cannot. */
export async function findServer(extensionPath: string): Promise<Server> {
  const failures: string[] = [];
  for (const command of candidates(extensionPath)) {
    try {
      return { command, version: await versionOf(command) };
    } catch (error) {
      failures.push(`${command}: ${error instanceof Error ? error.message : String(error)}`);
    }
  }
  throw new Error(failures.join('\n'));
}
