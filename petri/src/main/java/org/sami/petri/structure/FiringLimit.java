package org.sami.petri.structure;

import org.sami.petri.net.PetriNet;

/** A column of the incidence matrix counts so many times or more, or so many or fewer: one half of a distinction of cases that leaves no whole number out. */
record FiringLimit(int column, boolean least, long count) {

    /** The limit as a row of {@code row · x ≥ least()}. */
    IntegerVector row() {
        return IntegerVector.unit(column, least ? 1 : -1);
    }

    long bound() {
        return least ? count : -count;
    }

    String words(PetriNet net, Incidence incidence) {
        String number = (least ? "at least " : "at most ") + count;
        if (column < net.transitionCount()) {
            return net.transitionName(column) + " fires " + number + " times";
        }
        int emptied = incidence.columns().get(column).indexAt(0);
        return "resets remove " + number + " tokens of " + net.placeName(emptied);
    }
}
