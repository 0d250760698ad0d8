// @ts-check
// The link to the session (docs/session-link.md): login, rows as they change, commands with their replies.

const SILENT_MS = 30000;
const LONGEST_WAIT_MS = 30000;

export class Link {
  /**
   * @param {{changed: () => void, refused: (why: string) => void, news: (text: string) => void}} listener
   */
  constructor(listener) {
    this.listener = listener;
    /** @type {Map<string, Map<string, any>>} */
    this.tables = new Map();
    /** @type {any} */
    this.welcome = null;
    /** Of boats, by id. @type {Map<string, number>} */
    this.numbers = new Map();
    this.isOpen = false;
    this.heardAt = 0; // this device's clock
    this.aheadMs = 0; // of the session's clock before this device's
    this.waitMs = 1000;
    this.ids = 0;
    /** @type {Map<number, (reply: any) => void>} */
    this.asked = new Map();
    window.setInterval(() => this.look(), 1000);
  }

  /** @param {string} name @param {string} key */
  join(name, key) {
    this.name = name;
    this.key = key;
    this.connect();
  }

  connect() {
    const scheme = location.protocol === 'https:' ? 'wss://' : 'ws://';
    const socket = new WebSocket(scheme + location.host + '/session');
    this.socket = socket;
    socket.onopen = () => {
      const hello = {t: 'hello', v: 1, name: this.name};
      socket.send(JSON.stringify(this.key ? {...hello, key: this.key} : hello));
    };
    socket.onmessage = (event) => {
      if (this.socket === socket) {
        this.heardAt = Date.now();
        this.take(JSON.parse(event.data));
      }
    };
    socket.onclose = () => {
      if (this.socket === socket) {
        this.lost();
      }
    };
  }

  lost() {
    this.socket = undefined;
    this.isOpen = false;
    this.asked.forEach((reply) => reply({t: 'refused', text: 'The link to the session is lost'}));
    this.asked.clear();
    if (this.name !== undefined) {
      window.setTimeout(() => this.connect(), this.waitMs);
      this.waitMs = Math.min(LONGEST_WAIT_MS, this.waitMs * 2);
    }
    this.listener.changed();
  }

  look() {
    if (this.isOpen && Date.now() - this.heardAt > SILENT_MS) {
      const old = this.socket;
      this.lost();
      old?.close();
    } else {
      this.listener.changed();
    }
  }

  /** @param {any} message */
  take(message) {
    switch (message.t) {
      case 'welcome':
        this.welcome = message;
        this.isOpen = true;
        this.waitMs = 1000;
        this.aheadMs = message.now - Date.now();
        break;
      case 'rows':
        this.aheadMs = message.now - Date.now();
        this.rows(message);
        break;
      case 'done':
      case 'refused':
        if (message.id === 0 && !this.isOpen) {
          this.leave(message.text);
        } else {
          const reply = this.asked.get(message.id);
          this.asked.delete(message.id);
          reply?.(message);
        }
        break;
      case 'rights':
        this.welcome.role = message.role;
        this.welcome.rights = message.rights;
        this.listener.news(`Your role in this session is ${message.role} now`);
        break;
      case 'bye':
        this.leave(message.text);
        break;
      case 'news':
        this.listener.news(message.text);
        break;
      default: // of a later version
    }
    this.listener.changed();
  }

  /** @param {string} why */
  leave(why) {
    this.name = undefined;
    this.key = undefined;
    this.tables.clear();
    this.listener.refused(why);
  }

  /** @param {any} message */
  rows(message) {
    if (message.full) {
      this.tables.clear();
    }
    for (const [name, rows] of Object.entries(message.set ?? {})) {
      const table = this.tables.get(name) ?? new Map();
      this.tables.set(name, table);
      for (const row of rows) {
        table.set(row.id, row);
      }
    }
    for (const [name, ids] of Object.entries(message.gone ?? {})) {
      for (const id of ids) {
        this.tables.get(name)?.delete(id);
      }
    }
  }

  /**
   * The rows of a table, those with a rank by it.
   *
   * @param {string} table
   * @returns {any[]}
   */
  all(table) {
    const rows = [...(this.tables.get(table)?.values() ?? [])];
    return rows.sort((one, other) => (one.rank ?? 0) - (other.rank ?? 0) || String(one.id).localeCompare(other.id, 'en', {numeric: true}));
  }

  /** One row of a table. @param {string} table @param {string} id @returns {any} */
  row(table, id) {
    return this.tables.get(table)?.get(id);
  }

  /** The number of a boat, from 0, in the order in which boats were seen; it keeps it. @param {string} id */
  numberOf(id) {
    if (!this.numbers.has(id)) {
      this.all('boats').forEach((boat) => this.numbers.has(boat.id) || this.numbers.set(boat.id, this.numbers.size));
    }
    return this.numbers.get(id) ?? 0;
  }

  /** @param {string} right */
  may(right) {
    return this.isOpen && this.welcome.rights.includes(right);
  }

  /** Now, on the session's clock. */
  now() {
    return Date.now() + this.aheadMs;
  }

  /**
   * Gives a command; the reply is `done` or `refused`.
   *
   * @param {any} command
   * @returns {Promise<any>}
   */
  ask(command) {
    if (!this.isOpen || !this.socket) {
      return Promise.resolve({t: 'refused', text: 'The link to the session is lost'});
    }
    const id = ++this.ids;
    return new Promise((resolve) => {
      this.asked.set(id, resolve);
      this.socket?.send(JSON.stringify({...command, id}));
    });
  }
}
