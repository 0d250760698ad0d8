package org.sami.dreamm.inspector;

import java.util.List;
import java.util.Optional;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.value.Value;

/** Whether an input event is taken only if its field has one value, and which. */
final class FieldOnlyRow {
    private FieldOnlyRow() {}

    /** Adds its rows to a form. */
    static void add(FieldAt at, Form form, Optional<Value> value) {
        FieldBelow below = new FieldBelow(at);
        ProfileGuard.mark(
                form.choice(
                        "Only if",
                        at.name() + "-only",
                        "Whether the transition takes every such answer, or only those with one value",
                        List.of(false, true),
                        Optional.of(value.isPresent()),
                        one -> one ? "it is" : at.field().required() ? "– say which –" : "whatever it is",
                        one -> {
                            if (one) {
                                only(at, below, Optional.empty());
                            } else {
                                at.clear();
                            }
                        }),
                "event-field-only");
        form.wide(below);
        if (value.isPresent()) {
            only(at, below, value);
        }
    }

    private static void only(FieldAt at, FieldBelow below, Optional<Value> value) {
        below.edit(
                value,
                v -> at.apply(new FieldEdit.SetInputField(
                        at.scope().plan().id(), at.event(), at.field().name(), v)));
    }
}
