package org.sami.boat.hull.board;

/** How the link to the board is. */
public enum BoardState {
    /** There is no board: its port is not open. */
    GONE,
    /** Its port is open, but the board has said nothing for a second. */
    SILENT,
    /** The board reports. */
    CONNECTED
}
