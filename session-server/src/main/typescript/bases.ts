// The bases at which the session may be: one holds it, the others are its standbys.

const FIRST_WAIT_MS = 1000;
const LONGEST_WAIT_MS = 30000;
const FIRST_WAIT_OF_SEVERAL_MS = 500; // a round costs little, and one of them takes over within seconds
const LONGEST_WAIT_OF_SEVERAL_MS = 1000;
const KEPT = 'bases';

/** Where texts are kept: storage of the browser. */
export interface Kept {
  getItem(name: string): string | null;
  setItem(name: string, text: string): void;
}

export class Bases {
  kept: Kept;
  own: string;
  all: string[];
  /** They do not know this person. */
  leftOut: Set<string>;
  at: number;
  held: string;
  epoch: number;
  rounds: number;
  tried: number;

  /** The base that served this page, and those that it named before. */
  constructor(place: {protocol: string, host: string}, kept: Kept) {
    this.kept = kept;
    const own = (place.protocol === 'https:' ? 'wss://' : 'ws://') + place.host;
    this.own = own; // from which the page has come
    this.all = [own];
    this.leftOut = new Set();
    this.at = 0;
    this.held = own; // by this one, as far as is known here
    this.epoch = 0;
    this.rounds = 0;
    this.tried = 0; // in this round
    this.take(JSON.parse(kept.getItem(KEPT) ?? '[]'));
  }

  /** The base that served this page and the one at hand stay; others are those that are named now and were not left out. */
  take(addresses: string[]) {
    const current = this.current();
    this.all = [...new Set([this.all[0], current, ...addresses.filter((one) => !this.leftOut.has(one))])];
    this.at = this.all.indexOf(current);
  }

  /** Takes up the rows of bases, where there are any, and keeps them for a page that is opened without a base. */
  add(rows: {id: string}[]) {
    if (rows.length > 0) {
      this.take(rows.map((row) => row.id));
      this.kept.setItem(KEPT, JSON.stringify(this.all));
    }
  }

  current() {
    return this.all[this.at];
  }

  /** Host and port of the base at hand. */
  name() {
    return this.current().replace(/^wss?:[/][/]/, '');
  }

  /** Host and port of all. */
  names() {
    return this.all.map((one) => one.replace(/^wss?:[/][/]/, ''));
  }

  /** Tries a base next that is known. */
  turnTo(address: string) {
    this.at = Math.max(0, this.all.indexOf(address));
  }

  areSeveral() {
    return this.all.length > 1;
  }

  /** A connection that stood is lost. Gives how many milliseconds to wait. @param isSilent so that the next base is tried first; else the same one */
  lost(isSilent: boolean) {
    this.begin();
    this.at = isSilent ? (this.at + 1) % this.all.length : this.at;
    return this.areSeveral() ? 0 : FIRST_WAIT_MS;
  }

  begin() {
    this.rounds = 0;
    this.tried = 0;
  }

  /** Turns to the next base. Gives how many milliseconds to wait: longer and longer, each time that all were tried. */
  next() {
    this.at = (this.at + 1) % this.all.length;
    this.tried += 1;
    if (this.tried < this.all.length) {
      return 0;
    }
    this.tried = 0;
    const first = this.areSeveral() ? FIRST_WAIT_OF_SEVERAL_MS : FIRST_WAIT_MS;
    const wait = Math.min(this.areSeveral() ? LONGEST_WAIT_OF_SEVERAL_MS : LONGEST_WAIT_MS, first * 2 ** this.rounds);
    this.rounds += 1;
    return wait;
  }

  /** The base at hand says that it holds the session; false where another has followed it, whatever it says. */
  holds(epoch: number) {
    if (epoch < this.epoch) {
      return false;
    }
    this.epoch = epoch;
    this.begin();
    return true;
  }

  /** Whether the base at hand, which holds the session, is another one than before. */
  hasMoved() {
    const moved = this.held !== this.current();
    this.held = this.current();
    return moved;
  }

  /** Whether the session is held by another base than the one that served this page. */
  isElsewhere() {
    return this.held !== this.own;
  }

  /** Where pictures and the map of the base that holds the session are: empty at the base that served this page, else its address for HTTP. */
  web() {
    return this.isElsewhere() ? this.held.replace(/^ws/, 'http') + '/' : '';
  }

  /** Another person joins, whom other bases may know. */
  leaveOutNone() {
    this.leftOut.clear();
  }

  /** Never tries the base at hand again for this person; false where there is no other. */
  leaveOut() {
    if (!this.areSeveral()) {
      return false;
    }
    this.leftOut.add(this.current());
    this.all.splice(this.at, 1);
    this.at = (this.at + this.all.length - 1) % this.all.length; // the next is tried next
    return true;
  }
}
