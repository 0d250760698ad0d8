package org.sami.crw.operator;

import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.function.Predicate;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.alarm.Alarm.Kind;
import org.sami.crw.operator.alarm.ApproachCheck;
import org.sami.crw.operator.alarm.BoatAlarms;
import org.sami.crw.operator.alarm.FenceCheck;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.MissionTitles;
import org.sami.crw.proxy.link.LinkAlarm;
import org.sami.spn.value.GeoArea;

/**
 * The alarms: the worst first, of equal ones the newest. Each kind is raised once a boat, or once two boats, stays while it is so, and is
 * gone when it is over and acknowledged. Follows the snapshots of boats, their command queues and the fleet's events.
 */
public final class AlarmModel extends Model<List<Alarm>> {
    private static final Comparator<Alarm> ORDER = Comparator.comparing(
                    (Alarm alarm) -> alarm.kind().severity())
            .thenComparingLong(Alarm::sinceMillis)
            .reversed()
            .thenComparing(Alarm::kind)
            .thenComparing(Alarm::boat)
            .thenComparing(Alarm::other);

    private final Consumer<Runnable> inbox;
    private final CommandModel commands;
    private final OperatorLog log;
    private final RobotKind robots;
    private final FenceCheck fence;
    private final BoatAlarms boatAlarms;
    private final ApproachCheck approaches = new ApproachCheck();
    private final Map<Key, Alarm> alarms = new LinkedHashMap<>();
    private final Map<String, BoatSnapshot> boats = new LinkedHashMap<>();
    private final Set<Key> muted = new HashSet<>();
    private volatile long sampledEveryMillis;
    private long raised;
    private volatile Optional<LongConsumer> elsewhere = Optional.empty(); // acknowledges there

    private record Key(Kind kind, String boat, String other) {
        static Key of(Kind kind, String boat) {
            return new Key(kind, boat, "");
        }

        static Key of(Alarm alarm) {
            return new Key(alarm.kind(), alarm.boat(), alarm.other());
        }

        boolean concerns(String one) {
            return boat.equals(one) || other.equals(one);
        }
    }

    /** @param robots what alarms are about */
    AlarmModel(
            Consumer<Runnable> inbox, CommandModel commands, OperatorLog log, MissionTitles titles, RobotKind robots) {
        super(List.of());
        fence = new FenceCheck(titles);
        boatAlarms = new BoatAlarms(fence);
        this.inbox = inbox;
        this.commands = commands;
        this.log = log;
        this.robots = robots;
    }

    /**
     * From now on alarms are raised by a session elsewhere: they are {@link #show shown} as they are there, none is raised here, and acknowledgements are given to
     * that session. On the owner's thread.
     */
    void follow(LongConsumer acknowledge) {
        elsewhere = Optional.of(acknowledge);
    }

    /** These are all alarms of the session that is followed. On the owner's thread. */
    void show(List<Alarm> all) {
        alarms.clear();
        for (Alarm alarm : all) {
            put(alarm.number(), Key.of(alarm), alarm.text(), alarm.sinceMillis(), alarm.active(), alarm.acknowledged());
        }
        change();
    }

    /** Boats are seen once in this time, if nothing happens. From any thread. */
    void sampledEvery(long periodMillis) {
        sampledEveryMillis = periodMillis;
    }

    /** From now on boats that are, or are sent, outside of this area raise {@link Kind#FENCE} and {@link Kind#FENCE_AHEAD}. */
    void setArea(OperatingArea area, long atMillis) {
        Optional<String> unusable = Optional.empty();
        try {
            fence.setWater(area.water());
        } catch (IllegalArgumentException crossed) {
            fence.setWater(Optional.empty());
            unusable = Optional.of("No boat is held to the fence: " + crossed.getMessage());
        }
        set(Key.of(Kind.FENCE, ""), unusable, atMillis);
        boats.values().forEach(boat -> seen(boat, atMillis));
    }

    /**
     * From now on boats that carry out a mission's commands raise the same in the areas that it avoids.
     *
     * @param avoided by mission; those that avoid nothing may be missing
     */
    void setAvoided(Map<Long, List<GeoArea>> avoided, long atMillis) {
        fence.setAvoided(avoided);
        boats.values().forEach(boat -> seen(boat, atMillis));
    }

    // ---- what the operator does; from any thread

    /** The operator knows an alarm, by its number; if it is over, it goes. One that is gone changes nothing. */
    public void acknowledge(long number) {
        acknowledge(alarm -> alarm.number() == number);
    }

    /** The operator knows the alarms of a kind about a boat; those that are over go. */
    public void acknowledge(Kind kind, String boat) {
        acknowledge(alarm -> alarm.kind() == kind && alarm.boat().equals(boat));
    }

    private void acknowledge(Predicate<Alarm> which) {
        inbox.accept(() -> {
            for (Alarm alarm : List.copyOf(alarms.values())) {
                if (which.test(alarm) && !alarm.acknowledged() && elsewhere.isPresent()) {
                    elsewhere.get().accept(alarm.number());
                } else if (which.test(alarm) && !alarm.acknowledged()) {
                    log.add(OperatorLogEntry.Kind.ACKNOWLEDGED, alarm.text(), alarm.boat());
                    if (alarm.active()) {
                        put(new Alarm(
                                alarm.number(),
                                alarm.kind(),
                                alarm.boat(),
                                alarm.other(),
                                alarm.text(),
                                alarm.sinceMillis(),
                                true,
                                true,
                                alarm.muted()));
                    } else {
                        alarms.remove(Key.of(alarm));
                    }
                }
            }
            change();
        });
    }

    /** Alarms of a kind about a boat make no sound from now on, or do again. */
    public void mute(Kind kind, String boat, boolean mute) {
        inbox.accept(() -> {
            Key key = Key.of(kind, boat);
            boolean changed = mute ? muted.add(key) : muted.remove(key);
            if (changed && elsewhere.isEmpty()) {
                log.add(
                        OperatorLogEntry.Kind.MUTED,
                        (mute ? "alarms make no sound: " : "alarms are heard again: ") + kind,
                        boat);
            }
            for (Alarm alarm : List.copyOf(alarms.values())) {
                put(
                        alarm.number(),
                        Key.of(alarm),
                        alarm.text(),
                        alarm.sinceMillis(),
                        alarm.active(),
                        alarm.acknowledged());
            }
            change();
        });
    }

    // ---- what happens; on the owner's thread

    /** Forgets boats, alarms and the area, not which are muted. */
    void clear() {
        List.copyOf(boats.keySet()).forEach(boat -> removed(boat, 0));
        alarms.clear();
        fence.setWater(Optional.empty());
        fence.setAvoided(Map.of());
        raised = 0;
        change();
    }

    /** A boat is known as this now. */
    void seen(BoatSnapshot boat, long atMillis) {
        boats.put(boat.boat(), boat);
        boatAlarms
                .wrong(boat, commands.queue(boat.boat()))
                .forEach((kind, text) -> set(Key.of(kind, boat.boat()), text, atMillis));
        boat.pose()
                .ifPresent(pose -> approaches
                        .at(boat.boat(), pose, atMillis)
                        .forEach((other, text) -> set(pair(boat.boat(), other), text, atMillis)));
    }

    private static Key pair(String one, String two) {
        return one.compareTo(two) < 0 ? new Key(Kind.APPROACH, one, two) : new Key(Kind.APPROACH, two, one);
    }

    /** Time has passed: a boat that says nothing is not seen. */
    void tick(long nowMillis) {
        boats.values()
                .forEach(boat -> set(
                        Key.of(Kind.STALE_POSE, boat.boat()),
                        BoatAlarms.stale(boat, nowMillis, sampledEveryMillis),
                        nowMillis));
        boatAlarms.phonesSilent(nowMillis, (kind, boat) -> set(Key.of(kind, boat), Optional.empty(), nowMillis));
    }

    void apply(FleetEvent event, long atMillis) {
        if (event instanceof FleetEvent.LinkAlarmed e) {
            kindOf(e.alarm())
                    .ifPresent(kind ->
                            set(Key.of(kind, e.boat()), Optional.of(e.alarm().text()), atMillis));
        } else if (event instanceof FleetEvent.TooMuchSent e) {
            tooMuchSent(e, atMillis);
        } else if (event instanceof FleetEvent.Measured e) {
            boatAlarms
                    .measured(e.boat(), e.reading(), atMillis)
                    .forEach((kind, text) -> set(Key.of(kind, e.boat()), text, atMillis));
        } else if (event instanceof FleetEvent.Moved) {
            set(Key.of(Kind.DUPLICATE_ID, event.boat()), Optional.empty(), atMillis);
        } else if (event instanceof FleetEvent.QueueChanged || event instanceof FleetEvent.UploadAdvanced) {
            Optional.ofNullable(boats.get(event.boat())).ifPresent(boat -> seen(boat, atMillis));
        } else if (event instanceof FleetEvent.Removed) {
            removed(event.boat(), atMillis);
        }
    }

    /** What is over stays with what was left out in the end. */
    private void tooMuchSent(FleetEvent.TooMuchSent event, long atMillis) {
        Key key = Key.of(Kind.LINK_FLOOD, event.boat());
        set(key, Optional.of(event.leftOut().words(event.boat())), atMillis);
        if (!event.leftOut().active()) {
            set(key, Optional.empty(), atMillis);
        }
    }

    private void removed(String boat, long atMillis) {
        boats.remove(boat);
        boatAlarms.remove(boat);
        approaches.remove(boat);
        for (Key key : List.copyOf(alarms.keySet())) {
            if (key.concerns(boat)) {
                set(key, Optional.empty(), atMillis);
            }
        }
    }

    /** Empty for what is only a message: nobody says when it is over. */
    private static Optional<Kind> kindOf(LinkAlarm alarm) {
        return switch (alarm.kind()) {
            case TWO_BOATS_WITH_ONE_ID, ONE_BOAT_AT_TWO_ADDRESSES -> Optional.of(Kind.DUPLICATE_ID);
            case ANOTHER_BOAT, OTHER_VERSION, LINK_OF_BEFORE -> Optional.of(Kind.LINK_FAULT);
            case EVER_NEW_BOATS -> Optional.of(Kind.LINK_FLOOD);
            case SAID_BY_BOAT -> Optional.empty();
        };
    }

    /** It is so, with a text, or it is not so. */
    private void set(Key key, Optional<String> text, long atMillis) {
        if (elsewhere.isPresent()) {
            return;
        }
        Alarm before = alarms.get(key);
        if (text.isPresent()) {
            Optional<Alarm> goesOn = Optional.ofNullable(before).filter(Alarm::active);
            long number = goesOn.isPresent() ? goesOn.get().number() : ++raised;
            put(
                    number,
                    key,
                    text.get(),
                    goesOn.map(Alarm::sinceMillis).orElse(atMillis),
                    true,
                    goesOn.filter(Alarm::acknowledged).isPresent());
        } else if (before != null && before.acknowledged()) {
            alarms.remove(key);
        } else if (before != null && before.active()) {
            put(before.number(), key, before.text(), before.sinceMillis(), false, false);
        } else {
            return;
        }
        change();
    }

    private void put(long number, Key key, String text, long sinceMillis, boolean active, boolean acknowledged) {
        put(new Alarm(
                number,
                key.kind(),
                key.boat(),
                key.other(),
                robots.say(text),
                sinceMillis,
                active,
                acknowledged,
                muted.contains(Key.of(key.kind(), key.boat()))));
    }

    private void put(Alarm alarm) {
        alarms.put(Key.of(alarm), alarm);
    }

    @Override
    List<Alarm> take() {
        return alarms.values().stream().sorted(ORDER).toList();
    }
}
