package org.sami.crw.gui.context;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.map.TaskWays;
import org.sami.spn.protocol.Decision;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.ui.value.RobotWays;

/**
 * The ways on which boats of a session, or of a replay, would go along paths for a mission: at first the straight ones, and as soon as they are found those
 * around what the mission avoids. On the event thread.
 */
public final class SessionWays {
    private static final int CACHE_SIZE = 100;

    private final OperatorContext context;
    private final Map<Asked, List<GeoPoint>> found = new LinkedHashMap<>();

    private record Asked(long mission, String boat, GeoPath path) {}

    /** Has found none yet. */
    public SessionWays(OperatorContext context) {
        this.context = context;
    }

    /** Those of a mission. */
    public RobotWays of(long mission) {
        return (boat, path, teller) -> find(new Asked(mission, boat, path), teller);
    }

    /** The paths of the boats that wait for the answer to a decision about their ways; empty where it is about something else. */
    public CompletionStage<Optional<DoubtedPaths>> doubted(Decision decision) {
        return DomainQuestion.of(decision.type())
                .filter(DomainQuestion::isAboutWays)
                .map(question -> context.shown().doubtedPaths(decision))
                .orElse(CompletableFuture.completedFuture(Optional.empty()));
    }

    /** Where the tasks are that a value allocates, as far as they have a place; arrives on the event thread. */
    public CompletionStage<Map<TaskId, GeoPoint>> places(Set<TaskId> tasks) {
        return context.shown().ask(view -> TaskWays.places(tasks, view));
    }

    private void find(Asked asked, Consumer<List<GeoPoint>> teller) {
        Optional.ofNullable(found.get(asked)).or(() -> straight(asked)).ifPresent(teller);
        context.shown()
                .way(asked.mission(), asked.boat(), asked.path())
                .thenAccept(way -> way.ifPresent(one -> {
                    keep(asked, one);
                    teller.accept(one);
                }));
    }

    private Optional<List<GeoPoint>> straight(Asked asked) {
        return context.models()
                .fleet()
                .boat(asked.boat())
                .flatMap(BoatSnapshot::pose)
                .map(pose -> {
                    List<GeoPoint> way = new ArrayList<>(List.of(pose.position()));
                    way.addAll(asked.path().points());
                    return way;
                });
    }

    private void keep(Asked asked, List<GeoPoint> way) {
        if (found.size() >= CACHE_SIZE) {
            found.clear();
        }
        found.put(asked, way);
    }
}
