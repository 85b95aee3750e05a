// The editor and the browser: code-server from npm, Chromium from the distribution. They are installed once, outside the tree,
// in a folder named after its contents.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, readFileSync, renameSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join, relative } from 'node:path';

const here = import.meta.dirname;

/** Increase this when `install` changes. */
const kRecipe = 2;

/** Skips the tests with a reason. */
export class Missing extends Error {}

function run(cwd, program, ...args) {
  try {
    execFileSync(program, args, { cwd, stdio: 'pipe', timeout: 400_000, maxBuffer: 1 << 26 });
  } catch (error) {
    throw new Missing(`${program} ${args[0]} failed: ${String(error.stderr ?? error).trim().split('\n').slice(-4).join(' | ')}`);
  }
}

function chromium() {
  const found = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
  if (!found) throw new Missing('chromium is not installed (apt-get install chromium)');
  return found;
}

/** A module of native code, built here, because npm runs no scripts here. */
function build(folder, module, product) {
  const at = join(folder, 'node_modules', module);
  if (existsSync(join(at, product))) return;
  try {
    run(folder, 'npm', 'rebuild', module);
  } catch (error) {
    if (!existsSync(join(at, product))) throw error;
  }
}

/** Its own script would download it; the package for this platform contains it. */
function linkRipgrep(folder, code) {
  const at = join(code, 'node_modules/@vscode/ripgrep/bin');
  mkdirSync(at);
  symlinkSync(join(relative(at, join(folder, 'node_modules')), '@vscode/ripgrep-linux-x64/bin/rg'), join(at, 'rg'));
}

function install(folder) {
  mkdirSync(folder, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(join(here, file), join(folder, file));
  const quiet = ['--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error'];
  run(folder, 'npm', 'ci', ...quiet);
  const code = join(folder, 'node_modules/code-server/lib/vscode');
  run(code, 'npm', 'install', '--omit=dev', ...quiet);
  run(join(code, 'extensions'), 'npm', 'install', '--omit=dev', ...quiet);
  symlinkSync('node_modules', join(code, 'node_modules.asar'));
  linkRipgrep(folder, code);
  build(folder, 'argon2', 'lib/binding/napi-v3/argon2.node');
  build(code, '@vscode/spdlog', 'build/Release/spdlog.node');
  build(code, 'native-watchdog', 'build/Release/watchdog.node');
  build(code, 'node-pty', 'build/Release/pty.node');
}

/** The folder with code-server and playwright-core, and the path of Chromium. */
export function bench() {
  const major = process.versions.node.split('.')[0];
  if (major !== '20') throw new Missing(`code-server wants node 20, and this is ${process.version}`);
  const browser = chromium();
  const content = createHash('sha256').update(readFileSync(join(here, 'package-lock.json')))
    .update(`${kRecipe} ${process.version}`).digest('hex').slice(0, 16);
  const cache = join(process.env.XDG_CACHE_HOME || join(homedir(), '.cache'), 'proskill');
  const folder = join(cache, `editor-${content}`);
  if (!existsSync(join(folder, 'complete'))) {
    console.log(`installing code-server in ${folder}; this is done once`);
    const half = `${folder}.${process.pid}`;
    install(half);
    writeFileSync(join(half, 'complete'), '');
    rmSync(folder, { recursive: true, force: true });
    renameSync(half, folder);
  }
  return { folder, browser };
}
