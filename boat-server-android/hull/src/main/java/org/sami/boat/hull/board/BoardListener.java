package org.sami.boat.hull.board;

/** Receives what happens to a board; called on the board's threads, and never while one of its locks is held. */
public interface BoardListener {
    /** Takes no notice. */
    BoardListener NONE = new BoardListener() {};

    /**
     * The link to the board is another. While it is not {@link BoardState#CONNECTED} the motors are commanded 0.
     *
     * @param why in words for people; empty where the board is back
     */
    default void stateChanged(BoardState state, String why) {}

    /** The board reports an error. */
    default void boardError(String error, String arguments) {}

    /** A line that cannot be read, or a value that makes no sense; said at most once in ten seconds, with how many there were. */
    default void garbled(String line, long count) {}
}
