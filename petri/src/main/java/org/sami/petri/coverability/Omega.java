package org.sami.petri.coverability;

import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Markings in which a place may have "any number of tokens", written {@link #OMEGA}: a marking with it stands for all that have arbitrarily many tokens there.
 *
 * <p>Source: Karp and Miller, "Parallel program schemata", Journal of Computer and System Sciences 3(2), 1969.
 */
public final class Omega {
    /** Any number of tokens; larger than each number that a place can have. */
    public static final int OMEGA = Integer.MAX_VALUE;

    private Omega() {}

    /** Whether a transition is enabled. */
    static boolean isEnabled(PetriNet net, int transition, int[] marking) {
        ArcTable consumed = net.consumed();
        for (int arc = consumed.from(transition); arc < consumed.to(transition); arc++) {
            if (marking[consumed.node(arc)] < consumed.weight(arc)) {
                return false;
            }
        }
        ArcTable inhibitors = net.inhibitors();
        for (int arc = inhibitors.from(transition); arc < inhibitors.to(transition); arc++) {
            if (marking[inhibitors.node(arc)] >= inhibitors.weight(arc)) {
                return false;
            }
        }
        return true;
    }

    /**
     * The marking after an enabled transition has fired; any number of tokens stays any number.
     *
     * @throws ArithmeticException if a place would have more tokens than can be counted
     */
    static int[] fire(PetriNet net, int transition, int[] marking) {
        int[] next = marking.clone();
        add(next, net.consumed(), transition, -1);
        ArcTable resets = net.resets();
        for (int arc = resets.from(transition); arc < resets.to(transition); arc++) {
            next[resets.node(arc)] = 0;
        }
        add(next, net.produced(), transition, 1);
        return next;
    }

    private static void add(int[] marking, ArcTable arcs, int transition, int sign) {
        for (int arc = arcs.from(transition); arc < arcs.to(transition); arc++) {
            int place = arcs.node(arc);
            if (marking[place] != OMEGA) {
                marking[place] = Math.addExact(marking[place], sign * arcs.weight(arc));
                if (marking[place] == OMEGA) {
                    throw new ArithmeticException("more than " + (OMEGA - 1) + " tokens");
                }
            }
        }
    }
}
