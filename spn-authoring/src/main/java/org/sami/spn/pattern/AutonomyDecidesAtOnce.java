package org.sami.spn.pattern;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Reserved;

/** Autonomy answers the questions of the selected places in the same step (thesis 3.1, Markup). */
final class AutonomyDecidesAtOnce implements Pattern {
    @Override
    public String id() {
        return "autonomy-decides-at-once";
    }

    @Override
    public String title() {
        return "Autonomy decides at once";
    }

    @Override
    public String help() {
        return "Select places that ask the operator. Autonomy takes the first option, all robots, or yes, and the operator is not asked.";
    }

    @Override
    public Optional<String> refusal(PatternSpot spot) {
        if (trigger(spot).isEmpty()) {
            return Optional.of("The domain has no markup with which autonomy decides");
        }
        return questions(spot).isEmpty()
                ? Optional.of("Select a place that asks the operator something that autonomy can answer")
                : Optional.empty();
    }

    @Override
    public Edit edit(PatternSpot spot) {
        MarkupSpec markup = new MarkupSpec(
                Reserved.MIXED_INITIATIVE_TRIGGER,
                Map.of(Reserved.TRIGGER, new EnumValue(trigger(spot).orElseThrow(), Reserved.IMMEDIATELY)));
        List<Edit> edits = new ArrayList<>();
        for (OutputEventSpec question : questions(spot)) {
            edits.add(new EventEdit.SetMarkup(spot.plan().id(), question.id(), markup));
        }
        return new EditSequence(title(), edits);
    }

    /** The questions of the selected places that autonomy can answer and does not yet. */
    private static List<OutputEventSpec> questions(PatternSpot spot) {
        return spot.places().stream()
                .flatMap(p -> p.outputs().stream())
                .filter(o -> spot.vocabulary()
                        .event(o.type())
                        .flatMap(EventType::decision)
                        .filter(d -> d.autonomy() != AutonomyAnswer.NONE)
                        .isPresent())
                .filter(o -> o.markups().stream().noneMatch(AutonomyDecidesAtOnce::isAtOnce))
                .toList();
    }

    private static boolean isAtOnce(MarkupSpec markup) {
        return markup.type().equals(Reserved.MIXED_INITIATIVE_TRIGGER)
                && markup.option(Reserved.TRIGGER)
                        .filter(v -> v instanceof EnumValue e && e.constant().equals(Reserved.IMMEDIATELY))
                        .isPresent();
    }

    /** The name of the enumeration of the markup's option. */
    private static Optional<String> trigger(PatternSpot spot) {
        return Optional.ofNullable(spot.vocabulary().markups().get(Reserved.MIXED_INITIATIVE_TRIGGER))
                .map(MarkupType::options)
                .flatMap(options -> options.stream()
                        .filter(o -> o.name().equals(Reserved.TRIGGER))
                        .findFirst())
                .map(FieldType::type)
                .filter(ValueType.Named.class::isInstance)
                .map(type -> ((ValueType.Named) type).name());
    }
}
