import { execFile } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { dirname, join } from 'node:path';
import * as vscode from 'vscode';
import { findOnPath } from './find_program';

export interface Server extends Program {
  /** its version, such as `proskill 0.1.0` */
  version: string;
}
interface Program {
  command: string;
  /** additional environment variables */
  env: NodeJS.ProcessEnv;
}

/** Candidates for the server, best first: the user's setting, the extension's, PATH. */
export function candidates(extensionPath: string): Program[] {
  const plain = (command: string): Program => ({ command, env: {} });
  const chosen = vscode.workspace.getConfiguration('proskill').get<string>('server.path', '').trim();
  if (chosen) return [plain(chosen)];
  const carried = join(extensionPath, 'server', `${process.platform}-${process.arch}`, 'proskill');
  const installed = onPath().map(plain);
  if (!isThere(carried)) return installed;
  // some small computers lack libraries that others have in a better matching version
  const fallback = join(dirname(carried), 'fallback');
  return [plain(carried), { command: carried, env: { LD_LIBRARY_PATH: fallback } }, ...installed];
}

/** The program installed on this computer, if any. */
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

/** The version of a program; the error says why it cannot be run, such as a missing library. */
function versionOf({ command, env }: Program): Promise<string> {
  return new Promise((resolve, reject) => {
    execFile(command, ['--version'], { timeout: 10_000, env: { ...process.env, ...env } }, (error, stdout, stderr) => {
      if (error) reject(new Error(inWords(stderr.trim().split('\n')[0] || error.message)));
      else resolve(stdout.trim().split('\n')[0] ?? '');
    });
  });
}

/** Explains messages of the dynamic loader. */
function inWords(complaint: string): string {
  if (/GLIBC_[\d.]+' not found/.test(complaint)) return `it needs a newer Linux: Ubuntu 22.04, Debian 12, or later. (${complaint})`;
  const missing = /error while loading shared libraries: ([^:]+)/.exec(complaint);
  return missing ? `the library ${missing[1]} is missing; install the package of your distribution that contains it. (${complaint})` : complaint;
}

/** The first server that can be run; the error lists why each cannot. */
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
