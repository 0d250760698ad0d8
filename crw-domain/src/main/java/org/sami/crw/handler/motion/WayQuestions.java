package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.PlannedSwaps;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.reach.Way;
import org.sami.crw.service.reach.WayBack;
import org.sami.crw.service.reach.WayCheck;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

/**
 * Asks the operator before boats are sent where something is wrong ({@link WayCheck}): one question for each activation and kind of
 * doubt. Boats whose way is doubted wait for the answer, the others go. The answer is kept in the mission's memory, so that a base
 * that goes on does not ask again. An aircraft waits in the air no longer than its charge lasts for the way home: then the answer is no, and it comes home. For the
 * fleet's thread; it passes the engine's steps on to it.
 */
public final class WayQuestions implements HostListener {
    /** Begins the reason of a command that failed because the operator did not want it. */
    public static final String REJECTED_WAY = "the operator does not want it";

    private static final String UNANSWERED = "nobody has answered in time, and it comes home while its charge lasts";
    private static final String UNANSWERED_FAR =
            "nobody has answered in time, and it has not said where its home is: send it where it can land";

    private final ProxyRegistry boats;
    private final MessageSink messages;
    private final Executor fleet;
    private final Set<String> withWayHome;
    private final FutileReturns returns;
    private final FlightCharges flights;
    private final Map<String, WayQuestion> held = new LinkedHashMap<>(); // by kind and activation
    private final List<WayQuestion> next = new ArrayList<>(); // the same, while an earlier one is open
    private final Set<String> timed =
            new HashSet<>(); // those of the held ones whose timer runs, as far as this base has started it
    private final Map<Long, String> asked = new HashMap<>(); // by decision; for the engine's steps alone

    /**
     * Asks about the ways of some boats.
     *
     * @param withWayHome types of the output events whose boats need charge for the way home too
     */
    public WayQuestions(ProxyRegistry boats, MessageSink messages, Executor fleet, Set<String> withWayHome) {
        this.boats = boats;
        this.messages = messages;
        this.fleet = fleet;
        this.withWayHome = Set.copyOf(withWayHome);
        returns = new FutileReturns(boats);
        flights = new FlightCharges(boats);
    }

    /** Takes in what happened to a boat. */
    void accept(FleetEvent event) {
        returns.accept(event);
        flights.accept(event);
        if (event instanceof FleetEvent.StatusReported reported && !(next.isEmpty() && timed.isEmpty())) {
            bringHome(reported.status().boatId());
        }
    }

    /**
     * What waits for another question has no time of its own, and a battery may last shorter than it did when the time of a question was found: it ends with the
     * charge that is left. Not where the operator has stopped the timer.
     */
    private void bringHome(String aircraft) {
        Predicate<Move> mustGo = move ->
                move.addressee().boat().equals(aircraft) && flights.waitS(move).orElse(1) <= 0;
        for (WayQuestion one : List.copyOf(next)) {
            comeHome(one.taking(mustGo));
        }
        next.removeIf(one -> one.doubted().isEmpty());
        for (String key : List.copyOf(timed)) {
            Optional.ofNullable(held.get(key)).ifPresent(one -> {
                comeHome(one.taking(mustGo));
                if (one.doubted().isEmpty()) {
                    timed.remove(key);
                    one.context().post(new Input.WithdrawQuestion(one.kind().kind(), one.about()));
                }
            });
        }
    }

    /** A question is withdrawn; the next one is asked once it is, so that no answer to it counts for the next. */
    private void withdrawn(String key) {
        if (Optional.ofNullable(held.get(key))
                .filter(one -> one.doubted().isEmpty())
                .isPresent()) {
            held.remove(key);
            askNext(key);
        }
    }

    /** Counts moves that go on after a restart of the base; they were asked about before. */
    void goOn(List<Move> moves) {
        moves.forEach(returns::doubt);
    }

    /** Keeps the moves that are doubted and asks about them; the others are returned. */
    List<Move> hold(Activation activation, HandlerContext context, List<Move> moves, MoveSender sender) {
        List<Move> clear = new ArrayList<>();
        Map<DomainQuestion, WayQuestion> doubted = new EnumMap<>(DomainQuestion.class);
        List<GeoArea> avoid = moves.isEmpty() ? List.of() : context.query(view -> PlanAreas.avoided(activation, view));
        for (Move move : moves) {
            Optional<Way> way = way(activation, move, avoid);
            Optional<WayDoubt> futile = returns.doubt(move);
            Optional<WayDoubt> doubt = move.doubt().or(() -> futile).or(() -> way.flatMap(WayCheck::doubt));
            Optional<WayDoubt> flight = flights.doubt(activation, move);
            doubt = doubt.map(first -> first.and(flight)).or(() -> flight);
            Optional<WayBack> back = doubt.isPresent() ? Optional.empty() : way.flatMap(this::wayBack);
            if (back.isPresent() && !back.get().isSure() && asksForWayHome(activation, context, move)) {
                doubt = Optional.of(
                        new WayDoubt(WayDoubt.Kind.CHARGE, back.get().words()));
            }
            if (doubt.isEmpty()) {
                clear.add(move);
                back.ifPresent(one -> tellOfWayBack(activation, context, move, one));
            } else {
                doubted.computeIfAbsent(
                                question(doubt.get()),
                                kind -> new WayQuestion(kind, activation, context, sender, new ArrayList<>()))
                        .doubted()
                        .add(new WayQuestion.Doubted(move, doubt.get()));
            }
        }
        doubted.values().forEach(this::settleAnsweredAndAsk);
        return clear;
    }

    /** What is wrong with the way of a move, so that the operator would be asked before it is sent; nobody is asked now. */
    Optional<WayDoubt> doubt(Activation activation, HandlerContext context, Move move) {
        List<GeoArea> avoid = context.query(view -> PlanAreas.avoided(activation, view));
        return move.doubt().or(() -> way(activation, move, avoid).flatMap(WayCheck::doubt));
    }

    private Optional<WayBack> wayBack(Way way) {
        return boats.find(way.boat()).flatMap(BoatProxy::home).flatMap(home -> WayBack.of(way, home));
    }

    /**
     * Whether the operator is asked where a charge does not last for the way home: of paths and explorations that begin, unless the plan says
     * otherwise, or has batteries swapped on the way.
     */
    private boolean asksForWayHome(Activation activation, HandlerContext context, Move move) {
        return withWayHome.contains(activation.type())
                && move.command() instanceof FollowPath path
                && path.startIndex() == 0
                && PlannedSwaps.keepWaysHome(activation, context);
    }

    private void tellOfWayBack(Activation activation, HandlerContext context, Move move, WayBack back) {
        messages.tell(ActivationMessages.of(
                activation,
                context,
                Priority.LOW,
                back.words(),
                List.of(move.addressee().boat())));
    }

    private static DomainQuestion question(WayDoubt doubt) {
        return switch (doubt.kind()) {
            case PLACE -> DomainQuestion.DOUBTFUL_WAY;
            case CHARGE -> DomainQuestion.LONG_WAY;
            case NO_HEADWAY -> DomainQuestion.FUTILE_WAY;
            case ONE_WAY -> DomainQuestion.ONE_WAY;
        };
    }

    private Optional<Way> way(Activation activation, Move move, List<GeoArea> avoid) {
        List<GeoPoint> points = move.command().unvisitedPoints();
        String boat = move.addressee().boat();
        Optional<BoatStatus> status = boats.find(boat).map(BoatProxy::status);
        Optional<Charge> charge = boats.find(boat)
                .filter(known -> !known.isFlying()) // aircraft pay for time: FlightCharges
                .flatMap(known -> known.charge(SpeedChoice.mps(activation, move.command(), known)));
        return points.isEmpty()
                ? Optional.empty()
                : Optional.of(new Way(
                        boat,
                        status.flatMap(BoatStatus::pose).map(BoatPose::position),
                        charge,
                        points,
                        avoid,
                        move.command().water()));
    }

    /** Boats about which the operator has decided go or do not; who else is doubted is asked about, one question after the other. */
    private void settleAnsweredAndAsk(WayQuestion question) {
        for (WayAnswer answer : WayAnswer.values()) {
            question.takeAnswered(answer).ifPresent(answered -> settle(answered, answer));
        }
        if (question.doubted().isEmpty()) {
            return;
        }
        String key = key(question.kind().kind(), question.about());
        if (held.containsKey(key)) {
            next.add(question);
        } else {
            held.put(key, question);
            question.ask(question.moves()
                    .map(one -> flights.waitS(one.move()))
                    .flatMapToDouble(OptionalDouble::stream)
                    .min());
        }
    }

    /** Autonomy's answer is about those in the air alone: the others wait on. */
    private void nobodyAnswered(WayQuestion one) {
        WayQuestion flying = one.taking(move -> flights.waitS(move).isPresent());
        comeHome(flying);
        if (!one.doubted().isEmpty()) {
            settleAnsweredAndAsk(one);
        }
    }

    private void comeHome(WayQuestion flying) {
        if (flying.doubted().isEmpty()) {
            return;
        }
        flying.remember(WayAnswer.NOBODY);
        flying.taking(move -> !flights.canComeHome(move)).refuse(UNANSWERED_FAR);
        flying.refuse(UNANSWERED);
        flying.doubted().forEach(one -> flying.sender().sendHome(flying.activation(), flying.context(), one.boat()));
    }

    private void askNext(String key) {
        next.stream()
                .filter(question ->
                        key(question.kind().kind(), question.about()).equals(key))
                .findFirst()
                .ifPresent(question -> {
                    next.remove(question);
                    settleAnsweredAndAsk(question);
                });
    }

    private static String key(String kind, String about) {
        return kind + " " + about;
    }

    /** The paths of the boats that wait for the answer to a question; empty where none do. */
    public Optional<DoubtedPaths> doubted(String kind, String about) {
        return Optional.ofNullable(held.get(key(kind, about))).map(one -> {
            Map<String, GeoPath> paths = new LinkedHashMap<>();
            one.doubted().stream()
                    .map(WayQuestion.Doubted::move)
                    .filter(move -> !move.command().unvisitedPoints().isEmpty())
                    .forEach(move -> paths.put(
                            move.addressee().boat(), new GeoPath(move.command().unvisitedPoints())));
            return new DoubtedPaths(one.activation().mission(), paths);
        });
    }

    /** The missions that wait for an answer to such a question. */
    public Set<Long> missions() {
        return held.values().stream().map(one -> one.activation().mission()).collect(Collectors.toSet());
    }

    private void settle(WayQuestion one, WayAnswer answer) {
        if (answer != WayAnswer.YES) {
            one.refuse(answer.reason());
            return;
        }
        if (one.isFutile()) {
            one.doubted().forEach(doubted -> sendOn(one, doubted));
        }
        one.doubted().forEach(doubted -> flights.accept(one.activation(), doubted.move()));
        one.send();
    }

    private void sendOn(WayQuestion one, WayQuestion.Doubted doubted) {
        String boat = doubted.boat();
        messages.tell(ActivationMessages.of(
                one.activation(),
                one.context(),
                Priority.MEDIUM,
                doubted.doubt().words() + ". It goes on without coming home first, as the operator wants",
                List.of(boat)));
        returns.excuse(boat, one.activation().mission(), one.context());
    }

    /** What the operator has accepted of flights, for a base that goes on. */
    AircraftMemory.Part accepted() {
        return flights.accepted();
    }

    /** The moves that wait for an answer. */
    Stream<HeldMove> moves() {
        return Stream.concat(held.values().stream(), next.stream()).flatMap(WayQuestion::moves);
    }

    /** Replaces each move that waits by what is left of it; returns those of which nothing is. A question that is about nobody any longer is withdrawn. */
    List<HeldMove> reduce(Function<HeldMove, Optional<HeldMove>> left) {
        List<HeldMove> taken = new ArrayList<>();
        next.forEach(one -> taken.addAll(one.reduce(left)));
        next.removeIf(one -> one.doubted().isEmpty());
        Set<String> over = new HashSet<>();
        held.forEach((key, one) -> {
            taken.addAll(one.reduce(left));
            if (one.doubted().isEmpty()) {
                over.add(key);
                one.context().post(new Input.WithdrawQuestion(one.kind().kind(), one.about()));
            }
        });
        held.keySet().removeAll(over);
        over.forEach(this::askNext);
        return taken;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        boolean byAutonomy = false;
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened opened
                    && input instanceof Input.AskOperator question
                    && question.unanswered().isPresent()) {
                String key = key(question.kind(), question.about());
                asked.put(opened.decision().id(), key);
                fleet.execute(() -> timed.add(key));
            } else if (effect instanceof Effect.DecisionHeld stopped) {
                Optional.ofNullable(asked.get(stopped.decision()))
                        .ifPresent(key -> fleet.execute(() -> timed.remove(key)));
            } else if (effect instanceof Effect.DecisionClosed closed) {
                closed(closed);
                byAutonomy = closed.by().filter(by -> by == Answerer.AUTONOMY).isPresent();
            } else if (effect instanceof Effect.QuestionAnswered answered) {
                boolean late = byAutonomy; // its decision was closed just before
                fleet.execute(() -> answered(answered, late));
            }
        }
    }

    private void closed(Effect.DecisionClosed closed) {
        String key = asked.remove(closed.decision());
        if (key != null) {
            fleet.execute(() -> {
                timed.remove(key);
                if (closed.answer().isEmpty()) {
                    withdrawn(key);
                }
            });
        }
    }

    private void answered(Effect.QuestionAnswered answered, boolean late) {
        String key = key(answered.kind(), answered.about());
        WayQuestion one = held.remove(key);
        if (one != null) {
            if (late) {
                nobodyAnswered(one);
            } else {
                WayAnswer answer = answered.yes() ? WayAnswer.YES : WayAnswer.NO;
                one.remember(answer);
                settle(one, answer);
            }
            askNext(key);
        }
    }
}
