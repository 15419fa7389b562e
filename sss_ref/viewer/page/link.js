// The connection to the server: what comes is handed on, and where it breaks it is made again.

const SLOWEST = 3000; // milliseconds between two tries

export class Link {
  // on: name of a kind of message -> what takes its facts and, behind them, its bytes. onState: told whether it holds.
  constructor(on, onState) {
    this.on = on;
    this.onState = onState;
    this.wait = 250;
    this.open();
  }

  open() {
    const socket = new WebSocket(`ws://${location.host}/socket`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.wait = 250;
      this.onState(true);
    };
    socket.onmessage = (event) => this.take(event.data);
    socket.onclose = () => {
      this.onState(false);
      setTimeout(() => this.open(), this.wait);
      this.wait = Math.min(2 * this.wait, SLOWEST);
    };
    this.socket = socket;
  }

  take(data) {
    if (typeof data === "string") {
      const facts = JSON.parse(data);
      this.on[facts.kind](facts);
      return;
    }
    const length = new DataView(data).getUint32(0, true);
    const facts = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
    this.on[facts.kind](facts, data, 4 + length);
  }

  say(kind, facts = {}) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify({ kind, ...facts }));
  }

  bytes(part) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(part);
  }
}
