package org.sami.ui.value;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Purpose;
import org.sami.spn.component.WidgetType;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;

/** Makes the editors of values: those that the algorithms chose, or for a type the ones that they choose without markup. */
public final class ValueEditors {
    private final ComponentChoice choice;
    private final ValueContext context;

    /** Editors that are chosen and built in one context. */
    public ValueEditors(ComponentChoice choice, ValueContext context) {
        this.choice = Objects.requireNonNull(choice, "choice");
        this.context = Objects.requireNonNull(context, "context");
    }

    /** What is known now of the robots that can be chosen. */
    public List<ChoiceRow> robots() {
        return context.names().proxies();
    }

    /** An editor with which a value of the field's type is given; any type can be, also {@code any}. */
    public ValueEditor editor(ValueField field) {
        return field.type() == ValueType.Simple.ANY
                ? new AnyEditor(field, context.declarations(), this::editor)
                : build(choice.choose(Purpose.CREATE, field.type(), List.of()), field);
    }

    /** A value that is only shown, with the component that is chosen to show it. */
    public ValueEditor view(ValueField field) {
        ValueEditor view = build(choice.choose(Purpose.SELECT, field.type(), List.of()), field);
        view.setEditable(false);
        return view;
    }

    /** The editor that was chosen for a field; a warning where there is none. */
    public ValueEditor build(ChosenComponent chosen, ValueField field) {
        if (chosen instanceof ChosenComponent.Direct direct) {
            String name = direct.component().name();
            return ComponentBuilders.build(name, request(direct, field, Optional.empty()), context)
                    .orElseGet(() -> new WarningView(field, "The component " + name + " is not known to this window"));
        }
        if (chosen instanceof ChosenComponent.Repeated repeated && field.type() instanceof ValueType.ListOf) {
            return new RepeatedEditor(field, part -> build(repeated.element(), part));
        }
        if (chosen instanceof ChosenComponent.Entries entries && field.type() instanceof ValueType.MapOf) {
            return new EntriesEditor(field, part -> build(entries.key(), part), part -> build(entries.value(), part));
        }
        if (chosen instanceof ChosenComponent.Form form
                && field.type() instanceof ValueType.Named named
                && context.declarations().get(named.name()) instanceof NamedType.RecordType declared) {
            return new RecordEditor(field, record(form, field, declared));
        }
        return chosen instanceof ChosenComponent.Warning warning
                ? new WarningView(field, warning.reason())
                : unfit(field);
    }

    private static ValueEditor unfit(ValueField field) {
        return new WarningView(field, "The chosen component does not fit " + field.label());
    }

    private static ComponentRequest request(ChosenComponent.Direct direct, ValueField field, Optional<Offer> offer) {
        return new ComponentRequest(
                field, direct.widgets().stream().map(WidgetType::name).toList(), offer);
    }

    private FieldsPanel record(ChosenComponent.Form form, ValueField field, NamedType.RecordType declared) {
        Map<String, ValueEditor> editors = new LinkedHashMap<>();
        declared.fields().forEach((name, type) -> {
            ValueField part = field.part(name, ValueField.words(name), type);
            ChosenComponent component = form.fields().get(name);
            editors.put(name, component == null ? unfit(part) : build(component, part));
        });
        return new FieldsPanel(editors);
    }

    /** The editors of several values that are asked together: the parts of a chosen form, or the one component of a single value. */
    public FieldsPanel fields(ChosenComponent chosen, Map<String, ValueField> fields) {
        Map<String, ValueEditor> editors = new LinkedHashMap<>();
        fields.forEach((name, field) -> {
            ChosenComponent part =
                    chosen instanceof ChosenComponent.Form form && form.fields().containsKey(name)
                            ? form.fields().get(name)
                            : chosen;
            editors.put(name, fields.size() > 1 && part == chosen ? editor(field) : build(part, field));
        });
        return new FieldsPanel(editors);
    }

    /**
     * The component that was chosen to select from what is offered. Where the choice is no component that lists options, such as a form
     * for each, the options are listed in words.
     */
    public ValueChooser chooser(ChosenComponent chosen, ValueField field, Offer offer) {
        Optional<ValueEditor> direct = chosen instanceof ChosenComponent.Direct one
                ? ComponentBuilders.build(one.component().name(), request(one, field, Optional.of(offer)), context)
                : Optional.empty();
        return direct.filter(ValueChooser.class::isInstance)
                .map(ValueChooser.class::cast)
                .orElseGet(() -> new ListChooser(field, context.names().known(offer), !offer.single(), false));
    }
}
