import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import * as vscode from 'vscode';

interface Snippet {
  prefix: string | string[];
  body: string[];
  description: string;
}

/** A word at the start of a line, or after a parenthesis there. */
const kBeginning = /^(\(?)[\w-]*$/;

/**
 * Offers whole definitions where a definition may begin. VS Code would offer the snippets of a language wherever a word is typed, even a name, which Enter would
 * then replace. So a setting prevents that, and the server completes everything within a definition.
 */
export class Definitions implements vscode.CompletionItemProvider {
  private readonly snippets: Snippet[];

  constructor(extensionPath: string) {
    const all = JSON.parse(readFileSync(join(extensionPath, 'snippets/proskill.json'), 'utf8')) as Record<string, Snippet>;
    this.snippets = Object.values(all).filter(({ body }) => /^\((def|include)/.test(body[0] ?? ''));
  }

  provideCompletionItems(document: vscode.TextDocument, position: vscode.Position): vscode.CompletionItem[] {
    const line = document.lineAt(position).text;
    const opening = kBeginning.exec(line.slice(0, position.character))?.[1];
    if (opening === undefined) return [];
    const isClosed = opening !== '' && line[position.character] === ')';
    const range = new vscode.Range(position.with({ character: 0 }), position.translate(0, isClosed ? 1 : 0));
    return this.snippets.flatMap(({ prefix, body, description }) => [prefix].flat().map((label) => {
      const item = new vscode.CompletionItem({ label, description }, vscode.CompletionItemKind.Struct);
      item.filterText = opening + label;
      item.insertText = new vscode.SnippetString(body.join('\n'));
      item.range = range;
      item.sortText = `~${label}`;
      return item;
    }));
  }
}
