package org.sami.spn.planspace;

import java.util.List;

/** The words for states and firings of a net when its graph is drawn. */
public interface StateWords {
    /** The marked places with their tokens, each a few words. */
    List<String> marked(int[] marking);

    /** What a transition does. */
    String firing(int transition);

    /** Whether nothing needs to happen any more. */
    boolean isEnd(int[] marking);
}
