// One request in flight, the latest wins: what is asked for meanwhile waits, and only its last value is sent.
export class Latest<Ask, Answer> {
  private waiting_: {ask: Ask} | null = null;
  private running_: Promise<void> | null = null;

  constructor(
    private readonly call_: (ask: Ask) => Promise<Answer>,
    private readonly answered_: (answer: Answer, ask: Ask) => void,
    private readonly failed_: (error: unknown) => void,
  ) {}

  push(ask: Ask): void {
    this.waiting_ = {ask};
    this.running_ ??= this.run_();
  }

  /** When all that was pushed is answered. */
  async settled(): Promise<void> {
    while (this.running_) await this.running_;
  }

  private async run_(): Promise<void> {
    while (this.waiting_) {
      const {ask} = this.waiting_;
      this.waiting_ = null;
      try {
        this.answered_(await this.call_(ask), ask);
      } catch (error) {
        this.failed_(error);
      }
    }
    this.running_ = null;
  }
}
