import * as vscode from 'vscode';
import type { Client } from './client';
import { Edits } from './writing/edits';
import { PanelHost, savedPanel } from './panel_host';
import { currentText } from './writing/current_text';
import type { Programs } from './programs';
import * as protocol from './protocol';
import type { panel } from './protocol';
import type { Typing } from './writing/typing';

const kTyping = 150;
const kMoving = 60;

/** "Show automaton": one preview per window, for the program of the text for which it was opened. */
export class AutomatonPreview implements vscode.Disposable {
  private host: PanelHost | undefined;
  private readonly subscriptions: vscode.Disposable[];
  private editing: NodeJS.Timeout | undefined;
  private moving: NodeJS.Timeout | undefined;
  /** since the picture that is shown, which is older while the text has errors */
  private readonly edits = new Edits();

  constructor(
    private readonly client: Client,
    private readonly programs: Programs,
    private readonly typing: Typing,
    private readonly context: vscode.ExtensionContext,
  ) {
    this.subscriptions = [
      vscode.workspace.onDidChangeTextDocument((change) => {
        if (change.document.languageId !== 'proskill' || !change.contentChanges.length) return;
        this.edits.note(change);
        this.edited();
      }),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => this.moved(textEditor)),
    ];
  }

  dispose(): void {
    this.host?.dispose();
    clearTimeout(this.editing);
    clearTimeout(this.moving);
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** Shows what is named, for example by a lens, or the definition at the caret. */
  async open(uri?: vscode.Uri, picture?: { kind: panel.PictureKind; name: string }): Promise<void> {
    const document = uri ? await vscode.workspace.openTextDocument(uri) : currentText();
    const show = this.wanted(document, picture);
    if (this.host && this.host.uri.toString() === document.uri.toString()) {
      this.host.showIt(await show);
      this.host.reveal(false);
      return;
    }
    this.host?.dispose();
    const host = new PanelHost(this.client, this.programs, this.typing, this.context, 'automaton', document.uri, show);
    this.take(host);
    await show.catch((error: unknown) => {
      host.dispose();
      throw error;
    });
  }

  private async wanted(document: vscode.TextDocument, picture?: { kind: panel.PictureKind; name: string }): Promise<panel.Show> {
    const caret = vscode.window.visibleTextEditors.find((it) => it.document === document)?.selection.active;
    if (!picture) return { picture: await this.here(document, caret), ...(caret && { at: locationAt(document, caret) }) };
    const [shown, definition] = await Promise.all([this.named(document, picture), definitionOf(document, picture.name)]);
    return { picture: shown, ...definition };
  }

  /** After a reload of the window: restores the picture. */
  async deserializeWebviewPanel(view: vscode.WebviewPanel): Promise<void> {
    const saved = savedPanel(this.context.workspaceState, 'automaton');
    if (!saved) return view.dispose();
    await this.client.whenRunning();
    this.take(new PanelHost(this.client, this.programs, this.typing, this.context, 'automaton', vscode.Uri.parse(saved.uri), undefined, view, saved.remembered));
  }

  private take(host: PanelHost): void {
    host.edits = this.edits;
    host.onPicture((picture) => {
      if (picture.errors) return;
      this.edits.forget(picture.texts);
      if (vscode.window.activeTextEditor) this.moved(vscode.window.activeTextEditor);
    });
    host.onEnd(() => {
      if (this.host === host) this.host = undefined;
    });
    this.host = host;
  }

  private async here(document: vscode.TextDocument, caret?: vscode.Position): Promise<{ kind: panel.PictureKind; name: string }> {
    const position = caret ?? new vscode.Position(0, 0);
    const { kind, name } = await this.client.running.sendRequest(protocol.automaton, {
      textDocument: { uri: document.uri.toString() },
      position: { line: position.line, character: position.character }, format: 'json',
    });
    return { kind, name };
  }

  /** A composite skill is shown by its body. */
  private async named(document: vscode.TextDocument, picture: { kind: panel.PictureKind; name: string }): Promise<typeof picture> {
    if (picture.kind !== 'skill') return picture;
    const { kind, name } = await this.client.running.sendRequest(protocol.automaton, {
      textDocument: { uri: document.uri.toString() }, name: picture.name, format: 'json',
    });
    return { kind, name };
  }

  private edited(): void {
    clearTimeout(this.editing);
    this.editing = setTimeout(() => this.host?.tell('edited', {}), kTyping);
  }

  private moved(editor: vscode.TextEditor): void {
    if (editor.document.languageId !== 'proskill') return;
    clearTimeout(this.moving);
    const here = locationAt(editor.document, editor.selection.active);
    this.moving = setTimeout(() => this.host?.tell('caret', this.edits.former(here)), kMoving);
  }
}

function locationAt(document: vscode.TextDocument, { line, character }: vscode.Position): panel.Location {
  return { uri: document.uri.toString(), range: { start: { line, character }, end: { line, character } } };
}

async function definitionOf(document: vscode.TextDocument, name: string): Promise<{ at?: panel.Location }> {
  const symbols = await vscode.commands.executeCommand<vscode.DocumentSymbol[] | undefined>('vscode.executeDocumentSymbolProvider', document.uri);
  const found = symbols?.find((symbol) => symbol.name === name);
  return found ? { at: locationAt(document, found.selectionRange.start) } : {};
}
