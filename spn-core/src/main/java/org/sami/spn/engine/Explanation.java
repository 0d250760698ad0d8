package org.sami.spn.engine;

import java.util.List;

/**
 * A yes or no with its reasons.
 *
 * @param reasons one sentence each, for people; empty where the answer is yes
 */
public record Explanation(boolean yes, List<String> reasons) {
    public Explanation {
        reasons = List.copyOf(reasons);
    }
}
