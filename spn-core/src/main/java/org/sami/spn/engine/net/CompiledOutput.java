package org.sami.spn.engine.net;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** One output event of a place, with its markups read. */
public final class CompiledOutput {
    /** When autonomy answers (markup Mixed Initiative Trigger). */
    public enum Trigger {
        NEVER,
        IMMEDIATELY,
        TIMER
    }

    public final OutputEventSpec spec;
    public final String typeName;
    public final Optional<EventType> type;
    public final EventRole role;
    public final @Nullable DecisionType decision;
    public final Priority priority;
    public final Trigger trigger;
    public final long timeoutMillis;
    /** Which options its question offers, one after the other. */
    public final List<OptionFilter> filters;
    /** Whether nothing is selected when its question opens, so that autonomy chooses nobody. */
    public final boolean selectsNobody;
    /** Values that are the same for every activation. */
    public final Map<String, Value> fixed = new LinkedHashMap<>();
    /** Fields whose value is resolved at entry. */
    public final Map<String, FieldSource> resolved = new LinkedHashMap<>();

    public CompiledOutput(Vocabulary vocabulary, OutputEventSpec spec) {
        this.spec = spec;
        this.type = vocabulary.event(spec.type());
        this.typeName = type.map(EventType::name).orElse(spec.type());
        this.role = type.map(EventType::role).orElse(EventRole.NONE);
        this.decision = type.flatMap(EventType::decision).orElse(null);
        type.ifPresent(t -> t.fields().forEach(f -> f.defaultValue().ifPresent(v -> fixed.put(f.name(), v))));
        spec.fields().forEach(this::addSource);
        this.priority = readPriority();
        Optional<MarkupSpec> mixed = markup(vocabulary, Reserved.MIXED_INITIATIVE_TRIGGER);
        this.trigger = mixed.flatMap(m -> m.option(Reserved.TRIGGER))
                .map(CompiledOutput::readTrigger)
                .orElse(Trigger.NEVER);
        this.timeoutMillis = mixed.flatMap(m -> m.option(Reserved.TIMEOUT))
                .map(v -> v instanceof DurationValue d ? d.millis() : 0L)
                .orElse(0L);
        this.filters =
                markups(vocabulary, Reserved.FILTER).map(this::readFilter).toList();
        this.selectsNobody = markups(vocabulary, Reserved.DEFAULT_SELECTION)
                .reduce((first, second) -> second)
                .flatMap(m -> m.option(Reserved.SELECTION))
                .filter(value -> constant(value).equals(Reserved.NONE))
                .isPresent();
    }

    private OptionFilter readFilter(MarkupSpec markup) {
        return new OptionFilter(
                markup.option(Reserved.SOURCE).map(CompiledOutput::constant).orElse(""),
                markup.option(Reserved.ACTION)
                        .map(CompiledOutput::constant)
                        .filter(Reserved.EXCLUDE::equals)
                        .isPresent());
    }

    /** What the operator is asked; only where the event asks. */
    public DecisionType decision() {
        return Objects.requireNonNull(decision, "the question of an event that asks nothing");
    }

    public Optional<FieldType> field(String name) {
        return type.flatMap(t -> t.field(name));
    }

    private void addSource(String field, FieldSource source) {
        if (source instanceof FieldSource.Fixed value) {
            fixed.put(field, value.value());
        } else if (source instanceof FieldSource.FromVariable read
                && read.variable().equals(Reserved.TASK_VARIABLE)) {
            resolved.put(field, new FieldSource.FromTask());
        } else {
            resolved.put(field, source);
        }
    }

    private Priority readPriority() {
        for (MarkupSpec markup : spec.markups()) {
            if (markup.type().equals(Reserved.PRIORITY)) {
                String rank = markup.option(Reserved.RANK)
                        .map(CompiledOutput::constant)
                        .orElse("");
                for (Priority priority : Priority.values()) {
                    if (priority.name().equalsIgnoreCase(rank)) {
                        return priority;
                    }
                }
            }
        }
        return Priority.MEDIUM;
    }

    private Optional<MarkupSpec> markup(Vocabulary vocabulary, String name) {
        return markups(vocabulary, name).findFirst();
    }

    private Stream<MarkupSpec> markups(Vocabulary vocabulary, String name) {
        return spec.markups().stream()
                .filter(m -> vocabulary
                        .markup(m.type())
                        .map(t -> t.name().equals(name))
                        .orElse(m.type().equals(name)));
    }

    private static Trigger readTrigger(Value value) {
        for (Trigger trigger : Trigger.values()) {
            if (trigger.name().equalsIgnoreCase(constant(value))) {
                return trigger;
            }
        }
        return Trigger.NEVER;
    }

    private static String constant(Value value) {
        if (value instanceof EnumValue e) {
            return e.constant();
        }
        return value instanceof TextValue text ? text.value() : "";
    }
}
