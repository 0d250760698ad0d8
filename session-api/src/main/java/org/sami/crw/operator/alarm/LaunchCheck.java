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
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.handler.planning.BoatDemands;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.proxy.explanation.LostLinkWords;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.value.GeoPoint;

/**
 * The conditions for launching a boat, or for the take-off of a robot that flies, as far as they are known.
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
        /** Only of boats: nobody tries the motors of what flies on the ground. */
        MOTOR,
        /** What the autopilot says against starting the motors; only of robots that fly. */
        AUTOPILOT,
        BATTERY,
        LOST_LINK,
        /** The fence and no-go areas; only of robots that fly. */
        AREA,
        /** Only of robots that the session does not command. */
        KIND,
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
                case AUTOPILOT -> "autopilot: " + text;
                case BATTERY -> "battery " + text;
                case LOST_LINK -> "without a link it " + text;
                case AREA -> "area: " + text;
                case KIND, EQUIPMENT -> text;
            };
        }
    }

    public LaunchCheck {
        items = List.copyOf(items);
    }

    /**
     * Goes through a boat, or through a robot that flies: by what it is, as it has reported itself, and before by what the session commands.
     *
     * @param triedMps the greatest speed in m/s during a trial of its motor; empty where it was not tried
     */
    public static LaunchCheck of(BoatSnapshot boat, OptionalDouble triedMps, LaunchFacts known) {
        List<Item> items = new ArrayList<>();
        boat.unfit(known.robots())
                .map(text -> new Item(Subject.KIND, State.BAD, text))
                .ifPresent(items::add);
        items.add(link(boat, known.nowMillis()));
        items.add(commander(boat));
        if (boat.kind(known.robots()) == RobotKind.COPTER) {
            items.add(TakeOffCheck.position(boat, known));
            items.add(TakeOffCheck.autopilot(boat, known));
        } else {
            items.add(position(boat, known));
            items.add(compass(boat, known));
            boat.settings().flatMap(BoatTuning::board).map(LaunchCheck::board).ifPresent(items::add);
            items.add(motor(boat, triedMps));
        }
        items.add(battery(boat));
        items.add(lostLink(boat.settings(), known.lostLinkWish()));
        if (boat.kind(known.robots()) == RobotKind.COPTER) {
            items.add(TakeOffCheck.area(boat, known));
        }
        boat.settings().map(BoatTuning::capabilities).map(BoatDemands::missingEquipment).stream()
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
        if (boat.flies() && boat.mode().filter(BoatMode.FLEET_STOP::equals).isPresent()) {
            return new Item(Subject.COMMANDER, State.BAD, "it is stopped: release it first");
        }
        return switch (boat.commander()) {
            case THIS_BASE -> new Item(Subject.COMMANDER, State.GOOD, "commanded from here");
            case BY_HAND -> new Item(Subject.COMMANDER, State.DOUBTFUL, "driven by hand: give it back to the missions");
            case SOMEBODY_ELSE -> new Item(Subject.COMMANDER, State.BAD, "another base commands it: take its command");
            case UNKNOWN -> new Item(Subject.COMMANDER, State.UNKNOWN, "it has not said who commands it");
        };
    }

    private static Item position(BoatSnapshot boat, LaunchFacts known) {
        if (boat.pose().isEmpty()) {
            return new Item(Subject.POSITION, State.UNKNOWN, "it has not said where it is");
        }
        Optional<String> wrong = known.alarm(boat.boat(), Alarm.Kind.POSITION_DOUBTFUL)
                .or(() -> known.alarm(boat.boat(), Alarm.Kind.FENCE));
        if (wrong.isPresent()) {
            return new Item(Subject.POSITION, State.BAD, wrong.get());
        }
        GeoPoint at = boat.pose().get().position();
        long age = boat.poseAgeMillis(known.nowMillis()).orElse(0);
        return age <= LinkDefaults.LINK_LOST_AFTER_MS
                ? new Item(Subject.POSITION, State.GOOD, words(at))
                : new Item(Subject.POSITION, State.BAD, old(at, age));
    }

    /** A position in degrees. */
    static String words(GeoPoint at) {
        return String.format(Locale.ROOT, "%.6f, %.6f", at.latDeg(), at.lonDeg());
    }

    /** A position that was reported so many ms ago. */
    static String old(GeoPoint at, long ageMillis) {
        return words(at) + String.format(Locale.ROOT, " was %.0f s ago: wait for its satellites", ageMillis / 1000.0);
    }

    private static Item compass(BoatSnapshot boat, LaunchFacts known) {
        if (boat.pose().isEmpty()) {
            return new Item(Subject.COMPASS, State.UNKNOWN, "it has not said how it heads");
        }
        Optional<String> wrong = known.alarm(boat.boat(), Alarm.Kind.COMPASS_DOUBTFUL);
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
        Optional<String> unknown = UnknownCharge.why(boat);
        if (unknown.isPresent()) {
            return UnknownCharge.isCritical(boat)
                    ? new Item(Subject.BATTERY, State.BAD, "critical: put a full one in")
                    : new Item(Subject.BATTERY, State.DOUBTFUL, "of unknown charge: " + unknown.get());
        }
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
}
