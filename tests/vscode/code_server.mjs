// One code-server of its own: its own home, its own extensions, on a free port of the loopback.
import { execFileSync, spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, readlinkSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kSettings = {
  'proskill.verify.seconds': 60, // on a busy machine, verification may take several times as long
  'workbench.startupEditor': 'none', 'security.workspace.trust.startupPrompt': 'never',
  'security.workspace.trust.banner': 'never', 'telemetry.telemetryLevel': 'off', 'extensions.ignoreRecommendations': true,
  'git.enabled': false, 'workbench.tips.enabled': false, 'editor.minimap.enabled': false, 'files.autoSave': 'off',
  'remote.autoForwardPorts': false, // otherwise a message appears for every port that another program opens
  'editor.accessibilitySupport': 'off', 'workbench.reduceMotion': 'on', 'workbench.colorTheme': 'Default Dark Modern',
  'workbench.secondarySideBar.defaultVisibility': 'hidden', 'chat.commandCenter.enabled': false,
  'window.commandCenter': false, 'breadcrumbs.enabled': false, 'editor.stickyScroll.enabled': false,
  'workbench.layoutControl.enabled': false, 'testing.openTesting': 'neverOpen',
  '[jsonc]': { 'editor.autoClosingBrackets': 'never', 'editor.autoClosingQuotes': 'never', 'editor.autoSurround': 'never',
    'editor.quickSuggestions': false, 'editor.formatOnType': false },
};

export class CodeServer {
  static async start(folder, vsix) {
    const server = new CodeServer(folder);
    server.install(vsix);
    await server.listen();
    return server;
  }

  /** Without the extension: its programs are texts in the Lisp that the editor knows. */
  static async plain(folder) {
    const server = new CodeServer(folder, { 'files.associations': { '*.proskill': 'clojure' }, 'security.workspace.trust.enabled': false });
    await server.listen();
    return server;
  }

  constructor(folder, settings = {}) {
    this.home = mkdtempSync(join(tmpdir(), 'proskill-editor-'));
    this.entry = join(folder, 'node_modules/code-server/out/node/entry.js');
    this.env = { ...process.env, HOME: this.home, XDG_CACHE_HOME: join(this.home, 'cache'), XDG_CONFIG_HOME: join(this.home, 'config'), XDG_DATA_HOME: join(this.home, 'share') };
    delete this.env.VSCODE_IPC_HOOK_CLI;
    this.folders = ['--user-data-dir', join(this.home, 'data'), '--extensions-dir', join(this.home, 'extensions')];
    mkdirSync(join(this.home, 'data/User'), { recursive: true });
    writeFileSync(this.settingsFile, JSON.stringify({ ...kSettings, ...settings }));
  }

  get settingsFile() {
    return join(this.home, 'data/User/settings.json');
  }

  userSettings() {
    return JSON.parse(readFileSync(this.settingsFile, 'utf8'));
  }

  install(vsix) {
    execFileSync(process.execPath, [this.entry, ...this.folders, '--install-extension', vsix], { env: this.env, stdio: 'pipe' });
  }

  listen() {
    this.process = spawn(process.execPath, [this.entry, ...this.folders, '--auth', 'none', '--bind-addr', '127.0.0.1:0',
      '--disable-telemetry', '--disable-update-check', '--disable-getting-started-override'],
    { env: this.env, stdio: ['ignore', 'pipe', 'pipe'], detached: true });
    this.log = '';
    return new Promise((resolve, reject) => {
      const read = (data) => {
        this.log += data;
        const found = /HTTP server listening on (http:\/\/[^\s/]+)/.exec(this.log);
        if (found) resolve((this.url = found[1]));
      };
      this.process.stdout.on('data', read);
      this.process.stderr.on('data', read);
      this.process.on('exit', () => reject(new Error(`code-server has ended:\n${this.log}`)));
    });
  }

  /** The processes of the extension's own program: `{pid, args}`. */
  servers() {
    return readdirSync('/proc').filter((name) => /^\d+$/.test(name)).flatMap((name) => {
      try {
        const args = readFileSync(`/proc/${name}/cmdline`, 'utf8').split('\0');
        return args[0].startsWith(join(this.home, 'extensions')) ? [{ pid: Number(name), args: args.slice(1, -1) }] : [];
      } catch {
        return [];
      }
    });
  }

  /** Number of processes that verify for this editor's server. */
  workers() {
    return readdirSync('/proc').filter((name) => /^\d+$/.test(name)).filter((name) => {
      try {
        return readlinkSync(`/proc/${name}/exe`).startsWith(this.home) && readFileSync(`/proc/${name}/cmdline`, 'utf8').includes('verify-worker');
      } catch {
        return false;
      }
    }).length;
  }

  stop() {
    try {
      process.kill(-this.process.pid, 'SIGTERM');
    } catch {
      // it has ended
    }
    rmSync(this.home, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}
