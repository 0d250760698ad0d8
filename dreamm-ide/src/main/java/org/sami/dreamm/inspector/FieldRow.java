package org.sami.dreamm.inspector;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.Explained;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.SourceWords;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.value.ValueField;
import org.sami.ui.value.WrappedText;

/**
 * One field of an event: where it comes from – a value, asked of the operator, a variable, the entering task – and into which variable it is
 * written (thesis, Figure 5.3).
 */
final class FieldRow extends Form implements Explained {
    private static final int PROPOSED = 3;
    private static final String NEW_VARIABLE = ReadingChoice.NEW_VARIABLE;
    private static final String NOWHERE = "no variable";

    private final transient DreammContext context;
    private final transient Scope scope;
    private final String event;
    private final transient EventType type;
    private final transient FieldType field;
    private final String name;
    private final transient List<DataSource> sources;
    private final JPanel below =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 0 4, fillx, wrap 1", "[grow, fill]"));

    /** Where a field of an output event can come from. */
    enum Source {
        NOTHING("not given"),
        VALUE("value"),
        ASKED("asked, can be changed"),
        LOCKED("asked, locked"),
        VARIABLE("answer or variable"),
        TASK("@task");

        private final String words;

        Source(String words) {
            this.words = words;
        }

        static Source of(Optional<FieldSource> source) {
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
    }

    private FieldRow(DreammContext context, Scope scope, String event, EventType type, FieldType field) {
        this.context = context;
        this.scope = scope;
        this.event = event;
        this.type = type;
        this.field = field;
        this.name =
                "field-" + field.name().replaceAll("([a-z0-9])([A-Z])", "$1-$2").toLowerCase(java.util.Locale.ROOT);
        this.sources = type.direction() == Direction.OUTPUT ? scope.sources(event, field) : List.of();
        setName(name);
        below.setOpaque(false);
        ProfileGuard.mark(this, "event-field");
        JLabel title = new StrongLabel(
                ValueField.words(field.name()) + (field.unit().isEmpty() ? "" : " (" + field.unit() + ")"));
        title.setToolTipText(field.help() + " Type: " + TypeNames.of(field.type()));
        add(title, "span 2, growx, wmin 0, gaptop 4");
    }

    static FieldRow of(DreammContext context, Scope scope, OutputEventSpec spec, EventType type, FieldType field) {
        FieldRow row = new FieldRow(context, scope, spec.id(), type, field);
        row.source(Optional.ofNullable(spec.fields().get(field.name())));
        row.writes(spec.writes());
        return row;
    }

    static FieldRow of(DreammContext context, Scope scope, InputEventSpec spec, EventType type, FieldType field) {
        FieldRow row = new FieldRow(context, scope, spec.id(), type, field);
        row.writes(spec.writes());
        row.selects(Optional.ofNullable(spec.fields().get(field.name())));
        return row;
    }

    @Override
    public Optional<HelpTopic> help() {
        return Optional.of(
                new HelpTopics(context.vocabulary(), context.additions().library()).field(field, type.label()));
    }

    private void apply(Edit edit) {
        context.apply(edit);
    }

    private void set(FieldSource source) {
        apply(new FieldEdit.SetField(scope.plan().id(), event, field.name(), source));
    }

    private void source(Optional<FieldSource> source) {
        Source now = Source.of(source);
        ProfileGuard.mark(
                choice(
                        "From",
                        name + "-source",
                        "Where the value comes from when the place is entered",
                        possible(now),
                        Optional.of(now),
                        s -> s == Source.NOTHING ? nothing() : s.words,
                        chosen -> choose(chosen, source)),
                "event-field-source");
        wide(below);
        switch (now) {
            case NOTHING -> {
                say(
                        field.required() ? "▲ Needed: say where it comes from." : nothing() + ".",
                        field.required() ? SemanticColor.CRITICAL : SemanticColor.MUTED);
                if (field.required()) {
                    propose();
                }
            }
            case VALUE -> value(source.map(s -> ((FieldSource.Fixed) s).value()), FieldSource.Fixed::new);
            case ASKED ->
                value(
                        source.flatMap(s -> ((FieldSource.Asked) s).defaultValue()),
                        v -> new FieldSource.Asked(Optional.of(v), true));
            case LOCKED ->
                value(
                        source.flatMap(s -> ((FieldSource.Asked) s).defaultValue()),
                        v -> new FieldSource.Asked(Optional.of(v), false));
            case VARIABLE -> readFrom(source.map(s -> ((FieldSource.FromVariable) s).variable()));
            case TASK -> say("The field \"" + field.name() + "\" of each task that enters.", SemanticColor.MUTED);
        }
    }

    private String nothing() {
        return field.defaultValue()
                .map(v -> "not given: " + org.sami.ui.value.ValueSummary.of(v))
                .orElse(field.required() ? "not given" : "not given, not needed");
    }

    /** Where it can come from here; {@code @task} only where a task comes that has such a field (thesis 9.3.4). */
    private List<Source> possible(Source now) {
        boolean all = context.profile().allows("event-field-sources");
        return Stream.of(Source.values())
                .filter(s -> s != Source.TASK || now == Source.TASK || taskFits())
                .filter(s -> s == Source.NOTHING
                        || (context.profile().allows("event-source-" + s.name().toLowerCase(Locale.ROOT))
                                && (all || s == Source.VALUE)))
                .toList();
    }

    private boolean taskFits() {
        return sources.stream().anyMatch(DataSource.EnteringTask.class::isInstance);
    }

    /** Lines that say what reaches the field, each with a button that reads it from there. */
    private void propose() {
        List<Source> possible = possible(Source.NOTHING);
        List<DataSource> offered = sources.stream()
                .filter(DataSource::reaches)
                .filter(s -> possible.contains(s instanceof DataSource.EnteringTask ? Source.TASK : Source.VARIABLE))
                .limit(PROPOSED)
                .toList();
        for (int i = 0; i < offered.size(); i++) {
            DataSource from = offered.get(i);
            below.add(
                    new ProposalLine(
                            SourceWords.of(from, context.vocabulary()),
                            name + "-propose-" + i,
                            () -> apply(scope.reading(event, field, from))),
                    "wmin 0");
        }
    }

    private void readFrom(Optional<String> now) {
        List<ReadingChoice> choices = ReadingChoice.of(sources, now, context.vocabulary());
        ProfileGuard.mark(
                row(
                        "Source",
                        name + "-variable",
                        "Answers and variables of type " + TypeNames.of(field.type())
                                + " that come before, nearest first",
                        combo(
                                choices,
                                choices.stream()
                                        .filter(c ->
                                                now.isPresent() && c.variable().equals(now))
                                        .findFirst(),
                                ReadingChoice::words,
                                ReadingChoice::brief,
                                this::read)),
                "event-field-variable");
    }

    private void read(ReadingChoice chosen) {
        chosen.source()
                .ifPresentOrElse(
                        s -> apply(scope.reading(event, field, s)),
                        () -> chosen.variable()
                                .ifPresentOrElse(v -> set(new FieldSource.FromVariable(v)), this::readFresh));
    }

    private void readFresh() {
        String fresh = scope.freshName(field.name());
        apply(scope.declaring(
                fresh,
                field.type(),
                new FieldEdit.SetField(scope.plan().id(), event, field.name(), new FieldSource.FromVariable(fresh))));
    }

    /** What there is already stays, as far as the other source can hold it. */
    private void choose(Source chosen, Optional<FieldSource> before) {
        Optional<Value> value = before.flatMap(s -> s instanceof FieldSource.Fixed fixed
                        ? Optional.of(fixed.value())
                        : s instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty())
                .or(field::defaultValue);
        switch (chosen) {
            case NOTHING -> apply(new FieldEdit.ClearField(scope.plan().id(), event, field.name()));
            case VALUE ->
                value.ifPresentOrElse(v -> set(new FieldSource.Fixed(v)), () -> draft(FieldSource.Fixed::new));
            case ASKED -> set(new FieldSource.Asked(value, true));
            case LOCKED ->
                value.ifPresentOrElse(
                        v -> set(new FieldSource.Asked(Optional.of(v), false)),
                        () -> draft(v -> new FieldSource.Asked(Optional.of(v), false)));
            case VARIABLE ->
                read(ReadingChoice.of(sources, Optional.empty(), context.vocabulary())
                        .get(0));
            case TASK -> set(new FieldSource.FromTask());
        }
    }

    /** An editor for a value that has to be given before the field can have this source. */
    private void draft(Function<Value, FieldSource> source) {
        value(Optional.empty(), source);
        revalidate();
        repaint();
    }

    private void value(Optional<Value> value, Function<Value, FieldSource> source) {
        edit(value, v -> set(source.apply(v)));
    }

    /** Puts an editor below the choice that it belongs to, in place of what stood there: keys choose each source that they pass. */
    private void edit(Optional<Value> value, Consumer<Value> given) {
        below.removeAll();
        below.add(
                ProfileGuard.mark(
                        new ValueRow(context.values().editor(ValueField.of(field)), value, given), "event-field-value"),
                "wmin 0, gapbottom " + Spacing.TIGHT);
    }

    private void say(String text, SemanticColor color) {
        WrappedText line = new WrappedText(text);
        line.setColor(color);
        below.add(line, "wmin 0");
    }

    private List<String> variables() {
        List<String> names = new ArrayList<>(scope.ofType(field.type()));
        names.add(NEW_VARIABLE);
        return names;
    }

    private void variable(String chosen, Function<String, Edit> use) {
        if (chosen.equals(NEW_VARIABLE)) {
            String fresh = scope.freshName(field.name());
            apply(scope.declaring(fresh, field.type(), use.apply(fresh)));
        } else {
            apply(use.apply(chosen));
        }
    }

    private void writes(Map<String, String> writes) {
        List<String> names = new ArrayList<>(List.of(NOWHERE));
        names.addAll(variables());
        ProfileGuard.mark(
                choice(
                        "Write to",
                        name + "-write",
                        "The variable that receives the value; variables of type " + TypeNames.of(field.type()),
                        names,
                        Optional.of(writes.getOrDefault(field.name(), NOWHERE)),
                        v -> v,
                        this::write),
                "event-field-write");
    }

    private void write(String to) {
        if (to.equals(NOWHERE)) {
            apply(new FieldEdit.ClearWrite(scope.plan().id(), event, field.name()));
        } else {
            variable(to, chosen -> new FieldEdit.SetWrite(scope.plan().id(), event, field.name(), chosen));
        }
    }

    /** An input event is taken only if its field has the value that is given here. */
    private void selects(Optional<Value> value) {
        ProfileGuard.mark(
                choice(
                        "Only if",
                        name + "-only",
                        "Whether the transition takes every such answer, or only those with one value",
                        List.of(false, true),
                        Optional.of(value.isPresent()),
                        one -> one ? "it is" : field.required() ? "– say which –" : "whatever it is",
                        one -> {
                            if (one) {
                                only(Optional.empty());
                                revalidate();
                                repaint();
                            } else {
                                apply(new FieldEdit.ClearField(scope.plan().id(), event, field.name()));
                            }
                        }),
                "event-field-only");
        wide(below);
        if (value.isPresent()) {
            only(value);
        }
    }

    private void only(Optional<Value> value) {
        edit(value, v -> apply(new FieldEdit.SetInputField(scope.plan().id(), event, field.name(), v)));
    }
}
