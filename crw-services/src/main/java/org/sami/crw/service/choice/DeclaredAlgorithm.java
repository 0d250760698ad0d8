package org.sami.crw.service.choice;

import java.util.Map;
import java.util.Optional;

/**
 * An algorithm that declares its strengths (thesis 3.1, Markup: agent services indicate which markup options they support, so that the most
 * appropriate one is found at run time).
 *
 * @param <P> the problems that it solves
 */
public interface DeclaredAlgorithm<P> {
    /** Name for people. */
    String name();

    /** The criteria that it serves, and how well; a criterion that is not there is not served. */
    Map<Criterion, Merit> serves();

    /** Why it cannot be used for a problem; empty where it can. Looks at sizes and kinds alone, and costs next to nothing. */
    default Optional<String> whyNot(P problem) {
        return Optional.empty();
    }
}
