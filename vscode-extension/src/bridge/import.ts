import { execFile } from 'node:child_process';
import { existsSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import * as vscode from 'vscode';
import type { Client } from '../client';
import type { Server } from '../find_server';

/** The languages of `proskill import`, by the ends of their files' names. */
const kLanguages: Record<string, string> = { '.gen': 'gen', '.rl': 'rl', '.rlc': 'rl', '.xml': 'bt' };
/** A file beside the imported one, with the durations of what it declares. */
const kLeaves = 'leaves.json';

interface Translated {
  /** nothing, if it was written to a file */
  text: string;
  /** what was approximated, and what verdicts mean; or the errors */
  summary: string;
  failed: boolean;
}

/** "Import": other languages as ProSkill programs, by a command, a code action, or a file that is dropped into a program. */
export class Imports implements vscode.Disposable, vscode.CodeActionProvider, vscode.DocumentDropEditProvider {
  private readonly errors = vscode.languages.createDiagnosticCollection('proskill import');
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly client: Client) {
    const texts = Object.keys(kLanguages).map((end) => ({ scheme: 'file', pattern: `**/*${end}` }));
    this.subscriptions = [
      this.errors,
      vscode.languages.registerCodeActionsProvider(texts, this, { providedCodeActionKinds: [vscode.CodeActionKind.Refactor] }),
      vscode.languages.registerDocumentDropEditProvider('proskill', this),
      vscode.workspace.onDidChangeTextDocument(({ document }) => this.errors.delete(document.uri)),
    ];
  }

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** Writes the program beside the file, and opens it. Without a file, the user chooses one. */
  async open(uri?: vscode.Uri): Promise<void> {
    const file = uri ?? (await chosen());
    if (!file) return;
    if (!languageOf(file)) throw new Error(`\`${basename(file.fsPath)}\` is not a behavior tree (.xml), a component (.gen), a skillset (.rl) or a composite of skills (.rlc).`);
    await vscode.workspace.textDocuments.find((it) => it.uri.toString() === file.toString() && it.isDirty)?.save();
    const target = await placeFor(file);
    if (!target) return;
    const agreed = existsSync(target.fsPath) ? ['--force'] : [];
    const { summary, failed } = await this.translate(file, dirname(target.fsPath), ['-o', target.fsPath, ...agreed]);
    this.report(summary);
    if (failed) throw new Error(this.places(summary));
    await vscode.window.showTextDocument(target);
    void this.tell(summary);
  }

  provideCodeActions(document: vscode.TextDocument): vscode.CodeAction[] {
    if (extname(document.fileName) === '.xml' && !/<BehaviorTree\b/.test(document.getText())) return [];
    const action = new vscode.CodeAction('Import as a ProSkill program', vscode.CodeActionKind.Refactor);
    action.command = { title: action.title, command: 'proskill.import', arguments: [document.uri] };
    return [action];
  }

  /** The translation of a dropped file takes the place of its path. */
  async provideDocumentDropEdits(document: vscode.TextDocument, _position: vscode.Position, data: vscode.DataTransfer): Promise<vscode.DocumentDropEdit | undefined> {
    const list = (await data.get('text/uri-list')?.asString()) ?? '';
    const file = list.split(/\r?\n/).filter((line) => line && !line.startsWith('#')).map((line) => vscode.Uri.parse(line))[0];
    if (!file || !languageOf(file) || document.uri.scheme !== 'file') return undefined;
    const { text, summary, failed } = await this.translate(file, dirname(document.fileName), []);
    this.report(summary);
    void (failed ? vscode.window.showErrorMessage(`ProSkill: ${this.places(summary)}`) : this.tell(summary));
    return failed ? undefined : new vscode.DocumentDropEdit(text);
  }

  /** `folder` of the program, whose comments give the original's path from there. */
  private async translate(file: vscode.Uri, folder: string, options: string[]): Promise<Translated> {
    await this.client.whenRunning();
    const server = this.client.server;
    if (!server) throw new Error('The ProSkill server is not running. See the output "ProSkill".');
    const language = languageOf(file) ?? '';
    const leaves = join(dirname(file.fsPath), kLeaves);
    const known = language !== 'rl' && existsSync(leaves) ? ['--leaves', leaves] : [];
    return execute(server, ['import', language, file.fsPath, ...known, ...options], folder);
  }

  private report(summary: string): void {
    for (const line of summary.trimEnd().split('\n')) this.client.output.info(`import: ${line}`);
  }

  /** Marks the errors in their files. \return what to say: the message first, since a notification cuts off its end */
  private places(summary: string): string {
    this.errors.clear();
    const found = [...summary.matchAll(/^(.+?):(\d+):(\d+): error: (.*)$/gm)].map(([, file = '', line, column, message = '']) =>
      ({ file, begin: new vscode.Position(Number(line) - 1, Number(column) - 1), message }));
    for (const { file, begin, message } of found) {
      const uri = vscode.Uri.file(file);
      const mark = new vscode.Diagnostic(wordAt(uri, begin), message, vscode.DiagnosticSeverity.Error);
      mark.source = 'proskill import';
      this.errors.set(uri, [...(this.errors.get(uri) ?? []), mark]);
    }
    const [first] = found;
    return first ? `${first.message} (${basename(first.file)}:${first.begin.line + 1}:${first.begin.character + 1})` : summary.trim();
  }

  private async tell(summary: string): Promise<void> {
    const last = summary.trim().split('\n').pop() ?? '';
    const answer = await vscode.window.showInformationMessage(`ProSkill: ${last}.`, 'Details');
    if (answer) this.client.output.show();
  }
}

/** The word that begins there or one character later, as that of a tag does, if the text is open. */
function wordAt(uri: vscode.Uri, begin: vscode.Position): vscode.Range {
  const next = begin.translate(0, 1);
  const text = vscode.workspace.textDocuments.find((it) => it.uri.toString() === uri.toString());
  const word = text?.getWordRangeAtPosition(begin) ?? text?.getWordRangeAtPosition(next);
  return new vscode.Range(begin, word?.end ?? next);
}

const languageOf = (file: vscode.Uri): string | undefined => (file.scheme === 'file' ? kLanguages[extname(file.fsPath).toLowerCase()] : undefined);

/** The file of the active editor, if it is of another language, or one that the user chooses. */
async function chosen(): Promise<vscode.Uri | undefined> {
  const active = vscode.window.activeTextEditor?.document.uri;
  if (active && languageOf(active)) return active;
  const filters = { 'Behavior tree, component or skillset': Object.keys(kLanguages).map((end) => end.slice(1)) };
  return (await vscode.window.showOpenDialog({ filters, openLabel: 'Import' }))?.[0];
}

/** Beside the imported file. A program that is there is only replaced if the user agrees. */
async function placeFor(file: vscode.Uri): Promise<vscode.Uri | undefined> {
  const path = join(dirname(file.fsPath), `${basename(file.fsPath, extname(file.fsPath))}.proskill`);
  const beside = vscode.Uri.file(path);
  if (!existsSync(path)) return beside;
  const replace = 'Replace';
  const other = 'Choose Another File';
  const answer = await vscode.window.showWarningMessage(
    `${basename(path)} exists. If you have changed it since it was imported, these changes are lost.`, { modal: true }, replace, other);
  if (answer === replace) return beside;
  return answer === other ? vscode.window.showSaveDialog({ defaultUri: beside, filters: { ProSkill: ['proskill'] } }) : undefined;
}

function execute({ command, env }: Server, words: string[], cwd: string): Promise<Translated> {
  return new Promise((resolve, reject) => {
    const limits = { cwd, timeout: 60_000, maxBuffer: 64 << 20, env: { ...process.env, ...env } };
    execFile(command, words, limits, (error, text, summary) => {
      if (error && typeof error.code !== 'number') reject(error);
      else resolve({ text, summary, failed: error !== null });
    });
  });
}
