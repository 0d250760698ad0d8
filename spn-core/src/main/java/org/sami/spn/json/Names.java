package org.sami.spn.json;

import java.util.HashMap;
import java.util.Map;

/** Names that must be unique, each with the place where it was first seen. */
final class Names {
    private final Map<String, String> seen = new HashMap<>();
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

    boolean has(String name) {
        return seen.containsKey(name);
    }
}
