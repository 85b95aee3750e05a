import * as vscode from 'vscode';
import type { Client, Life } from './client';
import { inWords } from './findings';
import { isVerified } from './places';
import type { Programs } from './programs';
import type { Verdicts } from './protocol';

interface Look {
  text: string;
  tooltip: string;
  background?: 'warning' | 'error';
}

const kOfLife: Record<Exclude<Life, 'running'>, Look> = {
  starting: { text: '$(loading~spin) ProSkill', tooltip: 'The server is starting' },
  crashed: { text: '$(error) ProSkill: crashed', tooltip: 'The server crashed too often; click to restart it', background: 'error' },
  missing: { text: '$(error) ProSkill: no server', tooltip: 'Cannot start the server; click for help', background: 'error' },
  stopped: { text: '$(circle-slash) ProSkill', tooltip: 'The server is not running' },
};

/** The number of bad verdicts, in the words of the command line, or the number of all. */
function outcome({ counts, stale }: Verdicts): Look {
  const old = stale ? ' (outdated)' : '';
  const tooltip = `${[inWords(counts), `${counts.good} good`].filter((part) => part).join(', ')}${old}`;
  if (!counts.errors && !counts.warnings) {
    const open = counts.inconclusive ? `, ${inWords(counts)}` : '';
    return { text: `$(pass) ProSkill: ${counts.good} of ${counts.total} good${open}${old}`, tooltip };
  }
  const text = `${counts.errors ? '$(error)' : '$(warning)'} ProSkill: ${inWords({ ...counts, inconclusive: 0 })}${old}`;
  return { text, tooltip, ...(counts.errors && !stale && { background: 'error' as const }) };
}

/** Findings before everything is decided. */
function soFar({ counts, stale }: Verdicts): string {
  const found = stale ? '' : inWords({ ...counts, inconclusive: 0 });
  return found && `, ${found}`;
}

/** The text of the status bar for a program. */
export function lookOf(program: Verdicts): Look {
  const { progress } = program;
  switch (program.state) {
    case 'waiting': return program.verdicts.length ? outcome(program) : { text: '$(check) ProSkill', tooltip: '' };
    case 'checking':
      return {
        text: progress ? `$(sync~spin) ProSkill: verifying, ${progress.decided} of ${progress.total} decided${soFar(program)}` : '$(sync~spin) ProSkill: verifying',
        tooltip: progress
          ? `${progress.classes.toLocaleString()} states, ${Math.round(progress.rate).toLocaleString()} a second, ` +
            `${Math.round(progress.bytes / 1e6)} MB, ${progress.seconds.toFixed(1)} s`
          : '',
      };
    case 'done': return outcome(program);
    case 'errors': return { text: '$(error) ProSkill: errors', tooltip: 'The program has errors; nothing is verified' };
    case 'failed': return { text: '$(warning) ProSkill: failed', tooltip: program.message, background: 'warning' };
    case 'off': return program.verdicts.length ? outcome(program) : { text: '$(check) ProSkill', tooltip: program.message };
  }
}

/** The only place that computes the state; everything else uses the same `Programs`. */
export class Status implements vscode.Disposable {
  private readonly item = vscode.window.createStatusBarItem('proskill.status', vscode.StatusBarAlignment.Left, 10);
  private readonly subscriptions: vscode.Disposable[];
  /** the text that had the focus last */
  private last: string | undefined;

  constructor(private readonly client: Client, private readonly programs: Programs) {
    this.item.name = 'ProSkill';
    this.item.command = 'proskill.status';
    this.subscriptions = [
      this.item,
      client.onLife(() => this.show()),
      programs.onChange(() => this.show()),
      vscode.window.onDidChangeActiveTextEditor(() => this.show()),
      vscode.workspace.onDidGrantWorkspaceTrust(() => this.show()),
    ];
    this.show();
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  private show(): void {
    const look = this.look();
    this.item.text = look.text;
    const lines = [look.tooltip, ...this.about()].filter((line) => line);
    this.item.tooltip = lines.join('\n');
    this.item.accessibilityInformation = { label: `${look.text.replace(/\$\([^)]*\) ?/, '')}. ${lines.join('. ')}` };
    this.item.backgroundColor = look.background && new vscode.ThemeColor(`statusBarItem.${look.background}Background`);
    this.item.show();
  }

  private look(): Look {
    if (this.client.life !== 'running') return kOfLife[this.client.life];
    const program = this.current();
    if (!vscode.workspace.isTrusted)
      return { text: '$(shield) ProSkill: syntax and static checks', tooltip: 'The workspace is not trusted: nothing is verified' };
    return program ? lookOf(program) : { text: '$(check) ProSkill', tooltip: 'Ready' };
  }

  /** The program of the visible text, even if a panel has the focus; otherwise the only program. */
  private current(): Verdicts | undefined {
    const active = vscode.window.activeTextEditor?.document;
    const text = active ?? vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === this.last)?.document;
    if (text) this.last = text.uri.toString();
    // one that the server does not know yet has no verdicts, and those of another would mislead
    if (text && isVerified(text)) return this.programs.of(text.uri)[0];
    const open = this.programs.all().filter((program) => program.state !== 'off');
    return open.length === 1 ? open[0] : undefined;
  }

  private about(): string[] {
    const program = this.current();
    const server = this.client.server;
    return [program ? `Program: ${program.label}${program.main ? `, mission ${program.main}` : ''}` : '',
      program?.stale ? 'The verdicts are for an older version of the text' : '', server?.version ?? ''];
  }
}
