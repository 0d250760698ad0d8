package org.sami.dreamm.help.word;

import java.awt.Component;
import java.awt.Point;
import java.util.Optional;

/** A component that knows better than its text in which words it is to be explained. */
public interface TermSource {
    /**
     * What is shown at a point.
     *
     * @param inner the component at the point: this one, or one in it
     * @param at in that component
     * @return in coordinates of that component; empty where its text is to be taken
     */
    Optional<ShownText> wordsAt(Component inner, Point at);

    /** What is selected in it; empty where its text is to be taken. */
    Optional<String> words();
}
