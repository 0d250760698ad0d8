package org.sami.crw.operator.alarm;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LinkDefaults;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;

/**
 * The conditions for launching a boat, as far as they are known.
 *
 * @param items in the order of the checklist
 */
public record LaunchCheck(List<Item> items) {
    private static final double MOVES_MPS = 0.1;

    /** How one item stands. */
    public enum State {
        GOOD,
        /** The boat can go, and the operator is to know of it. */
        DOUBTFUL,
        BAD,
        /** Nothing has been heard of it yet. */
        UNKNOWN
    }

    /** What is looked at. */
    public enum Subject {
        LINK,
        COMMANDER,
        POSITION,
        COMPASS,
        /** Only of boats that have one. */
        BOARD,
        MOTOR,
        BATTERY,
        LOST_LINK,
        /** Only of boats that say what they cannot do. */
        EQUIPMENT
    }

    /**
     * One item.
     *
     * @param text how it is, and where it is not good what to do
     */
    public record Item(Subject subject, State state, String text) {
        public Item {
            Objects.requireNonNull(subject, "subject");
            Objects.requireNonNull(state, "state");
            Objects.requireNonNull(text, "text");
        }

        /** With what it is about, such as {@code battery 3 %: put a full one in}. */
        public String words() {
            return switch (subject) {
                case LINK -> "link: " + text;
                case COMMANDER -> text;
                case POSITION -> "position: " + text;
                case COMPASS -> "compass: " + text;
                case BOARD -> "control board " + text;
                case MOTOR -> "motor: " + text;
                case BATTERY -> "battery " + text;
                case LOST_LINK -> "without a link it " + text;
                case EQUIPMENT -> text;
            };
        }
    }

    public LaunchCheck {
        items = List.copyOf(items);
    }

    /**
     * Goes through a boat.
     *
     * @param alarms of the session
     * @param triedMps the greatest speed in m/s during a trial of its motor; empty where it was not tried
     */
    public static LaunchCheck of(BoatSnapshot boat, List<Alarm> alarms, OptionalDouble triedMps, long nowMillis) {
        return of(boat, alarms, triedMps, nowMillis, Optional.empty());
    }

    /**
     * The same, in a session that wishes what boats do when their link is lost.
     *
     * @param wish empty where it wishes nothing
     */
    public static LaunchCheck of(
            BoatSnapshot boat,
            List<Alarm> alarms,
            OptionalDouble triedMps,
            long nowMillis,
            Optional<LostLinkAction> wish) {
        List<Item> items = new ArrayList<>();
        items.add(link(boat, nowMillis));
        items.add(commander(boat));
        items.add(position(boat, alarms, nowMillis));
        items.add(compass(boat, alarms));
        boat.settings().flatMap(BoatTuning::board).map(LaunchCheck::board).ifPresent(items::add);
        items.add(motor(boat, triedMps));
        items.add(battery(boat));
        items.add(lostLink(boat.settings(), wish));
        boat.settings().map(BoatTuning::capabilities).map(BoatDemands::missing).stream()
                .flatMap(List::stream)
                .map(text -> new Item(Subject.EQUIPMENT, State.DOUBTFUL, text))
                .forEach(items::add);
        return new LaunchCheck(items);
    }

    /** Whether all is good, or at worst doubtful. */
    public boolean mayLaunch() {
        return items.stream().allMatch(item -> item.state() == State.GOOD || item.state() == State.DOUBTFUL);
    }

    /**
     * Whether it can take part in a mission: as {@link #mayLaunch}, but for a motor that nobody has tried, which keeps a boat ashore and not one that
     * is in the water.
     */
    public boolean isReady() {
        return items.stream().allMatch(LaunchCheck::allows);
    }

    private static boolean allows(Item item) {
        boolean untried = item.subject() == Subject.MOTOR && item.state() == State.UNKNOWN;
        return untried || item.state() == State.GOOD || item.state() == State.DOUBTFUL;
    }

    /** All in one: good, doubtful where it is ready all the same, unknown where it has not said enough, else bad. */
    public State overall() {
        if (isReady()) {
            return items.stream().anyMatch(item -> item.state() == State.DOUBTFUL) ? State.DOUBTFUL : State.GOOD;
        }
        return items.stream().anyMatch(item -> item.state() == State.BAD) ? State.BAD : State.UNKNOWN;
    }

    /**
     * In one line: {@code ready}, {@code ready; battery 25 %, low: a short way only}, or {@code battery 3 %: put a full one in} with all else that it
     * is not ready for.
     */
    public String words() {
        boolean ready = isReady();
        List<String> told = items.stream()
                .filter(item -> ready ? item.state() == State.DOUBTFUL : !allows(item))
                .map(Item::words)
                .toList();
        return ready ? told.isEmpty() ? "ready" : "ready; " + String.join("; ", told) : String.join("; ", told);
    }

    /** How many items are good. */
    public long good() {
        return items.stream().filter(item -> item.state() == State.GOOD).count();
    }

    private static Item link(BoatSnapshot boat, long now) {
        OptionalLong age = boat.linkAgeMillis(now);
        if (age.isEmpty()) {
            return new Item(Subject.LINK, State.UNKNOWN, "it has not answered yet");
        }
        boolean fresh = boat.link() == LinkState.LINKED && age.getAsLong() <= LinkDefaults.LINK_LOST_AFTER_MS;
        return new Item(
                Subject.LINK,
                fresh ? State.GOOD : State.BAD,
                String.format(Locale.ROOT, "heard %.1f s ago", age.getAsLong() / 1000.0)
                        + (fresh ? "" : ": bring it into reach of the router"));
    }

    private static Item commander(BoatSnapshot boat) {
        return switch (boat.commander()) {
            case THIS_BASE -> new Item(Subject.COMMANDER, State.GOOD, "commanded from here");
            case BY_HAND -> new Item(Subject.COMMANDER, State.DOUBTFUL, "driven by hand: give it back to the missions");
            case SOMEBODY_ELSE -> new Item(Subject.COMMANDER, State.BAD, "another base commands it: take its command");
            case UNKNOWN -> new Item(Subject.COMMANDER, State.UNKNOWN, "it has not said who commands it");
        };
    }

    private static Item position(BoatSnapshot boat, List<Alarm> alarms, long now) {
        if (boat.pose().isEmpty()) {
            return new Item(Subject.POSITION, State.UNKNOWN, "it has not said where it is");
        }
        Optional<String> wrong =
                alarm(boat, alarms, Alarm.Kind.POSITION_DOUBTFUL).or(() -> alarm(boat, alarms, Alarm.Kind.FENCE));
        if (wrong.isPresent()) {
            return new Item(Subject.POSITION, State.BAD, wrong.get());
        }
        long age = boat.poseAgeMillis(now).orElse(0);
        String text = String.format(
                Locale.ROOT,
                "%.6f, %.6f",
                boat.pose().get().position().latDeg(),
                boat.pose().get().position().lonDeg());
        return age <= LinkDefaults.LINK_LOST_AFTER_MS
                ? new Item(Subject.POSITION, State.GOOD, text)
                : new Item(
                        Subject.POSITION,
                        State.BAD,
                        String.format(Locale.ROOT, "%s was %.0f s ago: wait for its satellites", text, age / 1000.0));
    }

    private static Item compass(BoatSnapshot boat, List<Alarm> alarms) {
        if (boat.pose().isEmpty()) {
            return new Item(Subject.COMPASS, State.UNKNOWN, "it has not said how it heads");
        }
        Optional<String> wrong = alarm(boat, alarms, Alarm.Kind.COMPASS_DOUBTFUL);
        double degrees = Math.toDegrees(boat.pose().get().headingRad());
        return wrong.map(text -> new Item(Subject.COMPASS, State.BAD, text))
                .orElseGet(() -> new Item(
                        Subject.COMPASS,
                        State.GOOD,
                        String.format(
                                Locale.ROOT,
                                "heads %03.0f°: turn the hull, the value must follow",
                                (degrees + 360) % 360)));
    }

    private static Item board(BoardCondition condition) {
        return switch (condition) {
            case WORKING -> new Item(Subject.BOARD, State.GOOD, "answers");
            case SILENT -> new Item(Subject.BOARD, State.BAD, "is silent: look at its power and its cable");
            case GONE -> new Item(Subject.BOARD, State.BAD, "is gone: plug it in");
        };
    }

    private static Item motor(BoatSnapshot boat, OptionalDouble triedMps) {
        if (boat.mode().map(mode -> mode == BoatMode.FLEET_STOP).orElse(false)) {
            return new Item(Subject.MOTOR, State.BAD, "its motors are stopped: release it first");
        }
        boolean moves =
                boat.pose().map(pose -> Math.abs(pose.speedMps()) >= MOVES_MPS).orElse(false);
        if (moves) {
            return new Item(Subject.MOTOR, State.GOOD, "it moves");
        } else if (triedMps.isEmpty()) {
            return new Item(Subject.MOTOR, State.UNKNOWN, "not tried: keep clear of the propeller and try it");
        }
        return triedMps.getAsDouble() >= MOVES_MPS
                ? new Item(
                        Subject.MOTOR,
                        State.GOOD,
                        String.format(Locale.ROOT, "tried, it went %.1f m/s", triedMps.getAsDouble()))
                : new Item(Subject.MOTOR, State.DOUBTFUL, "tried, and it went nowhere: look whether it turns");
    }

    private static Item battery(BoatSnapshot boat) {
        return boat.battery()
                .map(battery -> {
                    String percent = String.format(Locale.ROOT, "%.0f %%", battery.percent());
                    return switch (battery.level()) {
                        case NOMINAL -> new Item(Subject.BATTERY, State.GOOD, percent);
                        case LOW -> new Item(Subject.BATTERY, State.DOUBTFUL, percent + ", low: a short way only");
                        case CRITICAL -> new Item(Subject.BATTERY, State.BAD, percent + ": put a full one in");
                    };
                })
                .orElseGet(() -> new Item(Subject.BATTERY, State.UNKNOWN, "not known yet"));
    }

    /** Whether a boat is known to do something else without a link than a session wishes. */
    public static boolean isAgainstWish(BoatSnapshot boat, Optional<LostLinkAction> wish) {
        return wish.isPresent()
                && boat.settings()
                        .map(BoatTuning::lostLinkAction)
                        .filter(action -> action != wish.get())
                        .isPresent();
    }

    /** What a boat does when its link is lost, in words, and what the session wishes instead. */
    public static String lostLink(BoatTuning own, Optional<LostLinkAction> wish) {
        return lostLink(Optional.of(own), wish).text();
    }

    private static Item lostLink(Optional<BoatTuning> settings, Optional<LostLinkAction> wish) {
        return settings.map(own -> {
                    LostLinkAction action = own.lostLinkAction();
                    boolean isWished = wish.isEmpty() ? action != LostLinkAction.DRIFT : wish.get() == action;
                    String by = own.lostLinkBy().isEmpty() ? "" : " (" + own.lostLinkBy() + ")";
                    String instead = wish.filter(wanted -> wanted != action)
                            .map(wanted -> ": set it, this session wishes that it " + LostLinkWords.of(wanted))
                            .orElse("");
                    return new Item(
                            Subject.LOST_LINK,
                            isWished ? State.GOOD : State.DOUBTFUL,
                            LostLinkWords.of(action) + by + instead);
                })
                .orElseGet(() -> new Item(Subject.LOST_LINK, State.UNKNOWN, "has not said what it does"));
    }

    private static Optional<String> alarm(BoatSnapshot boat, List<Alarm> alarms, Alarm.Kind kind) {
        return alarms.stream()
                .filter(alarm ->
                        alarm.active() && alarm.kind() == kind && alarm.boat().equals(boat.boat()))
                .map(Alarm::text)
                .findFirst();
    }
}
