import * as vscode from 'vscode';
import { DocumentOnTypeFormattingRequest, type LanguageClient, type Middleware, type TextEdit } from 'vscode-languageclient/node';
import * as protocol from '../protocol';
import { backwards, moved } from './edits';

/** Milliseconds until edits that VS Code has not made count as dropped. */
const kMostToWait = 1000;

/** Where something was typed: the beginning of a line that Enter began or ended, or the end of a parenthesis. */
interface Place {
  at: protocol.panel.Position;
  isLine: boolean;
}

/** What was typed in a text and may not be formatted. */
interface Text {
  places: Place[];
  /** on-type requests whose edits VS Code has not made: another edit would make it drop them */
  requests: number;
  isBusy: boolean;
  /** something has happened while it was busy */
  isDue: boolean;
  /** the first line that has changed since edits were requested */
  changed: number;
}

/**
 * VS Code drops the answer to on-type formatting if the text changes before it arrives, so what is typed faster than the server answers would stay as it is.
 * Therefore a line that was typed is formatted once the caret has left it, and a definition once it is complete: never the line of the caret, and nothing that
 * was pasted, undone, or saved by the user.
 */
export class TypedLines implements vscode.Disposable {
  private readonly texts = new Map<vscode.TextDocument, Text>();
  private readonly subscriptions = [
    vscode.workspace.onDidChangeTextDocument((event) => this.change(event)),
    vscode.workspace.onDidCloseTextDocument((document) => {
      this.forget(document);
      this.texts.delete(document);
    }),
    vscode.workspace.onWillSaveTextDocument(({ document, reason }) => reason === vscode.TextDocumentSaveReason.Manual && this.forget(document)),
    vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => void this.format(textEditor.document)),
  ];

  constructor(private readonly client: () => LanguageClient | undefined) {}

  readonly middleware: NonNullable<Middleware['provideOnTypeFormattingEdits']> = async (document, position, ch, options, token, next) => {
    if (document.languageId !== 'proskill') return next(document, position, ch, options, token);
    const text = this.textOf(document);
    const places = placesOf(position, ch);
    for (const place of places) text.places = text.places.filter((other) => !isSame(other, place)).concat(place);
    ++text.requests;
    let edits: vscode.TextEdit[] | null | undefined;
    try {
      return (edits = await next(document, position, ch, options, token));
    } finally {
      void this.answered(document, text, places[0], token.isCancellationRequested ? undefined : edits);
    }
  };

  dispose(): void {
    vscode.Disposable.from(...this.subscriptions).dispose();
  }

  /** VS Code makes the edits of an answer a moment later. An answer without edits says that the place is formatted. */
  private async answered(document: vscode.TextDocument, text: Text, asked: Place, edits: vscode.TextEdit[] | null | undefined): Promise<void> {
    if (edits?.length) await nextChange(document);
    else if (edits) text.places = text.places.filter((place) => place !== asked);
    --text.requests;
    void this.format(document);
  }

  private textOf(document: vscode.TextDocument): Text {
    const text = this.texts.get(document) ?? { places: [], requests: 0, isBusy: false, isDue: false, changed: 0 };
    this.texts.set(document, text);
    return text;
  }

  private forget(document: vscode.TextDocument): void {
    const text = this.texts.get(document);
    if (text) text.places = [];
  }

  private change({ document, contentChanges, reason }: vscode.TextDocumentChangeEvent): void {
    const text = this.texts.get(document);
    if (!text || !contentChanges.length) return;
    if (reason !== undefined) text.places = []; // undone, or done again
    for (const change of backwards(contentChanges)) {
      text.changed = Math.min(text.changed, change.range.start.line);
      text.places = text.places.filter((place) => {
        const now = moved(place.at, change);
        if (now) place.at = now;
        return now && (!place.isLine || now.character === 0);
      });
    }
    void this.format(document);
  }

  private async format(document: vscode.TextDocument): Promise<void> {
    const text = this.texts.get(document);
    if (!text) return;
    text.isDue = true;
    if (text.isBusy) return;
    text.isBusy = true;
    while (text.isDue && !text.requests) {
      text.isDue = false;
      await this.formatOnce(document, text).catch(() => undefined); // requested again after the next change
    }
    text.isBusy = false;
  }

  private async formatOnce(document: vscode.TextDocument, text: Text): Promise<void> {
    const client = this.client();
    const left = this.left(document, text);
    if (!client || !left.length) return;
    if (!isOn(document)) return this.forget(document);
    const parenthesis = left.find(({ isLine }) => !isLine);
    const places = parenthesis ? [parenthesis] : left;
    text.changed = Infinity;
    const edits = await (parenthesis ? definition(client, document, parenthesis) : lines(client, document, left));
    if (!isStillLeft(document, text, places)) return; // something has happened, after which they are requested again
    if (!(await apply(document, edits))) return; // the text has changed, of which the extension is about to hear
    text.places = text.places.filter((place) => !places.includes(place));
    text.isDue = true;
  }

  /** What the caret has left; nothing of a text that is not in view. Empty lines stay as they are. */
  private left(document: vscode.TextDocument, text: Text): Place[] {
    if (!editorsOf(document).length) return [];
    const carets = caretLines(document);
    const left = text.places.filter(({ at }) => !carets.has(at.line));
    const empty = left.filter(({ at }) => document.lineAt(at.line).isEmptyOrWhitespace);
    text.places = text.places.filter((place) => !empty.includes(place));
    return left.filter((place) => !empty.includes(place));
  }
}

/** The places of what was typed; the first is the one that the server is asked about. */
const placesOf = ({ line, character }: vscode.Position, ch: string): [Place, ...Place[]] =>
  ch === '\n'
    ? [{ at: { line: line - 1, character: 0 }, isLine: true }, { at: { line, character: 0 }, isLine: true }]
    : [{ at: { line, character }, isLine: false }];

const isSame = (a: Place, b: Place): boolean => a.isLine === b.isLine && a.at.line === b.at.line;

const isOn = (document: vscode.TextDocument): boolean => vscode.workspace.getConfiguration('editor', document).get('formatOnType', false);

/** Whether edits for these places may be made: nothing above has changed since they were requested, and neither carets nor an undo have come. */
function isStillLeft(document: vscode.TextDocument, text: Text, places: Place[]): boolean {
  const carets = caretLines(document);
  return places.every((place) => place.at.line < text.changed && text.places.includes(place) && !carets.has(place.at.line));
}

function nextChange(document: vscode.TextDocument): Promise<void> {
  return new Promise((resolve) => {
    const done = (): void => {
      clearTimeout(limit);
      subscription.dispose();
      resolve();
    };
    const limit = setTimeout(done, kMostToWait);
    const subscription = vscode.workspace.onDidChangeTextDocument((event) => event.document === document && event.contentChanges.length && done());
  });
}

const editorsOf = (document: vscode.TextDocument): vscode.TextEditor[] => vscode.window.visibleTextEditors.filter((editor) => editor.document === document);

const caretLines = (document: vscode.TextDocument): Set<number> =>
  new Set(editorsOf(document).flatMap(({ selections }) => selections.map(({ active }) => active.line)));

const about = ({ uri }: vscode.TextDocument): { textDocument: { uri: string } } => ({ textDocument: { uri: uri.toString() } });

async function definition(client: LanguageClient, document: vscode.TextDocument, { at }: Place): Promise<TextEdit[]> {
  const options = { tabSize: 2, insertSpaces: true };
  return (await client.sendRequest(DocumentOnTypeFormattingRequest.type, { ...about(document), position: at, ch: ')', options })) ?? [];
}

function lines(client: LanguageClient, document: vscode.TextDocument, places: Place[]): Promise<TextEdit[]> {
  return client.sendRequest(protocol.indent, { ...about(document), lines: places.map(({ at }) => at.line) });
}

/** Edits that would move the line of a caret are not made. One undo undoes what was typed together with the edits. */
async function apply(document: vscode.TextDocument, edits: TextEdit[]): Promise<boolean> {
  const carets = [...caretLines(document)];
  const [editor] = editorsOf(document);
  if (!editor || !edits.length || edits.some(({ range: { start, end } }) => carets.some((line) => start.line <= line && line <= end.line))) return true;
  return editor.edit((builder) => {
    for (const { range: { start, end }, newText } of edits)
      builder.replace(new vscode.Range(start.line, start.character, end.line, end.character), newText);
  }, { undoStopBefore: false, undoStopAfter: false });
}
