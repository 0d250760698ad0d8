package org.sami.crw.operator;

import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionSnapshot.Details;
import org.sami.crw.operator.mission.MissionSnapshot.Firing;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.value.Value;

/**
 * The missions: where their tokens stand, what fired, what their variables hold, and what blocks them. Follows the engine's effects;
 * what effects do not tell is looked up from time to time ({@link OperatorModels#refresh}).
 */
public final class MissionModel extends Model<MissionsSnapshot> {
    private static final System.Logger LOG = System.getLogger(MissionModel.class.getName());
    private static final int FIRINGS_KEPT = 100;
    private static final int ENDED_KEPT = 50;

    private final Map<Long, Tracked> tracked = new LinkedHashMap<>();
    private final Deque<Long> ended = new ArrayDeque<>();
    private final Map<String, Value> globals = new LinkedHashMap<>();
    private FollowedMarking marking = new FollowedMarking();
    private long firings;

    /** A mission and its state; its snapshot is renewed after a change. */
    private static final class Tracked {
        private final Effect.MissionStarted start;
        private final String title;
        private final long startedAtMillis;
        private final Deque<Firing> lastFirings = new ArrayDeque<>();
        private final Map<String, Value> variables;
        private long firings;
        private Optional<Outcome> outcome = Optional.empty();
        private OptionalLong endedAtMillis = OptionalLong.empty();
        private Details details = Details.NONE;
        private Optional<StuckMission> stuck = Optional.empty();
        private Optional<MissionSnapshot> snapshot = Optional.empty();

        Tracked(Effect.MissionStarted start, StartedPlan plan, long startedAtMillis) {
            this.start = start;
            this.title = plan.title();
            this.startedAtMillis = startedAtMillis;
            this.variables = new LinkedHashMap<>(plan.variables());
        }
    }

    /**
     * What is known of a mission's plan when it starts.
     *
     * @param variables values of those that the plan declares
     * @param globals values of those that it reads, as far as they are global
     * @param drawn its net and phases; empty where they are not known
     */
    record StartedPlan(String title, Map<String, Value> variables, Map<String, Value> globals, Optional<Drawn> drawn) {
        /** A plan's net, and the chart of its phases. */
        record Drawn(Plan plan, PhaseChart chart) {}
    }

    /** When a mission of a restored state started, where that is known, and how often it has fired. */
    record Earlier(OptionalLong startedAtMillis, long firings) {}

    MissionModel() {
        super(MissionsSnapshot.EMPTY);
    }

    /** What people call a mission: its own name, or its plan's title; empty where the mission is not known, or no longer. From any thread. */
    public Optional<String> title(long mission) {
        return snapshot().mission(mission).map(MissionSnapshot::words);
    }

    /** Names a mission to people, on the owner's thread: its plan's title, with its number where several of that title run. */
    String words(long mission) {
        Tracked named = tracked.get(mission);
        if (named == null) {
            return "mission " + mission;
        }
        boolean severalRun = tracked.values().stream()
                .anyMatch(other -> other != named && other.outcome.isEmpty() && other.title.equals(named.title));
        return severalRun ? named.title + " (" + mission + ")" : named.title;
    }

    /** Forgets all. */
    void clear() {
        restore(List.of(), Map.of(), Map.of(), 0);
        globals.clear();
        firings = 0;
        change();
    }

    /** Starts from a restored state: the effects that give its marking. */
    void restore(List<Effect> effects, Map<Long, StartedPlan> plans, Map<Long, Earlier> earlier, long atMillis) {
        marking = new FollowedMarking();
        tracked.clear();
        ended.clear();
        effects.forEach(effect -> apply(
                effect,
                plans,
                effect instanceof Effect.MissionStarted start && earlier.containsKey(start.mission())
                        ? earlier.get(start.mission()).startedAtMillis().orElse(atMillis)
                        : atMillis));
        earlier.forEach((id, before) -> with(id, mission -> mission.firings = before.firings()));
        firings = earlier.values().stream().mapToLong(Earlier::firings).sum();
    }

    void apply(Effect effect, Map<Long, StartedPlan> plans, long atMillis) {
        if (effect instanceof Effect.MissionStarted e) {
            StartedPlan plan =
                    plans.getOrDefault(e.mission(), new StartedPlan(e.plan(), Map.of(), Map.of(), Optional.empty()));
            tracked.put(e.mission(), new Tracked(e, plan, atMillis));
            plan.globals().forEach(globals::putIfAbsent);
            change();
        } else if (effect instanceof Effect.Fired e) {
            fired(e, atMillis);
        } else if (effect instanceof Effect.VariableWritten e) {
            if (e.mission() == Ids.NONE) {
                globals.put(e.variable(), e.value());
                change();
            } else {
                with(e.mission(), mission -> mission.variables.put(e.variable(), e.value()));
            }
        } else if (effect instanceof Effect.Entered e) {
            with(e.mission(), mission -> {});
        } else if (effect instanceof Effect.Left e) {
            with(e.mission(), mission -> {});
        }
        follow(effect);
        if (effect instanceof Effect.MissionEnded e) {
            ended(e, atMillis);
        }
    }

    private void follow(Effect effect) {
        try {
            marking.accept(effect);
        } catch (IllegalStateException missed) { // the other models go on; the marking of this mission is not known
            LOG.log(Level.ERROR, "effects of a mission were missed", missed);
        }
    }

    private void fired(Effect.Fired e, long atMillis) {
        firings = Math.max(firings, e.firing());
        with(e.mission(), mission -> {
            mission.firings++;
            mission.lastFirings.add(new Firing(e.firing(), atMillis, e.transition(), e.used(), e.moves()));
            if (mission.lastFirings.size() > FIRINGS_KEPT) {
                mission.lastFirings.poll();
            }
        });
    }

    private void ended(Effect.MissionEnded e, long atMillis) {
        with(e.mission(), mission -> {
            mission.outcome = Optional.of(e.outcome());
            mission.endedAtMillis = OptionalLong.of(atMillis);
            mission.details = Details.NONE;
            mission.stuck = Optional.empty();
        });
        if (e.outcome() != Outcome.HALTED) {
            ended.add(e.mission());
            if (ended.size() > ENDED_KEPT) {
                tracked.remove(ended.poll());
            }
        }
    }

    /** What the engine was asked; missions that it does not name have none any longer. */
    void details(Map<Long, Details> told) {
        tracked.forEach((id, mission) -> {
            Details now = mission.outcome.isPresent() ? Details.NONE : told.getOrDefault(id, Details.NONE);
            if (!now.equals(mission.details)) {
                with(id, changed -> changed.details = now);
            }
        });
    }

    /** These cannot go on by themselves: each, and its root mission. */
    void stuck(List<StuckMission> all) {
        Map<Long, StuckMission> byMission = new LinkedHashMap<>();
        all.forEach(one -> byMission.putIfAbsent(one.mission(), one));
        all.forEach(one -> byMission.putIfAbsent(one.root(), one));
        tracked.forEach((id, mission) -> {
            Optional<StuckMission> now = Optional.ofNullable(byMission.get(id));
            if (!now.equals(mission.stuck)) {
                with(id, changed -> changed.stuck = now);
            }
        });
    }

    private void with(long id, Consumer<Tracked> what) {
        Tracked mission = tracked.get(id);
        if (mission != null) {
            what.accept(mission);
            mission.snapshot = Optional.empty();
            change();
        }
    }

    /** The plan of a mission that has not ended; empty text where it is not known. */
    String planOf(long mission) {
        return marking.plan(mission);
    }

    /** The name of a mission that has not ended; empty text where it is not known. */
    String nameOf(long mission) {
        return marking.name(mission);
    }

    @Override
    MissionsSnapshot take() {
        List<MissionSnapshot> missions = new ArrayList<>();
        tracked.values().forEach(mission -> {
            if (mission.snapshot.isEmpty()) {
                mission.snapshot = Optional.of(snapshot(mission));
            }
            missions.add(mission.snapshot.get());
        });
        return new MissionsSnapshot(missions, globals, firings);
    }

    private MissionSnapshot snapshot(Tracked mission) {
        Effect.MissionStarted start = mission.start;
        return new MissionSnapshot(
                start.mission(),
                start.parent(),
                start.place(),
                start.plan(),
                mission.title,
                start.name(),
                mission.startedAtMillis,
                mission.outcome,
                mission.endedAtMillis,
                marking.marking(start.mission()),
                marking.visitedByNobody(start.mission()),
                mission.firings,
                List.copyOf(mission.lastFirings),
                mission.variables,
                mission.details,
                mission.stuck);
    }
}
