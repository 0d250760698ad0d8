package org.sami.spn.engine;

import java.util.Map;
import java.util.Optional;

/**
 * Which rules of firing this program follows (docs/semantics.md), as a number that rises whenever the same inputs can lead to other firings.
 * Headers of journals name it: 1, which they do not name, until 26 November 2026; 2 since robots that are gone are struck from answers, returns go
 * together by the tokens that they name and a filter that is left with nobody is given up (docs/semantics.md).
 */
public final class RuleVersion {
    /** The version of this program. */
    public static final int CURRENT = 2;

    /** The setting of a journal's header that names it. */
    public static final String SETTING = "rules";

    private static final String UNNAMED = "1";

    private RuleVersion() {}

    /** Why a journal with these settings cannot be gone on with, in words; empty where it can. */
    public static Optional<String> difference(Map<String, String> settings) {
        String version = settings.getOrDefault(SETTING, UNNAMED);
        return version.equals(Integer.toString(CURRENT))
                ? Optional.empty()
                : Optional.of(
                        "is of a program with other rules of firing (version " + version + ", this one's is " + CURRENT
                                + "), which could take its missions elsewhere than they were; go on with it in the program that wrote it,"
                                + " or begin a new one; crw journal, crw export and replays read it");
    }
}
