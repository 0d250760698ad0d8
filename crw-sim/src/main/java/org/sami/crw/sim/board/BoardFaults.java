package org.sami.crw.sim.board;

/**
 * What goes wrong with a simulated board.
 *
 * @param lossPart part of the lines, either way, that is lost, 0 to 1
 * @param garblePart part of the board's lines of which a piece is missing, 0 to 1
 * @param pullEveryS seconds from one pull of the cable to the next; 0 for none
 * @param pullForS seconds until a pulled cable is put back
 */
public record BoardFaults(double lossPart, double garblePart, double pullEveryS, double pullForS) {
    /** A good cable. */
    public static final BoardFaults NONE = new BoardFaults(0, 0, 0, 0);

    private static final double LONGEST_S = 86_400;

    /** Refuses parts that are none, and a cable that is out for longer than it is in. */
    public BoardFaults {
        part("part of lost lines", lossPart);
        part("part of damaged lines", garblePart);
        if (!(pullEveryS >= 0 && pullEveryS <= LONGEST_S && pullForS >= 0 && pullForS <= pullEveryS)) {
            throw new IllegalArgumentException("a cable is pulled every 0 to " + (int) LONGEST_S
                    + " s, for no longer than that: not " + pullForS + " s every " + pullEveryS + " s");
        }
    }

    private static void part(String what, double value) {
        if (!(value >= 0 && value <= 1)) {
            throw new IllegalArgumentException("the " + what + " is 0 to 1, not " + value);
        }
    }
}
