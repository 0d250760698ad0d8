package org.sami.spn.engine;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Token;

/**
 * A mission as it stands.
 *
 * @param parent the mission whose place runs it, or {@code Ids.NONE}
 * @param place the parent's place whose sub-mission it is, by its id; empty text for a root mission
 * @param marking tokens of each marked place in order of entry, by place id in the plan's order
 * @param projectVersion of which of the session's projects its plan is ({@code Effect.ProjectLoaded}); 1 where none was loaded
 * @param startedAtMillis on the session's clock; empty in a state of an earlier version
 * @param firings how many there were since then, as far as the state has counted them
 */
public record MissionView(
        long id,
        long parent,
        long root,
        String place,
        String plan,
        String name,
        MissionStatus status,
        Map<String, List<Token>> marking,
        int projectVersion,
        OptionalLong startedAtMillis,
        long firings) {
    public MissionView {
        Objects.requireNonNull(place, "place");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(status, "status");
        Objects.requireNonNull(startedAtMillis, "startedAtMillis");
        marking = Collections.unmodifiableMap(new LinkedHashMap<>(marking));
    }

    /** A mission of the project with which the session began. */
    public MissionView(
            long id,
            long parent,
            long root,
            String place,
            String plan,
            String name,
            MissionStatus status,
            Map<String, List<Token>> marking) {
        this(id, parent, root, place, plan, name, status, marking, 1, OptionalLong.empty(), 0);
    }

    /** Likewise, one that stands in no place of another. */
    public MissionView(
            long id,
            long parent,
            long root,
            String plan,
            String name,
            MissionStatus status,
            Map<String, List<Token>> marking) {
        this(id, parent, root, "", plan, name, status, marking, 1, OptionalLong.empty(), 0);
    }
}
