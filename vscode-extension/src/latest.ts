/** Takes one action at a time. While one is in work, only the newest of those that follow is kept. */
export class Latest {
  private next: (() => Promise<void>) | undefined;
  private isBusy = false;

  /** Resolves when nothing is left to do. Fails if an action fails; those that follow are taken all the same. */
  async take(action: () => Promise<void>): Promise<void> {
    this.next = action;
    if (this.isBusy) return;
    this.isBusy = true;
    let failure: unknown;
    while (this.next) {
      const now = this.next;
      this.next = undefined;
      await now().catch((error: unknown) => (failure = error));
    }
    this.isBusy = false;
    if (failure !== undefined) throw failure;
  }
}
