package org.sami.crw.mavlink;

import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import org.sami.boat.link.LostLinkAction;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * What an autopilot does when its ground station is lost: read from its parameters, and set in them. For the gateway's thread.
 *
 * <p>Source: ArduPilot's parameters {@code FS_GCS_ENABLE} (0 off, 1 on, 2 on but not in AUTO) and {@code FS_ACTION} (0 nothing, 1 RTL, 2 hold, 3 and 4 smart
 * RTL: back along the way that it came, 3 straight home where it does not know that, 5 end, 6 keep the place or hold). Copters have {@code FS_GCS_ENABLE} alone (0 off,
 * 1 RTL, 3 and 4 smart RTL, 5 land, 6 land or RTL, 7 brake or land), and with bit 1 of {@code FS_OPTIONS} they go on in AUTO whatever that says. {@code FS_GCS_TIMEOUT} is after how many seconds; the ground station is the one of the system id
 * {@code MAV_GCS_SYSID}, in earlier firmware {@code SYSID_MYGCS}. A vehicle that holds rally points ({@code RALLY_TOTAL}) returns to the nearest of them and of its
 * home, but where it goes back the way that it came.
 */
final class VehicleFailsafe {
    private static final String ENABLE = "FS_GCS_ENABLE";
    private static final String ACTION = "FS_ACTION";
    private static final String OPTIONS = "FS_OPTIONS"; // of copters; boats have other bits there
    private static final String TIMEOUT = "FS_GCS_TIMEOUT";
    private static final String STATION = "MAV_GCS_SYSID";
    private static final String EARLIER_STATION = "SYSID_MYGCS";
    private static final String RALLY_POINTS = "RALLY_TOTAL";
    private static final int THIS_BASE = 255;
    private static final int OFF = 0;
    private static final int NOT_IN_AUTO = 2; // of FS_GCS_ENABLE of a boat
    private static final int RETURNS = 1;
    private static final int HOLDS = 2;
    private static final int SMART_RETURN = 3;
    private static final int SMART_RETURN_OR_HOLD = 4;
    private static final int KEEPS_PLACE = 6;
    private static final int COPTER_LANDS = 5;
    private static final int COPTER_BRAKES = 7;
    private static final int COPTER_GOES_ON_IN_AUTO = 2; // of FS_OPTIONS

    private final MavlinkBase base;
    private final VehicleId id;
    private final boolean flies;
    private final Executor thread;
    private final Runnable changed;
    private final Consumer<String> alarm;
    private final WatchedParameters watched;
    private Optional<Integer> enable = Optional.empty();
    private Optional<Integer> action = Optional.empty(); // of boats
    private Optional<Integer> options = Optional.empty(); // of copters, in firmware that has them
    private Optional<Double> timeoutS = Optional.empty();
    private Optional<Integer> station = Optional.empty();
    private String stationName = STATION;
    private int rallyPoints;

    /**
     * Nothing is read yet.
     *
     * @param changed called when what it does without a link is known, or is another
     * @param alarm receives what others have changed, in words for the operator
     */
    VehicleFailsafe(
            MavlinkBase base, VehicleId id, boolean flies, Executor thread, Runnable changed, Consumer<String> alarm) {
        this.base = base;
        this.id = id;
        this.flies = flies;
        this.thread = thread;
        this.changed = changed;
        this.alarm = alarm;
        watched = new WatchedParameters(base, id, thread, this::changedByOthers);
    }

    /** Reads all of it. */
    void read() {
        watched.forget();
        readAction(why -> {});
        read(TIMEOUT, seconds -> timeoutS = Optional.of(seconds), () -> {});
        read(RALLY_POINTS, number -> rallyPoints = whole(number), () -> {});
        read(
                STATION,
                number -> heeds(STATION, number),
                () -> read(EARLIER_STATION, number -> heeds(EARLIER_STATION, number), () -> {}));
    }

    /** A base has come: what it was read to do may be another since. */
    void askSoon() {
        watched.askSoon();
    }

    /** The vehicle has said what a parameter is, to whomever. */
    void reported(String name, double value) {
        watched.reported(name, value);
    }

    void tick(long atMs, boolean isCommanded) {
        watched.tick(atMs, isCommanded);
    }

    private void changedByOthers(String name, double value, String words) {
        alarm.accept("what vehicle " + id + " does when its link is lost was changed by somebody else: " + words);
        switch (name) {
            case ENABLE -> {
                watched.pause();
                readAction(why -> watched.resume());
            }
            case ACTION -> action = Optional.of(whole(value));
            case OPTIONS -> options = Optional.of(whole(value));
            case TIMEOUT -> timeoutS = Optional.of(value);
            case RALLY_POINTS -> rallyPoints = whole(value);
            default -> heeds(name, value);
        }
        changed.run();
    }

    private void heeds(String name, double number) {
        stationName = name;
        station = Optional.of(whole(number));
    }

    private void read(String name, DoubleConsumer value, Runnable missing) {
        Results.when(
                base.parameter(id, name),
                thread,
                read -> {
                    watched.holds(name, read);
                    value.accept(read);
                    changed.run();
                },
                why -> missing.run());
    }

    /** Reads what it does; {@code ended} receives why it could not be read, or nothing. */
    private void readAction(Consumer<Optional<String>> ended) {
        Results.when(
                base.parameter(id, ENABLE),
                thread,
                failsafe -> {
                    watched.holds(ENABLE, failsafe);
                    if (whole(failsafe) == OFF) {
                        judged(failsafe, ended, Optional.empty());
                    } else if (flies) {
                        readOptions(failsafe, ended);
                    } else {
                        readAction(failsafe, ended);
                    }
                },
                why -> ended.accept(Optional.of(why)));
    }

    private void readAction(double failsafe, Consumer<Optional<String>> ended) {
        Results.when(
                base.parameter(id, ACTION),
                thread,
                number -> {
                    watched.holds(ACTION, number);
                    action = Optional.of(whole(number));
                    judged(failsafe, ended, Optional.empty());
                },
                why -> ended.accept(Optional.of(why)));
    }

    private void readOptions(double failsafe, Consumer<Optional<String>> ended) {
        Results.when(
                base.parameter(id, OPTIONS),
                thread,
                number -> {
                    watched.holds(OPTIONS, number);
                    options = Optional.of(whole(number));
                    judged(failsafe, ended, Optional.empty());
                },
                why -> judged(failsafe, ended, options.map(known -> why))); // earlier firmware has no such parameter
    }

    /** All is read that tells what it does, or why not. */
    private void judged(double failsafe, Consumer<Optional<String>> ended, Optional<String> why) {
        enable = Optional.of(whole(failsafe));
        changed.run();
        ended.accept(why);
    }

    private static int whole(double number) {
        return (int) Math.round(number);
    }

    /** What it does when its ground station is lost, on a mission; empty where it has not said it. */
    Optional<LostLinkAction> lostLink() {
        return heedsAnother() ? Optional.of(LostLinkAction.CONTINUE) : set();
    }

    /** The same, once it heeds this base. */
    private Optional<LostLinkAction> set() {
        return enable.map(number -> flies ? ofCopter(number) : ofBoat(number));
    }

    private boolean heedsAnother() {
        return station.filter(number -> number != THIS_BASE).isPresent();
    }

    private LostLinkAction ofBoat(int failsafe) {
        if (failsafe == OFF || failsafe == NOT_IN_AUTO) {
            return LostLinkAction.CONTINUE;
        }
        return switch (action.orElse(HOLDS)) {
            case RETURNS, SMART_RETURN, SMART_RETURN_OR_HOLD -> LostLinkAction.RETURN;
            case KEEPS_PLACE -> LostLinkAction.HOLD;
            case OFF -> LostLinkAction.CONTINUE;
            default -> LostLinkAction.DRIFT; // in its mode HOLD the motors are off
        };
    }

    private LostLinkAction ofCopter(int failsafe) {
        return isGoingOnInAuto() ? LostLinkAction.CONTINUE : ofEnabled(failsafe);
    }

    private static LostLinkAction ofEnabled(int failsafe) {
        return switch (failsafe) {
            case OFF -> LostLinkAction.CONTINUE;
            case COPTER_BRAKES -> LostLinkAction.HOLD;
            case COPTER_LANDS -> LostLinkAction.DRIFT; // nothing keeps its place any longer
            default -> LostLinkAction.RETURN;
        };
    }

    private boolean isGoingOnInAuto() {
        return options.filter(bits -> (bits & COPTER_GOES_ON_IN_AUTO) != 0).isPresent();
    }

    /** The parameters by which it does that: {@code FS_GCS_ENABLE 1, FS_ACTION 3, after 5 s}. */
    String words() {
        if (enable.isEmpty()) {
            return ENABLE + " is not read yet";
        }
        String does = ENABLE + " " + enable.get()
                + (enable.get() == OFF
                        ? ""
                        : action.map(number -> ", " + ACTION + " " + number)
                                .or(() -> options.filter(bits -> isGoingOnInAuto())
                                        .map(bits -> ", " + OPTIONS + " " + bits))
                                .orElse(""));
        String after = enable.get() == OFF
                ? ""
                : timeoutS.map(seconds -> String.format(Locale.ROOT, ", after %.0f s", seconds))
                        .orElse("");
        return does + after + rally() + (heedsAnother() ? ", " + anotherWords() : "");
    }

    /** Empty where it does not return, or holds no rally points. */
    private String rally() {
        if (rallyPoints == 0 || set().filter(LostLinkAction.RETURN::equals).isEmpty()) {
            return "";
        }
        return ", to the nearest of its home and "
                + (rallyPoints == 1 ? "its rally point" : "its " + rallyPoints + " rally points")
                + (isSmart() ? " where it does not go back the way that it came" : "");
    }

    private boolean isSmart() {
        int number = flies ? enable.orElse(OFF) : action.orElse(OFF);
        return number == SMART_RETURN || number == SMART_RETURN_OR_HOLD;
    }

    private String anotherWords() {
        return stationName + " " + station.orElseThrow() + " is another ground station than this base, " + THIS_BASE;
    }

    /** Sets what it does when its ground station is lost; {@code ended} receives why it could not be set, or nothing where it was read back. */
    void set(LostLinkAction wanted, Consumer<Optional<String>> told) {
        if (heedsAnother() && wanted != LostLinkAction.CONTINUE) {
            told.accept(Optional.of("vehicle " + id + " does not heed this base: " + anotherWords()));
            return;
        }
        watched.pause();
        Consumer<Optional<String>> ended = why -> {
            if (why.isPresent()) { // a part of it may be set
                readAction(unread -> watched.resume());
            } else {
                watched.resume();
            }
            told.accept(why);
        };
        if (wanted == LostLinkAction.CONTINUE) {
            set(ENABLE, OFF, () -> readBack(wanted, ended), ended);
        } else if (flies) {
            leaveAuto(() -> set(ENABLE, ofCopter(wanted), () -> readBack(wanted, ended), ended), ended);
        } else {
            int number = switch (wanted) {
                case RETURN -> SMART_RETURN; // along the way that it came, so around what it drove around
                case HOLD -> KEEPS_PLACE;
                default -> HOLDS;
            };
            set(ACTION, number, () -> set(ENABLE, 1, () -> readBack(wanted, ended), ended), ended);
        }
    }

    private static int ofCopter(LostLinkAction wanted) {
        return switch (wanted) {
            case CONTINUE -> OFF;
            case RETURN -> RETURNS;
            case HOLD -> COPTER_BRAKES;
            case DRIFT -> COPTER_LANDS;
        };
    }

    /** Clears the bit by which a copter would go on in AUTO, and no other. */
    private void leaveAuto(Runnable then, Consumer<Optional<String>> ended) {
        Results.when(
                base.parameter(id, OPTIONS),
                thread,
                number -> {
                    int bits = whole(number);
                    if ((bits & COPTER_GOES_ON_IN_AUTO) == 0) {
                        then.run();
                    } else {
                        set(OPTIONS, bits & ~COPTER_GOES_ON_IN_AUTO, then, ended);
                    }
                },
                why -> {
                    if (options.isPresent()) {
                        ended.accept(Optional.of(why));
                    } else {
                        then.run();
                    }
                });
    }

    private void set(String name, int value, Runnable then, Consumer<Optional<String>> ended) {
        Results.when(
                base.setParameter(id, name, value), thread, held -> then.run(), why -> ended.accept(Optional.of(why)));
    }

    private void readBack(LostLinkAction wanted, Consumer<Optional<String>> ended) {
        readAction(why -> ended.accept(
                why.isPresent() || set().filter(wanted::equals).isPresent()
                        ? why
                        : Optional.of("vehicle " + id + " accepts, but has " + words())));
    }
}
