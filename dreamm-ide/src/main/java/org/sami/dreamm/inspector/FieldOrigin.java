package org.sami.dreamm.inspector;

import java.util.Optional;
import org.sami.spn.model.FieldSource;

/** Where a field of an output event can come from. */
enum FieldOrigin {
    NOTHING("not given"),
    VALUE("value"),
    ASKED("asked, can be changed"),
    LOCKED("asked, locked"),
    VARIABLE("answer or variable"),
    TASK("@task");

    private final String words;

    FieldOrigin(String words) {
        this.words = words;
    }

    static FieldOrigin of(Optional<FieldSource> source) {
        if (source.isEmpty()) {
            return NOTHING;
        }
        FieldSource given = source.get();
        if (given instanceof FieldSource.Fixed) {
            return VALUE;
        }
        if (given instanceof FieldSource.Asked asked) {
            return asked.editable() ? ASKED : LOCKED;
        }
        return given instanceof FieldSource.FromVariable ? VARIABLE : TASK;
    }

    /** What it is called; where nothing is given, what that means. */
    String words(FieldAt field) {
        return this == NOTHING ? field.nothing() : words;
    }
}
