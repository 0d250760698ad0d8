package org.sami.crw.markup;

import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.function.LongFunction;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;

/**
 * An event with markup that was sent or received, as models need it; immutable.
 *
 * @param activation the activation whose visit ends it; {@code Ids.NONE} for an input event, which the next firing of its transition replaces
 * @param event names the plan's event, the same for all missions and visits: {@code plan/event}
 * @param type name of the event's type
 * @param boats the entering or named boats
 */
public record MarkedEvent(
        long activation, long mission, String event, String type, List<MarkupSpec> markups, List<String> boats) {
    public MarkedEvent {
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(type, "type");
        markups = List.copyOf(markups);
        boats = List.copyOf(boats);
    }

    public static MarkedEvent of(Activation activation) {
        return new MarkedEvent(
                activation.id(),
                activation.mission(),
                activation.plan() + "/" + activation.event(),
                activation.type(),
                activation.markups(),
                activation.proxies());
    }

    /** Whether it was sent, for a visit that ends, and not received. */
    public boolean isOutput() {
        return activation != Ids.NONE;
    }

    public MarkupReader reader() {
        return new MarkupReader(markups);
    }

    /**
     * What of the map it is about.
     *
     * @param allBoats that are known
     */
    public MapRelevance relevance(Collection<String> allBoats) {
        return MapRelevance.of(reader(), boats, List.copyOf(allBoats));
    }

    /**
     * Names it to people.
     *
     * @param missions names a mission
     */
    public String words(LongFunction<String> missions) {
        return type + " of " + missions.apply(mission);
    }
}
