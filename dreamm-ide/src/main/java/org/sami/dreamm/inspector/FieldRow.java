package org.sami.dreamm.inspector;

import java.util.Optional;
import javax.swing.JLabel;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.Explained;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.TypeNames;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.value.ValueField;

/**
 * One field of an event: where it comes from ({@link FieldSourceRow}), into which variable it is written ({@link FieldWriteRow}), and with
 * which value an input event is taken ({@link FieldOnlyRow}; thesis, Figure 5.3).
 */
final class FieldRow extends Form implements Explained {
    private final transient FieldAt at;

    private FieldRow(FieldAt at) {
        this.at = at;
        setName(at.name());
        ProfileGuard.mark(this, "event-field");
        FieldType field = at.field();
        JLabel title = new StrongLabel(
                ValueField.words(field.name()) + (field.unit().isEmpty() ? "" : " (" + field.unit() + ")"));
        title.setToolTipText(field.help() + " Type: " + TypeNames.of(field.type()));
        add(title, "span 2, growx, wmin 0, gaptop 4");
    }

    static FieldRow of(DreammContext context, Scope scope, OutputEventSpec spec, EventType type, FieldType field) {
        FieldRow row = new FieldRow(new FieldAt(context, scope, spec.id(), type, field));
        FieldSourceRow.add(row.at, row, Optional.ofNullable(spec.fields().get(field.name())));
        FieldWriteRow.add(row.at, row, spec.writes());
        return row;
    }

    static FieldRow of(DreammContext context, Scope scope, InputEventSpec spec, EventType type, FieldType field) {
        FieldRow row = new FieldRow(new FieldAt(context, scope, spec.id(), type, field));
        FieldWriteRow.add(row.at, row, spec.writes());
        FieldOnlyRow.add(row.at, row, Optional.ofNullable(spec.fields().get(field.name())));
        return row;
    }

    @Override
    public Optional<HelpTopic> help() {
        return Optional.of(new HelpTopics(
                        at.context().vocabulary(), at.context().additions().library())
                .field(at.field(), at.type().label()));
    }
}
