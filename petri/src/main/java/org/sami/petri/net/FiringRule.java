package org.sami.petri.net;

/** The firing rule on markings as arrays; see {@link PetriNet}. For where clearness counts more than speed: replays, explanations, checks. */
public final class FiringRule {
    private FiringRule() {}

    /** Whether a transition is enabled in a marking. */
    public static boolean isEnabled(PetriNet net, int transition, int[] marking) {
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
     * The marking after an enabled transition has fired.
     *
     * @return a new array
     * @throws IllegalArgumentException if the transition is not enabled
     * @throws ArithmeticException if a place would have more than {@link Integer#MAX_VALUE} tokens
     */
    public static int[] fire(PetriNet net, int transition, int[] marking) {
        if (!isEnabled(net, transition, marking)) {
            throw new IllegalArgumentException("transition " + net.transitionId(transition) + " is not enabled");
        }
        int[] next = marking.clone();
        ArcTable consumed = net.consumed();
        for (int arc = consumed.from(transition); arc < consumed.to(transition); arc++) {
            next[consumed.node(arc)] -= consumed.weight(arc);
        }
        ArcTable resets = net.resets();
        for (int arc = resets.from(transition); arc < resets.to(transition); arc++) {
            next[resets.node(arc)] = 0;
        }
        ArcTable produced = net.produced();
        for (int arc = produced.from(transition); arc < produced.to(transition); arc++) {
            next[produced.node(arc)] = Math.addExact(next[produced.node(arc)], produced.weight(arc));
        }
        return next;
    }
}
