package org.sami.dreamm.inspector;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.palette.SemanticColor;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.SourceWords;

/** Where a field of an output event comes from: a value, asked of the operator, an answer or variable, the entering task. */
final class FieldSourceRow {
    private static final int PROPOSED = 3;

    private final FieldAt at;
    private final Form form;
    private final FieldBelow below;
    private final List<DataSource> sources;

    private FieldSourceRow(FieldAt at, Form form) {
        this.at = at;
        this.form = form;
        this.below = new FieldBelow(at);
        this.sources = at.scope().sources(at.event(), at.field());
    }

    /** Adds its rows to a form. */
    static void add(FieldAt at, Form form, Optional<FieldSource> source) {
        new FieldSourceRow(at, form).show(source);
    }

    private void show(Optional<FieldSource> source) {
        FieldOrigin now = FieldOrigin.of(source);
        ProfileGuard.mark(
                form.choice(
                        "From",
                        at.name() + "-source",
                        "Where the value comes from when the place is entered",
                        possible(now),
                        Optional.of(now),
                        origin -> origin.words(at),
                        chosen -> choose(chosen, source)),
                "event-field-source");
        form.wide(below);
        Optional<Value> value = source.flatMap(FieldAt::value);
        switch (now) {
            case NOTHING -> sayNothing();
            case VALUE -> value(value, FieldSource.Fixed::new);
            case ASKED -> value(value, v -> new FieldSource.Asked(Optional.of(v), true));
            case LOCKED -> value(value, v -> new FieldSource.Asked(Optional.of(v), false));
            case VARIABLE -> readFrom(source.map(s -> ((FieldSource.FromVariable) s).variable()));
            case TASK ->
                below.say("The field \"" + at.field().name() + "\" of each task that enters.", SemanticColor.MUTED);
        }
    }

    private void sayNothing() {
        boolean needed = at.field().required() && at.context().profile().shows(ProfileIds.finding("E-FIELD-MISSING"));
        below.say(
                needed ? "▲ Needed: say where it comes from." : at.nothing() + ".",
                needed ? SemanticColor.CRITICAL : SemanticColor.MUTED);
        if (needed) {
            propose();
        }
    }

    /** Where it can come from here; {@code @task} only where a task comes that has such a field (thesis 9.3.4). */
    private List<FieldOrigin> possible(FieldOrigin now) {
        boolean all = at.context().profile().allows("event-field-sources");
        return Stream.of(FieldOrigin.values())
                .filter(origin -> origin != FieldOrigin.TASK || now == FieldOrigin.TASK || taskFits())
                .filter(origin -> origin == FieldOrigin.NOTHING
                        || (at.context()
                                        .profile()
                                        .allows("event-source-" + origin.name().toLowerCase(Locale.ROOT))
                                && (all || origin == FieldOrigin.VALUE)))
                .toList();
    }

    private boolean taskFits() {
        return sources.stream().anyMatch(DataSource.EnteringTask.class::isInstance);
    }

    /** Lines that say what reaches the field, each with a button that reads it from there. */
    private void propose() {
        List<FieldOrigin> possible = possible(FieldOrigin.NOTHING);
        List<DataSource> offered = sources.stream()
                .filter(DataSource::reaches)
                .filter(source -> possible.contains(
                        source instanceof DataSource.EnteringTask ? FieldOrigin.TASK : FieldOrigin.VARIABLE))
                .limit(PROPOSED)
                .toList();
        for (int i = 0; i < offered.size(); i++) {
            DataSource from = offered.get(i);
            below.add(
                    new ProposalLine(
                            SourceWords.of(from, at.context().vocabulary()),
                            at.name() + "-propose-" + i,
                            () -> at.apply(at.scope().reading(at.event(), at.field(), from))),
                    "wmin 0");
        }
    }

    private void readFrom(Optional<String> now) {
        List<ReadingChoice> choices =
                ReadingChoice.of(sources, now, at.context().vocabulary());
        ProfileGuard.mark(
                form.row(
                        "Source",
                        at.name() + "-variable",
                        "Answers and variables of type "
                                + TypeNames.of(at.field().type()) + " that come before, nearest first",
                        Form.combo(
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
                        s -> at.apply(at.scope().reading(at.event(), at.field(), s)),
                        () -> chosen.variable()
                                .ifPresentOrElse(v -> at.set(new FieldSource.FromVariable(v)), this::readFresh));
    }

    private void readFresh() {
        at.with(
                FieldAt.NEW_VARIABLE,
                fresh -> new FieldEdit.SetField(
                        at.scope().plan().id(), at.event(), at.field().name(), new FieldSource.FromVariable(fresh)));
    }

    /** What there is already stays, as far as the other source can hold it. */
    private void choose(FieldOrigin chosen, Optional<FieldSource> before) {
        Optional<Value> value =
                before.flatMap(FieldAt::value).or(() -> at.field().defaultValue());
        switch (chosen) {
            case NOTHING -> at.clear();
            case VALUE ->
                value.ifPresentOrElse(
                        v -> at.set(new FieldSource.Fixed(v)), () -> value(Optional.empty(), FieldSource.Fixed::new));
            case ASKED -> at.set(new FieldSource.Asked(value, true));
            case LOCKED ->
                value.ifPresentOrElse(
                        v -> at.set(new FieldSource.Asked(Optional.of(v), false)),
                        () -> value(Optional.empty(), v -> new FieldSource.Asked(Optional.of(v), false)));
            case VARIABLE ->
                read(ReadingChoice.of(sources, Optional.empty(), at.context().vocabulary())
                        .get(0));
            case TASK -> at.set(new FieldSource.FromTask());
        }
    }

    private void value(Optional<Value> value, Function<Value, FieldSource> source) {
        below.edit(value, v -> at.set(source.apply(v)));
    }
}
