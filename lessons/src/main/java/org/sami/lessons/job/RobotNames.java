package org.sami.lessons.job;

import java.util.Collection;
import java.util.List;

/** The robots of hidden cases, by their names. */
final class RobotNames {
    private static final List<String> NAMES = List.of(
            "anna", "bert", "carl", "dora", "emil", "frida", "gustav", "hanna", "ida", "jan", "karla", "lars", "mona",
            "nils", "olga", "paul", "quinn", "rosa", "sven", "tine");

    private RobotNames() {}

    static final int MOST = NAMES.size();

    static List<String> first(int count) {
        return NAMES.subList(0, count);
    }

    /** The first that is not among the known ones. */
    static String next(Collection<String> known) {
        return NAMES.stream()
                .filter(name -> !known.contains(name))
                .findFirst()
                .orElseGet(() -> "robot-" + (known.size() + 1));
    }
}
