package org.sami.crw.operator;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.spn.engine.EngineView;

/**
 * Gives models what a session in another process says of itself: what only that session can find out, such as alarms and faults. What follows from the engine's inputs
 * goes to {@link OperatorModels#onPastStep}, what happens to boats to {@link #boats()}. For one thread of the follower's.
 */
public final class FollowFeed {
    private final OperatorModels models;
    private final ReplayFeed boats;
    private final Map<String, HealthFault> faults = new HashMap<>();

    /** Takes what is acknowledged here to the session that is followed. Called on any thread; must not wait. */
    public interface Acknowledgements {
        /** Of a message, by its number there. */
        void message(long number);

        /** Of an alarm, by its number there. */
        void alarm(long number);
    }

    FollowFeed(OperatorModels models, Acknowledgements acknowledge) {
        this.models = models;
        boats = new ReplayFeed(models);
        models.post(() -> {
            models.messages().follow(acknowledge::message);
            models.alarms().follow(acknowledge::alarm);
        });
    }

    /** Starts again with a state: forgets what was shown. What the person chose to see, such as layers of the map, stays. */
    public void begin(EngineView state, long atMillis) {
        faults.clear();
        models.forget(state);
        models.restoreAreas(state);
        models.restore(state, atMillis);
    }

    /** What happens to boats. */
    public ReplayFeed boats() {
        return boats;
    }

    /** These are all messages that the session keeps. */
    public void messages(List<MessageEntry> all) {
        models.post(() -> models.messages().show(all));
    }

    /** These are all alarms. */
    public void alarms(List<Alarm> all) {
        models.post(() -> models.alarms().show(all));
    }

    /** These missions cannot go on by themselves. */
    public void stuck(List<StuckMission> all) {
        models.post(() -> models.missions().stuck(all));
    }

    /** These addresses do not answer. */
    public void unreached(List<UnreachedBoat> all) {
        models.unreached().show(all);
    }

    /** Whether the session stopped the whole fleet, including boats that join later. */
    public void stopsEveryBoat(boolean stops) {
        models.fleetStop().commanded(stops);
    }

    /** These are all faults of the session; those of alarms and of the fleet stop follow from what is said of those. */
    public void faults(List<HealthEntry> all) {
        Map<String, HealthFault> now = new HashMap<>();
        for (HealthEntry entry : all) {
            HealthFault fault = entry.fault();
            if (isFoundHere(fault.kind())) {
                continue;
            }
            String key = fault.kind() + " " + fault.subject();
            now.put(key, fault);
            if (!fault.equals(faults.get(key))) {
                models.health().report(fault, entry.sinceMillis());
            }
        }
        faults.forEach((key, fault) -> {
            if (!now.containsKey(key)) {
                models.health().over(fault.kind(), fault.subject());
            }
        });
        faults.clear();
        faults.putAll(now);
    }

    private static boolean isFoundHere(HealthKind kind) {
        return kind == HealthKind.ALARM || kind == HealthKind.DRIFT || kind == HealthKind.FLEET_STOP;
    }
}
