package org.sami.crw.operator.mission;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.sami.spn.engine.PendingAnswer;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.protocol.TokenMove;
import org.sami.spn.value.Value;

/**
 * A mission or sub-mission at a moment.
 *
 * @param parent the mission whose place runs it, or {@code Ids.NONE}
 * @param parentPlace id of that place; empty text for a root mission
 * @param plan id of its plan
 * @param title title of the plan
 * @param startedAtMillis on the session's clock
 * @param outcome how it ended, or that it was halted; empty while it runs
 * @param endedAtMillis time of its end; empty while it runs
 * @param marking tokens of each marked place in order of entry, by place id
 * @param visitedByNobody ids of places with a visit by nobody
 * @param firings number of firings
 * @param lastFirings the latest firings, oldest first
 * @param variables latest values of its own variables, as far as written
 * @param details the engine's latest details
 * @param stuck why it, or a sub-mission of it, cannot go on by itself; empty where it can
 */
public record MissionSnapshot(
        long id,
        long parent,
        String parentPlace,
        String plan,
        String title,
        String name,
        long startedAtMillis,
        Optional<Outcome> outcome,
        OptionalLong endedAtMillis,
        Map<String, List<Token>> marking,
        Set<String> visitedByNobody,
        long firings,
        List<Firing> lastFirings,
        Map<String, Value> variables,
        Details details,
        Optional<StuckMission> stuck) {

    /**
     * One firing.
     *
     * @param number of all firings of the session, from 1
     * @param transition id of the transition
     * @param used input events that it used up
     */
    public record Firing(long number, long atMillis, String transition, List<Occurrence> used, List<TokenMove> moves) {
        public Firing {
            Objects.requireNonNull(transition, "transition");
            used = List.copyOf(used);
            moves = List.copyOf(moves);
        }
    }

    /**
     * What only the engine can say; looked up a little later than the rest.
     *
     * @param pending input events that transitions have received and keep
     * @param blocked what the mission waits for, place by place
     */
    public record Details(List<PendingAnswer> pending, List<Wait> blocked) {
        public static final Details NONE = new Details(List.of(), List.of());

        public Details {
            pending = List.copyOf(pending);
            blocked = List.copyOf(blocked);
        }
    }

    public MissionSnapshot {
        Objects.requireNonNull(parentPlace, "parentPlace");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(name, "name");
        marking = Collections.unmodifiableMap(new LinkedHashMap<>(marking));
        lastFirings = List.copyOf(lastFirings);
        variables = Collections.unmodifiableMap(new LinkedHashMap<>(variables));
        Objects.requireNonNull(details, "details");
        Objects.requireNonNull(stuck, "stuck");
    }

    /** What people call it: the name that it was given, or its plan's title where it has none of its own. */
    public String words() {
        return name.isBlank() || name.equals(plan) ? title : name;
    }

    /** Whether it is over or was halted. */
    public boolean hasEnded() {
        return outcome.isPresent();
    }
}
