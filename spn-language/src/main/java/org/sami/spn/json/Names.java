package org.sami.spn.json;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.finding.Suggestions;

/** Names that must be unique, each with the place where it was first seen. */
final class Names {
    private final Map<String, String> seen = new LinkedHashMap<>();
    private final Problems problems;

    Names(Problems problems) {
        this.problems = problems;
    }

    /** Takes a name; one that is taken already is reported. Empty names were reported before. */
    void take(String name, String pointer) {
        if (name.isEmpty()) {
            return;
        }
        String before = seen.putIfAbsent(name, pointer);
        if (before != null) {
            problems.add(Codes.DUPLICATE, pointer, "\"" + name + "\" is used already at " + before, name);
        }
    }

    /** Where a name was first seen. */
    Optional<String> where(String name) {
        return Optional.ofNullable(seen.get(name));
    }

    /** The end of a sentence about a name that is not taken: which was probably meant, or nothing. */
    String meant(String name) {
        return Suggestions.meant(seen.keySet(), name);
    }

    boolean has(String name) {
        return seen.containsKey(name);
    }
}
