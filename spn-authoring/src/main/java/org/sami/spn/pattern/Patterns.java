package org.sami.spn.pattern;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.Sequence;

/** The patterns that an author is offered: those of the language, then those of the domain. */
public final class Patterns {
    private static final List<Pattern> OF_THE_LANGUAGE =
            List.of(new WhenAllAreHere(), new UntilNoneIsLeft(), new AutonomyDecidesAtOnce(), new AskAgainOnNo());

    private Patterns() {}

    /** All of them, in the order of a menu. */
    public static List<Pattern> of(AuthoringLibrary library) {
        List<Pattern> patterns = new ArrayList<>(OF_THE_LANGUAGE);
        for (Sequence sequence : library.sequences()) {
            if (sequence instanceof Sequence.Manual manual && manual.pattern()) {
                patterns.add(new WatchAroundThis(manual));
            }
        }
        return patterns;
    }
}
