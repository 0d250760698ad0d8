package org.sami.crw.message;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.manipulation.ManipulationLimit;
import org.sami.crw.markup.MapRelevance;
import org.sami.spn.protocol.Priority;

/**
 * A message to the operator, which needs no answer (appendix .2.1, Display Message; thesis 6.3.4).
 *
 * @param atMillis its time on the session's clock
 * @param mission its mission, or {@code Ids.NONE}
 * @param text one or a few sentences
 * @param boats the boats concerned, for zooming and highlighting; may be empty
 * @param keyword groups it with others; a later message with the same {@link #subject} replaces it; empty text = none does
 * @param map what it concerns on the map, for a click on it
 * @param manipulation how often its event may change the list, and when not
 */
public record OperatorMessage(
        long atMillis,
        long mission,
        Source source,
        Priority priority,
        String text,
        List<String> boats,
        String keyword,
        MapRelevance map,
        Manipulation manipulation) {
    /**
     * How an event of a plan may change the list of messages (meta-markup, thesis 5.3).
     *
     * @param event names the event, the same for all missions of its plan
     * @param limits none for an event that always may
     */
    public record Manipulation(String event, Set<ManipulationLimit> limits) {
        /** Always. */
        public static final Manipulation FREE = new Manipulation("", Set.of());

        public Manipulation {
            Objects.requireNonNull(event, "event");
            limits = Set.copyOf(limits);
        }
    }

    /**
     * The key by which a message replaces another: its keyword, with the boats and readings named by its markups (thesis 6.3.4), so that a message
     * about one boat does not replace that about another.
     *
     * @param boats of the markup Relevant Proxy
     * @param information the sensor of the markup Relevant Information; empty text without it
     */
    public record Subject(String keyword, Set<String> boats, String information) {
        public Subject {
            Objects.requireNonNull(keyword, "keyword");
            boats = Set.copyOf(boats);
            Objects.requireNonNull(information, "information");
        }
    }

    /** Who speaks. */
    public enum Source {
        /** A plan, by an output event. */
        PLAN,
        /** The engine: something that it noted. */
        ENGINE,
        /** A handler or a boat's proxy. */
        DOMAIN
    }

    /** The same in other words. */
    public OperatorMessage withText(String other) {
        return new OperatorMessage(atMillis, mission, source, priority, other, boats, keyword, map, manipulation);
    }

    public OperatorMessage {
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(priority, "priority");
        Objects.requireNonNull(text, "text");
        boats = List.copyOf(boats);
        Objects.requireNonNull(keyword, "keyword");
        Objects.requireNonNull(map, "map");
        Objects.requireNonNull(manipulation, "manipulation");
    }

    /** A message that is shown whenever it comes. */
    public OperatorMessage(
            long atMillis,
            long mission,
            Source source,
            Priority priority,
            String text,
            List<String> boats,
            String keyword,
            MapRelevance map) {
        this(atMillis, mission, source, priority, text, boats, keyword, map, Manipulation.FREE);
    }

    /** The same, of an event whose markup limits what it may do to the list. */
    public OperatorMessage limited(String event, Set<ManipulationLimit> limits) {
        return new OperatorMessage(
                atMillis, mission, source, priority, text, boats, keyword, map, new Manipulation(event, limits));
    }

    /** A message that shows nothing on the map. */
    public OperatorMessage(
            long atMillis,
            long mission,
            Source source,
            Priority priority,
            String text,
            List<String> boats,
            String keyword) {
        this(atMillis, mission, source, priority, text, boats, keyword, MapRelevance.NONE);
    }

    /** What it replaces others by; empty where it has no keyword. */
    public Optional<Subject> subject() {
        return keyword.isEmpty()
                ? Optional.empty()
                : Optional.of(new Subject(
                        keyword,
                        map.boats().map(shown -> Set.copyOf(shown.boats())).orElse(Set.of()),
                        map.information().map(MapRelevance.Information::sensor).orElse("")));
    }
}
