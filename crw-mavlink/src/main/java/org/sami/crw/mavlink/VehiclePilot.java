package org.sami.crw.mavlink;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.CommandVerdict;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Carries out an order in steps, each after the vehicle has reported the result of the one before. A later order cancels an earlier one. Remembers the state
 * that was ordered, and so notices when somebody else changes it. For the gateway's thread.
 */
final class VehiclePilot {
    private static final String STARTS = "INITIALIZING"; // the mode of ArduPilot's boats until they have started
    private static final long CLOCK_WITHIN_MS = 3_000;
    private static final long SEEN_WITHIN_MS = 4_000; // heartbeats, which tell mode and arming, come once a second
    private static final long LATE_MS =
            7_000; // what an order that has failed asked for may still happen: five tries, then a heartbeat

    /**
     * A state of the vehicle that it was ordered into: its mode, and whether its motors may turn.
     *
     * @param lands whether the order ends with a landing, after which it turns its motors off by itself
     */
    record Ordered(String mode, boolean armed, boolean lands) {
        Ordered(String mode, boolean armed) {
            this(mode, armed, false);
        }

        boolean isSo(VehicleSnapshot vehicle) {
            return vehicle.mode().equals(mode) && (vehicle.armed() == armed || (lands && !vehicle.armed()));
        }
    }

    private final MavlinkBase base;
    private final VehicleId id;
    private final Executor thread;
    private VehicleSnapshot now;
    private long nowMs;
    private Optional<Order> running = Optional.empty();
    private boolean disarms; // by an order that failed: it may be off, or soon, whatever it reports
    private boolean disarmAccepted;
    private Optional<Ordered> ordered = Optional.empty(); // reported by the vehicle since
    private Optional<Order> failed = Optional.empty(); // the last one that failed or was given up
    private long failedMs;
    private boolean isStarted; // by somebody else, while nothing is ordered
    private boolean stopFailed; // since the last report
    private Optional<Long> startsMs =
            Optional.empty(); // since when it may have started again, before its clock says it
    private boolean isJudged; // its clock has told that it has not

    VehiclePilot(MavlinkBase base, VehicleSnapshot first, Executor thread) {
        this.base = base;
        this.id = first.id();
        this.thread = thread;
        now = first;
    }

    /** Steps of one order, and who waits for its end. */
    final class Order {
        private final Set<String> modes = new HashSet<>(); // in which it was or was commanded to be by this order
        private final Set<String> expected = new HashSet<>(); // modes into which nobody else need have put it
        private boolean wasArmed; // seen since the order began, and no order turns its motors off
        private boolean arms; // it has accepted that
        private boolean insists;
        private Consumer<Optional<String>> ended; // empty where all is done, or why it is not
        private Predicate<VehicleSnapshot> awaited = vehicle -> true;
        private Runnable then = () -> {};
        private Consumer<String> late = why -> {};
        private String words = "";
        private long untilMs = Long.MAX_VALUE;
        private boolean waits;
        private boolean mayHaveArmed;
        private final Optional<Ordered> otherwise; // in force again where it fails

        private Order(Consumer<Optional<String>> ended, Optional<Ordered> otherwise) {
            this.ended = ended;
            this.otherwise = otherwise;
        }

        /** Tells one more of its end. */
        void tellAlso(Consumer<Optional<String>> other) {
            ended = ended.andThen(other);
        }

        /** It is carried out whatever others do with the vehicle meanwhile: a stop, or the end of an order that failed. */
        void insist() {
            insists = true;
        }

        /** A mode into which this order may put it. */
        void expect(String mode) {
            expected.add(mode);
        }

        private void saw() {
            wasArmed |= arms && now.armed();
        }

        /** Whether somebody else has changed its mode, or turned a boat's motors off, since the order began. A copter does the latter by itself as it has landed. */
        private boolean isTaken() {
            boolean isOff = wasArmed && !now.armed() && now.kind() != VehicleKind.COPTER;
            return !insists && (isOff || !expected.contains(now.mode()));
        }

        /** Whether a later order has come, or none holds any longer. */
        boolean isVoid() {
            return running.isEmpty() || running.get() != this;
        }

        /** Goes on with the next step once the vehicle accepts. */
        void command(CompletableFuture<CommandOutcome> asked, Runnable next) {
            Results.when(asked, thread, outcome -> took(outcome, next), this::fail);
        }

        /** The same, with another step where it refuses or does not answer. */
        void command(CompletableFuture<CommandOutcome> asked, Runnable next, Consumer<CommandOutcome> refused) {
            Results.when(
                    asked,
                    thread,
                    outcome -> {
                        if (!isVoid()) {
                            if (outcome.isAccepted()) {
                                next.run();
                            } else {
                                refused.accept(outcome);
                            }
                        }
                    },
                    this::fail);
        }

        /** Goes on once the vehicle accepts; asked again for as long as it does not answer and no later order has come. */
        void commandUntilAnswered(Supplier<CompletableFuture<CommandOutcome>> ask, Runnable next) {
            untilAnswered(ask, outcome -> took(outcome, next));
        }

        /** The same, with another step where it refuses. */
        void commandUntilAnswered(Supplier<CompletableFuture<CommandOutcome>> ask, Runnable next, Runnable refused) {
            untilAnswered(ask, outcome -> (outcome.isAccepted() ? next : refused).run());
        }

        private void untilAnswered(Supplier<CompletableFuture<CommandOutcome>> ask, Consumer<CommandOutcome> answered) {
            Results.when(
                    ask.get(),
                    thread,
                    outcome -> {
                        if (isVoid()) {
                            return;
                        }
                        if (outcome.verdict() == CommandVerdict.UNANSWERED) {
                            untilAnswered(ask, answered);
                        } else {
                            answered.accept(outcome);
                        }
                    },
                    this::fail);
        }

        private void took(CommandOutcome outcome, Runnable next) {
            if (!outcome.isAccepted()) {
                fail(outcome.inWords());
            } else if (!isVoid()) {
                next.run();
            }
        }

        /** Goes on once it is seen in what the vehicle reports. */
        void await(Predicate<VehicleSnapshot> seen, String what, Runnable next) {
            await(seen, what, next, this::fail);
        }

        private void await(Predicate<VehicleSnapshot> seen, String what, Runnable next, Consumer<String> otherwise) {
            await(seen, what, SEEN_WITHIN_MS, next, otherwise);
        }

        /** Goes on once it is seen in what the vehicle reports, or otherwise where it is not within a time, with the reason in words. */
        void await(
                Predicate<VehicleSnapshot> seen,
                String what,
                long withinMs,
                Runnable next,
                Consumer<String> otherwise) {
            awaited = seen;
            words = what;
            then = next;
            late = otherwise;
            untilMs = nowMs + withinMs;
            waits = true;
            look();
        }

        private void look() {
            if (!waits) {
                return;
            }
            if (awaited.test(now)) {
                waits = false;
                then.run();
            } else if (nowMs > untilMs) {
                waits = false;
                late.accept("vehicle " + id + " accepts, but does not " + words + ": it is in mode " + now.mode()
                        + arming(now.armed()));
            }
        }

        /**
         * It ends, for a reason in words, once motors that it has armed are off again; an order that is void has ended already. A vehicle that somebody else, or its failsafe, has put into a mode of
         * theirs meanwhile is not disarmed.
         */
        void fail(String why) {
            if (isVoid()) {
                return;
            }
            waits = false;
            if (mayHaveArmed && modes.contains(now.mode())) {
                mayHaveArmed = false;
                disarm(why);
            } else {
                end(why);
            }
        }

        /** It ends, for a reason in words, with its motors as they are; an order that is void has ended already. */
        void failAsItIs(String why) {
            if (!isVoid()) {
                waits = false;
                end(why);
            }
        }

        private void disarm(String why) {
            insist();
            disarms = true;
            disarmAccepted = false;
            Results.when(
                    base.command(id, VehicleCommand.disarm()),
                    thread,
                    outcome -> disarmed(outcome, why),
                    unheard -> end(why));
        }

        private void disarmed(CommandOutcome outcome, String why) {
            if (outcome.verdict() == CommandVerdict.REPLACED) {
                return; // by a later order, which has voided this one
            }
            if (outcome.isAccepted()) {
                disarmAccepted = true;
                if (!isVoid()) {
                    await(
                            vehicle -> !vehicle.armed(),
                            "turn its motors off",
                            () -> end(why),
                            words -> end(why + "; " + words));
                }
            } else {
                disarms = outcome.verdict() == CommandVerdict.UNANSWERED;
                end(why + "; it stays armed: " + outcome.inWords());
            }
        }

        private void end(String why) {
            if (isVoid()) {
                return;
            }
            giveUp();
            stopFailed = insists;
            ordered = otherwise;
            ended.accept(Optional.of(why));
        }

        /** All is done, and the vehicle is in this state; an order that is void has ended already. */
        void done(Ordered state) {
            if (isVoid()) {
                return;
            }
            running = Optional.empty();
            ordered = Optional.of(state);
            ended.accept(Optional.empty());
        }

        /** Lets the motors turn, unless they may already. Where the order fails later, they are turned off again. */
        void arm(Runnable next) {
            if (now.armed() && !disarms) {
                next.run();
            } else if (startsMs.isPresent()) {
                await(vehicle -> startsMs.isEmpty(), "finish its start", () -> arm(next));
            } else {
                disarms = false; // this command takes the place of the one that disarms
                modes.add(now.mode());
                Results.when(
                        base.command(id, VehicleCommand.arm()),
                        thread,
                        outcome -> {
                            arms = outcome.isAccepted();
                            mayHaveArmed = arms || outcome.verdict() == CommandVerdict.UNANSWERED;
                            took(outcome, next);
                        },
                        this::fail);
            }
        }

        /** Changes the mode and waits until the vehicle says that it is in it, with its motors as they should be. */
        void mode(String mode, boolean armed, Runnable next) {
            modes.add(mode);
            expect(mode);
            if (new Ordered(mode, armed).isSo(now)) {
                next.run();
            } else {
                modeAnew(mode, armed, next);
            }
        }

        /** The same, also where it was last seen in it: that may be older than an order. */
        void modeAnew(String mode, boolean armed, Runnable next) {
            Ordered state = new Ordered(mode, armed);
            modes.add(mode);
            expect(mode);
            command(base.setMode(id, mode), () -> await(state::isSo, "come into mode " + mode + arming(armed), next));
        }
    }

    private static String arming(boolean armed) {
        return armed ? ", armed" : ", disarmed";
    }

    /** Begins an order. One that runs is cancelled and ends with {@link #VOID}. */
    Order begin(Consumer<Optional<String>> ended) {
        return begin(new Order(ended, Optional.empty()));
    }

    /** Begins an order that changes how the one before is carried out. Where it fails, the state before is the ordered one again. */
    Order change(Consumer<Optional<String>> ended) {
        return begin(new Order(ended, ordered));
    }

    private Order begin(Order order) {
        Optional<Order> before = running;
        Optional<Order> mayGoOn = before.or(this::late);
        order.expect(now.mode());
        mayGoOn.ifPresent(earlier -> order.expected.addAll(earlier.expected));
        order.wasArmed = now.armed()
                && !disarms
                && mayGoOn.filter(earlier -> earlier.insists).isEmpty();
        running = Optional.of(order);
        ordered = Optional.empty();
        before.ifPresent(voided -> voided.ended.accept(Optional.of(VOID)));
        return order;
    }

    /** The last order that failed, while what it asked for may still happen. */
    private Optional<Order> late() {
        return failed.filter(order -> nowMs - failedMs < LATE_MS);
    }

    /** Why an order has ended that a later one made void. */
    static final String VOID = "a later command came";

    /** Why an order has ended whose vehicle somebody else has put into another state than it asked for. */
    static final String TAKEN = "somebody else, or its own failsafe, has taken the vehicle";

    /** Whether an order is being carried out. */
    boolean isBusy() {
        return running.isPresent();
    }

    /** What the vehicle was ordered into and is seen to have come into; empty while nothing holds. */
    Optional<Ordered> ordered() {
        return ordered;
    }

    /** Ends the running order as void, without telling who waits for it; the ordered state stays. */
    void giveUp() {
        if (running.isPresent()) {
            failed = running;
            failedMs = nowMs;
        }
        running = Optional.empty();
    }

    /** Forgets the running order and the ordered state. */
    void release() {
        startsMs = Optional.empty();
        isJudged = false;
        running = Optional.empty();
        ordered = Optional.empty();
        failed = Optional.empty();
    }

    VehicleSnapshot vehicle() {
        return now;
    }

    /** Whether it has landed at the end of its order. */
    private boolean hasLanded() {
        return ordered.filter(Ordered::lands).isPresent() && !now.armed();
    }

    /**
     * This is how the vehicle reports itself. Whether somebody else has put it into another state than was ordered, or than the running order has asked for: that ends as
     * {@link #TAKEN}, with nothing more sent.
     */
    boolean reported(VehicleSnapshot vehicle, long atMs) {
        VehicleSnapshot before = now;
        now = vehicle;
        nowMs = atMs;
        disarms &= vehicle.armed() || !disarmAccepted;
        running.ifPresent(Order::saw);
        judgeStart();
        boolean taken = isOther() && (vehicle.armed() || startsMs.isEmpty());
        running.ifPresent(taken ? order -> order.failAsItIs(TAKEN) : Order::look);
        if (hasLanded()) { // whoever starts its motors again is somebody else
            ordered = ordered.map(state -> new Ordered(state.mode(), false));
        }
        isStarted = isStart(before);
        stopFailed = false;
        return taken;
    }

    /**
     * Whether somebody else has just armed it, or changed its mode while it is armed, though nothing is ordered; or has it as a stop has failed. In HOLD a boat lies still and waits
     * for orders. One that its autopilot arms as it starts is nobody's.
     */
    boolean isStartedByOthers() {
        return isStarted;
    }

    private boolean isStart(VehicleSnapshot before) {
        boolean isChange = !before.mode().equals(STARTS)
                && !(before.armed() && before.mode().equals(now.mode()));
        boolean isNews = stopFailed || isChange;
        boolean isOurs = isBusy()
                || ordered.isPresent()
                || disarms
                || late().filter(order -> isBy(order)).isPresent();
        return now.armed() && isNews && !isOurs && !now.mode().equals(VehicleMotion.HOLD);
    }

    /** Whether the present mode may come from an order that has failed. */
    private boolean isBy(Order late) {
        return (late.insists ? late.modes : late.expected).contains(now.mode());
    }

    private boolean isOther() {
        return ordered.filter(state -> !state.isSo(now)).isPresent()
                || running.filter(Order::isTaken).isPresent();
    }

    /**
     * An autopilot that has started again is disarmed, and may say that before its clock does, which comes with its position. Until then nobody has taken it, and
     * nothing arms it: its operator has not allowed it yet.
     */
    private void judgeStart() {
        if (now.mode().equals(STARTS)) {
            startsMs = Optional.of(nowMs);
        } else if (startsMs.isPresent()) {
            long sinceMs = startsMs.get();
            boolean hasClock =
                    now.position().filter(at -> at.heardMs() > sinceMs).isPresent();
            isJudged = hasClock || now.armed() || nowMs - sinceMs >= CLOCK_WITHIN_MS;
            startsMs = startsMs.filter(since -> !isJudged);
        } else if (isOther() && !now.armed() && !isJudged) {
            startsMs = Optional.of(nowMs);
        }
        isJudged &= isOther();
    }
}
