package org.sami.crw.operator;

import java.util.Comparator;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.Alarm.Kind;
import org.sami.crw.proxy.BoatExplanation.Cause;
import org.sami.crw.proxy.BoatPose;
import org.sami.crw.proxy.LinkState;
import org.sami.crw.proxy.tcp.LinkAlarm;
import org.sami.crw.service.water.Water;

/**
 * The alarms: the worst first, of equal ones the newest. Each kind is raised once a boat, stays while it is so, and is gone when it is
 * over and acknowledged. Follows the snapshots of boats and the fleet's events.
 */
public final class AlarmModel extends Model<List<Alarm>> {
    private static final Comparator<Alarm> ORDER = Comparator.comparing(
                    (Alarm alarm) -> alarm.kind().severity())
            .thenComparingLong(Alarm::sinceMillis)
            .reversed()
            .thenComparing(Alarm::kind)
            .thenComparing(Alarm::boat);

    private final Consumer<Runnable> inbox;
    private final Map<Key, Alarm> alarms = new LinkedHashMap<>();
    private final Set<Key> muted = new HashSet<>();
    private Optional<Water> water = Optional.empty();

    private record Key(Kind kind, String boat) {}

    AlarmModel(Consumer<Runnable> inbox) {
        super(List.of());
        this.inbox = inbox;
    }

    /** From now on boats that are outside of this area raise {@link Kind#FENCE}. */
    void setArea(OperatingArea area, long atMillis) {
        Optional<String> unusable = Optional.empty();
        try {
            water = area.water();
        } catch (IllegalArgumentException crossed) {
            water = Optional.empty();
            unusable = Optional.of("No boat is held to the fence: " + crossed.getMessage());
        }
        set(new Key(Kind.FENCE, ""), unusable, atMillis);
    }

    /** The operator knows an alarm; if it is over, it goes. One that is gone changes nothing. From any thread. */
    public void acknowledge(Kind kind, String boat) {
        inbox.accept(() -> {
            Key key = new Key(kind, boat);
            Alarm alarm = alarms.get(key);
            if (alarm != null && !alarm.active()) {
                alarms.remove(key);
            } else if (alarm != null) {
                put(key, alarm.text(), alarm.sinceMillis(), true, true);
            }
            change();
        });
    }

    /** Alarms of a kind about a boat make no sound from now on, or do again. From any thread. */
    public void mute(Kind kind, String boat, boolean mute) {
        inbox.accept(() -> {
            Key key = new Key(kind, boat);
            if (mute) {
                muted.add(key);
            } else {
                muted.remove(key);
            }
            alarms.computeIfPresent(key, (k, a) -> alarm(key, a.text(), a.sinceMillis(), a.active(), a.acknowledged()));
            change();
        });
    }

    /** A boat is known as this now. */
    void seen(BoatSnapshot boat, long atMillis) {
        wrong(boat).forEach((kind, text) -> set(new Key(kind, boat.boat()), text, atMillis));
    }

    /** What is wrong with a boat, by each kind that its snapshot tells. */
    private Map<Kind, Optional<String>> wrong(BoatSnapshot boat) {
        Map<Kind, Optional<String>> wrong = new EnumMap<>(Kind.class);
        Cause cause = boat.why().cause();
        wrong.put(
                Kind.LINK_LOST,
                when(boat.link() == LinkState.LOST, "The link to " + boat.boat() + " is lost; its commands wait"));
        wrong.put(
                Kind.BATTERY_CRITICAL,
                boat.battery()
                        .filter(battery -> battery.level() == BatteryLevel.CRITICAL)
                        .map(battery -> "The battery of " + boat.boat() + " is critical"));
        wrong.put(
                Kind.BOAT_CRITICAL,
                when(
                        cause == Cause.STARTED_ANEW || cause == Cause.REFUSES || cause == Cause.BATTERY_EMPTY,
                        boat.why().text()));
        wrong.put(
                Kind.NO_PROGRESS, when(cause == Cause.NO_PROGRESS, boat.boat() + " comes no nearer to its next point"));
        wrong.put(Kind.FENCE, when(isOutside(boat), boat.boat() + " is outside of the water in which boats may go"));
        return wrong;
    }

    private boolean isOutside(BoatSnapshot boat) {
        Optional<BoatPose> pose = boat.pose();
        return water.isPresent()
                && pose.isPresent()
                && water.get().clearanceM(pose.get().position()) <= 0;
    }

    private static Optional<String> when(boolean is, String text) {
        return is ? Optional.of(text) : Optional.empty();
    }

    void apply(FleetEvent event, long atMillis) {
        if (event instanceof FleetEvent.LinkAlarmed e) {
            set(new Key(kindOf(e.alarm()), e.boat()), Optional.of(e.alarm().text()), atMillis);
        } else if (event instanceof FleetEvent.Moved) {
            set(new Key(Kind.DUPLICATE_ID, event.boat()), Optional.empty(), atMillis);
        } else if (event instanceof FleetEvent.Removed) {
            for (Key key : List.copyOf(alarms.keySet())) {
                if (key.boat().equals(event.boat())) {
                    set(key, Optional.empty(), atMillis);
                }
            }
        }
    }

    private static Kind kindOf(LinkAlarm alarm) {
        return switch (alarm.kind()) {
            case TWO_BOATS_WITH_ONE_ID, ONE_BOAT_AT_TWO_ADDRESSES -> Kind.DUPLICATE_ID;
            case ANOTHER_BOAT, OTHER_VERSION -> Kind.LINK_FAULT;
        };
    }

    /** It is so, with a text, or it is not so. */
    private void set(Key key, Optional<String> text, long atMillis) {
        Alarm before = alarms.get(key);
        if (text.isPresent()) {
            boolean goesOn = before != null && before.active();
            put(key, text.get(), goesOn ? before.sinceMillis() : atMillis, true, goesOn && before.acknowledged());
        } else if (before != null && before.acknowledged()) {
            alarms.remove(key);
        } else if (before != null) {
            put(key, before.text(), before.sinceMillis(), false, false);
        } else {
            return;
        }
        change();
    }

    private void put(Key key, String text, long sinceMillis, boolean active, boolean acknowledged) {
        alarms.put(key, alarm(key, text, sinceMillis, active, acknowledged));
    }

    private Alarm alarm(Key key, String text, long sinceMillis, boolean active, boolean acknowledged) {
        return new Alarm(key.kind(), key.boat(), text, sinceMillis, active, acknowledged, muted.contains(key));
    }

    @Override
    List<Alarm> take() {
        return alarms.values().stream().sorted(ORDER).toList();
    }
}
