package org.sami.lessons.course;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.EventCategory;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A part of a domain: some of its events, task classes and markups, the answers, groups and sequences that speak of nothing else, and no
 * library of plans. A learner is given the words that were introduced so far.
 *
 * @param events names of event types
 * @param tasks names of task classes
 * @param markups names of markup types
 */
public record LessonDomain(Set<String> events, Set<String> tasks, Set<String> markups) {
    public LessonDomain {
        events = Set.copyOf(events);
        tasks = Set.copyOf(tasks);
        markups = Set.copyOf(markups);
    }

    /** What is introduced in a lesson and in those before it: what its window has. */
    public static LessonDomain of(Course course, String lesson) {
        return new LessonDomain(course.eventsKnown(lesson), course.tasksKnown(lesson), course.markupsKnown(lesson));
    }

    /** That part of a domain. */
    public DomainLibrary of(DomainLibrary whole) {
        return new DomainLibrary(
                vocabulary(whole.vocabulary()),
                whole.files(),
                whole.components(),
                authoring(whole.authoring()),
                Map.of());
    }

    /** That part of a vocabulary; its types are all there. */
    private Vocabulary vocabulary(Vocabulary whole) {
        return new Vocabulary(
                whole.domain(),
                List.copyOf(whole.types().values()),
                whole.events().values().stream()
                        .filter(event -> events.contains(event.name()))
                        .map(this::event)
                        .toList(),
                whole.markups().values().stream()
                        .filter(markup -> markups.contains(markup.name()))
                        .toList(),
                whole.taskClasses().values().stream()
                        .filter(task -> tasks.contains(task.name()))
                        .toList(),
                whole.geography(),
                whole.robotNames(),
                whole.combines());
    }

    private EventType event(EventType whole) {
        return new EventType(
                whole.name(),
                whole.aliases(),
                whole.direction(),
                whole.fields(),
                whole.tokens(),
                known(whole.answers()),
                whole.role(),
                whole.flags(),
                whole.decision(),
                whole.label(),
                whole.help());
    }

    private AuthoringLibrary authoring(AuthoringLibrary whole) {
        return new AuthoringLibrary(
                whole.categories().stream()
                        .map(group -> new EventCategory(group.id(), group.name(), known(group.events())))
                        .filter(group -> !group.events().isEmpty())
                        .toList(),
                whole.sequences().stream()
                        .flatMap(each -> sequence(each).stream())
                        .toList(),
                whole.requirementHelp());
    }

    /** A sequence without the events that are not there yet; none where its own is not, or where it is drawn with one that is not. */
    private Optional<Sequence> sequence(Sequence whole) {
        if (!events.contains(whole.event())) {
            return Optional.empty();
        }
        if (whole instanceof Sequence.OfOutput output) {
            return Optional.of(new Sequence.OfOutput(
                    output.event(), output.help(), output.tokens(), known(output.inputs()), output.wires()));
        }
        if (whole instanceof Sequence.OfInput input) {
            return Optional.of(new Sequence.OfInput(
                    input.event(),
                    input.help(),
                    known(input.outputs()),
                    input.in(),
                    input.out(),
                    input.waitFor(),
                    input.movesGeneric()));
        }
        return Optional.of(whole).filter(each -> !(each instanceof Sequence.Manual manual) || knows(manual.part()));
    }

    /** Whether a plan speaks of nothing else. */
    private boolean knows(Plan part) {
        return Stream.concat(
                                part.places().stream()
                                        .flatMap(place -> place.outputs().stream())
                                        .map(each -> each.type()),
                                part.transitions().stream()
                                        .flatMap(transition -> transition.inputs().stream())
                                        .map(each -> each.type()))
                        .allMatch(events::contains)
                && part.places().stream()
                        .flatMap(place -> place.outputs().stream())
                        .flatMap(event -> event.markups().stream())
                        .allMatch(markup -> markups.contains(markup.type()));
    }

    private List<String> known(List<String> names) {
        return names.stream().filter(events::contains).toList();
    }
}
