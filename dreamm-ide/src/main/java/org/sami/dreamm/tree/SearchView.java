package org.sami.dreamm.tree;

import java.util.List;

/** What is searched for in the project, and what was found. On the event thread. */
interface SearchView {
    /** Puts the focus where a search is typed. */
    void focusSearch();

    /** Shows what was found instead of the tree, until Escape. */
    void showHits(String title, List<Hit> found);

    /** Puts the focus on what was found. */
    void focusHits();
}
