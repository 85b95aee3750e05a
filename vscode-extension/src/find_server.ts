import { execFile } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { dirname, join } from 'node:path';
import * as vscode from 'vscode';
import { findOnPath } from './find_program';

export interface Server extends Program {
  /** what it says of itself, such as `proskill 0.1.0` */
  version: string;
}
interface Program {
  command: string;
  /** what its environment has besides ours */
  env: NodeJS.ProcessEnv;
}

/** Where a server may be, best first: what the user says, what the extension carries, the path. */
export function candidates(extensionPath: string): Program[] {
  const plain = (command: string): Program => ({ command, env: {} });
  const chosen = vscode.workspace.getConfiguration('proskill').get<string>('server.path', '').trim();
  if (chosen) return [plain(chosen)];
  const carried = join(extensionPath, 'server', `${process.platform}-${process.arch}`, 'proskill');
  const installed = onPath().map(plain);
  if (!isThere(carried)) return installed;
  // Some small computers lack libraries that all others have in the version that fits them best.
  const fallback = join(dirname(carried), 'fallback');
  return [plain(carried), { command: carried, env: { LD_LIBRARY_PATH: fallback } }, ...installed];
}

/** The program that is installed on this computer, where there is one. */
function onPath(): string[] {
  const folders = (vscode.workspace.workspaceFolders ?? []).map(({ uri }) => uri.fsPath);
  const found = findOnPath('proskill', process.env['PATH'] ?? '', folders);
  return found === undefined ? [] : [found];
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
function versionOf({ command, env }: Program): Promise<string> {
  return new Promise((resolve, reject) => {
    execFile(command, ['--version'], { timeout: 10_000, env: { ...process.env, ...env } }, (error, stdout, stderr) => {
      if (error) reject(new Error(inWords(stderr.trim().split('\n')[0] || error.message)));
      else resolve(stdout.trim().split('\n')[0] ?? '');
    });
  });
}

/** What the loader of programs says, for those who have never met it. */
function inWords(complaint: string): string {
  if (/GLIBC_[\d.]+' not found/.test(complaint)) return `it needs a newer Linux: Ubuntu 22.04, Debian 12, or later. (${complaint})`;
  const missing = /error while loading shared libraries: ([^:]+)/.exec(complaint);
  return missing ? `the library ${missing[1]} is missing; install the package of your distribution that contains it. (${complaint})` : complaint;
}

/** The first server that can be run; an error tells of each that cannot. */
export async function findServer(extensionPath: string): Promise<Server> {
  const failures: string[] = [];
  for (const program of candidates(extensionPath)) {
    try {
      return { ...program, version: await versionOf(program) };
    } catch (error) {
      failures.push(`${program.command}: ${error instanceof Error ? error.message : String(error)}`);
    }
  }
  throw new Error([...new Set(failures)].join('\n') || '`proskill` is not on the PATH');
}
