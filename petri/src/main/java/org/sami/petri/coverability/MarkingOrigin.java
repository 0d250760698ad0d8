package org.sami.petri.coverability;

/**
 * How a search found a marking.
 *
 * @param parent the number of the marking from which; -1 of the initial one
 * @param transition what fired
 * @param repeatedFrom the first marking on the run that it covered, from which the run can be repeated; -1 where none
 * @param depth how many firings lead to it
 * @param milestone the nearest milestone before it on the run; -1 where none
 */
record MarkingOrigin(int parent, int transition, int repeatedFrom, int depth, int milestone) {
    /** So many firings lie between two milestones of a run. */
    static final int MILESTONE = 128;

    /** That of the initial marking. */
    static final MarkingOrigin FIRST = new MarkingOrigin(-1, -1, -1, 0, -1);

    /** Whether the marking is one of those with which all later ones of the run are compared. */
    boolean isMilestone() {
        return depth % MILESTONE == 0;
    }

    /** The origin of a marking to which a firing leads from this one, whose number is given. */
    MarkingOrigin next(int number, int fired, int repeated) {
        return new MarkingOrigin(number, fired, repeated, depth + 1, isMilestone() ? number : milestone);
    }
}
