import { CloseAction, ErrorAction, type CloseHandlerResult, type ErrorHandler, type ErrorHandlerResult } from 'vscode-languageclient/node';

const kMost = 5;
const kWithin = 3 * 60 * 1000;

/** Starts a server that has crashed again, at most five times in three minutes. */
export class Restarts implements ErrorHandler {
  private crashes: number[] = [];

  constructor(
    private readonly restarted: () => void,
    private readonly givenUp: () => void,
    private readonly now: () => number = Date.now,
  ) {}

  /** A person has asked for it: the past does not count. */
  forget(): void {
    this.crashes = [];
  }

  error(): ErrorHandlerResult {
    return { action: ErrorAction.Continue };
  }

  closed(): CloseHandlerResult {
    const now = this.now();
    this.crashes = [...this.crashes.filter((when) => now - when < kWithin), now];
    if (this.crashes.length <= kMost) {
      this.restarted();
      return { action: CloseAction.Restart, handled: true };
    }
    this.givenUp();
    return { action: CloseAction.DoNotRestart, handled: true };
  }
}
