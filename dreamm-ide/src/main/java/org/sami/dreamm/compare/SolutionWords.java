package org.sami.dreamm.compare;

import java.util.Map;

/** Says what differs from another right plan, which is no earlier version: nothing was "before" or is "gone". */
final class SolutionWords {
    private static final Map<String, String> WHOLE = Map.of(
            "the mission ends here", "only in your plan the mission ends here",
            "the mission ends here no longer", "only in the solution the mission ends here",
            "the mission begins here", "only in your plan the mission begins here",
            "the mission begins here no longer", "only in the solution the mission begins here",
            "it waits for all", "it waits for all; in the solution it fires for each",
            "it fires for each", "it fires for each; in the solution it waits for all");

    private SolutionWords() {}

    /** The same difference in these words. */
    static Difference of(Difference difference) {
        return new Difference(of(difference.text()), difference.elements());
    }

    private static String of(String text) {
        int colon = text.lastIndexOf(": ");
        String what = text.substring(colon < 0 ? 0 : colon + 2);
        if (WHOLE.containsKey(what)) {
            return text.substring(0, colon + 2) + WHOLE.get(what);
        }
        return text.replaceFirst(" is new$", " is only in your plan")
                .replaceFirst(" is gone$", " is only in the solution")
                .replaceFirst(" has other settings$", " has other settings in the solution")
                .replaceFirst(" is another$", " is another in the solution")
                .replaceFirst(", before (.*)$", "; in the solution: $1");
    }
}
