package org.sami.lessons.course;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** What stands for members that a file leaves out. */
final class Absent {
    private Absent() {}

    static <T> List<T> orNone(@Nullable List<T> given) {
        return given == null ? List.of() : List.copyOf(given);
    }

    static String orEmpty(@Nullable String given) {
        return given == null ? "" : given;
    }
}
