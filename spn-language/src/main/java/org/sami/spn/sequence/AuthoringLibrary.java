package org.sami.spn.sequence;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a domain says to help authors: groups of events, and the sequences of events. No vocabulary: plans mean the same without it.
 *
 * @param categories groups in the order of a palette
 * @param sequences flexible and manual ones
 * @param requirementHelp a sentence on each kind of token that a requirement speaks of, by its word in files, and on {@code implied-generic}
 */
public record AuthoringLibrary(
        List<EventCategory> categories, List<Sequence> sequences, Map<String, String> requirementHelp) {
    /** Of a domain that says nothing. */
    public static final AuthoringLibrary EMPTY = new AuthoringLibrary(List.of(), List.of());

    public AuthoringLibrary {
        categories = List.copyOf(categories);
        sequences = List.copyOf(sequences);
        requirementHelp = Map.copyOf(requirementHelp);
    }

    /** Groups and sequences without help on requirements. */
    public AuthoringLibrary(List<EventCategory> categories, List<Sequence> sequences) {
        this(categories, sequences, Map.of());
    }

    /** These, and those of another domain: groups of one id become one, and an event stays in the group in which it stands here. */
    public AuthoringLibrary and(AuthoringLibrary others) {
        Map<String, EventCategory> groups = new LinkedHashMap<>();
        Set<String> placed = new HashSet<>();
        for (EventCategory category :
                Stream.of(categories, others.categories).flatMap(List::stream).toList()) {
            List<String> events = new ArrayList<>(
                    groups.containsKey(category.id())
                            ? groups.get(category.id()).events()
                            : List.of());
            category.events().stream().filter(placed::add).forEach(events::add);
            String name = groups.getOrDefault(category.id(), category).name();
            groups.put(category.id(), new EventCategory(category.id(), name, events));
        }
        List<Sequence> all = new ArrayList<>(sequences);
        others.sequences.stream()
                .filter(s -> sequences.stream().noneMatch(own -> own.event().equals(s.event())))
                .forEach(all::add);
        Map<String, String> help = new LinkedHashMap<>(others.requirementHelp);
        help.putAll(requirementHelp);
        return new AuthoringLibrary(List.copyOf(groups.values()), all, help);
    }

    /**
     * The sequences of an event type, the one to offer first first. One whose answers come robot by robot is there once for each way to go
     * on, so that no plan waits for all unnoticed; a way that a manual sequence draws is that sequence's.
     */
    public List<Sequence> of(String event) {
        List<Sequence> written =
                sequences.stream().filter(s -> s.event().equals(event)).toList();
        List<Sequence> offered = new ArrayList<>();
        for (Sequence sequence : written) {
            if (waits(sequence)) {
                Stream.of(Gathering.values())
                        .filter(g -> written.stream().noneMatch(s -> s.name().equals(g.label())))
                        .forEach(g -> offered.add(new Sequence.Gathered(sequence, g)));
            } else {
                offered.add(sequence);
            }
        }
        return offered;
    }

    /** Whether a transition that comes with a sequence can wait for all. */
    private boolean waits(Sequence sequence) {
        if (sequence instanceof Sequence.OfOutput output) {
            return output.inputs().stream().flatMap(i -> ofInput(i).stream()).anyMatch(i -> i.waitFor() == WaitFor.ALL);
        }
        return sequence instanceof Sequence.OfInput input && input.waitFor() == WaitFor.ALL;
    }

    /** A sequence of an event type by its id; empty for {@link Sequence#ALONE}. */
    public Optional<Sequence> sequence(String event, String id) {
        return of(event).stream().filter(s -> s.id().equals(id)).findFirst();
    }

    /** The flexible sequence of an output event. */
    public Optional<Sequence.OfOutput> ofOutput(String event) {
        return flexible(event, Sequence.OfOutput.class);
    }

    /** The flexible sequence of an input event. */
    public Optional<Sequence.OfInput> ofInput(String event) {
        return flexible(event, Sequence.OfInput.class);
    }

    /** Fields of an output event that are proposed to be read from something although its type does not require them. */
    public Set<String> wired(String event) {
        return ofOutput(event).map(s -> Set.copyOf(s.wires())).orElse(Set.of());
    }

    private <S extends Sequence> Optional<S> flexible(String event, Class<S> kind) {
        return sequences.stream()
                .filter(s -> s.event().equals(event))
                .filter(kind::isInstance)
                .map(kind::cast)
                .findFirst();
    }

    /** What an output event needs: what its sequence says, and nothing where it has none (thesis 5.1.1). */
    public TokenNeed needs(String event) {
        return ofOutput(event).map(Sequence.OfOutput::tokens).orElse(TokenNeed.NONE);
    }

    /** The groups of a palette: those of the domain, then what they leave out, by direction. Every event type is in one. */
    public List<EventCategory> groups(Vocabulary vocabulary) {
        Set<String> left = new LinkedHashSet<>(vocabulary.events().keySet());
        List<EventCategory> groups = new ArrayList<>();
        for (EventCategory category : categories) {
            left.removeAll(category.events());
            groups.add(category);
        }
        rest(vocabulary, left, Direction.OUTPUT, "other-output-events", "Other output events", groups);
        rest(vocabulary, left, Direction.INPUT, "other-input-events", "Other input events", groups);
        return groups;
    }

    private static void rest(
            Vocabulary vocabulary,
            Set<String> left,
            Direction direction,
            String id,
            String name,
            List<EventCategory> groups) {
        List<String> events = left.stream()
                .map(e -> vocabulary.events().get(e))
                .filter(e -> e.direction() == direction)
                .map(EventType::name)
                .toList();
        if (!events.isEmpty()) {
            groups.add(new EventCategory(id, name, events));
        }
    }
}
