package org.sami.spn.wiring;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A field of an output event that has no source yet, and what it can be read from.
 *
 * @param sources nearest first, at least one
 * @param proposed the one that an addition reads from where its author says nothing else; empty where that would be a guess
 */
public record FieldProposal(FieldType field, List<DataSource> sources, Optional<DataSource> proposed) {
    /** Types that say too little: a reason of a failure is a text as well as a class of tasks. */
    private static final Set<ValueType.Simple> SAYING_LITTLE = EnumSet.of(
            ValueType.Simple.TEXT,
            ValueType.Simple.INTEGER,
            ValueType.Simple.REAL,
            ValueType.Simple.BOOLEAN,
            ValueType.Simple.DURATION,
            ValueType.Simple.ANY);

    public FieldProposal {
        Objects.requireNonNull(field, "field");
        sources = List.copyOf(sources);
        Objects.requireNonNull(proposed, "proposed");
    }

    /**
     * The proposals for the fields of an event that stands in a plan, in the order of its type.
     *
     * @param event its id
     * @param wanted optional fields that are proposed all the same
     */
    public static List<FieldProposal> of(
            Project project, String plan, String event, Vocabulary vocabulary, Set<String> wanted) {
        List<FieldProposal> proposals = new ArrayList<>();
        project.plan(plan).ifPresent(open -> {
            for (Place place : open.places()) {
                place.outputs().stream()
                        .filter(o -> o.id().equals(event))
                        .forEach(o -> vocabulary
                                .event(o.type())
                                .ifPresent(type ->
                                        add(project, open, place.id(), o, type, vocabulary, wanted, proposals)));
            }
        });
        return proposals;
    }

    private static void add(
            Project project,
            Plan plan,
            String place,
            OutputEventSpec output,
            EventType type,
            Vocabulary vocabulary,
            Set<String> wanted,
            List<FieldProposal> proposals) {
        ReachingData data = new ReachingData(project, plan, vocabulary);
        for (FieldType field : type.fields()) {
            if (!output.fields().containsKey(field.name())) {
                List<DataSource> sources = data.of(place, field);
                if (!sources.isEmpty()) {
                    boolean needed =
                            (field.required() && field.defaultValue().isEmpty()) || wanted.contains(field.name());
                    proposals.add(new FieldProposal(
                            field, sources, needed ? proposed(field, sources.get(0)) : Optional.empty()));
                }
            }
        }
    }

    private static Optional<DataSource> proposed(FieldType field, DataSource nearest) {
        boolean sameName = nearest instanceof DataSource.AnswerField answer
                ? answer.field().equals(field.name())
                : nearest instanceof DataSource.Variable variable
                        && variable.name().equals("@" + field.name());
        boolean near = nearest.reaches() && nearest.steps() != DataSource.FAR;
        boolean says = !(field.type() instanceof ValueType.Simple simple && SAYING_LITTLE.contains(simple));
        return nearest.reaches() && (sameName || (near && says)) ? Optional.of(nearest) : Optional.empty();
    }
}
