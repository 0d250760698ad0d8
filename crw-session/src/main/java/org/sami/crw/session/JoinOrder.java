package org.sami.crw.session;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/**
 * The order of a session's boats that decides their colours and marks, in windows as in reports: first the boats that are there when the first mission
 * starts, by name, as they are connected at once and join in any order; then the others as they join. It follows from the journal alone.
 */
public final class JoinOrder {
    private final Set<String> waiting = new TreeSet<>(); // before the first mission
    private final Set<String> ordered = new LinkedHashSet<>();
    private boolean begun;

    /** Follows a step of the engine. */
    public void onStep(Input input, List<Effect> effects) {
        if (input instanceof Input.ProxyJoined boat) {
            join(List.of(boat.proxy()));
        }
        if (effects.stream().anyMatch(Effect.MissionStarted.class::isInstance)) {
            begin();
        }
    }

    /** Boats have joined. */
    public void join(Collection<String> boats) {
        (begun ? ordered : waiting).addAll(boats);
    }

    /** A mission has started. */
    public void begin() {
        begun = true;
        ordered.addAll(waiting);
        waiting.clear();
    }

    /** The boats whose place is decided, in order; it changes by additions at the end only. */
    public List<String> decided() {
        return List.copyOf(ordered);
    }

    /** The place of a boat, from 0; a boat that never joined is behind all others. */
    public int indexOf(String boat) {
        List<String> all = new ArrayList<>(ordered);
        all.addAll(waiting);
        int index = all.indexOf(boat);
        return index < 0 ? all.size() : index;
    }
}
