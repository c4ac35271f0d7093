// What is asked for when nothing has changed for some time.

export class Calm {
  /** `then` is called once `after` [ms] have passed since the last beginning. */
  constructor(after, then) {
    Object.assign(this, { after, then, timer: null });
  }

  begin() {
    this.stop();
    this.timer = setTimeout(() => {
      this.timer = null;
      this.then();
    }, this.after);
  }

  stop() {
    clearTimeout(this.timer);
    this.timer = null;
  }

  get isWaiting() {
    return this.timer !== null;
  }
}
