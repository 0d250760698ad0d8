package org.sami.spn.plannet;

import java.util.List;

/** A sub-mission as what starts and enters it sees it. */
interface StartedChild {
    /**
     * The cases of a firing that tokens, or nobody, enter the place by, or that takes tokens out of a running instance.
     *
     * @param edges by how many edges the place is entered
     * @param isByNobody whether nobody enters by one of them
     * @param isPulled whether an interrupt takes tokens out
     */
    List<CaseArcs> changed(CaseArcs arcs, int edges, boolean isByNobody, boolean isPulled);

    /** The parent's mission starts: a shared child starts with it. */
    void parentStarts(CaseArcs arcs);

    /** Tokens enter the place in the firing that starts the parent's mission: nobody was there. */
    void enteredFirst(CaseArcs arcs);
}
