// Makes the .vsix:  node package.mjs SERVER FILE.vsix
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { install } from './install.mjs';

const [server, file] = process.argv.slice(2).map((path) => resolve(path));
const run = (...args) => execFileSync(process.execPath, args, { cwd: import.meta.dirname, stdio: ['ignore', 'inherit', 'inherit'] });

install();
run('node_modules/typescript/bin/tsc', '--noEmit');
run('build.mjs', '--server', server);
mkdirSync(dirname(file), { recursive: true });
run('node_modules/@vscode/vsce/vsce', 'package', '--no-dependencies', '--allow-missing-repository',
  '--skip-license', '--target', 'linux-x64', '--out', file);
