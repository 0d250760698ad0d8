package org.sami.dreamm.help;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.help.HelpTopic.Detail;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.value.TypeNames;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.value.ValueField;
import org.sami.ui.value.ValueSummary;

/** Help in the words of the domain. Knows no window. */
public final class HelpTopics {
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;

    /** The help of a domain. */
    public HelpTopics(Vocabulary vocabulary, AuthoringLibrary library) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.library = Objects.requireNonNull(library, "library");
    }

    /** On an event: its fields, and what can answer it. */
    public HelpTopic event(EventType type) {
        List<Detail> details = new ArrayList<>();
        type.fields().forEach(field -> details.add(new Detail(name(field), words(field))));
        if (!type.answers().isEmpty()) {
            details.add(new Detail(
                    "Answered by",
                    String.join(
                            ", ", type.answers().stream().map(this::eventLabel).toList())));
        }
        library.groups(vocabulary).stream()
                .filter(group -> group.events().contains(type.name()))
                .findFirst()
                .ifPresent(group -> details.add(new Detail("In the palette", group.name())));
        return new HelpTopic(
                type.label(),
                type.direction() == Direction.OUTPUT
                        ? "Output event: it stands on a place, and happens when tokens enter it"
                        : "Input event: it stands on a transition, which waits for it",
                type.help(),
                details);
    }

    private String eventLabel(String name) {
        return vocabulary.event(name).map(EventType::label).orElse(name);
    }

    private static String name(FieldType field) {
        return ValueField.words(field.name()) + (field.unit().isEmpty() ? "" : " (" + field.unit() + ")");
    }

    private static String words(FieldType field) {
        String given = field.defaultValue()
                .map(value -> " Where it is not given: " + ValueSummary.of(value) + ".")
                .orElse(field.required() ? " Needed." : "");
        return field.help() + " Type: " + TypeNames.of(field.type()) + "." + given;
    }

    /** On a field of an event or an option of markup. */
    public HelpTopic field(FieldType field, String owner) {
        return new HelpTopic(name(field), "Field of " + owner, words(field), List.of());
    }

    /** On markup: its options. */
    public HelpTopic markup(MarkupType type) {
        return new HelpTopic(
                type.label(),
                "Markup: how an interaction is shown, ranked or answered",
                type.help(),
                type.options().stream()
                        .map(option -> new Detail(name(option), words(option)))
                        .toList());
    }

    /** On what a transition waits for. */
    public HelpTopic requirement(InRequirement requirement) {
        String words = RequirementWords.of(requirement);
        String match = requirement.kind() == TokenKind.UNCONDITIONAL
                ? "The place says nothing on whether the transition fires."
                : switch (requirement.match()) {
                    case ZERO -> "The transition fires only while none of them stands in the place.";
                    case LESS_THAN ->
                        "The transition fires only while fewer than " + requirement.n()
                                + " of them stand in the place.";
                    case AT_LEAST ->
                        "The transition fires only while " + requirement.n() + " of them or more stand in the place.";
                    case EXACTLY ->
                        "The transition fires only while " + requirement.n()
                                + " of them stand in the place, no more and no fewer.";
                    case ALL -> "The transition fires only when all of them stand in the place.";
                };
        return new HelpTopic(words, "Requirement of an edge into a transition", match, kind(requirement.kind()));
    }

    /** On what a firing does with tokens. */
    public HelpTopic requirement(OutRequirement requirement) {
        String action = requirement.kind() == TokenKind.UNCONDITIONAL
                ? "The place is entered, and its events happen, though no token comes."
                : switch (requirement.action()) {
                    case TAKE -> "Where the transition fires, they leave the places before it and enter this one.";
                    case CONSUME -> "Where the transition fires, they leave the places before it and go nowhere.";
                    case ADD ->
                        "Where the transition fires, copies of them enter this place; they stay where they are.";
                };
        return new HelpTopic(
                RequirementWords.of(requirement),
                "Requirement of an edge out of a transition",
                action,
                kind(requirement.kind()));
    }

    private List<Detail> kind(TokenKind kind) {
        return Optional.ofNullable(library.requirementHelp()
                        .get(kind.name().toLowerCase(Locale.ROOT).replace('_', '-')))
                .map(help -> List.of(new Detail("Which tokens", help)))
                .orElse(List.of());
    }

    /** On an element of a plan: the first of its events, or its requirements; empty for a blank vertex. */
    public Optional<HelpTopic> element(Plan plan, String id) {
        Optional<HelpTopic> place = plan.place(id).map(this::place);
        Optional<HelpTopic> transition = plan.transition(id).map(this::transition);
        Optional<HelpTopic> in = plan.inEdges().stream()
                .filter(e -> e.id().equals(id))
                .findFirst()
                .flatMap(this::edge);
        Optional<HelpTopic> out = plan.outEdges().stream()
                .filter(e -> e.id().equals(id))
                .findFirst()
                .flatMap(this::edge);
        return place.or(() -> transition).or(() -> in).or(() -> out);
    }

    private HelpTopic place(Place place) {
        List<HelpTopic> events = place.outputs().stream()
                .flatMap(output -> vocabulary.event(output.type()).stream())
                .map(this::event)
                .toList();
        return vertex(
                place.name(),
                "Place",
                place.subMissions().isEmpty()
                        ? "Tokens wait here; it asks for nothing."
                        : "A sub-mission runs here for the tokens that enter.",
                events);
    }

    private HelpTopic transition(Transition transition) {
        List<HelpTopic> events = transition.inputs().stream()
                .flatMap(input -> vocabulary.event(input.type()).stream())
                .map(this::event)
                .toList();
        return vertex(
                transition.name(),
                "Transition",
                "It fires as soon as the requirements of its edges are met; it waits for no event.",
                events);
    }

    /** One event is explained in full, of several what each is. */
    private static HelpTopic vertex(String name, String kind, String blank, List<HelpTopic> events) {
        if (events.size() == 1) {
            return events.get(0);
        }
        String title = name.isBlank() ? kind : name;
        return new HelpTopic(
                title,
                kind + (events.isEmpty() ? "" : " with " + events.size() + " events"),
                events.isEmpty() ? blank : "",
                events.stream()
                        .map(event -> new Detail(event.title(), event.text()))
                        .toList());
    }

    private Optional<HelpTopic> edge(InEdge edge) {
        return together(
                "Edge into a transition",
                edge.requirements().stream().map(this::requirement).toList());
    }

    private Optional<HelpTopic> edge(OutEdge edge) {
        return together(
                "Edge out of a transition",
                edge.requirements().stream().map(this::requirement).toList());
    }

    private static Optional<HelpTopic> together(String kind, List<HelpTopic> requirements) {
        if (requirements.size() <= 1) {
            return requirements.stream().findFirst();
        }
        List<Detail> details = new ArrayList<>();
        for (HelpTopic requirement : requirements) {
            details.add(new Detail(requirement.title(), requirement.text()));
            details.addAll(requirement.details());
        }
        return Optional.of(new HelpTopic(kind, "With " + requirements.size() + " requirements", "", details));
    }
}
