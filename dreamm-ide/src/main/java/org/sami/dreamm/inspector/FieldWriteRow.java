package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.value.TypeNames;

/** Into which variable a field of an event is written. */
final class FieldWriteRow {
    private static final String NOWHERE = "no variable";

    private FieldWriteRow() {}

    /** Adds its row to a form. */
    static void add(FieldAt at, Form form, Map<String, String> writes) {
        List<String> names = new ArrayList<>(List.of(NOWHERE));
        names.addAll(at.variables());
        ProfileGuard.mark(
                form.choice(
                        "Write to",
                        at.name() + "-write",
                        "The variable that receives the value; variables of type "
                                + TypeNames.of(at.field().type()),
                        names,
                        Optional.of(writes.getOrDefault(at.field().name(), NOWHERE)),
                        v -> v,
                        to -> write(at, to)),
                "event-field-write");
    }

    private static void write(FieldAt at, String to) {
        String plan = at.scope().plan().id();
        String field = at.field().name();
        if (to.equals(NOWHERE)) {
            at.apply(new FieldEdit.ClearWrite(plan, at.event(), field));
        } else {
            at.with(to, chosen -> new FieldEdit.SetWrite(plan, at.event(), field, chosen));
        }
    }
}
