import { accessSync, constants, realpathSync, statSync } from 'node:fs';
import { delimiter, isAbsolute, join, relative } from 'node:path';

/**
 * The absolute path of a program in PATH. Folders of the workspace and relative entries are never searched: whoever wrote the open programs must not
 * choose what runs.
 */
export function findOnPath(name: string, path: string, workspace: string[]): string | undefined {
  const opened = workspace.map(real);
  return path.split(delimiter)
    .filter((folder) => isAbsolute(folder) && !opened.some((it) => isWithin(real(folder), it)))
    .map((folder) => join(folder, name))
    .find((file) => isProgram(file) && !opened.some((it) => isWithin(real(file), it)));
}

function real(file: string): string {
  try {
    return realpathSync(file);
  } catch {
    return file;
  }
}

function isWithin(file: string, folder: string): boolean {
  const way = relative(folder, file);
  return way === '' || (way.split(/[\\/]/)[0] !== '..' && !isAbsolute(way));
}

function isProgram(file: string): boolean {
  try {
    accessSync(file, constants.X_OK);
    return statSync(file).isFile();
  } catch {
    return false;
  }
}
