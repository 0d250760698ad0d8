package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.CommandMemory;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;

/**
 * The commands that activations have sent to boats, and the answers to the plan: progress, and one result for each (path completed or path failed). A
 * lost link is no failure: the command waits. A command whose id the boat already has is not sent twice. For the fleet's thread.
 */
public final class MotionCommands implements Consumer<FleetEvent> {
    public static final String UNKNOWN_BOAT = "no boat of that name is known";

    private static final String REPLACED = "a newer command of the same mission took its place";
    private static final String PREEMPTED = "a command of higher priority took the boat";

    private final ProxyRegistry boats;
    private final MessageSink messages;
    private final WayQuestions questions;
    private final ClearWays clearWays;
    private final Map<String, SentCommand> sent = new LinkedHashMap<>();
    private final Map<String, List<SentCommand>> again = new LinkedHashMap<>(); // by command, who had it sent once more
    private final Map<Long, Map<String, Optional<String>>> takenBack =
            new HashMap<>(); // by activation and boat: why, where the plan is told
    private final LeftPaths left;
    private final MovesAwaitingPosition awaitingPosition;
    private final UnaskedMoves unasked;
    private final HeldMoves held;
    private final ChargeReturns chargeReturns;

    public MotionCommands(ProxyRegistry boats, MessageSink messages, WayQuestions questions, ClearWays clearWays) {
        this.clearWays = clearWays;
        this.boats = boats;
        this.questions = questions;
        this.messages = messages;
        left = new LeftPaths(boats);
        awaitingPosition = new MovesAwaitingPosition(boats);
        unasked = new UnaskedMoves(clearWays, questions, clearWays.errors());
        held = new HeldMoves(questions, awaitingPosition);
        chargeReturns = new ChargeReturns(boats, clearWays, messages);
    }

    /** Whether a command failed because another one took its place, by the reason that the plan received: the boat might have done it. */
    public static boolean isDisplaced(String reason) {
        return reason.equals(REPLACED) || reason.equals(PREEMPTED);
    }

    /** What boats have left of their paths. */
    LeftPaths leftPaths() {
        return left;
    }

    /**
     * Gives commands to boats. A boat that has not said where it is gets its command once it has; those that are sent where something is wrong wait
     * for the operator's answer.
     */
    public void send(Activation activation, HandlerContext context, List<Move> moves) {
        List<Move> wanted = wanted(activation, context, moves);
        wanted.forEach(move -> replaceHeld(activation, move));
        List<Move> unknown = context.redelivered() ? goOn(activation, context, wanted) : wanted;
        check(activation, context, awaitingPosition.hold(activation, context, unknown));
    }

    /** The moves but for those that were taken back in advance. */
    private List<Move> wanted(Activation activation, HandlerContext context, List<Move> moves) {
        Map<String, Optional<String>> without =
                Optional.ofNullable(takenBack.remove(activation.id())).orElse(Map.of());
        List<Move> wanted = new ArrayList<>();
        for (Move move : moves) {
            Optional<String> why = without.getOrDefault(move.addressee().boat(), Optional.empty());
            if (without.containsKey(move.addressee().boat())) {
                takeBack(activation, context, move, why);
            } else {
                wanted.add(move);
            }
        }
        return wanted;
    }

    /**
     * Goes on with what is known of moves that are delivered again. After a restart, what is over is not sent again, and what was sent, of which the boat may be
     * on its way, goes on without another check. What the operator refused is refused. Nothing becomes of what the boat has, or is kept back. Returns the others.
     */
    private List<Move> goOn(Activation activation, HandlerContext context, List<Move> moves) {
        WayAnswers answers = new WayAnswers(activation, context);
        List<Move> sentBefore = new ArrayList<>();
        List<Move> unknown = new ArrayList<>();
        for (Move move : moves.stream().filter(move -> !isPresent(move)).toList()) {
            Optional<CommandMemory> known = move.remembered(activation, context);
            List<Input> ordered =
                    CommandMemory.ordered(activation, move.command().commandId(), context);
            if (!ordered.isEmpty()) {
                context.post(ordered);
            }
            boolean isWayKnown = move.wayFromHere().isEmpty(); // else it is another one than was checked
            if (isWayKnown
                    && !context.orderedAgain()
                    && known.filter(was -> was == CommandMemory.SENT).isPresent()) {
                sentBefore.add(move);
            } else if (!move.isOver(activation, context)) {
                answers.refusal(move)
                        .ifPresentOrElse(reason -> refuse(activation, context, move, reason), () -> unknown.add(move));
            }
        }
        if (!sentBefore.isEmpty()) {
            questions.goOn(sentBefore);
            sendNow(activation, context, clearWays.limit(activation, context, sentBefore));
        }
        return unknown;
    }

    private boolean isPresent(Move move) {
        return isPresent(move.command().commandId(), move.addressee().boat());
    }

    private boolean isPresent(String commandId, String boatId) {
        return held.has(commandId)
                || boats.find(boatId)
                        .flatMap(boat -> boat.commands().visitedCount(commandId))
                        .isPresent();
    }

    private void refuse(Activation activation, HandlerContext context, Move move, String reason) {
        SentCommand one = new SentCommand(activation, context, move);
        one.post(failed(one, reason));
    }

    /**
     * Gives a robot a command to a place that the program chooses and changes within seconds, as where it follows another robot. It keeps clear of what the plan
     * avoids and in what it is to stay in, and in the session's fence. The operator is not asked: where something is wrong, nothing is sent, and what the
     * robot had before stands.
     *
     * @return why it is not sent, a clause; empty where it is
     */
    public Optional<String> sendUnasked(Activation activation, HandlerContext context, Move move) {
        Optional<GeoPoint> from = boats.find(move.addressee().boat())
                .flatMap(boat -> boat.status().pose())
                .map(BoatPose::position);
        if (from.isEmpty()) {
            return Optional.of(move.addressee().boat() + " has not said where it is");
        }
        if (comesHome(move.addressee().boat())) {
            return Optional.of(move.addressee().boat() + " comes home, as its charge lasts for that alone");
        }
        UnaskedMoves.Judged judged = unasked.judge(activation, context, move, from.get());
        if (judged.refusal().isEmpty()) {
            replaceHeld(activation, move);
            submit(activation, context, List.of(judged.move()), false);
        }
        return judged.refusal();
    }

    private void check(Activation activation, HandlerContext context, List<Move> moves) {
        List<Move> limited = clearWays.limit(activation, context, moves);
        List<Move> clear = questions.hold(activation, context, limited, new MoveSender() {
            @Override
            public void send(Activation asked, HandlerContext answerTo, List<Move> allowed) {
                allowed.forEach(move -> chargeReturns.end(move.addressee().boat()));
                sendNow(asked, answerTo, allowed);
            }

            @Override
            public void sendHome(Activation asked, HandlerContext answerTo, String robot) {
                replaceOlder(asked, robot);
                chargeReturns.begin(asked, answerTo, robot);
            }

            @Override
            public void refuse(Activation asked, HandlerContext answerTo, Move move, String reason) {
                MotionCommands.this.refuse(asked, answerTo, move, reason);
            }
        });
        sendNow(activation, context, clear);
    }

    private void sendNow(Activation activation, HandlerContext context, List<Move> moves) {
        submit(activation, context, moves, true);
        SpeedChoice.words(activation)
                .filter(words -> !moves.isEmpty())
                .ifPresent(words -> tell(activation, context, words));
    }

    /**
     * What is settled at once is answered in one batch.
     *
     * @param remembered whether the mission remembers each command across restarts: not one that takes another's place within seconds
     */
    private void submit(Activation activation, HandlerContext context, List<Move> moves, boolean remembered) {
        List<Input> settled = new ArrayList<>();
        for (Move move : moves) {
            SentCommand one = remembered
                    ? new SentCommand(activation, context, move)
                    : new SentCommand(activation, context, move.addressee(), move.reply());
            Optional<BoatProxy> boat = boats.find(move.addressee().boat());
            if (move.wayFromHere().isEmpty()
                    && move.command() instanceof FollowPath path
                    && path.nothingIsLeft()
                    && !path.block()) {
                settled.addAll(one.completed());
            } else if (boat.isEmpty()) {
                settled.addAll(failed(one, UNKNOWN_BOAT));
            } else if (BoatMoves.refusal(activation.type(), boat.get()).isPresent()) {
                settled.addAll(failed(
                        one, BoatMoves.refusal(activation.type(), boat.get()).orElseThrow()));
            } else if (move.wayFromHere().isPresent()) {
                settled.addAll(failed(one, "its position is unknown"));
            } else {
                if (remembered) {
                    settled.addAll(move.remember(CommandMemory.SENT, activation, context));
                }
                sent.put(move.command().commandId(), one);
                chargeReturns.giveWay(boat.get().boatId());
                boat.get().commands().submit(SpeedChoice.of(activation, move.command(), boat.get()));
            }
        }
        if (!settled.isEmpty()) {
            context.post(settled);
        }
    }

    /**
     * Has boats be sent the waypoints of their present command once more, whichever mission's that is. The plan receives this
     * command too what becomes of it; a boat that has no waypoints now has nothing left of them. After a restart, what was sent again is not sent a third
     * time: the plan still hears what becomes of it.
     */
    void sendAgain(Activation activation, HandlerContext context, List<Addressee> addressees) {
        List<Input> settled = new ArrayList<>();
        for (Addressee addressee : addressees) {
            String id = Move.commandId(activation, addressee);
            if (!CommandMemory.isOver(activation, id, context)) {
                settled.addAll(CommandMemory.ordered(activation, id, context));
                settled.addAll(sendAgain(SentCommand.again(activation, context, addressee), id, context));
            }
        }
        if (!settled.isEmpty()) {
            context.post(settled);
        }
    }

    private List<Input> sendAgain(SentCommand one, String id, HandlerContext context) {
        Optional<BoatProxy> boat = boats.find(one.boat());
        if (boat.isEmpty()) {
            return failed(one, UNKNOWN_BOAT);
        }
        Optional<String> before = CommandMemory.sentAgain(one.mission(), id, context)
                .filter(commandId -> context.redelivered() && !context.orderedAgain())
                .filter(commandId -> isPresent(commandId, one.boat()));
        Optional<String> command =
                before.or(() -> boat.get().commands().sendPathAgain().map(BoatCommand::commandId));
        if (command.isEmpty()) {
            return one.completed();
        }
        again.computeIfAbsent(command.get(), unused -> new ArrayList<>()).add(one);
        return before.isPresent() ? List.of() : CommandMemory.sentAgain(one.mission(), id, command.get(), context);
    }

    /** A boat cannot do what it was asked: it is answered before it gets a command. */
    public void refuse(Activation activation, HandlerContext context, Addressee addressee, String reason) {
        refuse(activation, context, addressee, Reply.WAY, reason);
    }

    /** The same for a command with answers of its own. */
    public void refuse(Activation activation, HandlerContext context, Addressee addressee, Reply reply, String reason) {
        SentCommand one = new SentCommand(activation, context, addressee, reply);
        one.post(failed(one, reason));
    }

    /**
     * Takes back for boats what an activation is about to ask.
     *
     * @param why the failure that the plan receives in place of the command; empty where nobody is told, as where the step that asked went on to withdraw it
     */
    public void takeBack(long activation, List<String> named, Optional<String> why) {
        named.forEach(boat -> takeBack(activation).putIfAbsent(boat, why));
    }

    /**
     * Takes back a move that was not sent yet; it is not sent after a restart either.
     *
     * @param why the failure that the plan receives; empty where nobody is told
     */
    public void takeBack(Activation activation, HandlerContext context, Move move, Optional<String> why) {
        why.ifPresentOrElse(
                reason -> refuse(activation, context, move, reason),
                () -> end(new SentCommand(activation, context, move)));
    }

    private Map<String, Optional<String>> takeBack(long activation) {
        return takenBack.computeIfAbsent(activation, id -> new HashMap<>());
    }

    /** Whether what an activation is about to ask of a boat has been taken back in advance. */
    public boolean isTakenBack(long activation, String boat) {
        return takenBack.getOrDefault(activation, Map.of()).containsKey(boat);
    }

    /** A newer command of the same mission takes the place of one that was not sent yet: whoever still waits for it is answered. */
    public void replace(Activation activation, HandlerContext context, Addressee addressee, Reply reply) {
        SentCommand one = new SentCommand(activation, context, addressee, reply);
        if (one.isAwaited()) {
            one.post(failed(one, REPLACED));
        }
    }

    /**
     * What waits for a boat's position or for the operator, who would else send it after the newer one, is replaced as in the boat's queue: a critical command takes no
     * place of one that is not, nor the other way round.
     */
    private void replaceHeld(Activation activation, Move newer) {
        held.take(one -> one.mission() == activation.mission()
                        && one.boat().equals(newer.addressee().boat())
                        && one.activation().id() < activation.id()
                        && isCritical(one.move()) == isCritical(newer))
                .forEach(one -> {
                    SentCommand older = new SentCommand(one.activation(), one.context(), one.move());
                    if (older.isAwaitedByItsBoat()) {
                        older.post(failed(older, REPLACED));
                    } else {
                        end(older);
                    }
                });
    }

    /** What a robot has of the mission is replaced by the command home, as by a newer command of the mission. */
    private void replaceOlder(Activation activation, String robot) {
        boats.find(robot)
                .map(BoatProxy::commands)
                .ifPresent(commands -> Stream.concat(commands.current().stream(), commands.waiting().stream())
                        .filter(command -> command.mission() == activation.mission() && !isCritical(command))
                        .toList()
                        .forEach(command -> {
                            commands.withdraw(command.commandId());
                            onWithdrawn(command, Withdrawal.SUPERSEDED);
                        }));
    }

    private static boolean isCritical(Move move) {
        return isCritical(move.command());
    }

    private static boolean isCritical(BoatCommand command) {
        return command.priority() == Priority.CRITICAL;
    }

    /** An activation will ask nothing any more. */
    public void forget(long activation) {
        takenBack.remove(activation);
    }

    /** Takes back what a mission has for boats; no boats named = for all. */
    public void withdraw(long mission, List<String> named) {
        held.take(one -> one.mission() == mission && (named.isEmpty() || named.contains(one.boat())))
                .forEach(one -> end(new SentCommand(one.activation(), one.context(), one.move())));
        for (List<SentCommand> all : again.values()) {
            List<SentCommand> taken = all.stream()
                    .filter(one -> one.mission() == mission && (named.isEmpty() || named.contains(one.boat())))
                    .toList();
            all.removeAll(taken);
            taken.forEach(MotionCommands::end);
        }
        for (String boat : named.isEmpty() ? boats.boatIds() : named) {
            boats.find(boat)
                    .ifPresent(proxy -> proxy.commands().withdraw(mission).forEach(command -> {
                        SentCommand taken = sent.remove(command.commandId());
                        left.takenFrom(boat, command, visited(taken));
                        end(taken);
                        tellAgain(command, one -> failed(one, "the mission that wanted it took it back"));
                    }));
        }
    }

    /**
     * A boat is no longer responsible for a task, under any of its names: commands for that task alone are withdrawn, also those that are kept back, and commands
     * for other tasks too are answered without it.
     */
    public void release(String boat, List<TaskId> names) {
        held.release(boat, names).forEach(one -> end(new SentCommand(one.activation(), one.context(), one.move())));
        for (Map.Entry<String, SentCommand> one : List.copyOf(sent.entrySet())) {
            if (one.getValue().boat().equals(boat) && one.getValue().release(names)) {
                end(sent.remove(one.getKey()));
                boats.find(boat).ifPresent(proxy -> proxy.commands().withdraw(one.getKey()));
            }
        }
    }

    /** Withdraws a mission's commands from a boat at another mission's request; a transition that waits receives the failure. */
    void abort(long mission, String boat, String reason) {
        abortHeld(mission, boat, reason);
        boats.find(boat)
                .ifPresent(proxy -> proxy.commands().withdraw(mission).forEach(command -> {
                    left.takenFrom(boat, command, visited(sent.get(command.commandId())));
                    onFailed(command, reason);
                }));
    }

    /** The missions that have moves for a boat which are kept back: they wait for its position, or for the operator. */
    public Set<Long> held(String boat) {
        return held.missions(boat);
    }

    /** What a base that goes on needs to know of flights. */
    public List<AircraftMemory.Part> aircraftParts() {
        return List.of(chargeReturns, questions.accepted());
    }

    /** Whether the base itself brings a robot home, as its charge lasts for that alone, and it is not down yet. */
    public boolean comesHome(String robot) {
        return chargeReturns.has(robot);
    }

    /** Takes a mission's moves of a boat that are kept back; each is answered as failed. */
    void abortHeld(long mission, String boat, String reason) {
        held.take(one -> one.mission() == mission && one.boat().equals(boat))
                .forEach(one -> refuse(one.activation(), one.context(), one.move(), reason));
    }

    /** What was taken from a boat is not sent again after a restart. */
    private static void end(@Nullable SentCommand taken) {
        if (taken != null) {
            taken.post(taken.ended());
        }
    }

    private static int visited(@Nullable SentCommand command) {
        return command == null ? 0 : command.visited();
    }

    @Override
    public void accept(FleetEvent event) {
        chargeReturns.accept(event); // before it is sent home anew
        questions.accept(event);
        awaitingPosition.released(event).forEach(this::checkAlone);
        if (event instanceof FleetEvent.Progressed progressed) {
            onProgress(progressed.command(), progressed.visited());
        } else if (event instanceof FleetEvent.PanoramaTaken panorama) {
            onPanorama(panorama.command(), panorama.pictures(), panorama.from());
        } else if (event instanceof FleetEvent.CommandCompleted done) {
            onCompleted(done.command());
        } else if (event instanceof FleetEvent.CommandFailed failed) {
            onFailed(failed.command(), failed.reason());
        } else if (event instanceof FleetEvent.CommandWithdrawn withdrawn) {
            onWithdrawn(withdrawn.command(), withdrawn.why());
        }
    }

    /** What goes wrong with a move that waited concerns its activation, and nothing that waited beside it. */
    private void checkAlone(HeldMove one) {
        try {
            check(one.activation(), one.context(), List.of(one.move()));
        } catch (RuntimeException fault) {
            one.context().post(new Input.HandlerFailed(one.activation().id(), String.valueOf(fault.getMessage())));
        }
    }

    private void onProgress(BoatCommand command, int visitedCount) {
        SentCommand one = sent.get(command.commandId());
        if (one != null) {
            one.post(one.progress(visitedCount));
        }
    }

    private void onPanorama(BoatCommand command, int pictures, GeoPoint from) {
        SentCommand one = sent.get(command.commandId());
        if (one != null) {
            one.post(one.pictures(Map.of("location", from, "pictures", new IntegerValue(pictures))));
        }
    }

    private void onCompleted(BoatCommand command) {
        SentCommand one = sent.remove(command.commandId());
        if (one != null) {
            left.finished(one.boat());
            one.post(one.completed());
        }
        tellAgain(command, SentCommand::completed);
    }

    private void onFailed(BoatCommand command, String reason) {
        SentCommand one = sent.remove(command.commandId());
        if (one != null) {
            one.post(failed(one, reason));
        }
        tellAgain(command, each -> failed(each, reason));
    }

    /** A command that was displaced fails for whoever still waits for it. */
    private void onWithdrawn(BoatCommand command, Withdrawal why) {
        SentCommand one = sent.remove(command.commandId());
        String reason = why == Withdrawal.PREEMPTED ? PREEMPTED : REPLACED;
        if (one != null && (why == Withdrawal.PREEMPTED || one.isAwaitedByItsBoat())) {
            one.post(failed(one, reason));
        } else {
            end(one);
        }
        tellAgain(command, each -> failed(each, reason));
    }

    /** Tells those who had a command sent once more, and still wait, what has become of it. */
    private void tellAgain(BoatCommand command, Function<SentCommand, List<Input>> news) {
        List<SentCommand> all = again.remove(command.commandId());
        if (all != null) {
            all.stream().filter(SentCommand::isAwaited).forEach(one -> one.post(news.apply(one)));
        }
    }

    private void tell(Activation activation, HandlerContext context, String words) {
        messages.tell(ActivationMessages.of(activation, context, Priority.LOW, words, activation.proxies()));
    }

    private List<Input> failed(SentCommand one, String reason) {
        messages.tell(one.failure(reason));
        return one.failed(reason);
    }
}
