package org.sami.crw.session;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.alarm.MissingCapabilities;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * Tells the operator, when a mission starts, which robots cannot do what its plan asks; and while it runs, when a robot says so later. Hears steps on the engine's
 * thread; all else is for the fleet's thread.
 */
final class CapabilityWatch implements HostListener {
    private static final int MOST_TOLD = 5;

    /** Vehicles report what they have while it is still read from them: a camera of which nothing is known yet is not missing. */
    private static final long SETTLES_MS = 2000;

    private final RobotKind robots;
    private final Supplier<ProxyRegistry> fleet;
    private final Executor thread;
    private final MessageSink messages;
    private final Scheduler time;
    private final Map<Long, Mission> running = new LinkedHashMap<>();
    private final Map<String, Long> settlesAt = new HashMap<>(); // by robot

    private record Mission(long id, Plan plan, Project project, Set<String> told) {}

    /**
     * A watch that knows no mission.
     *
     * @param robots what the session's plans command
     * @param thread the fleet's
     */
    CapabilityWatch(
            RobotKind robots, Supplier<ProxyRegistry> fleet, Executor thread, MessageSink messages, Scheduler time) {
        this.robots = robots;
        this.fleet = fleet;
        this.thread = thread;
        this.messages = messages;
        this.time = time;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted started && started.parent() == Ids.NONE) {
                Project project = view.project();
                view.plan(started.plan())
                        .map(plan -> new Mission(started.mission(), plan, project, new HashSet<>()))
                        .ifPresent(mission -> thread.execute(() -> begun(mission)));
            } else if (effect instanceof Effect.MissionEnded ended) {
                thread.execute(() -> running.remove(ended.mission()));
            }
        }
    }

    private void begun(Mission mission) {
        running.put(mission.id(), mission);
        tellMissing(mission);
    }

    /** Something happened to the fleet. */
    void take(FleetEvent event) {
        if (event instanceof FleetEvent.SettingsReported) {
            if (settlesAt.putIfAbsent(event.boat(), time.nowMs() + SETTLES_MS) == null) {
                time.after(SETTLES_MS, () -> thread.execute(this::tellMissing));
            }
            tellMissing();
        } else if (event instanceof FleetEvent.Removed) {
            settlesAt.remove(event.boat());
        }
    }

    private void tellMissing() {
        running.values().forEach(this::tellMissing);
    }

    private void tellMissing(Mission mission) {
        List<MissingCapabilities.Robot> known =
                fleet.get().all().stream().map(this::robot).toList();
        List<String> news =
                new ArrayList<>(MissingCapabilities.ofRobots(mission.plan(), mission.project(), known, robots)
                        .missing());
        news.removeIf(sentence -> !mission.told().add(sentence));
        if (!news.isEmpty()) {
            int more = news.size() - MOST_TOLD;
            String listed = String.join("; ", news.subList(0, Math.min(MOST_TOLD, news.size())));
            messages.tell(new OperatorMessage(
                    time.nowMs(),
                    mission.id(),
                    OperatorMessage.Source.DOMAIN,
                    Priority.MEDIUM,
                    "Not all that " + mission.plan().title() + " asks can be done: " + listed
                            + (more > 0 ? "; and " + more + " more" : ""),
                    List.of(),
                    ""));
        }
    }

    private MissingCapabilities.Robot robot(BoatProxy boat) {
        boolean hasSettled = time.nowMs() >= settlesAt.getOrDefault(boat.boatId(), Long.MAX_VALUE);
        return new MissingCapabilities.Robot(
                boat.boatId(),
                boat.status().pose().isPresent(),
                boat.isFlying(),
                hasSettled ? boat.capabilities() : BoatCapabilities.UNKNOWN);
    }
}
