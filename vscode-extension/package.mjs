// Makes the .vsix:  node package.mjs SERVER FILE.vsix
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';

const here = import.meta.dirname;
const [server, file] = process.argv.slice(2).map((path) => resolve(path));
const run = (program, ...args) => execFileSync(program, args, { cwd: here, stdio: ['ignore', 'inherit', 'inherit'] });

/** What the lock file says, installed once; no package's own script is run. */
function install() {
  const lock = createHash('sha256').update(readFileSync(join(here, 'package-lock.json'))).digest('hex');
  const stamp = join(here, 'node_modules/.installed');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return;
  run('npm', 'ci', '--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error');
  writeFileSync(stamp, lock);
}

install();
run(process.execPath, 'node_modules/typescript/bin/tsc', '--noEmit');
run(process.execPath, 'build.mjs', '--server', server);
mkdirSync(dirname(file), { recursive: true });
run(process.execPath, 'node_modules/@vscode/vsce/vsce', 'package', '--no-dependencies', '--allow-missing-repository',
  '--skip-license', '--target', 'linux-x64', '--out', file);
