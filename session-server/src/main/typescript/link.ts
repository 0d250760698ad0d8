// The link to the session (docs/session-link.md): login, rows as they change, commands with their replies; to whichever of the session's bases holds it.
import {Bases} from './bases.js';
import type {Command, Hello, Reply, Right, Row, Rows, ServerMessage, Tables, Welcome} from './protocol.js';

const SILENT_MS = 30000;
const SILENT_BASE_MS = 5000; // of a base that sends something twice a second
const SILENT_ONLY_BASE_MS = 8000; // of such a base that is the only one: a new connection gets through lost packets sooner
const QUIET_MS = 1500;
const SCOUT_MS = 3000;

/** Who hears what comes. */
export interface Listener {
  changed(): void;
  refused(why: string): void;
  news(text: string): void;
}

export class Link {
  listener: Listener;
  tables: Map<string, Map<string, Row>>;
  welcome: Welcome | null;
  /** Of boats, by id. */
  numbers: Map<string, number>;
  isOpen: boolean;
  heardAt: number;
  aheadMs: number;
  bases: Bases;
  beats: boolean;
  waits: string;
  triedAt: number;
  scoutedAt: number;
  scouts: number;
  ids: number;
  socket: WebSocket | undefined;
  name: string | undefined;
  key: string | undefined;
  asked: Map<number, (reply: Reply) => void>;

  constructor(listener: Listener) {
    this.listener = listener;
    this.tables = new Map();
    this.welcome = null;
    this.numbers = new Map();
    this.isOpen = false;
    this.heardAt = 0; // this device's clock
    this.aheadMs = 0; // of the session's clock before this device's
    this.bases = new Bases(location, localStorage);
    this.beats = false; // the base sends something twice a second
    this.waits = ''; // what a standby has said
    this.triedAt = 0;
    this.scoutedAt = 0; // when it was looked last whether another base holds the session
    this.scouts = 0;
    this.ids = 0;
    this.asked = new Map();
    window.setInterval(() => this.look(), 500);
  }

  join(name: string, key: string) {
    this.name = name;
    this.key = key;
    this.bases.leaveOutNone();
    this.connect();
  }

  connect() {
    const socket = new WebSocket(this.bases.current() + '/session');
    this.socket = socket;
    this.triedAt = Date.now();
    socket.onopen = () => {
      const hello: Hello = {t: 'hello', v: 1, name: this.name ?? ''};
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

  longestSilence(): number {
    if (!this.beats) {
      return SILENT_MS;
    }
    return this.bases.areSeveral() ? SILENT_BASE_MS : SILENT_ONLY_BASE_MS;
  }

  lost(isSilent = false) {
    const stood = this.isOpen;
    this.socket = undefined;
    this.isOpen = false;
    this.asked.forEach((reply) => reply({t: 'refused', id: 0, text: 'The link to the session is lost'}));
    this.asked.clear();
    if (this.name !== undefined) {
      window.setTimeout(() => this.connect(), stood ? this.bases.lost(isSilent) : this.bases.next());
    }
    this.listener.changed();
  }

  look() {
    const now = Date.now();
    const isSilent = this.isOpen && now - this.heardAt > this.longestSilence();
    const answersNot = !this.isOpen && this.socket && this.bases.areSeveral() && now - this.triedAt > SILENT_BASE_MS;
    if (isSilent || answersNot) {
      this.turnAway(true);
    } else {
      this.scout(now);
      this.listener.changed();
    }
  }

  /** Where the base at hand stands still, as it is cut off from the journal, another may hold the session: a standby says at once that it is one, a base that holds it waits for a name. */
  scout(now: number) {
    if (!this.isOpen || !this.bases.areSeveral() || !this.all('fleet')[0]?.standStill || now - this.scoutedAt < SCOUT_MS) {
      return;
    }
    this.scoutedAt = now;
    const others = this.bases.all.filter((one) => one !== this.bases.current());
    const other = others[this.scouts++ % others.length];
    const socket = new WebSocket(other + '/session');
    let isStandby = false;
    socket.onmessage = () => (isStandby = true);
    window.setTimeout(() => {
      const holds = socket.readyState === WebSocket.OPEN && !isStandby;
      socket.close();
      if (holds && this.isOpen && this.all('fleet')[0]?.standStill) {
        this.bases.turnTo(other);
        this.turnAway();
      }
    }, SCOUT_MS - 1000);
  }

  /** Leaves the base at hand and tries again, there or at another. */
  turnAway(isSilent = false) {
    const old = this.socket;
    this.lost(isSilent);
    old?.close();
  }

  /** Whether nothing has come for 1.5 s from a base that sends something twice a second. */
  isQuiet() {
    return this.isOpen && this.beats && Date.now() - this.heardAt > QUIET_MS;
  }

  take(message: ServerMessage) {
    switch (message.t) {
      case 'welcome':
        if (!this.bases.holds(message.epoch ?? 0)) { // another base has followed it: nothing that it says is of now
          this.turnAway();
          break;
        }
        this.welcome = message;
        this.isOpen = true;
        this.beats = (message.beat ?? 0) > 0;
        if (this.bases.hasMoved()) {
          this.listener.news('At another base of the session now: ' + this.bases.name());
        }
        this.waits = '';
        this.aheadMs = message.now - Date.now();
        break;
      case 'rows':
        this.aheadMs = message.now - Date.now();
        this.rows(message);
        if (message.set?.bases) {
          this.bases.add(message.set.bases);
        }
        break;
      case 'standby':
        this.waits = this.bases.name() + ', a standby: ' + message.text;
        this.bases.add(message.bases ?? []);
        break; // and it closes
      case 'done':
      case 'refused':
        if (message.id === 0 && !this.isOpen && this.welcome && this.bases.leaveOut()) {
          this.listener.news(message.text); // another base does not know this person
        } else if (message.id === 0 && !this.isOpen) {
          this.leave(message.text);
        } else {
          const reply = this.asked.get(message.id);
          this.asked.delete(message.id);
          reply?.(message);
        }
        break;
      case 'rights':
        if (this.welcome) {
          this.welcome.role = message.role;
          this.welcome.rights = message.rights;
        }
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

  leave(why: string) {
    this.name = undefined;
    this.key = undefined;
    this.welcome = null; // so that a wrong key at the next login is said there, and leaves out no base
    this.tables.clear();
    this.listener.refused(why);
  }

  rows(message: Rows) {
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

  /** The rows of a table, those with a rank by it. */
  all<Name extends keyof Tables>(table: Name): Tables[Name][] {
    const rows = [...(this.tables.get(table)?.values() ?? [])] as Tables[Name][]; // as `rows` has put them in
    return rows.sort((one, other) => (one.rank ?? 0) - (other.rank ?? 0) || String(one.id).localeCompare(other.id, 'en', {numeric: true}));
  }

  /** One row of a table. */
  row<Name extends keyof Tables>(table: Name, id: string): Tables[Name] | undefined {
    return this.tables.get(table)?.get(id) as Tables[Name] | undefined;
  }

  /** The number of a boat, from 0, in the order in which boats were seen; it keeps it. */
  numberOf(id: string) {
    if (!this.numbers.has(id)) {
      this.all('boats').forEach((boat) => this.numbers.has(boat.id) || this.numbers.set(boat.id, this.numbers.size));
    }
    return this.numbers.get(id) ?? 0;
  }

  may(right: Right) {
    return this.isOpen && this.welcome !== null && this.welcome.rights.includes(right);
  }

  /** Now, on the session's clock. */
  now() {
    return Date.now() + this.aheadMs;
  }

  /** Gives a command; the reply is `done` or `refused`. */
  ask(command: Command): Promise<Reply> {
    if (!this.isOpen || !this.socket) {
      return Promise.resolve({t: 'refused', id: 0, text: 'The link to the session is lost'});
    }
    const id = ++this.ids;
    return new Promise((resolve) => {
      this.asked.set(id, resolve);
      this.socket?.send(JSON.stringify({...command, id}));
    });
  }
}
