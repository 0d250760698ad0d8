package org.sami.uav.handler;

import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Waypoint;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.ClearWays;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.WayQuestions;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.sim.clock.VirtualClock;
import org.sami.crw.sim.fleet.FleetConfig;
import org.sami.crw.sim.fleet.SimulatedFleet;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Handlers on simulated copters without an engine: a test activates them, and sees what they answer. Every token stands where it was, and every event is awaited. */
final class FlightHandlerHarness implements HandlerContext {
    final VirtualClock clock = new VirtualClock();
    final SimulatedFleet fleet;
    final Flights flights;
    final MotionCommands motion;
    final WayQuestions ways;
    final List<Occurrence> answers = new ArrayList<>();
    final List<String> messages = new ArrayList<>();
    final List<Input.AskOperator> asked = new ArrayList<>();
    final Map<TaskId, Map<String, Value>> tasks = new HashMap<>();
    final Map<String, Value> memory = new HashMap<>(); // of the mission
    final Map<TaskId, String> allocation = new HashMap<>();
    final Set<String> dropped = new HashSet<>(); // by the operator
    final List<Input.WithdrawQuestion> withdrawn = new ArrayList<>();
    private final List<Consumer<FleetEvent>> listeners = new ArrayList<>();
    private final List<Token> standing = new ArrayList<>();
    private final List<Activation> given = new ArrayList<>();
    private long activations;

    /** Where tokens stand. */
    String place = "place";

    /** The plan of the mission, where a handler asks for it. */
    Optional<Plan> plan = Optional.empty();

    /** Whether activations are delivered again by a base that goes on. */
    boolean isRedelivered;

    /** Whether the operator has them sent again. */
    boolean isOrderedAgain;

    /** Whether activations stay open. */
    boolean areOpen;

    /** Whether the mission ended with what it asked last. */
    boolean isOver;

    /** Copters on the ground, whose links are not up before time passes. */
    FlightHandlerHarness(int copters) {
        this(copters, HullConfig.COPTER);
    }

    /** Robots of another hull, too. */
    FlightHandlerHarness(int copters, HullConfig hull) {
        fleet = new SimulatedFleet(
                clock,
                1,
                copters,
                45.7,
                10.72,
                id -> event -> List.copyOf(listeners).forEach(listener -> listener.accept(event)),
                FleetConfig.DEFAULT.withHull(hull));
        BoatErrors errors = new BoatErrors(fleet.proxies(), CrwServices.STANDARD.error());
        ways = new WayQuestions(fleet.proxies(), message -> {}, Runnable::run, Set.of());
        motion = new MotionCommands(
                fleet.proxies(),
                message -> messages.add(message.text()),
                ways,
                new ClearWays(fleet.proxies(), message -> {}, errors, new FleetEvents()));
        flights = new Flights(fleet.proxies(), motion, Runnable::run);
        listen(motion);
        listen(flights);
        fleet.start();
    }

    void listen(Consumer<FleetEvent> listener) {
        listeners.add(listener);
    }

    void pass(long seconds) {
        clock.runUntil(clock.nowMs() + seconds * 1000);
    }

    BoatProxy proxy(String copter) {
        return fleet.proxies().find(copter).orElseThrow();
    }

    double altM(String copter) {
        return fleet.boat(copter).orElseThrow().hull().altM().orElseThrow();
    }

    /** Copters enter the place of an output event. */
    void activate(ActivationHandler handler, Map<String, Value> values, String... copters) {
        activate(
                handler, values, Stream.of(copters).<Token>map(Token.Proxy::new).toList());
    }

    /** Any tokens enter it. */
    void activate(ActivationHandler handler, Map<String, Value> values, List<Token> tokens) {
        standing.addAll(tokens);
        activations++;
        Activation activation = new Activation(
                activations,
                1,
                1,
                1,
                "plan",
                place,
                "event",
                "type",
                values,
                Map.of(),
                tokens,
                Map.copyOf(allocation),
                List.of(),
                Priority.MEDIUM);
        given.add(activation);
        handle(handler, activation);
    }

    /** The base starts anew: it knows of no command, and the mission's memory is as it was. */
    void restart() {
        Map<String, Value> kept = Map.copyOf(memory);
        motion.withdraw(1, List.of());
        memory.clear();
        memory.putAll(kept);
        isRedelivered = true;
    }

    /** The last activation comes to a handler once more. */
    void activateAgain(ActivationHandler handler) {
        handle(handler, given.get(given.size() - 1));
    }

    private void handle(ActivationHandler handler, Activation activation) {
        try {
            handler.handle(activation, this);
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    /** The mission takes back what it asked of copters; of all, where none is named. */
    void withdraw(String... copters) {
        step(flights, new Input.TimeReached(), new Effect.CommandsWithdrawn(1, List.of(copters)));
    }

    /** The engine makes a step. */
    void step(HostListener listener, Input input, Effect... effects) {
        query(view -> {
            listener.onStep(1, clock.nowMs(), input, List.of(effects), view);
            return true;
        });
    }

    /** The operator answers the last question. */
    void answer(boolean yes) {
        Input.AskOperator question = asked.get(asked.size() - 1);
        step(ways, new Input.TimeReached(), new Effect.QuestionAnswered(question.kind(), question.about(), yes));
    }

    /** Nobody answers the last question until its deadline, at which autonomy says no. */
    void answerLate() {
        Input.AskOperator question = asked.get(asked.size() - 1);
        pass(question.unanswered().orElseThrow().afterMillis() / 1000);
        step(
                ways,
                new Input.TimeReached(),
                new Effect.DecisionClosed(1, Optional.of(new Answer.YesNo(false)), Optional.of(Answerer.AUTONOMY)),
                new Effect.QuestionAnswered(question.kind(), question.about(), false));
    }

    /** A copter reports where it took off; that it does not know it, where that is empty. */
    void reportHome(String copter, Optional<GeoPoint> home) {
        Gains none = new Gains(0, 0, 0);
        Optional<Waypoint> place = home.map(at -> new Waypoint(at.latDeg(), at.lonDeg(), Flights.SPEED_MPS));
        SettingsReport report = new SettingsReport(none, none, 1, LostLinkAction.HOLD, place, Optional.empty());
        proxy(copter).receive(new Frame(1, "", report), clock.nowMs());
    }

    /** A copter says that it flies along its path at another altitude, in m; what it says itself afterwards does not count any longer. */
    void report(String copter, double altM) {
        BoatProxy proxy = proxy(copter);
        BoatPose pose = proxy.status().pose().orElseThrow();
        proxy.receive(
                new Frame(
                        Long.MAX_VALUE,
                        "",
                        new Telemetry(
                                pose.position().latDeg(),
                                pose.position().lonDeg(),
                                pose.headingRad(),
                                0,
                                proxy.status().battery().orElseThrow().percent(),
                                BoatMode.PATH,
                                clock.nowMs(),
                                OptionalDouble.of(altM))),
                clock.nowMs());
    }

    /** What was answered, in order. */
    List<String> answered() {
        return answers.stream().map(Occurrence::type).toList();
    }

    @Override
    public void post(List<Input> inputs) {
        for (Input input : inputs) {
            if (input instanceof Input.Received received) {
                answers.add(received.occurrence());
            } else if (input instanceof Input.Remember remember) {
                memory.put(remember.key(), remember.value());
            } else if (input instanceof Input.AllocateTasks allocate) {
                allocate(allocate.allocation());
            } else if (input instanceof Input.AskOperator question) {
                asked.add(question);
                step(ways, question, new Effect.DecisionOpened(decision(question)));
            } else if (input instanceof Input.WithdrawQuestion withdrawn) {
                this.withdrawn.add(withdrawn);
                step(ways, withdrawn, new Effect.DecisionClosed(asked.size(), Optional.empty(), Optional.empty()));
            }
        }
    }

    /** The last question as the engine opens it. */
    private Decision decision(Input.AskOperator question) {
        return new Decision(
                asked.size(),
                Ids.NONE,
                Ids.NONE,
                question.kind(),
                question.prompt(),
                new Question.Approve(),
                Optional.empty(),
                OptionalLong.empty(),
                question.priority(),
                List.of());
    }

    /** The operator stops the timer of the last question. */
    void stopTimer() {
        step(ways, new Input.HoldDecision(asked.size()), new Effect.DecisionHeld(asked.size()));
    }

    private void allocate(Map<TaskId, Optional<String>> robots) {
        robots.forEach((task, robot) -> {
            allocation.remove(task);
            robot.ifPresent(one -> allocation.put(task, one));
        });
    }

    /** Flights to tasks, which hear of the fleet and nothing of the engine's steps. */
    TaskFlights taskFlights() {
        return new TaskFlights(
                fleet.proxies(),
                flights,
                motion,
                Runnable::run,
                new LowBatteryTasks(message -> messages.add(message.text())),
                Set.of());
    }

    @Override
    public <T> T query(Function<EngineView, T> question) {
        return question.apply((EngineView) Proxy.newProxyInstance(
                getClass().getClassLoader(), new Class<?>[] {EngineView.class}, (view, method, arguments) -> {
                    return switch (method.getName()) {
                        case "mission" ->
                            Optional.of(mission()).filter(one -> !isOver && arguments[0].equals(one.id()));
                        case "awaits" -> true;
                        case "proxies" ->
                            fleet.proxies().boatIds().stream()
                                    .filter(one -> !dropped.contains(one))
                                    .toList();
                        case "memory" -> Optional.ofNullable(memory.get(arguments[1]));
                        case "task" -> Optional.ofNullable(tasks.get(arguments[0]));
                        case "planOf" -> plan;
                        case "allocation" -> Map.copyOf(allocation);
                        case "openActivations" -> areOpen ? List.copyOf(given) : List.of();
                        default -> nothing(method.getReturnType());
                    };
                }));
    }

    private static Object nothing(Class<?> type) {
        return type == Map.class ? Map.of() : type == List.class ? List.of() : Optional.empty();
    }

    private MissionView mission() {
        return new MissionView(1, 0, 1, "plan", "plan", MissionStatus.RUNNING, Map.of(place, standing));
    }

    @Override
    public long nowMillis() {
        return clock.nowMs();
    }

    @Override
    public boolean orderedAgain() {
        return isOrderedAgain;
    }

    @Override
    public boolean redelivered() {
        return isRedelivered;
    }
}
